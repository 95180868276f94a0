// Surface tension: the passes on vectors against the sums over all pairs; and what is known of disks and bubbles.
#include "sph/surface_tension.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "sph/delta.hpp"
#include "sph/given_system.hpp"
#include "sph/plain_delta_twins.hpp"

namespace sph {
namespace {

using std::numbers::pi;
constexpr double kSupport = 2 * kCloudH;

/// What the passes read and write, in double.
struct Surface {
  std::vector<double> normal_x, normal_y, part, weight, depth;
};

/// Poly6 of support R, and its gradient over the displacement.
double Colour(double r) { return Poly6(kSupport).Value(r); }
double ColourSlope(double r) {
  const double rest = std::max(0.0, 1 - r * r / (kSupport * kSupport));
  return -24 / (pi * std::pow(kSupport, 4)) * rest * rest;
}

template <typename Real>
class SurfaceTension : public testing::Test {};
using BothPrecisions = testing::Types<float, double>;
TYPED_TEST_SUITE(SurfaceTension, BothPrecisions);

TYPED_TEST(SurfaceTension, FindsTheSurfaceLikeTheSumOverAllPairs) {
  WithEveryInstructionSet([] {
    for (const Cloud& given : AllClouds()) {
      auto found = FindNeighbours<TypeParam>(given, kSupport);
      const Cloud& cloud = found.cloud;
      const std::size_t n = cloud.Size();
      std::vector<TypeParam> volume(cloud.mass.begin(), cloud.mass.end());
      volume.resize(n + kPadding);
      SurfaceArrays<TypeParam> arrays;
      for (auto* values : arrays.All()) values->resize(n + kPadding);
      for (const ListBlock& block : found.search.Blocks()) {
        ComputeSurface(found.Input(), volume.data(), block, arrays);
      }
      for (std::size_t i = 0; i < n; ++i) {
        double colour = 0, size = 0;
        Vec2 gradient;
        for (std::size_t j = 0; j < n; ++j) {
          const Vec2 d{cloud.x[i] - cloud.x[j], cloud.y[i] - cloud.y[j]};
          colour += cloud.mass[j] * Colour(Length(d));
          gradient = gradient + cloud.mass[j] * ColourSlope(Length(d)) * d;
          size += cloud.mass[j] * std::abs(ColourSlope(Length(d))) * Length(d);
        }
        const double tolerance = 4 * kTolerance<TypeParam>;
        // From 0.9 to 0.97 the part falls by a cubic, whose slope is at most 1.5/0.07.
        const double fall = std::clamp((0.97 - colour) / 0.07, 0.0, 1.0);
        const double part = fall * fall * (3 - 2 * fall);
        ASSERT_NEAR(arrays.part[i], part, 22 * tolerance * colour) << cloud.name << ", " << i;
        ASSERT_NEAR(arrays.weight[i], part * cloud.mass[i], 22 * tolerance * colour * cloud.mass[i]) << cloud.name;
        const double above = std::clamp(colour - 0.5, 0.0, 0.5);
        const double depth = kSupport * above / (128 / (35 * pi) * (1 - above * above));
        ASSERT_NEAR(arrays.depth[i], depth, 2 * tolerance * kSupport * std::max(1.0, colour)) << cloud.name;
        if (!(Length(gradient) > 1e-3 * size)) continue;  // its direction is round-off
        const double blur = 4 * tolerance * size / Length(gradient);
        ASSERT_NEAR(arrays.normal_x[i], gradient.x / Length(gradient), blur) << cloud.name << ", " << i;
        ASSERT_NEAR(arrays.normal_y[i], gradient.y / Length(gradient), blur) << cloud.name << ", " << i;
      }
    }
  });
}

/// The acceleration of particle i over 2 sigma/(rho f), f being the method's own factor, and how well it is known:
/// determinant over trace^2.
struct PlainTension {
  Vec2 value;
  double size = 0;
  double known = 0;
};
PlainTension TensionOf(const Cloud& cloud, const Surface& s, SmoothingKernel kernel, std::size_t i) {
  double xx = 0, xy = 0, yy = 0, turn_xx = 0, turn_across = 0, turn_yy = 0, size = 0;
  Vec2 lack;
  for (std::size_t j = 0; j < cloud.Size(); ++j) {
    const Vec2 d{cloud.x[i] - cloud.x[j], cloud.y[i] - cloud.y[j]};
    if (Length(d) >= kSupport) continue;
    const double w = -s.weight[j] * ColourSlope(Length(d));
    const Vec2 turn{s.normal_x[i] - s.normal_x[j], s.normal_y[i] - s.normal_y[j]};
    xx += w * d.x * d.x;
    xy += w * d.x * d.y;
    yy += w * d.y * d.y;
    turn_xx += w * turn.x * d.x;
    turn_across += w * (turn.x * d.y + turn.y * d.x);
    turn_yy += w * turn.y * d.y;
    const double slope = cloud.mass[j] * GradientAt(kernel, kCloudH, Length(d));
    lack = lack + slope * d;
    size += std::abs(slope) * Length(d);
  }
  const double determinant = xx * yy - xy * xy, square = (xx + yy) * (xx + yy);
  if (!(determinant > 1e-4 * square)) return {{}, size, square > 0 ? determinant / square : 0};
  const double divergence = (yy * turn_xx - xy * turn_across + xx * turn_yy) / determinant;
  const double inside = std::clamp(-divergence, -4 / kSupport, 4 / kSupport);
  const double curvature = inside / std::max(0.5, 1 + inside * s.depth[i]);
  return {s.part[i] * curvature * lack, size, determinant / square};
}

TYPED_TEST(SurfaceTension, PushesLikeTheSumOverAllPairs) {
  WithEveryInstructionSet([] {
    for (const Cloud& given : AllClouds()) {
      for (const SmoothingKernel kernel : kAllKernels) {
        auto found = FindNeighbours<TypeParam>(given, kSupport);
        const Cloud& cloud = found.cloud;
        const std::size_t n = cloud.Size();
        Random random(5);
        Surface s;
        for (std::size_t i = 0; i < n; ++i) {
          const double angle = random.Uniform(0, 2 * pi);
          s.normal_x.push_back(std::cos(angle));
          s.normal_y.push_back(std::sin(angle));
          s.part.push_back(i % 3 == 0 ? 0 : random.Uniform(0, 1));
          s.weight.push_back(s.part[i] * cloud.mass[i]);
          s.depth.push_back(random.Uniform(0, 0.5 * kSupport));
        }
        const auto converted = [&](const std::vector<double>& values) {
          std::vector<TypeParam> result(values.begin(), values.end());
          result.resize(n + kPadding);
          return result;
        };
        const SurfaceArrays<TypeParam> arrays{converted(s.normal_x), converted(s.normal_y), converted(s.part),
                                              converted(s.weight), converted(s.depth)};
        const auto volume = converted(cloud.mass), density = converted(std::vector<double>(n, 2.0));
        std::vector<double> ax(n + kPadding), ay(n + kPadding);
        for (const ListBlock& block : found.search.Blocks()) {
          AddSurfaceTension(found.Input(), {kernel, &arrays, volume.data(), density.data(), 3.0}, block, ax.data(),
                            ay.data());
        }
        // The factor that makes up for what s leaves out is the same for all: from the greatest acceleration.
        std::vector<PlainTension> plain;
        std::size_t greatest = 0;
        for (std::size_t i = 0; i < n; ++i) {
          plain.push_back(TensionOf(cloud, s, kernel, i));
          if (plain[i].known > 0.05 && Length(plain[i].value) > Length(plain[greatest].value)) greatest = i;
        }
        if (n == 0 || !(Length(plain[greatest].value) > 0)) continue;
        const double factor = std::hypot(ax[greatest], ay[greatest]) / Length(plain[greatest].value);
        EXPECT_NEAR(factor, 2 * 3.0 / 2.0, 0.2 * 3.0) << cloud.name;  // 1.03 for Wendland C4, 1.1 for C2
        for (std::size_t i = 0; i < n; ++i) {
          if (plain[i].known < 0.05) continue;  // what a difference of nearly equal numbers is divided by
          const double bound = 400 * kTolerance<TypeParam> * factor * plain[i].size * 4 / kSupport;
          ASSERT_NEAR(ax[i], factor * plain[i].value.x, bound) << cloud.name << ", " << i;
          ASSERT_NEAR(ay[i], factor * plain[i].value.y, bound) << cloud.name << ", " << i;
        }
      }
    }
  });
}

constexpr double kSpacing = 0.04;  // [m]

/// Water without motion or weight on a lattice, with a surface tension of 1 N.
struct TenseWater {
  Parameters base = NoForces();
  ParametersSPH sph;

  /// Particles at the lattice points, half a spacing from both axes, that the region has.
  explicit TenseWater(bool (*has)(Vec2 point)) {
    GivenStart start;
    for (int row = -20; row < 20; ++row) {
      for (int column = -20; column < 20; ++column) {
        const Vec2 point{(column + 0.5) * kSpacing, (row + 0.5) * kSpacing};
        if (!has(point)) continue;
        start.particles.Add(point, {}, kSpacing * kSpacing);
      }
    }
    base.given = std::make_shared<const GivenStart>(std::move(start));
    base.particle_mass = kSpacing * kSpacing;
    base.fluid.spacing = kSpacing;
    base.time_step = 1e-3;
    base.threads = 1;
    sph.smoothing_length = 2 * kSpacing;
    sph.equation_of_state = IdealGas{400, 1};
    sph.delta.kernel = SmoothingKernel::kWendlandC4;
    sph.delta.surface_tension = 1;
  }
};

Vec2 AccelerationOf(const ParticleSystem& system, std::size_t i) {
  return {system.State().ax[i], system.State().ay[i]};
}

bool InDisk(Vec2 point) { return Length(point) < 0.7; }

TEST(TensionOfWater, LeavesAStraightSurfaceAloneAndPullsCornersIn) {
  const TenseWater water([](Vec2 point) { return std::max(std::abs(point.x), std::abs(point.y)) < 0.6; });
  Delta system(water.base, water.sph);
  system.Reset();
  system.ComputeFields();
  const Particles& p = system.State();
  int corners = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const Vec2 a = AccelerationOf(system, i);
    const double least = std::min(std::abs(p.x[i]), std::abs(p.y[i]));
    // Beyond the reach of a corner's normals: two supports.
    if (least < 0.6 - 4 * system.Support() / 2 - kSpacing) {
      EXPECT_LT(Length(a), 1e-9) << p.x[i] << ", " << p.y[i];
    }
    if (least < 0.57) continue;
    ++corners;
    EXPECT_LT(Dot(a, p.Position(i)), -1) << p.x[i] << ", " << p.y[i];
  }
  EXPECT_EQ(corners, 4);
}

TEST(TensionOfWater, HasAPlaneWallForAMirror) {
  const TenseWater whole(InDisk);
  TenseWater half([](Vec2 point) { return InDisk(point) && point.y > 0; });
  half.base.wall.kind = WallKind::kMirror;
  half.base.walls = {{.name = "floor", .fluid = FluidSide::kAbove, .at = 0}};
  Delta disk(whole.base, whole.sph), dome(half.base, half.sph);
  for (Delta* system : {&disk, &dome}) {
    system->Reset();
    system->ComputeFields();
  }
  double greatest = 0;
  for (std::size_t i = 0; i < dome.State().Size(); ++i) {
    const Vec2 at = dome.State().Position(i);
    std::size_t same = 0;
    while (Length(disk.State().Position(same) - at) > 1e-9) ++same;
    EXPECT_LT(Length(AccelerationOf(dome, i) - AccelerationOf(disk, same)), 1e-9) << at.x << ", " << at.y;
    greatest = std::max(greatest, Length(AccelerationOf(dome, i)));
  }
  EXPECT_GT(greatest, 1);
}

TEST(TensionOfWater, HasThePressureOfLaplaceInADropThatHasComeToRest) {
  TenseWater water(InDisk);
  water.base.motion_damping = 5;
  water.sph.delta.sound_damping = 0.1;
  Delta system(water.base, water.sph);
  system.Reset();
  while (system.Time() < 1.5 && !system.Trouble()) system.Step();
  ASSERT_FALSE(system.Trouble());
  const std::vector<double> pressures = system.Pressure();
  const double radius = std::sqrt(static_cast<double>(pressures.size()) * kSpacing * kSpacing / pi);
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    if (Length(system.State().Position(i)) > 0.3) continue;
    sum += pressures[i];
    ++count;
  }
  EXPECT_NEAR(sum / count * radius, 1, 0.1);  // 17 spacings in the radius
}

TEST(TensionOfWater, IsStableWithTheLongestStepThatIsAdvised) {
  TenseWater water(InDisk);
  water.sph.delta.surface_tension = 2;  // so much that it limits the step
  Delta system(water.base, water.sph);
  system.Reset();
  system.parameters.adaptive_step = true;
  const double longest = LongestTensionStep(system.Support(), 1, 2);
  for (int k = 0; k < 300 && !system.Trouble(); ++k) system.Step();
  EXPECT_FALSE(system.Trouble());
  EXPECT_LT(system.Time(), 300 * longest);
}

}  // namespace
}  // namespace sph
