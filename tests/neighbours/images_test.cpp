// Images against all copies of all particles: every pair within reach across a seam is there, and once.
#include "neighbours/images.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "base/random.hpp"

namespace sph {
namespace {

const Box kBox{-1, 2, 2, 3.5};  // [m], 3 x 1.5
constexpr double kReach = 0.4;

struct Points {
  std::vector<double> x, y;
};

Ends Periodic(bool in_x, bool in_y) {
  Ends ends;
  if (in_x) ends.x = {kBox.x0, kBox.x1, true};
  if (in_y) ends.y = {kBox.y0, kBox.y1, true};
  return ends;
}

/// In the box, and up to `drift` out of it.
Points Scattered(std::size_t n, double drift, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    points.x.push_back(random.Uniform(kBox.x0 - drift, kBox.x1 + drift));
    points.y.push_back(random.Uniform(kBox.y0 - drift, kBox.y1 + drift));
  }
  return points;
}

/// From the source of each image to the image [m].
std::vector<Vec2> Shifts(const Images& images, const Ends& ends, const Points& points) {
  std::vector<double> x, y;
  images.Place(ends, points.x, points.y, x, y);
  std::vector<Vec2> shifts;
  for (std::size_t k = 0; k < images.Size(); ++k) {
    shifts.push_back(Vec2{x[k], y[k]} - Vec2{points.x[images.Sources()[k]], points.y[images.Sources()[k]]});
  }
  return shifts;
}

/// How often a particle i sees a copy of j, shifted by (a, b) periods: by particle and shift.
using Seen = std::map<std::tuple<std::size_t, std::size_t, int, int>, int>;

bool Near(const Points& p, std::size_t i, std::size_t j, double shift_x, double shift_y) {
  return std::hypot(p.x[i] - p.x[j] - shift_x, p.y[i] - p.y[j] - shift_y) < kReach;
}

Seen SeenByCopies(const Points& p, const Periods& periods) {
  Seen seen;
  for (int a = -1; a <= 1; ++a) {
    for (int b = -1; b <= 1; ++b) {
      if ((a == 0 && b == 0) || (a != 0 && !periods.in_x) || (b != 0 && !periods.in_y)) continue;
      for (std::size_t i = 0; i < p.x.size(); ++i) {
        for (std::size_t j = 0; j < p.x.size(); ++j) {
          if (Near(p, i, j, a * kBox.Width(), b * kBox.Height())) ++seen[{i, j, a, b}];
        }
      }
    }
  }
  return seen;
}

Seen SeenByImages(const Points& p, const Images& images, const Ends& ends) {
  const std::vector<Vec2> shifts = Shifts(images, ends, p);
  Seen seen;
  for (std::size_t k = 0; k < images.Size(); ++k) {
    const auto [shift_x, shift_y] = shifts[k];
    const int a = static_cast<int>(std::lround(shift_x / kBox.Width()));
    const int b = static_cast<int>(std::lround(shift_y / kBox.Height()));
    for (std::size_t i = 0; i < p.x.size(); ++i) {
      if (Near(p, i, images.Sources()[k], shift_x, shift_y)) ++seen[{i, images.Sources()[k], a, b}];
    }
  }
  return seen;
}

struct Directions {
  const char* name;
  bool in_x, in_y;
};
class ImagesOf : public testing::TestWithParam<Directions> {
 protected:
  static Periods ThePeriods() { return {kBox, GetParam().in_x, GetParam().in_y}; }
  static Ends TheEnds() { return Periodic(GetParam().in_x, GetParam().in_y); }
};
INSTANTIATE_TEST_SUITE_P(Directions, ImagesOf,
                         testing::Values(Directions{"x", true, false}, Directions{"y", false, true},
                                         Directions{"both", true, true}),
                         [](const auto& tested) { return tested.param.name; });

TEST_P(ImagesOf, ShowEveryPairWithinReachAcrossASeamOnce) {
  for (const double drift : {0.0, 0.1}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const Points points = Scattered(150, drift, seed);
      Images images;
      images.Find(TheEnds(), kReach, 0, points.x, points.y);
      const Seen expected = SeenByCopies(points, ThePeriods());
      EXPECT_GT(expected.size(), 50u);
      ASSERT_EQ(SeenByImages(points, images, TheEnds()), expected) << "drift " << drift << ", seed " << seed;
    }
  }
}

TEST_P(ImagesOf, ShowThePairsOfParticlesThatTravel) {
  constexpr double kTravel = 0.15;  // [m]
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Points points = Scattered(150, 0, seed);
    Images images;
    images.Find(TheEnds(), kReach, kTravel, points.x, points.y);
    Random random(seed + 100);
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      const double angle = random.Uniform(0, 2 * std::numbers::pi);
      points.x[i] += kTravel * std::cos(angle);
      points.y[i] += kTravel * std::sin(angle);
    }
    ASSERT_EQ(SeenByImages(points, images, TheEnds()), SeenByCopies(points, ThePeriods())) << "seed " << seed;
  }
}

TEST_P(ImagesOf, AreNoMoreThanTheRimHolds) {
  const Points points = Scattered(2000, 0, 1);
  Images images;
  images.Find(TheEnds(), kReach, 0, points.x, points.y);
  const double wide = kBox.Width() + (GetParam().in_x ? 2 * kReach : 0);
  const double high = kBox.Height() + (GetParam().in_y ? 2 * kReach : 0);
  const double expected = 2000 * (wide * high / (kBox.Width() * kBox.Height()) - 1);
  EXPECT_NEAR(static_cast<double>(images.Size()), expected, 5 * std::sqrt(expected));
}

TEST(Images, OfNothingPeriodicAreNone) {
  const Points points = Scattered(100, 0.1, 1);
  Images images;
  images.Find(Periodic(true, true), kReach, 0, points.x, points.y);
  EXPECT_GT(images.Size(), 0u);
  images.Find({}, kReach, 0, points.x, points.y);
  EXPECT_EQ(images.Size(), 0u);
}

TEST(Images, KeepSourceAndShiftTogetherWhenTheyAreReordered) {
  const Points points = Scattered(60, 0, 4);
  Images images;
  images.Find(Periodic(true, true), kReach, 0, points.x, points.y);
  const auto all = [&] {
    std::multiset<std::tuple<std::uint32_t, double, double>> result;
    const std::vector<Vec2> shifts = Shifts(images, Periodic(true, true), points);
    for (std::size_t k = 0; k < images.Size(); ++k) result.insert({images.Sources()[k], shifts[k].x, shifts[k].y});
    return result;
  };
  const auto before = all();
  const std::uint32_t first = images.Sources()[0];
  std::vector<std::uint32_t> backwards;
  for (std::size_t k = images.Size(); k > 0; --k) backwards.push_back(static_cast<std::uint32_t>(k - 1));
  images.Reorder(backwards);
  EXPECT_EQ(all(), before);
  EXPECT_EQ(images.Sources()[images.Size() - 1], first);
}

TEST(Images, InMirrorsAreTheReflectionsOfEveryParticleWithinReachOfThem) {
  const Points points = Scattered(300, 0, 7);
  const Ends ends{{kBox.x0, kBox.x1}, {kBox.y0}};  // left and right, and a floor
  Images images;
  images.Find(ends, kReach, 0, points.x, points.y);
  std::vector<double> x, y;
  images.Place(ends, points.x, points.y, x, y);
  std::multiset<std::tuple<std::uint32_t, double, double>> found, expected;
  for (std::size_t k = 0; k < images.Size(); ++k) found.insert({images.Sources()[k], x[k], y[k]});
  for (std::uint32_t i = 0; i < 300; ++i) {
    std::vector<double> xs = {points.x[i]}, ys = {points.y[i]};
    if (points.x[i] - kBox.x0 < kReach) xs.push_back(2 * kBox.x0 - points.x[i]);
    if (kBox.x1 - points.x[i] < kReach) xs.push_back(2 * kBox.x1 - points.x[i]);
    if (points.y[i] - kBox.y0 < kReach) ys.push_back(2 * kBox.y0 - points.y[i]);
    for (const double at_x : xs) {
      for (const double at_y : ys) {
        if (at_x != points.x[i] || at_y != points.y[i]) expected.insert({i, at_x, at_y});
      }
    }
  }
  EXPECT_GT(expected.size(), 100u);
  EXPECT_EQ(found, expected);
}

RC_GTEST_PROP(Periods, WrapIntoTheBoxByWholePeriods, ()) {
  const Vec2 point{0.01 * *rc::gen::inRange(-2000, 2000), 0.01 * *rc::gen::inRange(-2000, 2000)};
  const Vec2 both = Periods{kBox, true, true}.Wrap(point);
  // The lower side belongs to the box, and round-off of the subtraction may reach the upper one.
  RC_ASSERT(both.x >= kBox.x0 - 1e-12 && both.x <= kBox.x1 + 1e-12);
  RC_ASSERT(both.y >= kBox.y0 - 1e-12 && both.y <= kBox.y1 + 1e-12);
  const double periods = (point.x - both.x) / kBox.Width();
  RC_ASSERT(std::abs(periods - std::round(periods)) < 1e-12);
  const Vec2 in_x = Periods{kBox, true, false}.Wrap(point), none = Periods{kBox, false, false}.Wrap(point);
  RC_ASSERT(in_x.x == both.x && in_x.y == point.y);
  RC_ASSERT(none == point);
}

TEST(Images, RefuseAPeriodOfLessThanTwiceTheReach) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const Points points = Scattered(3, 0, 1);
  Images images;
  EXPECT_DEATH(images.Find(Periodic(false, true), 0.75, 0, points.x, points.y), "too short for a reach of 0.75 m");
}

}  // namespace
}  // namespace sph
