#include "commands/report.hpp"

#include <omp.h>

#include <nlohmann/json.hpp>

#include "base/instruction_set.hpp"
#include "particles/diagnostics.hpp"
#include "scenes/build.hpp"

namespace sph {

std::map<std::string, double> ErrorsAgainstReference(const Session& session) {
  const auto star = StarOf(session.CurrentScene());
  if (session.CurrentScene().reference != Reference::kStaticStar || !star) return {};
  const Particles& p = session.System().State();
  const DensityErrors errors = CompareDensity(*star, p.x, p.y, session.System().Density());
  return {{"density_mse", errors.mse}, {"density_rms_relative", errors.rms_relative}};
}

nlohmann::ordered_json ReportRun(const Session& session, double wall_seconds) {
  const ParticleSystemSPH& system = session.System();
  const Diagnostics d = Diagnose(system);
  const auto particles = system.State().Size();
  const double particle_steps = static_cast<double>(particles) * static_cast<double>(system.Steps());
  std::vector<std::string> skipped;
  for (const PassPlan& pass : system.Plan()) {
    if (!pass.runs) skipped.push_back(pass.name);
  }
  skipped.insert(skipped.end(), {"drawing", "PNG"});
  const auto pair = [](Vec2 v) { return std::vector<double>{v.x, v.y}; };
  nlohmann::ordered_json report;
  report["scene"] = session.CurrentScene().name;
  report["solver"] = session.CurrentScene().solver;
  report["kernel"] = system.KernelName();
  report["precision"] = system.parameters_sph.precision == Precision::kFloat ? "float" : "double";
  report["simd"] = InstructionSetInUse();
  report["threads"] = system.parameters.threads > 0 ? system.parameters.threads : omp_get_num_procs();
  report["seed"] = system.parameters.seed;
  report["particles"] = particles;
  report["steps"] = system.Steps();
  report["time"] = system.Time();
  report["dt_last"] = system.parameters.time_step;
  report["wall_seconds"] = wall_seconds;
  report["particle_steps_per_second"] = wall_seconds > 0 ? particle_steps / wall_seconds : 0.0;
  report["neighbours_mean"] = system.MeanNeighbours();
  report["phases"] = system.Phases().Seconds();
  report["skipped"] = skipped;
  report["kinetic_energy"] = d.kinetic_energy;
  report["potential_energy"] = d.potential_energy;
  report["internal_energy"] = d.internal_energy;
  report["momentum"] = pair(d.momentum);
  report["angular_momentum"] = d.angular_momentum;
  report["centre_of_mass"] = pair(d.centre_of_mass);
  report["max_speed"] = d.max_speed;
  report["density"] = {{"min", d.density.min}, {"mean", d.density.mean}, {"max", d.density.max}};
  report["bounds"] = {d.bounds.x0, d.bounds.y0, d.bounds.x1, d.bounds.y1};
  report["outside"] = d.outside;
  report["deepest"] = d.deepest;
  report["status"] = system.Trouble() ? "unstable" : "ok";
  report["state_hash"] = fmt::format("{:016x}", d.state_hash);
  report["errors"] = ErrorsAgainstReference(session);
  report["memory_bytes"] = system.Bytes();
  report["retreats"] = session.CurrentGuard().Retreats();
  report["guard_bytes"] = session.CurrentGuard().Bytes();
  return report;
}

std::string DescribeRun(const nlohmann::ordered_json& report) {
  const auto number = [&](const char* key) { return report[key].get<double>(); };
  std::string text = fmt::format(
      "{} with solver {}: {} particles, {} steps of {:.4g} s to t = {:.6g} s, {}\n"
      "  {:.3g} s of wall time, {:.3g} million particle-steps/s, {:.1f} neighbours\n"
      "  energy: kinetic {:.4g}, potential {:.4g}, internal {:.4g} J/m; fastest {:.3g} m/s\n"
      "  walls: {} particles outside, deepest penetration {:.3g} spacings\n",
      report["scene"].get<std::string>(), report["solver"].get<std::string>(), report["particles"].get<long>(),
      report["steps"].get<long>(), number("dt_last"), number("time"), report["status"].get<std::string>(),
      number("wall_seconds"), 1e-6 * number("particle_steps_per_second"), number("neighbours_mean"),
      number("kinetic_energy"), number("potential_energy"), number("internal_energy"), number("max_speed"),
      report["outside"].get<long>(), number("deepest"));
  for (const auto& [metric, value] : report["errors"].items()) {
    text += fmt::format("  {} {:.4g}\n", metric, value.get<double>());
  }
  return text;
}

}  // namespace sph
