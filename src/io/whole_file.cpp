#include "io/whole_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "base/error.hpp"

namespace sph {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Fail(const fs::path& path, const char* tried) {
  throw TroubleError("cannot write {}: {}: {}", path.string(), tried, std::generic_category().message(errno));
}

/// A file opened for writing; closed when it goes.
class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  bool IsOpen() const { return descriptor_ >= 0; }
  bool Write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
  }
  bool SetPermissions(mode_t mode) { return fchmod(descriptor_, mode) == 0; }
  bool Sync() { return fsync(descriptor_) == 0; }
  bool Close() { return close(std::exchange(descriptor_, -1)) == 0; }

 private:
  int descriptor_;
};

/// A new file beside `path`, under a name that no other file, thread or process has; removed unless it took the name.
class Temporary {
 public:
  explicit Temporary(const fs::path& path) : file_(Create(path)) {}
  ~Temporary() {
    if (!name_.empty()) unlink(name_.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  OpenFile& File() { return file_; }
  bool Rename(const fs::path& path) {
    if (rename(name_.c_str(), path.c_str()) != 0) return false;
    name_.clear();
    return true;
  }

 private:
  int Create(const fs::path& path) {
    static std::atomic<unsigned> count = 0;
    for (;;) {
      name_ = fmt::format("{}.part-{}-{}", path.string(), getpid(), count++);
      const int descriptor = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor >= 0) return descriptor;
      if (errno == EEXIST) continue;  // left by a process that was killed
      name_.clear();
      Fail(path, "creating a temporary file beside it");
    }
  }

  std::string name_;
  OpenFile file_;
};

void WriteDirectly(const fs::path& path, std::span<const std::byte> bytes) {
  OpenFile file(open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file.IsOpen()) Fail(path, "opening it");
  if (!file.Write(bytes)) Fail(path, "writing to it");
  if (!file.Close()) Fail(path, "closing it");
}

}  // namespace

void WriteWholeFile(const fs::path& path, std::span<const std::byte> bytes) {
  std::error_code ignored;
  const fs::path target = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
  struct stat status = {};
  const bool exists = stat(target.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) return WriteDirectly(target, bytes);
  if (exists && faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) Fail(path, "replacing it");

  Temporary temporary(target);
  OpenFile& file = temporary.File();
  if (exists && !file.SetPermissions(status.st_mode & 07777)) Fail(path, "keeping its permissions");
  if (!file.Write(bytes)) Fail(path, "writing a temporary file beside it");
  if (!file.Sync() || !file.Close()) Fail(path, "bringing it to the disk");
  if (!temporary.Rename(target)) Fail(path, "renaming the temporary file");
}

void WriteWholeFile(const fs::path& path, std::string_view text) {
  WriteWholeFile(path, std::as_bytes(std::span(text)));
}

}  // namespace sph
