// The flows that scenes start with are what they are said to be: without divergence, with the pressure that belongs to
// them.
#include "sph/initial_flow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "sph/given_system.hpp"
#include "sph/quadrature.hpp"
#include "sph/toy_star.hpp"

namespace sph {
namespace {

const InitialFlow& Named(std::string_view name) {
  const auto flows = AllInitialFlows();
  return *std::find_if(flows.begin(), flows.end(), [&](const InitialFlow& flow) { return flow.name == name; });
}

/// A scale in which no length, rate or density is 1.
FlowScale SomeScale() { return {{-0.3, 0.2, 0.5, 1.0}, 1.7, 3.0, 2.4, {0, -9}, 0}; }

/// Points inside, away from the sides.
std::vector<Vec2> PointsOf(const Box& box) {
  std::vector<Vec2> points;
  for (const double a : {0.17, 0.31, 0.5, 0.64, 0.83}) {
    for (const double b : {0.22, 0.45, 0.71}) points.push_back({box.x0 + a * box.Width(), box.y0 + b * box.Height()});
  }
  return points;
}

/// By central differences, exact to delta^2.
struct Derivatives {
  double ux, uy, vx, vy;  // of the velocity [1/s]
  double laplacian;       // of the pressure [Pa/m^2]
};
Derivatives DerivativesOf(const InitialFlow& flow, const FlowScale& scale, Vec2 p) {
  const double delta = 1e-3 * scale.box.Width();
  const auto at = [&](double dx, double dy) { return flow.at(p + delta * Vec2{dx, dy}, scale); };
  const FlowAtPoint left = at(-1, 0), right = at(1, 0), below = at(0, -1), above = at(0, 1);
  const double per = 1 / (2 * delta);
  return {per * (right.velocity.x - left.velocity.x), per * (above.velocity.x - below.velocity.x),
          per * (right.velocity.y - left.velocity.y), per * (above.velocity.y - below.velocity.y),
          (left.pressure + right.pressure + below.pressure + above.pressure - 4 * at(0, 0).pressure) / (delta * delta)};
}

TEST(InitialFlow, OfALiquidHasNoDivergence) {
  const FlowScale scale = SomeScale();
  for (const char* name :
       {"rest", "hydrostatic", "standing-wave", "taylor-green", "shear-wave", "stretching", "rotating-square"}) {
    for (const Vec2 p : PointsOf(scale.box)) {
      const Derivatives d = DerivativesOf(Named(name), scale, p);
      // In a wave the two differences' errors, of (k delta)^2/6 with k delta = 0.006, do not cancel.
      const double tolerance = std::string(name) == "standing-wave" ? 2e-4 : 1e-9;
      EXPECT_NEAR(d.ux + d.vy, 0, tolerance * scale.speed / scale.box.Width()) << name;
    }
  }
}

TEST(InitialFlow, PressureObeysItsPoissonEquation) {
  // The divergence of du_i/dt + u_j d_j u_i = -d_i p/rho + f_i with div u = 0, and div f = -2 lambda of f = -lambda x:
  // lap p = -rho (d_i u_j d_j u_i + 2 lambda). For vortices lambda is 0: they have no centre.
  for (const double central : {0.0, 2.5}) {
    FlowScale scale = SomeScale();
    scale.central = central;
    for (const char* name : {"rest", "hydrostatic", "standing-wave", "taylor-green", "stretching", "rotating-square"}) {
      if (central != 0 && std::string(name) != "stretching") continue;
      for (const Vec2 p : PointsOf(scale.box)) {
        const Derivatives d = DerivativesOf(Named(name), scale, p);
        const double expected = -scale.density * (d.ux * d.ux + 2 * d.uy * d.vx + d.vy * d.vy + 2 * central);
        // The differences' error is (k delta)^2/12; the sine series of the square, cut off after 30 x 30 terms, is
        // 5 % off in its second derivatives, but within 1e-4 in its values.
        const double tolerance = std::string(name) == "rotating-square" ? 0.1 : 1e-4;
        const double size =
            scale.density * (scale.speed * scale.speed / (scale.box.Width() * scale.box.Width()) + central);
        EXPECT_NEAR(d.laplacian, expected, tolerance * 40 * size) << name;
      }
    }
  }
}

TEST(InitialFlow, TaylorGreenRepeatsAndIsAsFastAsTold) {
  const FlowScale scale = SomeScale();
  const InitialFlow& flow = Named("taylor-green");
  double fastest = 0;
  for (const Vec2 p : PointsOf(scale.box)) {
    const FlowAtPoint here = flow.at(p, scale),
                      there = flow.at(p + Vec2{scale.box.Width(), -scale.box.Height()}, scale);
    EXPECT_NEAR(here.velocity.x, there.velocity.x, 1e-13);
    EXPECT_NEAR(here.velocity.y, there.velocity.y, 1e-13);
    EXPECT_NEAR(here.pressure, there.pressure, 1e-13);
  }
  for (int k = 0; k < 400; ++k) {
    const Vec2 p{scale.box.x0 + scale.box.Width() * (k % 20) / 20, scale.box.y0 + scale.box.Height() * (k / 20) / 20};
    fastest = std::max(fastest, Length(flow.at(p, scale).velocity));
  }
  EXPECT_NEAR(fastest, scale.speed, 1e-12);
}

TEST(InitialFlow, StandingWaveKeepsToTheTankAndHasNoPressureOnItsFlatSurface) {
  const FlowScale scale = SomeScale();
  const InitialFlow& flow = Named("standing-wave");
  for (const double a : {0.0, 0.3, 0.8, 1.0}) {
    const FlowAtPoint surface = flow.at({scale.box.x0 + a * scale.box.Width(), scale.box.y1}, scale);
    EXPECT_NEAR(surface.pressure, 0, 1e-12);
    EXPECT_NEAR(surface.velocity.y, -scale.speed * std::cos(2 * std::numbers::pi * a), 1e-12);
    EXPECT_EQ(flow.at({scale.box.x0 + a * scale.box.Width(), scale.box.y0}, scale).velocity.y, 0);
    for (const double x : {scale.box.x0, scale.box.x1}) {
      EXPECT_NEAR(flow.at({x, scale.box.y0 + a * scale.box.Height()}, scale).velocity.x, 0, 1e-12);
    }
  }
}

TEST(InitialFlow, HydrostaticPressureCarriesTheFluidAbove) {
  const FlowScale scale = SomeScale();
  const InitialFlow& flow = Named("hydrostatic");
  EXPECT_EQ(flow.at({0, 1.0}, scale).pressure, 0);
  EXPECT_DOUBLE_EQ(flow.at({0.3, 0.4}, scale).pressure, 3.0 * 9 * 0.6);
}

TEST(InitialFlow, StretchingHasItsSpeedAndNoPressureAtTheRim) {
  FlowScale scale = SomeScale();
  scale.central = 0.7;
  const Vec2 centre = scale.box.Centre();
  const double radius = 0.5 * scale.box.Width();
  for (const double angle : {0.0, 0.4, 2.0, 5.0}) {
    const FlowAtPoint rim = Named("stretching").at(centre + radius * Vec2{std::cos(angle), std::sin(angle)}, scale);
    EXPECT_NEAR(Length(rim.velocity), scale.speed, 1e-12);
    EXPECT_NEAR(rim.pressure, 0, 1e-12);
  }
  EXPECT_GT(Named("stretching").at(centre, scale).pressure, 0);
  EXPECT_LT(Named("stretching").at(centre + Vec2{0.1, 0}, scale).velocity.x, 0);  // it narrows along x
}

TEST(InitialFlow, RotatingSquareHasNoPressureOnItsSidesAndTheKnownOneInItsMiddle) {
  const FlowScale scale = SomeScale();
  const InitialFlow& flow = Named("rotating-square");
  const double w = 2 * scale.speed / 0.8, unit = scale.density * w * w * 0.8 * 0.8;
  // Saint-Venant's torsion of a square shaft has its stress function's greatest value, 0.14734 x side^2, there.
  EXPECT_NEAR(flow.at(scale.box.Centre(), scale).pressure, -0.14734 * unit, 2e-5 * unit);
  for (const double a : {0.1, 0.5, 0.8}) {
    for (const Vec2 p :
         {Vec2{-0.3 + a * 0.8, 0.2}, Vec2{-0.3 + a * 0.8, 1.0}, Vec2{-0.3, 0.2 + a * 0.8}, Vec2{0.5, 0.2 + a * 0.8}}) {
      EXPECT_NEAR(flow.at(p, scale).pressure, 0, 1e-13 * unit);
    }
  }
  const FlowAtPoint middle_of_a_side = flow.at({0.1, 1.0}, scale);
  EXPECT_NEAR(middle_of_a_side.velocity.x, scale.speed, 1e-13);
  EXPECT_NEAR(middle_of_a_side.velocity.y, 0, 1e-13);
}

TEST(InitialFlow, StarHasItsMassAndTheDensityOfTheStaticStar) {
  const FlowScale scale = SomeScale();
  const double radius = 0.5 * scale.box.Width();
  const ToyStar star{scale.mass, radius, 0.1};
  const auto density = [&](double r) { return Named("star").at(scale.box.Centre() + Vec2{0, r}, scale).density; };
  EXPECT_NEAR(Integral([&](double r) { return 2 * std::numbers::pi * r * density(r); }, 0, radius), scale.mass, 1e-13);
  for (const double r : {0.0, 0.1, 0.3, 0.45}) EXPECT_NEAR(density(r), star.Density(r), 1e-12 * star.Density(0)) << r;
}

TEST(InitialFlow, BreathingAndEllipticStarsMoveInProportionToTheRadiusAndTheStarAtRestNot) {
  const FlowScale scale = SomeScale();
  const Vec2 centre = scale.box.Centre(), at{0.12, -0.2};
  const Vec2 velocity = Named("breathing-star").at(centre + at, scale).velocity;
  EXPECT_NEAR(velocity.x, scale.speed * at.x / 0.4, 1e-14);
  EXPECT_NEAR(velocity.y, scale.speed * at.y / 0.4, 1e-14);
  EXPECT_EQ(Named("elliptic-star").at(centre + at, scale).velocity, (Vec2{velocity.x, -velocity.y}));
  EXPECT_EQ(Named("elliptic-star").at(centre + at, scale).density, Named("star").at(centre + at, scale).density);
  EXPECT_EQ(Named("star").at(centre + at, scale).velocity, Vec2{});
}

TEST(InitialFlow, IsScaledToTheSystemsOwnRegionSpeedAndForces) {
  Parameters base = NoForces();
  base.fluid.region = {{}, {0.2, 0.1}, 0.5};
  base.central_force = 3;
  ParametersSPH liquid;
  liquid.smoothing_length = kCloudH;
  liquid.equation_of_state = IdealGas{400, 2.5};
  liquid.flow = &Named("stretching");
  liquid.flow_speed = 0.5;
  Cloud one;
  one.x = one.y = one.vx = one.vy = {0};
  one.mass = {1};
  const GivenSystem system(base, liquid, one);
  // p = rho/2 (A^2 + lambda) R^2 in the centre, A = 1/s.
  EXPECT_DOUBLE_EQ(system.FlowAt({0.2, 0.1}).pressure, 0.5 * 2.5 * (1 + 3) * 0.25);
  EXPECT_DOUBLE_EQ(system.FlowAt({0.7, 0.1}).velocity.x, -0.5);
}

}  // namespace
}  // namespace sph
