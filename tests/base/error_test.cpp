// Errors carry the exit code that users and scripts rely on.
#include "base/error.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

TEST(Error, ExitCodesAreThoseThatScriptsRelyOn) {
  EXPECT_EQ(static_cast<int>(ExitCode::kDone), 0);
  EXPECT_EQ(static_cast<int>(ExitCode::kTrouble), 1);
  EXPECT_EQ(static_cast<int>(ExitCode::kUsage), 2);
  EXPECT_EQ(static_cast<int>(ExitCode::kUnstable), 3);
  EXPECT_EQ(static_cast<int>(ExitCode::kInterrupted), 130);  // 128 + SIGINT
}

TEST(Error, AWrongCommandLineIsUsageAndAFailedFileIsTrouble) {
  EXPECT_EQ(UsageError("{} of {}", 1, "two").Code(), ExitCode::kUsage);
  EXPECT_EQ(TroubleError("{}", "disk").Code(), ExitCode::kTrouble);
}

TEST(Error, SaysTheWholeMessageAndNothingElse) {
  EXPECT_STREQ(UsageError("{}:{}: {}", "dam.toml", 3, "no").what(), "dam.toml:3: no");
}

TEST(Error, OneCatchGetsThemAll) {
  try {
    throw TroubleError("x");
  } catch (const Error& error) {
    EXPECT_EQ(error.Code(), ExitCode::kTrouble);
  }
}

}  // namespace
}  // namespace sph
