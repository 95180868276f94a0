#include "io/output_directory.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "base/error.hpp"

namespace sph {

void PrepareOutputDirectory(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::exists(path, error) && !std::filesystem::is_directory(path, error)) {
    throw TroubleError("output directory {}: it exists and is not a directory", path.string());
  }
  std::filesystem::create_directories(path, error);
  if (error) throw TroubleError("output directory {}: it cannot be created: {}", path.string(), error.message());
  if (faccessat(AT_FDCWD, path.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    throw TroubleError("output directory {}: it cannot be written to: {}", path.string(),
                       std::generic_category().message(errno));
  }
}

}  // namespace sph
