// Numbers at the edge of what is accepted, and how what is accepted is put into words.
#include "scenes/value.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "scenes/scene_text.hpp"

namespace sph {
namespace {

/// The message with which `read(value)` is refused, for a value written as TOML; "accepted" if it is not.
template <typename Read>
std::string RefusalOf(const std::string& text, Read read) {
  const toml::table table = toml::parse("v = " + text);
  try {
    read(Value(*table.get("v"), "a.v", "scene.toml"));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Accepted, IncludesItsEndsUnlessOpen) {
  EXPECT_TRUE((Accepted{0, 1}.Holds(0)));
  EXPECT_TRUE((Accepted{0, 1}.Holds(1)));
  EXPECT_FALSE((Accepted{0, 1, true}.Holds(0)));
  EXPECT_TRUE((Accepted{0, 1, true}.Holds(std::numeric_limits<double>::denorm_min())));
  EXPECT_FALSE((Accepted{0, 1}.Holds(std::nextafter(1, 2))));
  EXPECT_FALSE(Accepted::Any().Holds(std::nan("")));
}

TEST(Accepted, SaysInWordsOnlyWhatBounds) {
  EXPECT_EQ(Accepted::Any().InWords(), "a finite number");
  EXPECT_EQ(Accepted::Positive().InWords(), "a finite number > 0");
  EXPECT_EQ(Accepted::NotNegative().InWords(), "a finite number >= 0");
  EXPECT_EQ((Accepted{0, 1}.InWords()), "a finite number >= 0 and <= 1");
  EXPECT_EQ((Accepted{std::numeric_limits<double>::lowest(), 5}.InWords()), "a finite number <= 5");
}

TEST(Value, ReadsWholeNumbersWhereANumberIsMeantButNotTheOtherWayRound) {
  const auto number = [](const Value& v) { return v.AsNumber(Accepted::Any()); };
  const auto integer = [](const Value& v) { return v.AsInteger(1, 10); };
  EXPECT_EQ(RefusalOf("3", number), "accepted");
  EXPECT_EQ(RefusalOf("-2.5e-3", number), "accepted");
  EXPECT_EQ(RefusalOf("3", integer), "accepted");
  for (const char* text : {"3.0", "0", "11", "'3'", "true", "[3]", "1979-05-27"}) {
    EXPECT_TRUE(Has(RefusalOf(text, integer), {"scene.toml:1:5: a.v = ", "a whole number from 1 to 10"})) << text;
  }
  for (const char* text : {"'3'", "true", "[3]", "{ x = 3 }", "nan", "inf", "-inf"}) {
    EXPECT_TRUE(Has(RefusalOf(text, number), {"scene.toml:1:5: a.v = ", "a finite number"})) << text;
  }
}

TEST(Value, BoxesHaveAnArea) {
  const auto box = [](const Value& v) { return v.AsBox(); };
  EXPECT_EQ(RefusalOf("[0, 0, 1, 1]", box), "accepted");
  for (const char* text :
       {"[0, 0, 0, 1]", "[0, 1, 1, 1]", "[1, 0, 0, 1]", "[0, 0, 1]", "[0, 0, 1, inf]", "3", "[[0, 0], [1, 1]]"}) {
    EXPECT_TRUE(Has(RefusalOf(text, box), {"four finite numbers [x0, y0, x1, y1]"})) << text;
  }
}

TEST(Value, VectorsHaveTwoComponents) {
  const auto vec2 = [](const Value& v) { return v.AsVec2(); };
  EXPECT_EQ(RefusalOf("[0, -9.8]", vec2), "accepted");
  for (const char* text : {"-9.8", "[]", "[1]", "[1, 2, 3]", "[1, '2']", "[nan, 0]"}) {
    EXPECT_TRUE(Has(RefusalOf(text, vec2), {"two finite numbers [x, y]"})) << text;
  }
}

TEST(Value, FlagsAreTrueOrFalseAndNothingThatMightMeanIt) {
  const auto flag = [](const Value& v) { return v.AsFlag(); };
  EXPECT_EQ(RefusalOf("true", flag), "accepted");
  for (const char* text : {"1", "'true'", "0.0"}) EXPECT_TRUE(Has(RefusalOf(text, flag), {"true or false"})) << text;
}

TEST(Value, FromACommandLineHasThatForAPlace) {
  const toml::table table = toml::parse("v = 3");
  EXPECT_EQ(Value(*table.get("v"), "v", "--set").Place(), "--set");
  EXPECT_EQ(Value(*table.get("v"), "v", "dam.toml").Place(), "dam.toml:1:5");
}

}  // namespace
}  // namespace sph
