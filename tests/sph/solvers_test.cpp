// The table of solvers, and what every solver in it owes its users.
#include "sph/solvers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "particles/diagnostics.hpp"
#include "sph/given_system.hpp"

namespace sph {
namespace {

/// A small drop of fluid that stretches, with no forces from outside. `h` is such that either meaning of it gives
/// neighbours.
std::unique_ptr<ParticleSystemSPH> MakeDrop(const Solver& solver) {
  Parameters base = NoForces();
  base.fluid = {300, {{0, 0, 0.6, 0.5}, {}, 0}, Arrangement::kRandom, 0, 0, {0.1, 0.2}};
  base.particle_mass = 1e-3;
  ParametersSPH water{0.07, IdealGas{1.0, 1.0}, 0.01, false};
  water.delta.tensile_control = false;  // which costs conservation
  water.flow = &*std::ranges::find(AllInitialFlows(), "stretching", &InitialFlow::name);
  water.flow_speed = 0.3;
  auto system = solver.make(base, water);
  system->Reset();
  return system;
}

TEST(Solvers, AreFoundByTheirNamesWhichAreAllDifferent) {
  std::set<std::string> names;
  for (const Solver& solver : AllSolvers()) {
    EXPECT_EQ(FindSolver(solver.name), &solver);
    EXPECT_TRUE(names.insert(solver.name).second) << solver.name;
    EXPECT_FALSE(solver.what.empty()) << solver.name;
  }
  EXPECT_EQ(FindSolver("no such solver"), nullptr);
}

TEST(Solvers, OfThePaperAndTheTutorialAreThere) {
  EXPECT_NE(FindSolver("paper"), nullptr);
  EXPECT_NE(FindSolver("mueller"), nullptr);
}

TEST(Solvers, ConserveLinearMomentum) {
  for (const Solver& solver : AllSolvers()) {
    const auto system = MakeDrop(solver);
    const auto momentum = [&] {
      Vec2 sum;
      const Particles& p = system->State();
      for (std::size_t i = 0; i < p.Size(); ++i) sum = sum + p.mass[i] * Vec2{p.vx_prev[i], p.vy_prev[i]};
      return sum;
    };
    const Vec2 start = momentum();
    for (int k = 0; k < 100; ++k) system->Step();
    ASSERT_FALSE(system->Trouble()) << solver.name << ": " << system->Trouble()->Message();
    EXPECT_GT(Diagnose(*system).max_speed, 0.25) << solver.name << ": nothing has happened";
    // 300 particles' round-off of 1e-16 times a mass of 1e-3 and a speed of about 1, over 100 steps: 3e-15.
    EXPECT_LT(Length(momentum() - start), 1e-14) << solver.name;
  }
}

TEST(Solvers, PlanNamesThePassesOnceAndSaysWhyEachRunsOrNot) {
  for (const Solver& solver : AllSolvers()) {
    std::set<std::string> names;
    for (const PassPlan& pass : MakeDrop(solver)->Plan()) {
      EXPECT_TRUE(names.insert(pass.name).second) << solver.name << ": " << pass.name;
      EXPECT_FALSE(pass.reason.empty()) << solver.name << ": " << pass.name;
      if (pass.name == "walls" || pass.name == "gravity" || pass.name == "motion damping") {
        EXPECT_FALSE(pass.runs) << solver.name << ": " << pass.name << " costs nothing in a scene without it";
      }
    }
    EXPECT_TRUE(names.contains("grid") && names.contains("density") && names.contains("integrate")) << solver.name;
  }
}

TEST(Solvers, TimeThePhasesThatTheyRun) {
  for (const Solver& solver : AllSolvers()) {
    const auto system = MakeDrop(solver);
    system->Step();
    system->Step();  // a liquid's density follows from a step
    for (const char* phase : {"grid", "density", "integrate"}) {
      EXPECT_TRUE(system->Phases().Seconds().contains(phase)) << solver.name << ": " << phase;
    }
    EXPECT_FALSE(system->Phases().Seconds().contains("walls")) << solver.name;
  }
}

TEST(Solvers, NameTheirKernelAndASupportThatFollowsTheSmoothingLength) {
  for (const Solver& solver : AllSolvers()) {
    const auto system = MakeDrop(solver);
    EXPECT_FALSE(system->KernelName().empty()) << solver.name;
    const double support = system->Support();
    system->parameters_sph.smoothing_length *= 2;
    EXPECT_DOUBLE_EQ(system->Support(), 2 * support) << solver.name;
  }
}

}  // namespace
}  // namespace sph
