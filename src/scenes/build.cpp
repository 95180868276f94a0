#include "scenes/build.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/error.hpp"
#include "scenes/start.hpp"
#include "sph/mueller.hpp"
#include "sph/solvers.hpp"

namespace sph {

void ScaleToParticles(Scene& scene, std::size_t particles) {
  SPH_CHECK(particles > 0 && scene.base.fluid.particles > 0, "{} of {}", particles, scene.base.fluid.particles);
  const double f = static_cast<double>(particles) / static_cast<double>(scene.base.fluid.particles);
  const double root = std::sqrt(f);
  const auto times_f = [f](std::size_t n) {
    return static_cast<std::size_t>(std::llround(f * static_cast<double>(n)));
  };
  Parameters& base = scene.base;
  base.fluid.particles = particles;
  base.drop.particles = times_f(base.drop.particles);
  base.particle_limit = times_f(base.particle_limit);
  base.particle_mass /= f;
  for (double* length : {&base.fluid.spacing, &base.fluid.jitter, &base.drop.spacing, &scene.sph.smoothing_length}) {
    *length /= root;
  }
  base.time_step /= root;
  const auto* water = std::get_if<IdealGas>(&scene.sph.equation_of_state);
  if (f > 1 && water != nullptr && scene.sph.viscosity > 0) {
    const double viscous = ViscousStep(scene.sph.viscosity, water->rho0, scene.sph.smoothing_length);
    base.time_step = std::min(base.time_step, kStepSafety * viscous);
  }
  if (scene.wall_scaling == WallScaling::kDerived) {
    base.wall.stiffness *= f;
    base.wall.damping *= root;
  }
}

namespace {

/// Where no scene file says: a quarter of the fluid, as a square in the upper part of the container.
Block DefaultDrop(const Parameters& base) {
  Block drop;
  drop.spacing = Spacing(base.fluid);
  drop.particles = std::max<std::size_t>(1, base.fluid.particles / 4);
  const double half = 0.5 * drop.spacing * std::ceil(std::sqrt(static_cast<double>(drop.particles)));
  const Box fluid = base.fluid.region.Bounds();
  const Box legal = LegalRegion(base.walls);
  const double top = std::isfinite(legal.y1) ? legal.y1 : fluid.y1 + fluid.Height();
  const double x = std::isfinite(legal.x0 + legal.x1) ? legal.Centre().x : fluid.Centre().x;
  const double bottom = std::max(top - 2 * half - drop.spacing, fluid.y0);
  drop.region.box = {x - half, bottom, x + half, bottom + 2 * half};
  return drop;
}

}  // namespace

std::optional<ToyStar> StarOf(const Scene& scene) {
  const auto* gas = std::get_if<Polytrope>(&scene.sph.equation_of_state);
  if (!scene.star || gas == nullptr) return std::nullopt;
  return ToyStar{scene.star->mass, scene.star->radius, gas->k};
}

Parameters CompleteParameters(const Scene& scene) {
  Parameters base = scene.base;
  base.fluid = Fitted(base.fluid);
  if (base.fluid.spacing <= 0) {  // one that the scene gives is its particles' own, and so is their mass
    base.particle_mass *= static_cast<double>(scene.base.fluid.particles) / static_cast<double>(base.fluid.particles);
  }
  if (const auto star = StarOf(scene)) base.central_force = star->CentralForce();
  if (base.drop.region.Area() <= 0) base.drop = DefaultDrop(base);
  if (base.drop.spacing <= 0) base.drop.spacing = Spacing(base.fluid);
  if (base.drop.particles == 0) {
    constexpr double kRoundOff = 1e-6;
    const double sites = base.drop.region.Area() / (base.drop.spacing * base.drop.spacing);
    base.drop.particles = static_cast<std::size_t>(sites + kRoundOff);
  }
  if (base.particle_limit == 0) base.particle_limit = std::max<std::size_t>(20 * base.fluid.particles, 10'000);
  return base;
}

std::string DescribePlacement(const Scene& scene) {
  const Block asked = scene.base.fluid, fluid = Fitted(asked);
  std::string text = fmt::format("placed {} particles", fluid.particles);
  if (fluid.columns > 0) text += fmt::format(" ({} x {})", fluid.columns, fluid.rows);
  if (fluid.particles == asked.particles) return text;
  text += fmt::format(" of {} asked for", asked.particles);
  if (asked.spacing > 0) return text + fmt::format(": with fluid.spacing = {} m no more are inside", asked.spacing);
  text += ", with their mass in all";
  const auto [below, above] = FillingNumbers(asked);
  if (below == 0 && above == 0) return text;
  return text + fmt::format("; nearest numbers that fill the {} exactly: {}{}{}", asked.IsDisk() ? "disk" : "box",
                            below > 0 ? fmt::format("{}", below) : "", below > 0 && above > 0 ? ", " : "",
                            above > 0 ? fmt::format("{}", above) : "");
}

std::unique_ptr<ParticleSystemSPH> MakeSystem(const Scene& scene) {
  const Solver* solver = FindSolver(scene.solver);
  SPH_CHECK(solver != nullptr, "solver '{}'", scene.solver);
  Parameters base = CompleteParameters(scene);
  if (base.given == nullptr) base.start = FindStart(scene, base);
  auto system = solver->make(base, scene.sph);
  system->Reset();
  if (const auto& trouble = system->Trouble()) {
    throw UsageError("{}: the scene cannot start: particle {} at ({:.4g}, {:.4g}) m: {}", scene.name, trouble->id,
                     trouble->position.x, trouble->position.y, trouble->limit);
  }
  return system;
}

Box InitialView(const Scene& scene) {
  if (scene.view.Width() > 0) return scene.view;
  Box box = scene.base.fluid.region.Bounds();
  for (const Wall& wall : scene.base.walls) {
    // A wall that moves is seen wherever it goes.
    double& low = wall.Vertical() ? box.x0 : box.y0;
    double& high = wall.Vertical() ? box.x1 : box.y1;
    low = std::min(low, wall.lowest);
    high = std::max(high, wall.highest);
  }
  const double margin = 0.03 * std::max(box.Width(), box.Height());
  return {box.x0 - margin, box.y0 - margin, box.x1 + margin, box.y1 + margin};
}

}  // namespace sph
