// Work handed from one thread to another through a few slots that are used again and again.
#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <utility>

#include "base/check.hpp"

namespace sph {

/// One thread fills slots, one empties them, in the same order. Slots keep what they own, such as a vector's memory, so
/// that nothing is allocated once every slot has been filled. Who fills waits when all slots are full: the work that
/// waits is bounded.
template <typename Slot, std::size_t kSlots = 2>
class HandOver {
 public:
  /// For the filling thread: the next free slot, waited for; throws what the other thread has failed with.
  Slot& NextFree() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return full_ < kSlots || failure_; });
    if (failure_) std::rethrow_exception(failure_);
    SPH_CHECK(!ended_, "{} slots", kSlots);
    return slots_[(first_ + full_) % kSlots];
  }
  /// The slot that NextFree gave is filled.
  void Pass() {
    Change([this] { ++full_; });
  }
  /// Nothing more will come.
  void End() {
    Change([this] { ended_ = true; });
  }

  /// For the emptying thread: the slot that was filled first, waited for; nullptr if there is none and none will come,
  /// or after a failure.
  Slot* NextFull() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return full_ > 0 || ended_ || failure_; });
    return full_ > 0 && !failure_ ? &slots_[first_] : nullptr;
  }
  /// The slot that NextFull gave may be filled again.
  void Return() {
    Change([this] {
      first_ = (first_ + 1) % kSlots;
      --full_;
    });
  }
  /// From any thread: nothing is handed over any more. The first failure is kept.
  void Fail(std::exception_ptr failure) {
    Change([&] {
      if (!failure_) failure_ = std::move(failure);
    });
  }
  /// Throws the failure, if there is one.
  void Check() const {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  template <typename Work>
  void Change(Work work) {
    {
      const std::lock_guard lock(mutex_);
      work();
    }
    changed_.notify_all();
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::array<Slot, kSlots> slots_;  // full ones from first_ on; who fills or empties one does it without the lock
  std::size_t first_ = 0;
  std::size_t full_ = 0;
  bool ended_ = false;
  std::exception_ptr failure_;
};

}  // namespace sph
