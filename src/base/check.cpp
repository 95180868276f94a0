#include "base/check.hpp"

#include <cstdio>
#include <cstdlib>

namespace sph {

void CheckFailed(const char* file, int line, const char* condition, std::string_view values) {
  fmt::print(stderr, "{}:{}: check failed: {}; {}\n", file, line, condition, values);
  std::fflush(stderr);
  std::abort();
}

}  // namespace sph
