// What the tables of `bench` begin with, and a table that is seen while it grows.
#pragma once

#include <string>

namespace sph {

/// Processor, compiler, flags, settings of threads, and date, in lines; then an empty one.
std::string DescribeMachine();

/// Goes to stdout as it grows, and can be had as a whole.
class Protocol {
 public:
  explicit Protocol(const std::string& head) { Add(head); }
  void Add(const std::string& text);
  const std::string& Text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace sph
