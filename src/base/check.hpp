// SPH_CHECK: a condition that our own code promises, kept in release builds.
#pragma once

#include <fmt/format.h>

#include <string_view>

namespace sph {

/// Prints `file:line: check failed: condition; values` to stderr and aborts.
[[noreturn]] void CheckFailed(const char* file, int line, const char* condition, std::string_view values);

}  // namespace sph

/// SPH_CHECK(h > 0, "h = {}", h) stops the program when the condition is false: a mistake of ours, never of the user's.
#define SPH_CHECK(condition, ...)                                                     \
  do {                                                                                \
    if (!(condition)) [[unlikely]] {                                                  \
      ::sph::CheckFailed(__FILE__, __LINE__, #condition, ::fmt::format(__VA_ARGS__)); \
    }                                                                                 \
  } while (false)
