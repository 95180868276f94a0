// Panels side by side: each in its place, a gap between them, white where the last row has none.
#include "commands/montage.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

Image Grey(int width, int height, std::uint8_t grey) {
  return {width, height, std::vector<std::uint8_t>(std::size_t{3} * static_cast<std::size_t>(width * height), grey)};
}

TEST(JoinPanels, PutsEachInItsPlaceWithAGapBetween) {
  const std::vector<Image> panels = {Grey(4, 3, 10), Grey(4, 3, 20), Grey(4, 3, 30)};
  const Image joined = JoinPanels(panels, 2, 1);
  ASSERT_EQ(joined.width, 9);
  ASSERT_EQ(joined.height, 7);
  EXPECT_EQ(joined.Pixel(0, 0)[0], 10);
  EXPECT_EQ(joined.Pixel(3, 2)[2], 10);
  EXPECT_EQ(joined.Pixel(5, 0)[0], 20);
  EXPECT_EQ(joined.Pixel(8, 2)[1], 20);
  EXPECT_EQ(joined.Pixel(0, 4)[0], 30);
  EXPECT_EQ(joined.Pixel(5, 4)[0], 255) << "no fourth panel";
  EXPECT_EQ(joined.Pixel(4, 0)[0], joined.Pixel(0, 3)[0]) << "the gap";
  EXPECT_NE(joined.Pixel(4, 0)[0], 255);
}

TEST(JoinPanels, OfOnePanelIsThePanel) {
  const std::vector<Image> panels = {Grey(5, 2, 77)};
  EXPECT_EQ(JoinPanels(panels, 3, 2), panels[0]);
}

}  // namespace
}  // namespace sph
