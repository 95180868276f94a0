// Wakes a thread that waits for something else, too: a file descriptor that can be read once the bell was rung.
#pragma once

namespace sph {

class Bell {
 public:
  /// TroubleError if the system has no file descriptors left.
  Bell();
  ~Bell();
  Bell(const Bell&) = delete;
  Bell& operator=(const Bell&) = delete;

  /// From any thread.
  void Ring();
  /// Returns once the bell was rung since the last call, or `other` (a file descriptor; none if negative) can be read,
  /// or a signal came, or after `seconds`.
  void Wait(int other, double seconds);

 private:
  int descriptor_;
};

}  // namespace sph
