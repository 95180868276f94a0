// The latest state of something that one thread changes and another one looks at, neither waiting for the other.
#pragma once

#include <array>
#include <cstddef>
#include <mutex>

namespace sph {

/// Two buffers: one is looked at while the other is filled, then they are swapped. What was not looked at before
/// something newer came is lost.
template <typename Content>
class DoubleBuffer {
 public:
  /// For the filling thread: the back buffer, with what it was last filled with. Until Publish it cannot be taken.
  Content& Fill() {
    const std::lock_guard lock(mutex_);
    filled_ = false;
    return buffers_[1 - front_];
  }
  void Publish() {
    const std::lock_guard lock(mutex_);
    filled_ = true;
  }

  /// For the looking thread: if something new was published, it is Front() from now on. @return whether it was
  bool Take() {
    const std::lock_guard lock(mutex_);
    if (!filled_) return false;
    filled_ = false;
    front_ = 1 - front_;
    return true;
  }
  /// What was taken last.
  const Content& Front() const { return buffers_[front_]; }

 private:
  std::mutex mutex_;
  std::array<Content, 2> buffers_;
  std::size_t front_ = 0;  // changed by Take only
  bool filled_ = false;    // the back buffer has something new
};

}  // namespace sph
