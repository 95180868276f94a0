#include "commands/bench_protocol.hpp"

#include <fmt/chrono.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

namespace sph {
namespace {

/// "model name" of /proc/cpuinfo.
std::string Processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  }
  return "unknown processor";
}

/// The settings of OpenMP in the environment, as a line; empty if there are none.
std::string ThreadSettings() {
  std::string settings;
  for (const char* name : {"OMP_WAIT_POLICY", "OMP_PROC_BIND", "OMP_PLACES"}) {
    if (const char* value = std::getenv(name))
      settings += fmt::format("{}{}={}", settings.empty() ? "" : " ", name, value);
  }
  return settings.empty() ? "" : settings + "\n";
}

}  // namespace

std::string DescribeMachine() {
  const std::time_t now = std::time(nullptr);
  return fmt::format("{}, {} processors\ncompiled by {} {} with {}\n{}{:%Y-%m-%d}\n\n", Processor(),
                     std::thread::hardware_concurrency(), SPHLAB_COMPILER, __VERSION__, SPHLAB_FLAGS, ThreadSettings(),
                     fmt::gmtime(now));
}

void Protocol::Add(const std::string& text) {
  fmt::print("{}", text);
  std::fflush(stdout);
  text_ += text;
}

}  // namespace sph
