#include "base/shared_work.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sph {
namespace {

TEST(ShareOut, DoesEveryPieceOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    for (const std::size_t count : {0, 1, 2, 7, 1000}) {
      std::vector<std::atomic<int>> done(count);
      ShareOut(count, threads, [&](std::size_t piece) { ++done[piece]; });
      for (const auto& times : done) EXPECT_EQ(times, 1) << count << " pieces, " << threads << " threads";
    }
  }
}

TEST(ShareOut, LetsOthersDoThePiecesOfAThreadThatIsSlow) {
  std::atomic<int> done = 0;
  ShareOut(100, 2, [&](std::size_t piece) {
    ++done;
    // The first piece lasts until all others are done, half of which belong to its own thread.
    while (piece == 0 && done < 100) {
    }
  });
  EXPECT_EQ(done, 100);
}

TEST(ShareOut, ThrowsWhatAPieceThrowsOnceAllAreDone) {
  for (const int threads : {1, 2}) {
    std::atomic<int> done = 0;
    const auto work = [&](std::size_t piece) {
      ++done;
      if (piece == 3) throw std::runtime_error("the fourth");
    };
    EXPECT_THROW(ShareOut(10, threads, work), std::runtime_error);
    EXPECT_EQ(done, 10);
  }
}

}  // namespace
}  // namespace sph
