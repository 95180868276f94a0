// Blocks start with the number asked for, inside their region, on sites that do not touch.
#include "particles/placement.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sph {
namespace {

const Box kBox{-0.95, -0.95, -0.35, 0.0};

Block InABox(std::size_t particles, Arrangement arrange) { return {particles, {kBox, {}, 0}, arrange, 0, 0, {}}; }
Block InADisk(std::size_t particles, Arrangement arrange) {
  return {particles, {{}, {0.2, 0.1}, 0.75}, arrange, 0, 0, {}};
}

std::vector<Vec2> PlaceWithSeed(const Block& block, std::uint64_t seed) {
  Random random(seed);
  return Place(block, random);
}

double LeastDistance(const std::vector<Vec2>& places) {
  double least = 1e300;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, Length(places[i] - places[j]));
  }
  return least;
}

TEST(Region, AreaBoundsAndContainsAgreeWithCounting) {
  const Region disk{{}, {0.2, 0.1}, 0.75};
  EXPECT_DOUBLE_EQ(disk.Area(), std::numbers::pi * 0.75 * 0.75);
  EXPECT_EQ(disk.Bounds(), (Box{0.2 - 0.75, 0.1 - 0.75, 0.2 + 0.75, 0.1 + 0.75}));
  EXPECT_TRUE(disk.Contains({0.2, 0.85}));
  EXPECT_FALSE(disk.Contains({0.2 + 0.6, 0.1 + 0.6}));  // inside its bounds, outside the circle
  const Region box{kBox, {}, 0};
  EXPECT_DOUBLE_EQ(box.Area(), 0.57);
  EXPECT_TRUE(box.Contains({-0.95, 0.0}));
  EXPECT_FALSE(box.Contains({-0.95, 0.1}));
}

TEST(Spacing, IsTheSideOfTheSquareThatAParticleFills) {
  EXPECT_DOUBLE_EQ(Spacing(InABox(57, Arrangement::kRandom)), 0.1);
  Block given = InABox(57, Arrangement::kLattice);
  given.spacing = 0.02;
  EXPECT_EQ(Spacing(given), 0.02);
}

RC_GTEST_PROP(Place, GivesARandomBlockItsNumberInsideItsRegion, (std::uint64_t seed)) {
  const auto n = *rc::gen::inRange<std::size_t>(0, 500);
  for (const Block& block : {InABox(n, Arrangement::kRandom), InADisk(n, Arrangement::kRandom)}) {
    const auto places = PlaceWithSeed(block, seed);
    RC_ASSERT(places.size() == n);
    for (const Vec2 place : places) RC_ASSERT(block.region.Contains(place));
  }
}

TEST(Place, RandomStartsFollowTheSeed) {
  const Block block = InADisk(50, Arrangement::kRandom);
  EXPECT_EQ(PlaceWithSeed(block, 1), PlaceWithSeed(block, 1));
  EXPECT_NE(PlaceWithSeed(block, 1), PlaceWithSeed(block, 2));
}

TEST(Place, RandomStartsAreUniformOverTheDisk) {
  // The share within half the radius is 1/4; four standard deviations of a share of 20 000.
  const auto places = PlaceWithSeed(InADisk(20000, Arrangement::kRandom), 3);
  const auto inner = std::count_if(places.begin(), places.end(), [](Vec2 p) {
    return Length(p - Vec2{0.2, 0.1}) < 0.375;
  });
  EXPECT_NEAR(static_cast<double>(inner) / 20000, 0.25, 4 * std::sqrt(0.25 * 0.75 / 20000));
}

RC_GTEST_PROP(Place, GivesALatticeThatIsNotFittedAnyNumberOnSitesASpacingApart, ()) {
  const auto n = *rc::gen::inRange<std::size_t>(0, 400);
  const Block block = InABox(n, Arrangement::kLattice);
  const auto places = PlaceWithSeed(block, 1);
  RC_ASSERT(places.size() == n);
  if (n > 1) RC_ASSERT(LeastDistance(places) > Spacing(block) * (1 - 1e-9));
  for (const Vec2 place : places) {
    RC_ASSERT(place.x > kBox.x0 && place.x < kBox.x1 && place.y > kBox.y0);
    // The last, incomplete rows may be above the box: by the columns that do not fit into its width, no more than one
    // in two.
    RC_ASSERT(place.y < kBox.y1 + kBox.Height());
  }
}

TEST(Place, LatticeThatFitsFillsItsBoxExactly) {
  Block block = InABox(60, Arrangement::kLattice);
  block.region.box = {0, 0, 1, 0.6};  // 10 x 6 sites of spacing 0.1
  const auto places = PlaceWithSeed(block, 1);
  ASSERT_EQ(places.size(), 60u);
  EXPECT_NEAR(places.front().x, 0.05, 1e-15);
  EXPECT_NEAR(places.front().y, 0.05, 1e-15);
  EXPECT_NEAR(places.back().x, 0.95, 1e-15);
  EXPECT_NEAR(places.back().y, 0.55, 1e-15);
}

TEST(Place, LatticeGoesOnAboveItsBoxWhenItsRowsAreFull) {
  Block block = InABox(65, Arrangement::kLattice);
  block.region.box = {0, 0, 1, 0.6};
  block.spacing = 0.1;
  const auto places = PlaceWithSeed(block, 1);
  ASSERT_EQ(places.size(), 65u);
  EXPECT_NEAR(places.back().y, 0.65, 1e-12);
}

TEST(Place, LatticeOfOneParticleIsInsideEvenATallBox) {
  Block block = InABox(1, Arrangement::kLattice);
  block.region.box = {0, 0, 0.1, 10};  // the spacing, 1, is ten times the width
  const auto places = PlaceWithSeed(block, 1);
  ASSERT_EQ(places.size(), 1u);
  EXPECT_TRUE(block.region.Contains(places[0]));
}

TEST(Place, LatticeInADiskStaysInsideAndIsAsManyAsItsAreaHolds) {
  const Block block = InADisk(1000, Arrangement::kLattice);
  const auto places = PlaceWithSeed(block, 1);
  for (const Vec2 place : places) EXPECT_TRUE(block.region.Contains(place));
  // Sites in a circle of radius R/dx = 17.8: the area within a boundary's error of a few times the root of the radius.
  EXPECT_NEAR(static_cast<double>(places.size()), 1000, 20);
  EXPECT_LE(places.size(), 1000u);
}

TEST(Place, JitterMovesToTheRightByLessThanItself) {
  Block lattice = InABox(100, Arrangement::kLattice);
  Block jittered = InABox(100, Arrangement::kJittered);
  jittered.jitter = 0.01;
  const auto sites = PlaceWithSeed(lattice, 1);
  const auto places = PlaceWithSeed(jittered, 1);
  ASSERT_EQ(places.size(), sites.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    EXPECT_EQ(places[k].y, sites[k].y);
    EXPECT_GE(places[k].x, sites[k].x);
    EXPECT_LT(places[k].x, sites[k].x + 0.01);
  }
  EXPECT_NE(PlaceWithSeed(jittered, 2), places);
}

TEST(Place, PerturbedStartsMoveEitherWayByLessThanTheJitterAndNowhereInTheMean) {
  Block lattice = InABox(2500, Arrangement::kLattice);
  Block perturbed = InABox(2500, Arrangement::kPerturbed);
  perturbed.jitter = 0.002;
  const auto sites = PlaceWithSeed(lattice, 1);
  const auto places = PlaceWithSeed(perturbed, 1);
  ASSERT_EQ(places.size(), sites.size());
  Vec2 mean, squares;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Vec2 shift = places[k] - sites[k];
    EXPECT_LE(std::max(std::abs(shift.x), std::abs(shift.y)), 0.002 * (1 + 1e-9));
    mean = mean + (1 / 2500.0) * shift;
    squares = squares + (1 / 2500.0) * Vec2{shift.x * shift.x, shift.y * shift.y};
  }
  // Uniform between -jitter and jitter: the variance is jitter^2/3; four standard deviations of both means.
  const double deviation = 0.002 / std::sqrt(3.0);
  EXPECT_NEAR(mean.x, 0, 4 * deviation / 50);
  EXPECT_NEAR(mean.y, 0, 4 * deviation / 50);
  EXPECT_NEAR(squares.x, deviation * deviation, 4 * 0.9 * deviation * deviation / 50);
  EXPECT_NEAR(squares.y, deviation * deviation, 4 * 0.9 * deviation * deviation / 50);
  EXPECT_NE(PlaceWithSeed(perturbed, 2), places);
}

/// Distance of nearest neighbours in a hexagonal lattice of one particle per spacing^2.
double HexagonalPitch(const Block& block) { return Spacing(block) * std::sqrt(2 / std::sqrt(3.0)); }

TEST(Place, HexagonalDiskIsFullHasACentreAndSixNeighboursForEachInside) {
  Block disk = InADisk(4000, Arrangement::kHexagonal);
  disk.spacing = 0.025;
  const auto places = PlaceWithSeed(disk, 1);
  const double pitch = HexagonalPitch(disk);
  const double expected = disk.region.Area() / (disk.spacing * disk.spacing);  // equal areas: 2827
  EXPECT_NEAR(static_cast<double>(places.size()), expected, 0.01 * expected);
  EXPECT_NEAR(LeastDistance(places), pitch, 1e-12);
  EXPECT_TRUE(std::ranges::any_of(places, [](Vec2 p) { return Length(p - Vec2{0.2, 0.1}) < 1e-12; }));
  for (const Vec2 place : places) {
    EXPECT_TRUE(disk.region.Contains(place));
    if (Length(place - disk.region.centre) > 0.75 - 1.01 * pitch) continue;
    EXPECT_EQ(std::ranges::count_if(places, [&](Vec2 p) { return Length(p - place) < 1.01 * pitch; }), 6 + 1);
  }
}

TEST(Place, HexagonalBoxIsFilledByAboutTheNumberAskedForAndNoMore) {
  const Block block = InABox(2000, Arrangement::kHexagonal);
  const auto places = PlaceWithSeed(block, 1);
  EXPECT_LE(places.size(), 2000u);
  EXPECT_GT(places.size(), 1940u);  // a row, or a column, may not fit
  EXPECT_NEAR(LeastDistance(places), HexagonalPitch(block), 1e-12);
  for (const Vec2 place : places) EXPECT_TRUE(block.region.Contains(place));
}

/// A box a corner of which is anywhere, of any shape but the thinnest.
Block SomeBox(Arrangement arrange) {
  const auto thousandths = [](int least, int most) { return 0.001 * *rc::gen::inRange(least, most); };
  Block block = InABox(*rc::gen::inRange<std::size_t>(1, 3000), arrange);
  const Vec2 corner{thousandths(-5000, 5000), thousandths(-5000, 5000)};
  block.region.box = {corner.x, corner.y, corner.x + thousandths(200, 3000), corner.y + thousandths(200, 3000)};
  return block;
}

Box BoundsOf(const std::vector<Vec2>& places) {
  Box bounds{1e300, 1e300, -1e300, -1e300};
  for (const Vec2 p : places) {
    bounds = {std::min(bounds.x0, p.x), std::min(bounds.y0, p.y), std::max(bounds.x1, p.x), std::max(bounds.y1, p.y)};
  }
  return bounds;
}

RC_GTEST_PROP(Fitted, LatticeFillsItsBoxAndHasAboutTheNumberAskedFor, ()) {
  for (const Arrangement arrange : {Arrangement::kLattice, Arrangement::kHexagonal}) {
    const Block asked = SomeBox(arrange), block = Fitted(asked);
    const auto places = PlaceWithSeed(block, 1);
    RC_ASSERT(places.size() == block.particles);
    RC_ASSERT(block.particles == block.columns * block.rows);
    const Box& box = block.region.box;
    for (const Vec2 place : places) RC_ASSERT(block.region.Contains(place));
    // As far from the left side as from the right one, and from the floor as from the top.
    const Box bounds = BoundsOf(places);
    const double round_off = 1e-9 * (box.Width() + box.Height());
    RC_ASSERT((arrange == Arrangement::kHexagonal && block.rows == 1) ||
              std::abs((bounds.x0 - box.x0) - (box.x1 - bounds.x1)) < round_off);
    RC_ASSERT(std::abs((bounds.y0 - box.y0) - (box.y1 - bounds.y1)) < round_off);
    const double off = std::abs(static_cast<double>(block.particles) - static_cast<double>(asked.particles));
    RC_ASSERT(off <= 0.5 * static_cast<double>(std::max(block.columns, block.rows)));
    RC_ASSERT(Fitted(block).particles == block.particles);
  }
}

TEST(Fitted, ColumnTwiceAsHighAsWideGetsTheNearestNumberOfNearlySquareCells) {
  Block column = InABox(10'000, Arrangement::kLattice);
  column.region.box = {0, 0, 1, 2};
  const Block fitted = Fitted(column);
  EXPECT_EQ(fitted.columns, 71u);
  EXPECT_EQ(fitted.rows, 141u);
  EXPECT_EQ(fitted.particles, 10'011u);
  EXPECT_EQ(FillingNumbers(column), (std::pair<std::size_t, std::size_t>{9'800, 10'082})) << "70 x 140 and 71 x 142";
}

TEST(Fitted, NumbersThatFillTheirBoxStayAsTheyAreToTheBit) {
  for (const Arrangement arrange : {Arrangement::kLattice, Arrangement::kJittered, Arrangement::kPerturbed}) {
    for (const auto& [box, n] : {std::pair{Box{0, 0, 2, 0.9}, 4500},
                                 {Box{0, 0, 2.0 / 3, 1}, 2400},
                                 {Box{-0.5, -0.5, 0.5, 0.5}, 10'000},
                                 {Box{0, 0, 0.6, 0.3}, 12'800}}) {
      Block block = InABox(static_cast<std::size_t>(n), arrange);
      block.region.box = box;
      block.jitter = 0.001;
      EXPECT_EQ(Fitted(block).particles, block.particles);
      EXPECT_EQ(PlaceWithSeed(Fitted(block), 3), PlaceWithSeed(block, 3));
    }
  }
}

TEST(Fitted, DiskHoldsItsNumberAtEqualPartsOfItsAreaRoundItsCentre) {
  for (const Arrangement arrange : {Arrangement::kHexagonal, Arrangement::kLattice}) {
    for (const std::size_t asked : {1u, 4u, 100u, 2000u, 3000u}) {
      const Block block = Fitted(InADisk(asked, arrange));
      const auto places = PlaceWithSeed(block, 1);
      EXPECT_EQ(places.size(), block.particles);
      Vec2 sum;
      for (const Vec2 place : places) sum = sum + (place - block.region.centre);
      EXPECT_NEAR(Length(sum), 0, 1e-9) << "as many on every side";
      const double least = arrange == Arrangement::kHexagonal ? std::sqrt(2 / std::sqrt(3.0)) : 1;
      if (asked > 4) {
        EXPECT_NEAR(LeastDistance(places), least * Spacing(block), 1e-9);
      }
      EXPECT_NEAR(static_cast<double>(block.particles), static_cast<double>(asked), 3 + std::sqrt(asked))
          << "by a third of what lies along the rim";
    }
  }
  EXPECT_EQ(Fitted(InADisk(2000, Arrangement::kHexagonal)).particles, 1993u);
  EXPECT_EQ(FillingNumbers(InADisk(2000, Arrangement::kHexagonal)),
            (std::pair<std::size_t, std::size_t>{1'993, 2'053}));
}

TEST(Fitted, SpacingThatIsGivenStays) {
  Block disk = InADisk(4000, Arrangement::kHexagonal);
  disk.spacing = 0.025;
  const Block fitted = Fitted(disk);
  EXPECT_EQ(fitted.spacing, 0.025);
  EXPECT_EQ(fitted.particles, PlaceWithSeed(disk, 1).size()) << "no more are inside";
  Block box = InABox(65, Arrangement::kLattice);
  box.spacing = 0.1;
  EXPECT_EQ(PlaceWithSeed(Fitted(box), 1), PlaceWithSeed(box, 1));
}

TEST(Place, LatticeFarFromTheOriginHasTheSameColumns) {
  // There a hundred spacings are less than the box's width by rounding.
  Block block = InABox(4500, Arrangement::kLattice);
  block.spacing = 0.02;
  for (const double far : {0.0, 262144.0, 1e6}) {
    block.region.box = {far, far, far + 2, far + 0.9};
    const auto places = PlaceWithSeed(block, 1);
    ASSERT_EQ(places.size(), 4500u);
    EXPECT_NEAR(places.back().x - far, 1.99, 1e-9);
    EXPECT_NEAR(places.back().y - far, 0.89, 1e-9);
  }
}

RC_GTEST_PROP(StartBounds, HasAllPlacesInside, (std::uint64_t seed)) {
  for (const Arrangement arrange : {Arrangement::kRandom, Arrangement::kLattice, Arrangement::kJittered,
                                    Arrangement::kPerturbed, Arrangement::kHexagonal}) {
    Block block = *rc::gen::arbitrary<bool>() ? SomeBox(arrange) : InADisk(*rc::gen::inRange(1, 500), arrange);
    block.jitter = 0.02;
    if (*rc::gen::arbitrary<bool>()) block.spacing = 0.001 * *rc::gen::inRange(20, 300);
    block = Fitted(block);
    const Box extent = StartBounds(block);
    for (const Vec2 p : PlaceWithSeed(block, seed)) {
      constexpr double kRoundOff = 1e-12;
      RC_ASSERT(p.x >= extent.x0 - kRoundOff && p.x <= extent.x1 + kRoundOff);
      RC_ASSERT(p.y >= extent.y0 - kRoundOff && p.y <= extent.y1 + kRoundOff);
    }
  }
}

TEST(StartBounds, OfALatticeThatGoesOnAboveItsBoxEndsWithItsLastRow) {
  Block block = InABox(65, Arrangement::kLattice);
  block.region.box = {0, 0, 1, 0.6};
  block.spacing = 0.1;
  EXPECT_NEAR(StartBounds(block).y1, PlaceWithSeed(block, 1).back().y, 1e-12);
}

TEST(PlaceAround, TakesTheLowestFreeSitesOfTheBlocksColumn) {
  Block block = InABox(4, Arrangement::kLattice);
  block.region.box = {0, 0, 0.2, 0.2};
  block.spacing = 0.1;
  const auto lowest_row_taken = [](Vec2 site) { return site.y < 0.1; };
  const auto places = PlaceAround(block, {-1, -1, 1, 1}, lowest_row_taken);
  ASSERT_EQ(places.size(), 4u);
  for (const Vec2 place : places) EXPECT_TRUE(place.x > 0 && place.x < 0.2 && place.y > 0.1 && place.y < 0.3);
}

TEST(PlaceAround, GoesBesideWhenItsColumnIsFullAndGivesUpWhenTheRoomIs) {
  Block block = InABox(4, Arrangement::kLattice);
  block.region.box = {0, 0, 0.2, 0.2};
  block.spacing = 0.1;
  const auto middle_taken = [](Vec2 site) { return site.x > 0 && site.x < 0.2; };
  const auto beside = PlaceAround(block, {-1, 0, 1, 0.25}, middle_taken);
  ASSERT_EQ(beside.size(), 4u);
  for (const Vec2 place : beside) EXPECT_TRUE(place.x > 0.2 && place.x < 0.4);
  EXPECT_TRUE(PlaceAround(block, {-0.1, 0, 0.3, 0.25}, middle_taken).empty()) << "no whole block beside it";
  EXPECT_TRUE(PlaceAround(block, {-1, 0, 1, 0.15}, [](Vec2) { return false; }).empty()) << "one row is not enough";
}

}  // namespace
}  // namespace sph
