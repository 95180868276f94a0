// Judgements of snapshots: exact ones have no error, wrong ones the error that was put in.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/reference_data.hpp"
#include "lab/verification.hpp"
#include "scenes/build.hpp"

namespace sph {
namespace {

using std::numbers::pi;

std::unique_ptr<ParticleSystemSPH> FlowOf(const std::string& name) {
  const VerificationCase& of = *std::ranges::find(AllVerificationCases(), name, &VerificationCase::name);
  SceneRequest request = of.request;
  request.particles = 900;
  return MakeSystem(LoadScene(request));
}

/// Particles on a lattice of n x n in the box, with what `add` makes of their places.
template <typename At>
FlowSnapshot Lattice(int n, const Box& box, double time, At at) {
  FlowSnapshot snapshot{.time = time};
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const Vec2 place = {box.x0 + (column + 0.5) / n * box.Width(), box.y0 + (row + 0.5) / n * box.Height()};
      const auto [velocity, pressure] = at(place);
      snapshot.particles.Add(place, velocity, box.Width() * box.Height() / (n * n));
      snapshot.pressure.push_back(pressure);
    }
  }
  return snapshot;
}

using State = std::pair<Vec2, double>;

TEST(TaylorGreenJudgement, FindsTheErrorThatIsPutIn) {
  const auto flow = FlowOf("taylor-green");
  const auto vortices = [](double t, double speed_factor, double pressure_factor) {
    const double decay = std::exp(-8 * pi * pi / 100 * t);
    return [=](Vec2 at) {
      const double x = 2 * pi * at.x, y = 2 * pi * at.y;
      const Vec2 velocity = {-std::cos(x) * std::sin(y), std::sin(x) * std::cos(y)};
      const double pressure = -0.25 * (std::cos(2 * x) + std::cos(2 * y));
      return State{decay * speed_factor * velocity, decay * decay * pressure_factor * pressure + 7};
    };
  };
  const Box box{0, 0, 1, 1};
  const std::vector<FlowSnapshot> snapshots = {Lattice(20, box, 0.5, vortices(0.5, 1, 1)),
                                               Lattice(20, box, 1.003, vortices(1.003, 1.02, 1))};
  const auto verdicts = kTaylorGreen.judge(*flow, snapshots);
  EXPECT_NEAR(verdicts[0].value, 0.02, 1e-12);
  EXPECT_NEAR(verdicts[1].value, 0, 1e-12) << "whatever the mean pressure is";
}

TEST(EllipticDropJudgement, KnowsTheAxisAtAnyTime) {
  const auto flow = FlowOf("elliptic-drop");
  // b at these times, and 1.944517 at the end [J. J. Monaghan, J. Comput. Phys. 110 (1994) 399].
  for (const Vec2 known : {Vec2{0.0008, 1.083103}, Vec2{0.0038, 1.439219}, Vec2{0.0076, 1.944517}}) {
    const auto still = [](Vec2) { return State{{1, 0}, 0.0}; };
    const FlowSnapshot start = Lattice(10, {-1, -1, 1, 1}, 0, still);
    FlowSnapshot end = start;
    end.time = known.x;
    for (double& y : end.particles.y) y *= known.y;
    for (double& u : end.particles.vx) u *= std::sqrt(0.9);
    const auto verdicts = kEllipticDrop.judge(*flow, std::vector{start, end});
    EXPECT_LT(std::abs(verdicts[0].value), 5e-7);
    EXPECT_NEAR(verdicts[1].value, -0.1, 1e-12) << "lost";
  }
}

TEST(StillWaterJudgement, FindsTheErrorThatIsPutIn) {
  const auto flow = FlowOf("still-water");
  constexpr double kSound2 = 360, kHeight = 0.9;  // rho = 1000 exp((H - y)/c^2)
  const auto rest = [](Vec2 at) {
    return State{{0.01, 0}, 1000 * kSound2 * std::expm1((kHeight - at.y) / kSound2) + 9};
  };
  FlowSnapshot now = Lattice(30, {0, 0, 2, kHeight}, 2, rest);
  for (double& mass : now.particles.mass) mass *= 1000 * kSound2 * std::expm1(kHeight / kSound2) / kHeight;
  const auto verdicts = kStillWater.judge(*flow, std::vector{now});
  EXPECT_NEAR(verdicts[0].value, 0.01, 1e-5) << "the surface is told to the second order in g H/c^2";
  EXPECT_NEAR(verdicts[1].value, 0.5 * 1e-4 / kHeight, 1e-9);
}

TEST(PoiseuilleJudgement, FindsTheParabolaAtTheEndAndRestAtTheStart) {
  const auto flow = FlowOf("poiseuille");
  const auto parabola = [](Vec2 at) { return State{{1.02 * 4 * at.y * (1 - at.y), 0}, 0.0}; };
  const auto rest = [](Vec2) { return State{{0, 0}, 0.0}; };
  const Box box{0, 0, 2.0 / 3, 1};
  const auto late = kPoiseuille.judge(*flow, std::vector{Lattice(200, box, 100, parabola)});
  EXPECT_NEAR(late[0].value, 0.02 * std::sqrt(8.0 / 15), 1e-5);  // the mean square of the parabola is 8/15
  EXPECT_LT(kPoiseuille.judge(*flow, std::vector{Lattice(200, box, 0, rest)})[0].value, 1e-4);
}

TEST(WaterColumnJudgement, FindsTheErrorThatIsPutIn) {
  const auto flow = FlowOf("water-column");
  std::vector<FlowSnapshot> snapshots;
  for (const Vec2 point : ReadReference("koshizuka_oka1996_front_mps")) {
    if (point.y > 3.95) break;
    FlowSnapshot snapshot;
    snapshot.particles.Add({point.y - 0.005 + 0.03, 0}, {}, 0.1);  // a particle of 0.01 m
    snapshot.particles.Add({0.5, 0}, {}, 0.1);
    snapshots.push_back(snapshot);
  }
  ASSERT_EQ(snapshots.size(), kWaterColumn.times(*flow).size());
  EXPECT_NEAR(kWaterColumn.judge(*flow, snapshots)[0].value, 0.03, 1e-12);
}

TEST(CavityJudgement, FindsTheErrorThatIsPutIn) {
  const auto flow = FlowOf("still-water");  // only its support and the width of its fluid are looked at
  flow->parameters.fluid.region.box = {0, 0, 1, 1};
  const auto linear = [](Vec2 at) { return State{{at.y - 0.3, 0.1 - at.x}, 0.0}; };
  const auto verdicts = kCavity.judge(*flow, std::vector{Lattice(40, {0, 0, 1, 1}, 25, linear)});
  double squares = 0, greatest = 0;
  int points = 0;
  for (const Vec2 point : ReadReference("ghia1982_u_x0.5")) {
    if (point.x <= 0 || point.x >= 1) continue;
    const double error = point.x - 0.3 - point.y;
    squares += error * error;
    greatest = std::max(greatest, std::abs(error));
    ++points;
  }
  EXPECT_EQ(points, 15);
  EXPECT_NEAR(verdicts[0].value, std::sqrt(squares / points), 1e-12);
  EXPECT_NEAR(verdicts[2].value, greatest, 1e-12);
  EXPECT_GT(verdicts[1].value, 0.3) << "v is not that";
}

TEST(Judgement, OfARunThatBrokeDownHoldsNothing) {
  for (const auto& [name, judgement] : {std::pair{"taylor-green", &kTaylorGreen},
                                        {"elliptic-drop", &kEllipticDrop},
                                        {"still-water", &kStillWater},
                                        {"poiseuille", &kPoiseuille},
                                        {"water-column", &kWaterColumn},
                                        {"still-water", &kCavity}}) {
    for (const Verdict& verdict : judgement->judge(*FlowOf(name), {})) EXPECT_FALSE(verdict.WithinBar()) << name;
  }
}

}  // namespace
}  // namespace sph
