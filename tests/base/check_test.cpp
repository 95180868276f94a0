// SPH_CHECK stops the program in every build, and says where, what and which values.
#include "base/check.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sph {
namespace {

TEST(Check, StopsTheProgramAndNamesFileConditionAndValues) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const double h = -0.5;
  EXPECT_DEATH(SPH_CHECK(h > 0, "h = {}", h), "check_test.cpp:[0-9]+: check failed: h > 0; h = -0.5");
}

TEST(Check, TakesANaNForAFailure) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const double h = std::nan("");
  EXPECT_DEATH(SPH_CHECK(h > 0, "h = {}", h), "h = nan");
}

TEST(Check, FormatsNothingWhileTheConditionHolds) {
  int formatted = 0;
  const auto value = [&] { return ++formatted; };
  SPH_CHECK(formatted == 0, "{}", value());
  EXPECT_EQ(formatted, 0);
}

TEST(Check, IsOneStatementBetweenIfAndElse) {
  bool other = false;
  if (other)
    SPH_CHECK(false, "not reached");
  else
    other = true;
  EXPECT_TRUE(other);
}

}  // namespace
}  // namespace sph
