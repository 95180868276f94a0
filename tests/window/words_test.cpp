// The window's words: status line, help, key names, the names of pictures.
#include "window/words.hpp"

#include <GL/freeglut.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "io/scratch.hpp"
#include "io/trouble.hpp"
#include "window/key_names.hpp"
#include "window/message_board.hpp"
#include "window/picture_name.hpp"
#include "window/sessions.hpp"
#include "window/ui_scale.hpp"

namespace sph {
namespace {

bool Has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(StatusLine, SaysWhatRunsAndHowFast) {
  Session session = SessionOf("dam-break");
  for (int i = 0; i < 3; ++i) session.Step();
  const std::string line = StatusLine(session, {250, 60, 0.5});
  for (const char* part : {"dam-break", "N 100", "step 3", "250 steps/s", "0.50 x real time", "60 fps"}) {
    EXPECT_TRUE(Has(line, part)) << part << " in: " << line;
  }
}

TEST(StatusLine, SaysThatNothingMoves) {
  Session session = SessionWithoutRetries();
  session.paused = true;
  EXPECT_TRUE(Has(StatusLine(session, {}), "paused"));
  EXPECT_TRUE(StandingMessage(session).empty());
  session.Reset();
  session.System().parameters.time_step = 10;
  for (int i = 0; i < 10; ++i) session.Step();
  EXPECT_TRUE(Has(StatusLine(session, {}), "stopped"));
  EXPECT_TRUE(Has(StandingMessage(session), session.System().Trouble()->Message()));
  EXPECT_TRUE(Has(StandingMessage(session), "b goes back"));
}

TEST(Help, HasARowForEveryControlInTheWordsOfTheScene) {
  const Session session = SessionOf("dam-break");
  const std::vector<HelpRow> rows = HelpRows(session);
  ASSERT_GE(rows.size(), AllControls().size());
  for (std::size_t i = 0; i < AllControls().size(); ++i) EXPECT_EQ(rows[i].key, AllControls()[i].shown);
  EXPECT_EQ(rows[0].key, "d");
  EXPECT_EQ(rows[0].does, session.CurrentScene().controls[0].what);
}

TEST(Help, HasARowForAKeyThatOnlyTheSceneKnows) {
  const ScratchDirectory folder;
  const std::filesystem::path file = folder.Path() / "own.toml";
  std::ofstream(file)
      << Contents(SPHLAB_SOURCE_DIR "/assets/scenes/dam-break.toml")
      << "[[key]]\npress = \"x\"\nwhat = \"calm down\"\ndo = [ { set = \"forces.damping\", to = 9.0 } ]\n";
  Session session = SessionOf(file.string());
  EXPECT_EQ(HelpRows(session).back().key, "x");
  EXPECT_EQ(HelpRows(session).back().does, "calm down");
  Type(session, "x");
  EXPECT_DOUBLE_EQ(session.System().parameters.motion_damping, 9.0);
}

TEST(KeyNames, EveryControlCanBeReachedFromTheKeyboard) {
  std::set<std::string> reachable;
  for (int code = 0; code < 256; ++code) {
    reachable.insert(NameOfKey(static_cast<unsigned char>(code)));
    reachable.insert(NameOfSpecialKey(code));
  }
  for (const std::string& key : AllKeyNames()) EXPECT_TRUE(reachable.contains(key)) << key;
}

TEST(KeyNames, CapsLockDoesNotMatterAndModifiersAreNoKeys) {
  EXPECT_EQ(NameOfKey('D'), "d");
  EXPECT_EQ(NameOfKey(27), "Esc");
  EXPECT_EQ(NameOfKey(3), "");  // Ctrl-C
  EXPECT_EQ(NameOfSpecialKey(GLUT_KEY_F1), "F1");
  EXPECT_EQ(NameOfSpecialKey(GLUT_KEY_SHIFT_L), "");
}

TEST(MessageBoard, ShowsAMessageForSecondsAndThenNothing) {
  MessageBoard board;
  EXPECT_EQ(board.Read(0), "");
  board.Show("reset", 10);
  EXPECT_EQ(board.Read(10), "reset");
  EXPECT_EQ(board.Read(12), "reset");
  EXPECT_EQ(board.Read(20), "");
  board.Show("speed", 21);
  board.Show("", 21.5);
  EXPECT_EQ(board.Read(21.5), "");
}

TEST(RateMeter, CountsPerSecondOfWallTime) {
  RateMeter meter;
  for (int frame = 0; frame < 60; ++frame) {
    meter.CountSteps(4);
    meter.CountFrame();
  }
  const Rates& rates = meter.Read(2.0, 0.5);
  EXPECT_DOUBLE_EQ(rates.steps, 120);
  EXPECT_DOUBLE_EQ(rates.frames, 30);
  EXPECT_DOUBLE_EQ(rates.pace, 0.25);
  EXPECT_DOUBLE_EQ(meter.Read(2.1, 0.5).frames, 30);  // not before half a second has passed
  EXPECT_DOUBLE_EQ(meter.Read(4.0, 0.0).pace, 0);     // after a reset
}

TEST(PictureName, IsTheFirstThatNoFileHas) {
  const ScratchDirectory folder;
  EXPECT_EQ(NextPictureName(folder.Path(), "toy-star").filename(), "sphlab_toy-star_001.png");
  std::ofstream(folder.Path() / "sphlab_toy-star_001.png") << "kept";
  EXPECT_EQ(NextPictureName(folder.Path(), "toy-star").filename(), "sphlab_toy-star_002.png");
  EXPECT_EQ(NextPictureName(folder.Path(), "dam-break").filename(), "sphlab_dam-break_001.png");
  std::filesystem::create_symlink("nowhere", folder.Path() / "sphlab_toy-star_002.png");
  EXPECT_EQ(NextPictureName(folder.Path(), "toy-star").filename(), "sphlab_toy-star_003.png");
}

/// $SPHLAB_UI_SCALE as a test wants it, for as long as this lives.
class AskedScale {
 public:
  explicit AskedScale(const char* text) { setenv("SPHLAB_UI_SCALE", text, 1); }
  ~AskedScale() { unsetenv("SPHLAB_UI_SCALE"); }
  AskedScale(const AskedScale&) = delete;
  AskedScale& operator=(const AskedScale&) = delete;
};

TEST(UiScale, FollowsTheDesktopAndGrowsWithTheWindow) {
  EXPECT_DOUBLE_EQ(UiScale(std::nullopt).For(800, 600), 1);
  EXPECT_DOUBLE_EQ(UiScale(std::nullopt).For(3840, 2160), 3);
  EXPECT_DOUBLE_EQ(UiScale(192).For(800, 600), 2);
  EXPECT_DOUBLE_EQ(UiScale(192).For(3840, 2160), 3);
}

TEST(UiScale, TheUsersWordGoesFirst) {
  const AskedScale asked("1.6");
  EXPECT_DOUBLE_EQ(UiScale(192).For(3840, 2160), 1.6);
}

TEST(UiScale, RefusesWhatIsNoScale) {
  for (const char* text : {"big", "0", "-1", "2x", "nan", "100"}) {
    const AskedScale asked(text);
    EXPECT_TRUE(Complains<UsageError>([] { UiScale scale(std::nullopt); }, {"SPHLAB_UI_SCALE", text, "0.5 to 8"}));
  }
}

}  // namespace
}  // namespace sph
