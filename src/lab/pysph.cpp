#include "lab/pysph.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "base/error.hpp"
#include "lab/price_runs.hpp"
#include "scenes/build.hpp"
#include "scenes/catalogue.hpp"

namespace sph {
namespace {

constexpr std::size_t kColumns = 7;  // t, x, y, vx, vy, mass, pressure

/// Runs a command with its output in `log`. @return its exit code, or -1 if it could not be started or was killed
int RunCommand(std::vector<std::string> arguments, const std::filesystem::path& log) {
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t process = -1;
  const int error = posix_spawnp(&process, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (error != 0) return -1;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) return -1;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The numbers of a row; TroubleError if there are not as many.
std::array<double, kColumns> ReadRow(const std::string& line, const std::filesystem::path& file) {
  std::array<double, kColumns> row{};
  const char* at = line.data();
  const char* const end = at + line.size();
  for (std::size_t k = 0; k < kColumns; ++k) {
    const auto [rest, error] = std::from_chars(at, end, row[k]);
    const bool last = k + 1 == kColumns;
    if (error != std::errc() || (last ? rest != end : rest == end || *rest != ',')) {
      throw TroubleError("{}: '{}' does not have {} numbers", file.string(), line, kColumns);
    }
    at = last ? rest : rest + 1;
  }
  return row;
}

void RunScript(const std::string& case_name, int resolution, const std::filesystem::path& file,
               const std::vector<double>& times, const std::filesystem::path& log) {
  std::vector<std::string> command = {PythonForPySph(), (AssetsFolder() / "peers" / "pysph_run.py").string(), case_name,
                                      fmt::format("{}", resolution), file.string()};
  for (const double time : times) command.push_back(fmt::format("{}", time));
  if (RunCommand(command, log) == 0) return;
  throw TroubleError("PySPH could not run its example for '{}'; what it said is in {}", case_name, log.string());
}

/// Those of the times; there may be others, of the start or the end.
std::vector<FlowSnapshot> SnapshotsAt(const std::vector<double>& times, const PeerFile& peer,
                                      const std::filesystem::path& file) {
  const double tolerance = 1e-4 * times.back();
  std::vector<FlowSnapshot> wanted;
  for (const double time : times) {
    const auto distance = [&](const FlowSnapshot& snapshot) { return std::abs(snapshot.time - time); };
    const auto nearest = std::ranges::min_element(peer.snapshots, {}, distance);
    if (distance(*nearest) > tolerance) throw TroubleError("{}: has no particles at t = {} s", file.string(), time);
    wanted.push_back(*nearest);
  }
  return wanted;
}

double AsNumber(const std::string& text, const std::filesystem::path& file) {
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) throw TroubleError("{}: '{}' is not a number", file.string(), text);
  return value;
}

}  // namespace

std::string PythonForPySph() {
  const char* set = std::getenv("SPHLAB_PYTHON");
  return set != nullptr && *set != '\0' ? set : "/usr/bin/python3";
}

void RequirePySph() {
  if (RunCommand({PythonForPySph(), "-c", "import pysph"}, "/dev/null") == 0) return;
  throw TroubleError(
      "--peers: {} has no PySPH. On Debian: apt-get install python3-pysph python3-dev g++; another Python that has it "
      "goes into SPHLAB_PYTHON",
      PythonForPySph());
}

std::vector<int> PySphResolutions(const std::string& case_name) {
  if (case_name == "taylor-green") return {25, 50};
  if (case_name == "elliptic-drop") return {20, 40};
  if (case_name == "still-water" || case_name == "water-column" || case_name == "poiseuille") return {0};
  return {};
}

const std::string& PeerFile::Fact(const std::string& key) const {
  for (const auto& [name, value] : facts) {
    if (name == key) return value;
  }
  throw TroubleError("PySPH's results do not say '{}'", key);
}

PeerFile ReadPeerFile(const std::filesystem::path& file) {
  PeerFile peer;
  std::ifstream stream(file);
  bool past_names = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("# ")) {
      const std::size_t space = line.find(' ', 2);
      peer.facts.emplace_back(line.substr(2, space - 2), space == std::string::npos ? "" : line.substr(space + 1));
    } else if (!past_names) {
      past_names = true;
    } else {
      const auto [t, x, y, vx, vy, mass, pressure] = ReadRow(line, file);
      if (peer.snapshots.empty() || peer.snapshots.back().time != t) peer.snapshots.push_back({.time = t});
      peer.snapshots.back().particles.Add({x, y}, {vx, vy}, mass);
      peer.snapshots.back().pressure.push_back(pressure);
    }
  }
  if (peer.snapshots.empty()) throw TroubleError("{}: cannot be read, or has no particles", file.string());
  return peer;
}

RivalRun RunPySph(const VerificationCase& of, int resolution, const std::filesystem::path& folder) {
  const auto flow = MakeSystem(LoadScene(of.request));
  const std::vector<double> times = of.judgement->times(*flow);
  const auto log = folder / fmt::format("pysph-{}.log", of.name);
  const auto file = folder / fmt::format("pysph-{}-{}.csv", of.name, resolution);
  std::filesystem::remove(log);
  RunScript(of.name, resolution, file, {}, log);
  RunScript(of.name, resolution, file, times, log);
  PeerFile peer = ReadPeerFile(file);
  std::filesystem::remove(file);
  const std::vector<FlowSnapshot> wanted = SnapshotsAt(times, peer, file);
  RivalRun run{.case_name = of.name,
               .who = fmt::format("PySPH {}, {}", peer.Fact("version"), peer.Fact("scheme")),
               .particles = static_cast<std::size_t>(AsNumber(peer.Fact("particles"), file)),
               .seconds = AsNumber(peer.Fact("seconds"), file)};
  run.errors = ErrorsOf(of.judgement->judge(*flow, wanted));
  return run;
}

}  // namespace sph
