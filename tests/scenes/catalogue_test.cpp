// Every scene of the catalogue can be loaded, seen and run.
#include "scenes/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "base/error.hpp"
#include "particles/diagnostics.hpp"
#include "scenes/build.hpp"
#include "scenes/request.hpp"
#include "scenes/scene_text.hpp"

namespace sph {
namespace {

Scene Load(const std::string& name) {
  SceneRequest request;
  request.scene = name;
  request.threads = 2;
  return LoadScene(request);
}

TEST(Catalogue, HasTheScenesOfTheTwoDocumentsInAlphabeticalOrder) {
  const auto names = SceneNames();
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  for (const char* name : {"dam-break", "mueller", "mueller-published", "toy-star"}) {
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
}

TEST(Catalogue, EverySceneRunsTwentyStepsWithoutTrouble) {
  for (const std::string& name : SceneNames()) {
    const Scene scene = Load(name);
    const auto system = MakeSystem(scene);
    ASSERT_EQ(system->State().Size(), CompleteParameters(scene).fluid.particles) << name;
    for (int k = 0; k < 20; ++k) system->Step();
    EXPECT_FALSE(system->Trouble()) << name << ": " << system->Trouble()->Message();
    EXPECT_EQ(Diagnose(*system).outside, 0u) << name;
  }
}

TEST(Catalogue, EverySceneSaysWhatItIs) {
  for (const std::string& name : SceneNames()) {
    const Scene scene = Load(name);
    EXPECT_EQ(scene.name, name);
    EXPECT_FALSE(scene.title.empty()) << name;
    EXPECT_FALSE(scene.about.empty()) << name;
    EXPECT_EQ(scene.title.find('\n'), std::string::npos) << name << ": one line";
  }
}

TEST(Catalogue, EveryScenesFirstViewContainsItsFluidAndTheBlockToDrop) {
  for (const std::string& name : SceneNames()) {
    const Scene scene = Load(name);
    const Box view = InitialView(scene);
    for (const Box& box : {scene.base.fluid.region.Bounds(), CompleteParameters(scene).drop.region.Bounds()}) {
      EXPECT_TRUE(box.x0 >= view.x0 && box.y0 >= view.y0 && box.x1 <= view.x1 && box.y1 <= view.y1) << name;
    }
  }
}

TEST(Catalogue, EverySceneHasRoomForABlockAtItsStart) {
  for (const std::string& name : SceneNames()) {
    const auto system = MakeSystem(Load(name));
    const Periods& periods = system->parameters_sph.periods;
    // Fluid everywhere, up to a ceiling or to its own images.
    const bool full = periods.in_y || system->InitialBounds().y1 == LegalRegion(system->parameters.walls).y1;
    EXPECT_EQ(system->DropBlock() == "", !full) << name;
  }
}

TEST(Catalogue, FindsAScenesFileByName) {
  EXPECT_EQ(FindScene("toy-star"), AssetsFolder() / "scenes" / "toy-star.toml");
  EXPECT_EQ(FindScene("some/where/else.toml"), "some/where/else.toml");
}

TEST(Catalogue, UnknownSceneIsRefusedWithTheNearestAndAllThatThereAre) {
  try {
    FindScene("dambreak");
    ADD_FAILURE() << "found";
  } catch (const UsageError& error) {
    EXPECT_TRUE(
        Has(error.what(), {"'dambreak'", "Did you mean 'dam-break'?", "mueller-published", "toy-star", ".toml"}));
  }
  EXPECT_THROW(FindScene(""), UsageError);
  EXPECT_THROW(FindScene("../scenes/toy-star"), UsageError);
}

/// $SPHLAB_ASSETS for as long as the object lives.
class AssetsIn {
 public:
  explicit AssetsIn(const std::string& folder) { setenv("SPHLAB_ASSETS", folder.c_str(), 1); }
  ~AssetsIn() { unsetenv("SPHLAB_ASSETS"); }
};

TEST(Catalogue, LooksInTheFolderThatTheEnvironmentNames) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "sphlab-assets";
  std::filesystem::create_directories(folder / "scenes");
  {
    const AssetsIn elsewhere(folder.string());
    EXPECT_TRUE(SceneNames().empty());
    EXPECT_EQ(AssetsFolder(), folder);
  }
  const AssetsIn nowhere("/no/such/folder");
  try {
    SceneNames();
    ADD_FAILURE() << "listed";
  } catch (const TroubleError& error) {
    EXPECT_TRUE(Has(error.what(), {"/no/such/folder", "SPHLAB_ASSETS"}));
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace sph
