#include "window/bell.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <ctime>
#include <system_error>

#include "base/error.hpp"

namespace sph {

Bell::Bell() : descriptor_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (descriptor_ < 0) {
    throw TroubleError("no file descriptor to wake the window with: {}", std::generic_category().message(errno));
  }
}

Bell::~Bell() { close(descriptor_); }

void Bell::Ring() { eventfd_write(descriptor_, 1); }

void Bell::Wait(int other, double seconds) {
  std::array<pollfd, 2> sources = {pollfd{descriptor_, POLLIN, 0}, pollfd{other, POLLIN, 0}};
  const auto nanoseconds = static_cast<long>(1e9 * std::clamp(seconds, 0.0, 0.9));
  const timespec timeout{0, nanoseconds};
  ppoll(sources.data(), sources.size(), &timeout, nullptr);
  eventfd_t rings = 0;
  eventfd_read(descriptor_, &rings);
}

}  // namespace sph
