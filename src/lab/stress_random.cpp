// Random scenes: each is refused, or keeps what it promises for a thousand steps, or ends unstable with its cause
// named.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "lab/known_keys.hpp"
#include "lab/promises.hpp"
#include "lab/random_course.hpp"
#include "lab/stress.hpp"

namespace sph {
namespace {

constexpr long kUsualSteps = 1000, kManySteps = 20'000;
constexpr std::uint64_t kManyEvery = 64;  ///< of ten thousand scenes more than a hundred are accepted and take so many
constexpr long kRandomScenes = 10'000, kRandomScenesOfQuick = 40;
constexpr double kMostRefused = 0.5;  // of all
/// Of so many scenes every kind is among those that are accepted.
constexpr long kScenesWithEveryKind = 1000;

long StepsOf(std::uint64_t seed, bool quick) { return !quick && seed % kManyEvery == 0 ? kManySteps : kUsualSteps; }

/// Kinds of scenes that shall be among those that are accepted.
std::set<std::string> AllKinds() {
  std::set<std::string> kinds = {"tilted gravity", "sticking walls", "sliding walls"};
  for (const char* key : {"solver", "fluid.arrange", "fluid.flow", "walls.kind"}) {
    for (const std::string& choice : ChoicesOf(key)) kinds.insert(fmt::format("{} {}", key, choice));
  }
  return kinds;
}

std::vector<std::string> KindsOf(const Scene& scene) {
  const auto name = [](const char* key, auto choice) {
    return fmt::format("{} {}", key, ChoicesOf(key)[static_cast<std::size_t>(choice)]);
  };
  std::vector<std::string> kinds = {"solver " + scene.solver, name("fluid.arrange", scene.base.fluid.arrange)};
  if (scene.sph.flow != nullptr) kinds.push_back("fluid.flow " + scene.sph.flow->name);
  if (scene.base.gravity.x != 0) kinds.push_back("tilted gravity");
  if (scene.base.walls.empty()) return kinds;
  kinds.push_back(name("walls.kind", scene.base.wall.kind));
  const auto sticks = [&](const Wall& wall) { return Sticks(wall, scene.base.wall); };
  if (std::ranges::any_of(scene.base.walls, sticks)) kinds.push_back("sticking walls");
  if (FastestSlide(scene) > 0) kinds.push_back("sliding walls");
  return kinds;
}

/// What became of the scenes.
class Tally {
 public:
  Tally() : missing_(AllKinds()) {}

  void Add(std::uint64_t seed, long steps, const Course& course) {
    ++endings_[static_cast<std::size_t>(course.ending)];
    if (course.ending == Ending::kFlawed) flaws_.push_back(fmt::format("seed {}: {}", seed, course.flaw));
    if (course.ending != Ending::kRefused) {
      for (const std::string& kind : KindsOf(course.scene)) missing_.erase(kind);
      if (steps == kManySteps) ++long_ones_;
    }
    if (course.seconds <= slowest_) return;
    slowest_ = course.seconds;
    of_slowest_ = seed;
  }

  void Report(const std::string& what, long count, StressSink& sink) const {
    const auto number = [&](Ending ending) { return endings_[static_cast<std::size_t>(ending)]; };
    constexpr std::size_t kShown = 3;
    const auto shown = std::span(flaws_).first(std::min(kShown, flaws_.size()));
    sink.Row({what, "flawed", static_cast<double>(flaws_.size()), 0,
              fmt::format("{} ok, {} unstable, {} refused, {} of {} steps{}{}", number(Ending::kOk),
                          number(Ending::kUnstable), number(Ending::kRefused), long_ones_, kManySteps,
                          shown.empty() ? "" : "; first flaws: ", fmt::join(shown, "; "))});
    if (count >= kScenesWithEveryKind) {
      sink.Row({what, "refused, share", static_cast<double>(number(Ending::kRefused)) / static_cast<double>(count),
                kMostRefused});
      sink.Row({what, "kinds of scenes that were not there", static_cast<double>(missing_.size()), 0,
                fmt::format("{}", fmt::join(missing_, ", "))});
    }
    sink.Row({what, "slowest [s]", slowest_, 60, fmt::format("seed {}", of_slowest_)});
  }

  const std::vector<std::string>& Flaws() const { return flaws_; }

 private:
  std::array<long, 4> endings_{};
  std::vector<std::string> flaws_;
  std::set<std::string> missing_;
  long long_ones_ = 0;
  double slowest_ = 0;  // [s]
  std::uint64_t of_slowest_ = 0;
};

}  // namespace

std::uint64_t SeedOfDay(std::chrono::sys_days day) {
  constexpr std::uint64_t kRoom = 100'000;
  const std::chrono::year_month_day date(day);
  const auto year = static_cast<std::uint64_t>(static_cast<int>(date.year()));
  return ((year * 100 + static_cast<unsigned>(date.month())) * 100 + static_cast<unsigned>(date.day())) * kRoom;
}

void StressRandom(const StressOptions& options, StressSink& sink) {
  constexpr unsigned kPatience = 300;  // [s]
  const long count = options.CountOr(kRandomScenes, kRandomScenesOfQuick);
  const auto today = std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  const std::uint64_t first = options.seed.value_or(SeedOfDay(today));
  if (count == 1) sink.Say(Describe(MakeRandomScene(first)));  // to be repeated by hand
  Tally tally;
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed) {
    if (sink.Stopped()) return;
    sink.Note(fmt::format("random: seed {}", seed), kPatience);
    const long steps = StepsOf(seed, options.quick);
    tally.Add(seed, steps, CourseOf(MakeRandomScene(seed), seed, steps, options.threads));
  }
  tally.Report(fmt::format("{} scenes, seeds from {} on", count, first), count, sink);
}

}  // namespace sph
