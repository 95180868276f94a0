#include "lab/random_scene.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "base/random.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/request.hpp"
#include "scenes/scene_keys.hpp"
#include "sph/solvers.hpp"

namespace sph {
namespace {

/// The names that a key takes, from its refusal of one that is none; empty if it takes no names.
std::vector<std::string> ChoicesOf(const SceneKey& key) {
  Scene scene;
  const toml::value<std::string> node("-");
  try {
    key.apply(scene, Value(node, key.name, "--set"));
  } catch (const UsageError& error) {
    const std::string message = error.what();
    const std::string head = "one of: ";
    const auto begin = message.find(head);
    if (begin == std::string::npos) return {};
    std::vector<std::string> names;
    std::string list = message.substr(begin + head.size());
    list.resize(std::min(list.find('.'), list.size()));
    for (std::size_t at = 0; at < list.size();) {
      const auto comma = std::min(list.find(", ", at), list.size());
      names.push_back(list.substr(at, comma - at));
      at = comma + 2;
    }
    return names;
  }
  return {};
}

enum class Kind { kNumber, kWhole, kText, kVec2, kBox };

bool Takes(const SceneKey& key, const toml::node& node) {
  Scene scene;
  try {
    key.apply(scene, Value(node, key.name, "--set"));
    return true;
  } catch (const Error&) {
    return false;
  }
}

Kind KindOf(const SceneKey& key) {
  if (Takes(key, toml::array{0.0, 0.0, 1.0, 1.0})) return Kind::kBox;
  if (Takes(key, toml::array{0.5, 0.5})) return Kind::kVec2;
  if (Takes(key, toml::value<double>(0.5)) || Takes(key, toml::value<double>(1.5))) return Kind::kNumber;
  if (Takes(key, toml::value<std::int64_t>(1))) return Kind::kWhole;
  return Kind::kText;
}

/// What is known of a key without looking into the table.
struct KnownKey {
  std::string name;
  Kind kind = Kind::kText;
  std::vector<std::string> choices = {};
  bool required = false;
  bool negative = false;  ///< takes negative numbers
  bool large = false;     ///< takes numbers above 1
};

const std::vector<KnownKey>& KnownKeys() {
  static const std::vector<KnownKey> keys = [] {
    std::vector<KnownKey> all;
    for (const SceneKey& key : AllSceneKeys()) {
      all.push_back({key.name, KindOf(key), ChoicesOf(key), key.required, Takes(key, toml::value<double>(-0.5)),
                     Takes(key, toml::value<double>(1.5))});
    }
    return all;
  }();
  return keys;
}

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}

  bool Chance(double probability) { return random_.Uniform() < probability; }
  std::size_t Below(std::size_t n) { return static_cast<std::size_t>(random_.Uniform() * static_cast<double>(n)); }
  template <typename T>
  const T& OneOf(const std::vector<T>& all) {
    return all[Below(all.size())];
  }
  /// Mostly of the size of what scenes have, now and then of any size or sign.
  double Number() {
    if (Chance(0.05)) return 0;
    const double reach = Chance(0.1) ? 300 : Chance(0.3) ? 6 : 2;
    const double size = std::pow(10, random_.Uniform(-reach, reach));
    return Chance(0.15) ? -size : size;
  }
  double Uniform(double low, double high) { return random_.Uniform(low, high); }

 private:
  Random random_;
};

/// Particles in numbers that can be run ten thousand times.
std::size_t Count(Dice& dice) { return 1 + dice.Below(dice.Chance(0.2) ? 8 : 250); }

std::string BoxAround(Dice& dice) {
  const double reach = dice.Chance(0.1) ? std::abs(dice.Number()) : 1.0;
  const double x = dice.Uniform(-reach, reach), y = dice.Uniform(-reach, reach);
  return fmt::format("[{}, {}, {}, {}]", x, y, x + reach * dice.Uniform(0.02, 1), y + reach * dice.Uniform(0.02, 1));
}

std::string ValueOf(const KnownKey& key, Dice& dice) {
  if (key.name.ends_with("particles")) return std::to_string(Count(dice));
  if (!key.choices.empty()) return fmt::format("\"{}\"", dice.OneOf(key.choices));
  switch (key.kind) {
    case Kind::kNumber: {
      const double number = dice.Number();
      const bool obey = dice.Chance(0.97);  // else it is to be refused
      const double size = obey && !key.large ? std::fmod(std::abs(number), 1.0) : number;
      return fmt::format("{:e}", obey && !key.negative ? std::abs(size) : size);  // a float, whatever its value
    }
    case Kind::kWhole:
      return std::to_string(static_cast<long>(std::clamp(std::abs(dice.Number()), dice.Chance(0.1) ? 0.0 : 1.0, 30.0)));
    case Kind::kVec2:
      return fmt::format("[{:e}, {:e}]", dice.Number(), dice.Number());
    case Kind::kBox:
      return BoxAround(dice);
    case Kind::kText:
      break;
  }
  return key.name == "arrows.wall" ? "\"a\"" : "\"text\"";
}

/// Keys of which a scene takes one group.
bool InGroup(const std::string& name) {
  return name.starts_with("equation_of_state.") || name.starts_with("fluid.region.");
}

std::string WallsAround(Dice& dice) {
  static const std::vector<std::string> sides = {"left", "right", "below", "above"};
  std::string text;
  const std::size_t count = dice.Below(6);
  for (std::size_t k = 0; k < count; ++k) {
    const std::string& side = sides[k < 4 && !dice.Chance(0.1) ? k : dice.Below(4)];
    const bool low = side == "right" || side == "above";
    const double at = (low ? -1 : 1) * dice.Uniform(dice.Chance(0.1) ? 0.1 : 1.5, 3);
    text += fmt::format("[[wall]]\nname = \"{}\"\nat = {:e}\nfluid = \"{}\"\n",
                        std::string(1, static_cast<char>('a' + k)), at, side);
    if (dice.Chance(0.3))
      text += fmt::format("range = [{:e}, {:e}]\n", at - dice.Uniform(0, 2), at + dice.Uniform(0, 2));
  }
  return text;
}

std::string ControlOf(Dice& dice) {
  const KnownKey& key = dice.OneOf(KnownKeys());  // most of which may not change: refused
  const std::string action = dice.Chance(0.8) ? fmt::format("{{ move_wall = \"a\", to = {:e} }}", dice.Uniform(-3, 3))
                                              : fmt::format("{{ set = \"{}\", to = {:e} }}", key.name, dice.Number());
  return fmt::format("[[key]]\npress = \"d\"\ndo = [ {} ]\n", action);
}

/// Whether a solver refuses the key; now and then it is to do so.
bool Useless(const KnownKey& key, const std::string& solver, Dice& dice) {
  return !FindSceneKey(key.name)->UsedBy(solver) && dice.Chance(0.95);
}

/// Sizes that go together, so that not every scene blows up at once.
std::string SoundKeys(Dice& dice, std::size_t particles) {
  const double width = dice.Uniform(0.2, 1), height = dice.Uniform(0.2, 1);
  const double spacing = std::sqrt(width * height / static_cast<double>(particles));
  const double rho0 = std::pow(10, dice.Uniform(-1, 3));
  const double sound = std::pow(10, dice.Uniform(-1, 2));
  const std::vector<std::string> equations = {
      fmt::format("polytrope.k = {:e}", sound * sound / (2 * rho0)),
      fmt::format("tait = {{ k = {:e}, rho0 = {:e} }}", rho0 * sound * sound / 7, rho0),
      fmt::format("ideal_gas = {{ k = {:e}, rho0 = {:e} }}", sound * sound, rho0)};
  const double h = spacing * dice.Uniform(1.0, 3.0);
  return fmt::format(
      "fluid.mass = {:e}\nfluid.region.box = [0.0, 0.0, {:e}, {:e}]\nequation_of_state.{}\n"
      "method.smoothing_length = {:e}\nmethod.time_step = {:e}\n",
      rho0 * spacing * spacing, width, height, dice.OneOf(equations), h, dice.Uniform(0.1, 1.5) * h / sound);
}

std::string FromNothing(Dice& dice) {
  const std::size_t particles = Count(dice);
  std::string text = fmt::format("title = \"random\"\nfluid.particles = {}\n", particles);
  const bool sound = dice.Chance(0.7);
  const std::vector<std::string> set = {"title", "fluid.particles", "fluid.mass", "method.smoothing_length",
                                        "method.time_step"};
  if (sound) text += SoundKeys(dice, particles);
  const auto solvers = AllSolvers();
  const std::string& solver = solvers[dice.Below(solvers.size())].name;
  text += fmt::format("solver = \"{}\"\n", solver);
  std::vector<std::string> groups;  // one of each
  for (const KnownKey& key : KnownKeys()) {
    if (key.name == "solver" || Useless(key, solver, dice)) continue;
    const bool is_set = std::ranges::find(set, key.name) != set.end();
    if (sound ? is_set || InGroup(key.name) : key.name == "title" || key.name == "fluid.particles") continue;
    if (key.name.starts_with("forces.star.") || key.name.starts_with("periodic.")) continue;  // in pairs, below
    const bool names_another = key.name == "arrows.wall" || key.name == "reference";
    const bool wanted = key.required || dice.Chance(InGroup(key.name) ? 0.5 : names_another ? 0.03 : 0.15);
    if (wanted) text += fmt::format("{} = {}\n", key.name, ValueOf(key, dice));
  }
  if (dice.Chance(0.1))
    text += fmt::format("forces.star = {{ mass = {:e}, radius = {:e} }}\n", dice.Number(), dice.Number());
  if (dice.Chance(0.15)) {
    static const std::vector<std::string> directions = {"x", "y", "both"};
    text += fmt::format("periodic = {{ box = [0.0, 0.0, {:e}, {:e}], directions = \"{}\" }}\n", dice.Uniform(0.5, 2),
                        dice.Uniform(0.5, 2), dice.OneOf(directions));
  }
  text += WallsAround(dice);
  if (dice.Chance(0.2)) text += ControlOf(dice);
  return text;
}

std::vector<std::string> Settings(const std::string& solver, Dice& dice) {
  std::vector<std::string> settings;
  const std::size_t count = 1 + dice.Below(6);
  for (std::size_t k = 0; k < count; ++k) {
    const KnownKey& key = dice.OneOf(KnownKeys());
    if (InGroup(key.name) && dice.Chance(0.8)) continue;  // which mostly contradicts what the scene has
    if (Useless(key, solver, dice)) continue;
    settings.push_back(key.name + "=" + ValueOf(key, dice));
  }
  return settings;
}

}  // namespace

RandomScene MakeRandomScene(std::uint64_t seed) {
  Dice dice(seed);
  RandomScene scene;
  if (dice.Chance(0.5)) {
    scene.base = dice.OneOf(SceneNames());
    SceneRequest request;
    request.scene = scene.base;
    scene.settings = Settings(LoadScene(request).solver, dice);
  } else {
    scene.text = FromNothing(dice);
  }
  return scene;
}

std::string Describe(const RandomScene& scene) {
  if (scene.base.empty()) return scene.text;
  std::string line = "sphlab run " + scene.base;
  for (const std::string& setting : scene.settings) line += fmt::format(" --set '{}'", setting);
  return line;
}

}  // namespace sph
