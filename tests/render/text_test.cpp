#include "render/text.hpp"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <vector>

#include "render/picture.hpp"

namespace sph {
namespace {

const std::vector<HelpRow> kHelp = {{"d", "break the dam"}, {"p", "pause"}, {"Left, Right", "move the dam wall"}};

/// The part of the picture that is not white.
struct Extent {
  int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;
};

Extent ExtentOf(const Image& image) {
  Extent extent;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* pixel = image.Pixel(x, y);
      if (pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255) continue;
      extent = {std::min(extent.left, x), std::min(extent.top, y), std::max(extent.right, x),
                std::max(extent.bottom, y)};
    }
  }
  return extent;
}

TEST(Text, IsWrittenWhereItBelongs) {
  Easel easel(640, 360);
  const auto extent = [&](const std::function<void(TextLayer&)>& write) {
    return ExtentOf(easel.DrawInPixels(640, 360, [&](Renderer& r) { write(r.Text()); }));
  };
  EXPECT_EQ(extent([](TextLayer&) {}).right, -1) << "nothing is written unasked";
  const Extent status = extent([](TextLayer& t) { t.StatusLine("t = 1.00 s"); });
  EXPECT_LT(status.right, 120);
  EXPECT_LT(status.bottom, 40);
  const Extent message = extent([](TextLayer& t) { t.Message("paused"); });
  EXPECT_GT(message.top, 320);
  EXPECT_NEAR(0.5 * (message.left + message.right), 320, 2);
  const Extent help = extent([](TextLayer& t) { t.HelpTable("Keys", kHelp); });
  EXPECT_NEAR(0.5 * (help.left + help.right), 320, 2);
  EXPECT_NEAR(0.5 * (help.top + help.bottom), 180, 2);
}

TEST(Text, IsGoneInTheNextFrame) {
  Easel easel(200, 100);
  easel.DrawInPixels(200, 100, [](Renderer& r) { r.Text().StatusLine("t = 1.00 s"); });
  EXPECT_EQ(ExtentOf(easel.DrawInPixels(200, 100, [](Renderer&) {})).right, -1);
}

TEST(Text, HasTheSignsOfPhysics) {
  Easel easel(200, 100);
  const auto picture = [&](const char* text) {
    return easel.DrawInPixels(200, 100, [&](Renderer& r) { r.Text().StatusLine(text); });
  };
  const Image unknown = picture("\xef\xbf\xbd");  // what a missing sign looks like
  for (const char* sign : {"³", "×", "·", "µ", "ρ", "→", "−", "≤", "∇"}) EXPECT_NE(picture(sign), unknown) << sign;
}

TEST(Text, StaysInTheWindowHoweverSmall) {
  const std::string status = "dam-break   t = 12.345 s   N = 100000   dt = 0.000123 s   speed 1.00×";
  for (const auto& [width, height] : {std::pair(320, 240), {200, 400}, {1280, 720}}) {
    Easel easel(width, height);
    const std::vector<HelpRow> rows(12, {"Left, Right", "move the dam wall while held, and more of the like"});
    const Image image = easel.DrawInPixels(width, height, [&](Renderer& r) {
      r.Text().StatusLine(status);
      r.Text().Message(status);
      r.Text().HelpTable("Keys", rows);
    });
    const Extent extent = ExtentOf(image);
    EXPECT_GE(extent.left, 1);
    EXPECT_GE(extent.top, 1);
    EXPECT_LT(extent.right, width - 1);
    EXPECT_LT(extent.bottom, height - 1);
  }
}

TEST(Text, GrowsWithTheUiScale) {
  const auto line = [](Renderer& r) { r.Text().StatusLine("t = 1.00 s"); };
  Easel easel(1280, 960);
  const Extent one = ExtentOf(easel.DrawInPixels(1280, 960, line));
  easel.GetRenderer().SetUiScale(2);
  const Extent two = ExtentOf(easel.DrawInPixels(1280, 960, line));
  EXPECT_NEAR(two.right - two.left, 2 * (one.right - one.left), 6);
  EXPECT_NEAR(two.bottom - two.top, 2 * (one.bottom - one.top), 2);
}

TEST(Text, LeavesRoomForItselfInTheFittedView) {
  for (const auto& [width, height] : {std::pair(320, 240), {1280, 720}}) {
    Easel easel(width, height);
    const Extent status = ExtentOf(easel.DrawInPixels(width, height, [](Renderer& r) { r.Text().StatusLine("t, N"); }));
    const View view = easel.GetRenderer().FittedView({0, 0, 1, 1}, width, height);
    EXPECT_GT(view.ToPixel({0, 1}).y, status.bottom);
  }
}

TEST(Text, SharesItsFrameWithWidgets) {
  Easel easel(400, 300);
  const auto with_window = [](Renderer& r) {
    r.Text().StatusLine("t = 1.00 s");
    ImGui::SetNextWindowPos({150, 150});
    ImGui::Begin("panel");
    ImGui::TextUnformatted("damping");
    ImGui::End();
  };
  easel.DrawInPixels(400, 300, with_window);  // Dear ImGui shows a new window in its second frame
  const Extent extent = ExtentOf(easel.DrawInPixels(400, 300, with_window));
  EXPECT_LT(extent.top, 40);
  EXPECT_GT(extent.bottom, 160);
}

TEST(Text, SurvivesAFrameThatWasGivenUp) {
  Easel easel(200, 100);
  easel.GetRenderer().BeginFrame({{0, 0, 1, 1}, 200, 100}, Colouring::kBlackDisks);
  easel.GetRenderer().Text().Message("never shown");
  EXPECT_EQ(ExtentOf(easel.DrawInPixels(200, 100, [](Renderer&) {})).right, -1);
}

}  // namespace
}  // namespace sph
