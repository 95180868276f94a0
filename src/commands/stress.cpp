#include "commands/stress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/clock.hpp"
#include "base/nearest_name.hpp"
#include "commands/interrupt.hpp"
#include "io/output_directory.hpp"
#include "io/png.hpp"
#include "io/whole_file.hpp"

namespace sph {
namespace {

constexpr const char* kRow = "{:<10} {:<52} {:<40} {:>9} {:>8}  {:<5} {:>7}  {}\n";

std::vector<const StressTest*> Chosen(const std::vector<std::string>& wanted) {
  std::vector<const StressTest*> chosen;
  std::vector<std::string> names;
  for (const StressTest& test : AllStressTests()) {
    names.push_back(test.name);
    if (wanted.empty() || std::ranges::find(wanted, test.name) != wanted.end()) chosen.push_back(&test);
  }
  for (const std::string& name : wanted) {
    if (std::ranges::find(names, name) == names.end()) {
      throw UsageError("stress: unknown test '{}'.{} There are: {}", name, DidYouMean(name, names),
                       fmt::join(names, ", "));
    }
  }
  return chosen;
}

/// What the program was at when it crashed or hung: without it, a crash in ten thousand scenes could not be repeated.
class LastWords {
 public:
  void Set(const std::string& text, unsigned patience_s) {
    const auto end = std::snprintf(text_, sizeof text_, "\nsphlab: stress ended in %s\n", text.c_str());
    size_ = std::min<std::size_t>(static_cast<std::size_t>(std::max(end, 0)), sizeof text_ - 1);
    alarm(patience_s);
  }
  /// Only what is safe in a signal's handler.
  void Say() const {
    if (write(STDERR_FILENO, text_, size_) < 0) return;
  }

 private:
  char text_[200] = "";
  std::size_t size_ = 0;
};

LastWords last_words;

void SayLastWords(int signal) {
  last_words.Say();
  if (signal == SIGALRM) _exit(static_cast<int>(ExitCode::kTrouble));  // it hangs
  std::signal(signal, SIG_DFL);
  raise(signal);
}

/// Prints rows as they come, or collects them; writes figures at once.
class Sink final : public StressSink {
 public:
  explicit Sink(const StressCommand& command) : command_(command) {}

  void Begin(const StressTest& test) {
    test_ = test.name;
    since_.Restart();
  }

  void Row(const StressRow& row) override {
    all_hold_ = all_hold_ && row.Holds();
    const double seconds = since_.Seconds();
    since_.Restart();
    if (command_.json) {
      report_.push_back({{"test", test_},
                         {"what", row.what},
                         {"metric", row.metric},
                         {"value", row.value},
                         {"bar", row.bar},
                         {"holds", row.Holds()},
                         {"note", row.note},
                         {"wall_seconds", seconds}});
    } else {
      ClearNote();
      fmt::print(kRow, test_, row.what, row.metric, fmt::format("{:.4g}", row.value),
                 std::isfinite(row.bar) ? fmt::format("{:.3g}", row.bar) : "", row.Holds() ? "holds" : "open",
                 fmt::format("{:.1f}", seconds), row.note);
      std::fflush(stdout);
    }
  }

  void Figure(const std::string& name, const Plot& plot, const std::string& csv) override {
    if (command_.out.empty()) return;
    const std::filesystem::path folder = command_.out;
    WriteWholeFile(folder / (name + ".csv"), csv);
    WritePng(folder / (name + ".png"), Draw(plot));
  }

  void Note(const std::string& text, unsigned patience_s) override {
    last_words.Set(text, patience_s);
    if (!on_terminal_) return;
    fmt::print(stderr, "\r{}\033[K", text);
    std::fflush(stderr);
    noted_ = true;
  }

  void Say(const std::string& text) override {
    ClearNote();
    fmt::print(stderr, "{}\n", text);
  }

  bool Stopped() const override { return Interrupted(); }

  void ClearNote() {
    if (noted_) fmt::print(stderr, "\r\033[K");
    noted_ = false;
  }
  bool AllHold() const { return all_hold_; }
  const nlohmann::ordered_json& Report() const { return report_; }

 private:
  const StressCommand& command_;
  std::string test_;
  Stopwatch since_;
  bool all_hold_ = true;
  bool on_terminal_ = isatty(STDERR_FILENO) != 0;
  bool noted_ = false;
  nlohmann::ordered_json report_ = nlohmann::ordered_json::array();
};

}  // namespace

ExitCode Stress(const StressCommand& command) {
  const auto tests = Chosen(command.tests);
  CatchInterrupts();
  if (!command.out.empty()) PrepareOutputDirectory(command.out);
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGALRM}) std::signal(signal, &SayLastWords);
  Sink sink(command);
  if (!command.json) {
    fmt::print(kRow, "test", "what", "metric", "value", "bar", "", "seconds", "");
    std::fflush(stdout);
  }
  for (const StressTest* test : tests) {
    sink.Begin(*test);
    test->run(command.options, sink);
    alarm(0);
    if (Interrupted()) break;
  }
  sink.ClearNote();
  if (command.json) fmt::print("{}\n", sink.Report().dump(2));
  if (Interrupted()) return ExitCode::kInterrupted;
  return sink.AllHold() ? ExitCode::kDone : ExitCode::kTrouble;
}

}  // namespace sph
