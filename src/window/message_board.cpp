#include "window/message_board.hpp"

#include <utility>

namespace sph {

void MessageBoard::Show(std::string message, double now) {
  constexpr double kNotice = 3;        // [s] until the eye is there
  constexpr double kPerLetter = 0.04;  // [s]
  until_ = now + kNotice + kPerLetter * static_cast<double>(message.size());
  message_ = std::move(message);
}

const std::string& MessageBoard::Read(double now) {
  if (now >= until_) message_.clear();
  return message_;
}

}  // namespace sph
