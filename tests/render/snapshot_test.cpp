#include "render/snapshot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace sph {
namespace {

/// Notes each call, and where its numbers were.
class Listener final : public Canvas {
 public:
  explicit Listener(Colouring colouring) : colouring_(colouring) {}
  Colouring WantedColouring() const override { return colouring_; }
  void DrawDisks(std::span<const double> x, std::span<const double> y, double radius,
                 std::span<const double> values) override {
    calls.push_back({{x.begin(), x.end()}, {y.begin(), y.end()}, {values.begin(), values.end()}, {radius}});
    places.push_back(x.data());
  }
  void DrawWall(Vec2 a, Vec2 b) override { calls.push_back({{a.x, a.y}, {b.x, b.y}}); }

  std::vector<std::vector<std::vector<double>>> calls;
  std::vector<const double*> places;

 private:
  Colouring colouring_;
};

const std::vector<double> kX = {0.1, 1.0 / 3, -2e-300};
const std::vector<double> kY = {5, 1e300, -0.0};
const std::vector<double> kValues = {3, std::numeric_limits<double>::infinity(), 0.1};

void DrawSome(Canvas& canvas) {
  canvas.DrawDisks(kX, kY, 0.7, kValues);
  canvas.DrawDisks(std::span(kY).first(2), std::span(kX).first(2), 0.2, {});
  canvas.DrawDisks({}, {}, 0.1, {});
  canvas.DrawDisks(kY, kX, 0.3, kX);
  canvas.DrawWall({1, 2}, {3, 4});
  canvas.DrawWall({0.1, 0.2}, {0.3, 0.4});
}

TEST(Snapshot, DrawsNumberForNumberWhatWasDrawnOnIt) {
  Listener direct(Colouring::kSpeed);
  DrawSome(direct);
  Snapshot snapshot;
  snapshot.Begin(Colouring::kSpeed);
  EXPECT_EQ(snapshot.WantedColouring(), Colouring::kSpeed);
  DrawSome(snapshot);
  for (int time = 0; time < 2; ++time) {
    Listener later(Colouring::kSpeed);
    snapshot.DrawOn(later);
    EXPECT_EQ(later.calls, direct.calls);
  }
}

TEST(Snapshot, ForgetsTheLastPictureAndKeepsItsMemory) {
  Snapshot snapshot;
  std::vector<const double*> places;
  for (const double x : {1.0, 2.0, 3.0}) {
    snapshot.Begin(Colouring::kBlackDisks);
    const std::vector<double> numbers(1000, x);
    snapshot.DrawDisks(numbers, numbers, x, {});
    Listener listener(Colouring::kBlackDisks);
    snapshot.DrawOn(listener);
    ASSERT_EQ(listener.calls.size(), 1u);
    EXPECT_EQ(listener.calls[0][0], numbers);
    places.push_back(listener.places[0]);
  }
  EXPECT_EQ(places[1], places[0]);
  EXPECT_EQ(places[2], places[0]);
}

}  // namespace
}  // namespace sph
