// Errors that are the user's or the machine's: caught once, in main, and turned into a message and an exit code.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace sph {

enum class ExitCode { kDone = 0, kTrouble = 1, kUsage = 2, kUnstable = 3, kInterrupted = 130 };

/// what() is the whole message: what was tried, where, and what is accepted.
class Error : public std::runtime_error {
 public:
  ExitCode Code() const { return code_; }

 protected:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}

 private:
  ExitCode code_;
};

/// A wrong command line or scene: exit code 2.
class UsageError : public Error {
 public:
  template <typename... Args>
  explicit UsageError(fmt::format_string<Args...> format, Args&&... args)
      : Error(ExitCode::kUsage, fmt::format(format, std::forward<Args>(args)...)) {}
};

/// A file, a library or a device that failed at run time: exit code 1.
class TroubleError : public Error {
 public:
  template <typename... Args>
  explicit TroubleError(fmt::format_string<Args...> format, Args&&... args)
      : Error(ExitCode::kTrouble, fmt::format(format, std::forward<Args>(args)...)) {}
};

}  // namespace sph
