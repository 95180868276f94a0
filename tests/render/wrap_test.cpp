#include "render/wrap.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <sstream>

namespace sph {
namespace {

double Bytes(std::string_view text) { return static_cast<double>(text.size()); }

TEST(Wrap, LeavesAloneWhatFits) {
  EXPECT_EQ(Wrapped("", 5, Bytes), "");
  EXPECT_EQ(Wrapped("t = 1", 5, Bytes), "t = 1");
  EXPECT_EQ(Wrapped("ab\ncd", 2, Bytes), "ab\ncd");
}

TEST(Wrap, KeepsFieldsTogetherThenWords) {
  EXPECT_EQ(Wrapped("t = 1 s   N = 200   x", 15, Bytes), "t = 1 s\nN = 200   x");
  EXPECT_EQ(Wrapped("t = 1 s   N = 200", 5, Bytes), "t = 1\ns\nN =\n200");
}

TEST(Wrap, BreaksAWordOnlyIfItMustAndNeverWithinACharacter) {
  EXPECT_EQ(Wrapped("abcdefg", 3, Bytes), "abc\ndef\ng");
  EXPECT_EQ(Wrapped("ρρρ", 5, Bytes), "ρρ\nρ");
}

TEST(Wrap, MakesNoLineTooWideAndLosesNoLetter) {
  EXPECT_TRUE(rc::check([] {
    const auto text = *rc::gen::container<std::string>(rc::gen::element('a', 'b', ' '));
    const int room = *rc::gen::inRange(1, 30);
    const std::string wrapped = Wrapped(text, room, Bytes);
    std::istringstream lines(wrapped);
    for (std::string line; std::getline(lines, line);) RC_ASSERT(static_cast<int>(line.size()) <= room);
    const auto letters = [](std::string s) {
      std::erase_if(s, [](char c) { return c == ' ' || c == '\n'; });
      return s;
    };
    RC_ASSERT(letters(wrapped) == letters(text));
  }));
}

}  // namespace
}  // namespace sph
