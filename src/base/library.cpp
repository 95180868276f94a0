#include "base/library.hpp"

#include <dlfcn.h>
#include <link.h>

#include <utility>

#include "base/error.hpp"

namespace sph {

Library::Library(std::string what, std::span<const std::string> names, std::string package)
    : what_(std::move(what)), package_(std::move(package)) {
  std::string failures;
  for (const std::string& name : names) {
    handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ != nullptr) {
      name_ = name;
      return;
    }
    const char* reason = dlerror();
    failures += fmt::format("\n  {}: {}", name, reason == nullptr ? "unknown reason" : reason);
  }
  throw TroubleError("{}: no usable library; tried{}\nOn Debian the package {} brings it.", what_, failures, package_);
}

void* Library::Symbol(const char* name) const {
  void* symbol = dlsym(handle_, name);
  if (symbol == nullptr) {
    throw TroubleError("{}: the library {} has no function {}.\nOn Debian the package {} brings one that has.", what_,
                       name_, name, package_);
  }
  return symbol;
}

void KeepLoadedLibraries() {
  const auto keep = [](dl_phdr_info* info, std::size_t, void*) {
    // A second handle that is never closed. The program itself has an empty name, and needs none.
    if (info->dlpi_name != nullptr && *info->dlpi_name != '\0') {
      dlopen(info->dlpi_name, RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
    }
    return 0;
  };
  dl_iterate_phdr(keep, nullptr);
}

}  // namespace sph
