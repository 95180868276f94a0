#include "commands/listing.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/instruction_set.hpp"
#include "headless/context.hpp"
#include "scenes/build.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/request.hpp"
#include "scenes/scene_file.hpp"

namespace sph {
namespace {

using Json = nlohmann::ordered_json;

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "none known" : text;
}

Json PlanAsJson(const ParticleSystem& system) {
  Json plan = Json::array();
  for (const PassPlan& pass : system.Plan()) {
    plan.push_back({{"pass", pass.name}, {"runs", pass.runs}, {"reason", pass.reason}});
  }
  plan.push_back(
      {{"pass", "drawing"}, {"runs", false}, {"reason", "in the window and `render` only; `run` loads no GL"}});
  return plan;
}

/// The limits that there are, the shortest first, and what the adaptive step takes of them.
Json LimitsAsJson(const ParticleSystemSPH& system) {
  std::vector<StepLimit> limits = system.StepLimits();
  const double largest = LargestStep(limits);
  std::erase_if(limits, [](const StepLimit& limit) { return !std::isfinite(limit.seconds); });
  std::ranges::sort(limits, {}, &StepLimit::seconds);
  limits.push_back({"adaptive step", largest});
  Json list = Json::array();
  for (const StepLimit& limit : limits) list.push_back({{"limit", limit.what}, {"seconds", limit.seconds}});
  return list;
}

}  // namespace

void ListScenes(bool json) {
  Json list = Json::array();
  for (const std::string& name : SceneNames()) {
    const Scene scene = ReadScene(FindScene(name));
    if (json) {
      list.push_back({{"name", name},
                      {"title", scene.title},
                      {"solver", scene.solver},
                      {"particles", CompleteParameters(scene).fluid.particles}});
    } else {
      fmt::print("{:20} {}\n", name, scene.title);
    }
  }
  if (json) fmt::print("{}\n", list.dump(2));
}

void DescribeProgram(bool json) {
  Json back_ends = Json::array();
  for (const BackendInfo& backend : FindBackends()) {
    back_ends.push_back(
        {{"name", backend.name}, {"available", backend.available}, {"description", backend.description}});
  }
  const Json info = {{"program", "sphlab"},
                     {"version", SPHLAB_VERSION},
                     {"compiler", __VERSION__},
                     {"instruction_sets", AvailableInstructionSets()},
                     {"threads", omp_get_num_procs()},
                     {"scenes", AssetsFolder() / "scenes"},
                     {"gl_back_ends", back_ends}};
  if (json) {
    fmt::print("{}\n", info.dump(2));
    return;
  }
  fmt::print("sphlab {}, compiled by {}\n", SPHLAB_VERSION, __VERSION__);
  fmt::print("threads: {}; instruction sets: {}\n", omp_get_num_procs(), Joined(AvailableInstructionSets()));
  fmt::print("scenes in {}\n", (AssetsFolder() / "scenes").string());
  for (const Json& backend : back_ends) {
    fmt::print("GL back-end {}: {}{}\n", backend["name"].get<std::string>(),
               backend["available"].get<bool>() ? "" : "not available: ", backend["description"].get<std::string>());
  }
}

void DescribeScene(const SceneRequest& request, bool json) {
  const Scene scene = LoadScene(request);
  const auto system = MakeSystem(scene);
  const Parameters& p = system->parameters;
  const Json info = {{"name", scene.name},
                     {"title", scene.title},
                     {"about", scene.about},
                     {"solver", scene.solver},
                     {"kernel", system->KernelName()},
                     {"particles", system->State().Size()},
                     {"particles_asked_for", scene.base.fluid.particles},
                     {"placement", DescribePlacement(scene)},
                     {"particle_mass", p.particle_mass},
                     {"spacing", system->InitialSpacing()},
                     {"support_radius", system->Support()},
                     {"time_step", p.time_step},
                     {"wall_stiffness", p.wall.stiffness},
                     {"wall_damping", p.wall.damping},
                     {"step_limits", LimitsAsJson(*system)},
                     {"plan", PlanAsJson(*system)}};
  if (json) {
    fmt::print("{}\n", info.dump(2));
    return;
  }
  fmt::print("{}: {}\n{}\n\n", scene.name, scene.title, scene.about);
  fmt::print("solver {} ({}), {} particles of {:.4g} kg/m, {:.4g} m apart, support radius {:.4g} m, step {:.4g} s\n",
             scene.solver, system->KernelName(), system->State().Size(), p.particle_mass, system->InitialSpacing(),
             system->Support(), p.time_step);
  fmt::print("{}\n", DescribePlacement(scene));
  if (!p.walls.empty() && p.wall.kind == WallKind::kPenalty) {
    fmt::print("walls: stiffness {:.4g} 1/s^2, damping {:.4g} 1/s\n", p.wall.stiffness, p.wall.damping);
  }
  fmt::print("\njust stable steps at the start, and the largest advisable one:\n");
  for (const Json& limit : info["step_limits"]) {
    fmt::print("  {:<22} {:.4g} s\n", limit["limit"].get<std::string>(), limit["seconds"].get<double>());
  }
  fmt::print("\nplan of a step:\n");
  for (const Json& pass : info["plan"]) {
    fmt::print("  {:8} {:24} {}\n", pass["runs"].get<bool>() ? "runs" : "skipped", pass["pass"].get<std::string>(),
               pass["reason"].get<std::string>());
  }
}

}  // namespace sph
