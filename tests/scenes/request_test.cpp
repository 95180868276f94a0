// What a command line asks for reaches the scene.
#include "scenes/request.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "scenes/build.hpp"
#include "scenes/scene_text.hpp"

namespace sph {
namespace {

TEST(LoadScene, WithoutWishesIsTheDamBreak) { EXPECT_EQ(LoadScene({}).name, "dam-break"); }

TEST(LoadScene, GrantsEveryWish) {
  const TextFile file(kScene);
  SceneRequest request;
  request.scene = file.Path().string();
  request.settings = {"forces.damping=3", "solver=paper"};
  request.solver = "mueller";
  request.particles = 400;
  request.seed = 42;
  request.threads = 5;
  const Scene scene = LoadScene(request);
  EXPECT_EQ(scene.base.motion_damping, 3);
  EXPECT_EQ(scene.solver, "mueller") << "--solver goes before --set solver";
  EXPECT_EQ(scene.base.fluid.particles, 400u);
  EXPECT_DOUBLE_EQ(scene.sph.smoothing_length, 1.75 * 0.05) << "usual for that solver; the file's is another's";
  EXPECT_EQ(scene.base.seed, 42u);
  EXPECT_EQ(scene.base.threads, 5);
}

TEST(LoadScene, RescalesWhatTheSettingsMake) {
  const TextFile file(kScene);
  SceneRequest request;
  request.scene = file.Path().string();
  request.settings = {"method.smoothing_length=0.3", "fluid.particles=200"};
  request.particles = 800;
  EXPECT_EQ(LoadScene(request).sph.smoothing_length, 0.15);
}

TEST(LoadScene, RefusesAnUnknownSolverWithTheNearest) {
  SceneRequest request;
  request.solver = "muller";
  try {
    LoadScene(request);
    ADD_FAILURE() << "accepted";
  } catch (const UsageError& error) {
    EXPECT_TRUE(Has(error.what(), {"solver", "'muller'", "Did you mean 'mueller'?"}));
  }
}

TEST(LoadScene, RefusesSoFewParticlesThatThePeriodIsTooShort) {
  SceneRequest request;
  request.scene = "taylor-green";
  request.particles = 100;
  try {
    LoadScene(request);
    FAIL() << "accepted";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("--particles 100: periodic.box"), std::string::npos) << error.what();
  }
}

TEST(TransferRequest, ReadsNoMoreAndNoFewerParticlesThanACommandLine) {
  const auto reads = [](std::size_t particles) {
    SceneRequest saved, read;
    saved.particles = particles;
    std::vector<std::byte> bytes;
    Archive writer = Archive::Writer(bytes, Archive::Extent::kSameBits);
    TransferRequest(writer, saved);
    Archive reader = Archive::Reader(bytes, Archive::Extent::kSameBits);
    TransferRequest(reader, read);
    EXPECT_EQ(read.particles, particles);
  };
  reads(1);
  reads(kMostParticles);
  EXPECT_THROW(reads(0), TroubleError);
  EXPECT_THROW(reads(kMostParticles + 1), TroubleError);
}

}  // namespace
}  // namespace sph
