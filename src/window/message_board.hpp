// The message line of the window: the last thing said, for as long as it takes to read it.
#pragma once

#include <string>

namespace sph {

class MessageBoard {
 public:
  /// Shows `message` from `now` [s, on any clock that goes forward] on; an empty one shows nothing.
  void Show(std::string message, double now);
  /// What is to be seen at `now`; empty when the time to read it is over.
  const std::string& Read(double now);

 private:
  std::string message_;
  double until_ = 0;  // [s]
};

}  // namespace sph
