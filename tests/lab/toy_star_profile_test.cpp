#include "lab/toy_star_profile.hpp"

#include <gtest/gtest.h>

#include "scenes/build.hpp"
#include "scenes/request.hpp"

namespace sph {
namespace {

Scene ToyStarScene(std::size_t particles) {
  SceneRequest request;
  request.scene = "toy-star";
  request.particles = particles;
  return LoadScene(request);
}

TEST(ToyStarProfile, ShowsEveryParticleAndTheExactCurve) {
  const Scene scene = ToyStarScene(200);
  const auto system = MakeSystem(scene);
  for (int step = 0; step < 20; ++step) system->Step();
  system->ComputeFields();
  const ToyStar star = StarOf(scene).value();
  const Plot plot = ToyStarProfile(*system, star);

  ASSERT_EQ(plot.series.size(), 2U);
  const Series& particles = plot.series[0];
  ASSERT_EQ(particles.x.size(), 200U);
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_EQ(particles.x[i], Length(system->State().Position(i)));
    EXPECT_EQ(particles.y[i], system->Density()[i]);
  }
  const Series& exact = plot.series[1];
  EXPECT_EQ(exact.x.back(), star.radius);
  EXPECT_EQ(exact.y.back(), 0);
  EXPECT_DOUBLE_EQ(exact.y.front(), 2 * star.mass / (3.14159265358979324 * star.radius * star.radius));
  EXPECT_NE(plot.x.label.find("[m]"), std::string::npos);
  EXPECT_NE(plot.y.label.find("[kg/m³]"), std::string::npos);
}

// The paper's Figure 3. A plain program of our own, with other random starts, came to 2.3e-3; our first five seeds lie
// between 2.27e-3 and 2.30e-3, so the tolerance is twice their spread.
TEST(ToyStarProfile, SlowFigure3HasTheMeasuredError) {
  const Scene scene = ToyStarScene(3000);
  const auto system = MakeSystem(scene);
  while (system->Time() < scene.until && !system->Trouble()) system->Step();
  ASSERT_FALSE(system->Trouble());
  system->ComputeFields();
  const ToyStar star = StarOf(scene).value();
  const double mse = CompareDensity(star, system->State().x, system->State().y, system->Density()).mse;
  EXPECT_NEAR(mse, 2.285e-3, 0.06e-3);
  const std::string name = ToyStarProfile(*system, star).series[0].name;
  EXPECT_NE(name.find("mean square error 2."), std::string::npos) << name;
  EXPECT_NE(name.find("×10⁻³ kg²/m⁶"), std::string::npos) << name;
}

}  // namespace
}  // namespace sph
