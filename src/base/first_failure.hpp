// The exception of work that threads share: none may leave an OpenMP region, or the program ends at once.
#pragma once

#include <exception>
#include <mutex>

namespace sph {

class FirstFailure {
 public:
  /// Does the work, and keeps what it throws if it is the first.
  template <typename Work>
  void Catch(Work&& work) noexcept {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }
  /// Throws what was kept. To be called when the threads are done.
  void Rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace sph
