// What the message of an error must say.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "base/error.hpp"

namespace sph {

/// Does `action` throw an `Expected` whose message has each of `parts`?
template <typename Expected = TroubleError, typename Action>
testing::AssertionResult Complains(const Action& action, std::initializer_list<const char*> parts) {
  try {
    action();
  } catch (const Expected& error) {
    const std::string message = error.what();
    for (const char* part : parts) {
      if (message.find(part) == std::string::npos) {
        return testing::AssertionFailure() << "no '" << part << "' in: " << message;
      }
    }
    return testing::AssertionSuccess() << message;
  }
  return testing::AssertionFailure() << "nothing was thrown";
}

}  // namespace sph
