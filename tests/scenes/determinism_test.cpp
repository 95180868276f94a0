// Same scene, seed and build: same bits, whatever the number of threads.
#include <gtest/gtest.h>

#include "particles/diagnostics.hpp"
#include "scenes/build.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/request.hpp"

namespace sph {
namespace {

std::uint64_t HashAfter(int steps, const SceneRequest& request) {
  const auto system = MakeSystem(LoadScene(request));
  for (int k = 0; k < steps; ++k) system->Step();
  EXPECT_FALSE(system->Trouble()) << request.scene << ": " << system->Trouble()->Message();
  return Diagnose(*system).state_hash;
}

SceneRequest Request(const std::string& scene, std::size_t particles, int threads) {
  SceneRequest request;
  request.scene = scene;
  request.particles = particles;
  request.threads = threads;
  return request;
}

/// The hashes of several numbers of threads against that of one.
void ExpectSameBits(const std::vector<std::string>& scenes, std::size_t particles, int steps,
                    const std::vector<int>& numbers = {2, 3, 8}) {
  for (const std::string& scene : scenes) {
    const std::uint64_t one = HashAfter(steps, Request(scene, particles, 1));
    for (const int threads : numbers) {
      EXPECT_EQ(HashAfter(steps, Request(scene, particles, threads)), one) << scene << ", " << threads << " threads";
    }
  }
}

// 1600 particles are seven blocks: enough for work to be shared out.
TEST(Determinism, EverySceneGivesTheSameBitsWithAnyNumberOfThreads) { ExpectSameBits(SceneNames(), 1600, 50); }

// 40 000 particles in a tank have more than three blocks of wall particles: enough for work to be shared out.
TEST(Determinism, WallParticlesGiveTheSameBitsWithAnyNumberOfThreads) {
  const auto hash = [](int threads) {
    SceneRequest request = Request("still-water", 40'000, threads);
    request.settings = {"walls.kind=particles"};
    return HashAfter(5, request);
  };
  const std::uint64_t one = hash(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(hash(threads), one) << threads << " threads";
}

// What ThreadSanitizer runs, under which all scenes take ten minutes: one scene a solver, and one with images.
TEST(Determinism, EverySolverGivesTheSameBitsWithTwoThreads) {
  ExpectSameBits({"toy-star", "mueller", "water-column", "taylor-green"}, 1600, 10, {2});
}

// More than 10 000 particles: the integration is shared out, too.
TEST(Determinism, SlowManyParticlesGiveTheSameBitsWithAnyNumberOfThreads) { ExpectSameBits(SceneNames(), 10500, 10); }

TEST(Determinism, EverySceneGivesTheSameBitsTwiceAndOthersWithAnotherSeed) {
  for (const std::string& scene : SceneNames()) {
    SceneRequest request = Request(scene, 1600, 2);
    const std::uint64_t first = HashAfter(50, request);
    EXPECT_EQ(HashAfter(50, request), first) << scene;
    request.seed = 2;
    const Arrangement arrange = LoadScene(request).base.fluid.arrange;
    const bool has_chance = arrange != Arrangement::kLattice && arrange != Arrangement::kHexagonal;
    EXPECT_EQ(HashAfter(50, request) != first, has_chance) << scene;
  }
}

TEST(Determinism, ResetGivesTheSameBitsAsANewSystem) {
  for (const std::string& scene : SceneNames()) {
    const SceneRequest request = Request(scene, 1600, 2);
    const auto system = MakeSystem(LoadScene(request));
    for (int k = 0; k < 10; ++k) system->Step();
    system->DropBlock();
    for (int k = 0; k < 10; ++k) system->Step();
    system->Reset();
    for (int k = 0; k < 50; ++k) system->Step();
    EXPECT_EQ(Diagnose(*system).state_hash, HashAfter(50, request)) << scene;
  }
}

TEST(Determinism, ADropFallsTheSameWayWithAnyNumberOfThreads) {
  std::uint64_t one = 0;
  for (const int threads : {1, 2, 8}) {
    const auto system = MakeSystem(LoadScene(Request("toy-star", 1600, threads)));
    for (int k = 0; k < 10; ++k) system->Step();
    ASSERT_EQ(system->DropBlock(), "");
    for (int k = 0; k < 10; ++k) system->Step();
    const std::uint64_t hash = Diagnose(*system).state_hash;
    if (threads == 1) one = hash;
    EXPECT_EQ(hash, one) << threads;
  }
}

}  // namespace
}  // namespace sph
