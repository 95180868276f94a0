#include "lab/random_scene.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "lab/dice.hpp"
#include "lab/known_keys.hpp"
#include "lab/plausible_scene.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/request.hpp"
#include "scenes/scene_keys.hpp"
#include "sph/solvers.hpp"

namespace sph {
namespace {

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
    case KeyKind::kNumber: {
      const double number = dice.Number();
      const bool obey = dice.Chance(0.97);  // else it is to be refused
      const double size = obey && !key.large ? std::fmod(std::abs(number), 1.0) : number;
      return fmt::format("{:e}", obey && !key.negative ? std::abs(size) : size);  // a float, whatever its value
    }
    case KeyKind::kWhole:
      return std::to_string(static_cast<long>(std::clamp(std::abs(dice.Number()), dice.Chance(0.1) ? 0.0 : 1.0, 30.0)));
    case KeyKind::kVec2:
      return fmt::format("[{:e}, {:e}]", dice.Number(), dice.Number());
    case KeyKind::kBox:
      return BoxAround(dice);
    case KeyKind::kText:
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
  constexpr double kPlausible = 0.55, kOfTheCatalogue = 0.2;  // the rest is made of any keys
  Dice dice(seed);
  RandomScene scene;
  const double choice = dice.Uniform(0, 1);
  if (choice < kPlausible) {
    scene.text = PlausibleScene(dice);
  } else if (choice < kPlausible + kOfTheCatalogue) {
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
