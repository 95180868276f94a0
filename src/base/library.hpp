// A shared library loaded at run time, so that the program starts without it.
#pragma once

#include <span>
#include <string>

namespace sph {

/// Stays loaded until the program ends: GL libraries keep threads and exit handlers that do not survive being unloaded.
class Library {
 public:
  /// The first of `names` that dlopen accepts, its symbols visible to nobody else (RTLD_LOCAL).
  /// @param what     what it is for, as the message says it: "OSMesa"
  /// @param package  the Debian package that brings it
  /// TroubleError with each name tried and why it failed, and the package.
  Library(std::string what, std::span<const std::string> names, std::string package);

  /// The function of that name; TroubleError if the library lacks it.
  template <typename Function>
  Function Find(const char* name) const {
    return reinterpret_cast<Function>(Symbol(name));
  }

 private:
  void* Symbol(const char* name) const;

  std::string what_;
  std::string package_;
  std::string name_;
  void* handle_ = nullptr;
};

/// Keeps every library that is loaded now, also those that libraries have loaded for themselves, such as a graphics
/// driver, until the program ends: for the same reason, and so that a leak checker can say whose memory it has found.
void KeepLoadedLibraries();

}  // namespace sph
