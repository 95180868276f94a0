// One random scene, from its file to its end: is it refused, does it end well, unstable with its cause named, or
// flawed?
#pragma once

#include <cstdint>
#include <string>

#include "lab/random_scene.hpp"
#include "scenes/scene.hpp"

namespace sph {

enum class Ending { kRefused, kOk, kUnstable, kFlawed };

struct Course {
  Ending ending = Ending::kOk;
  std::string flaw = {};
  double seconds = 0;  ///< of wall time
  Scene scene = {};    ///< as it was read; empty if it was refused
};

/// Runs it for so many steps, in the middle of which somebody presses a key of it, drops a block, moves a wall for a
/// while, or does nothing, by the same seed. A flaw is what may not be printed (FirstFlaw), an end without a cause, or
/// a promise not kept (RunWatch).
Course CourseOf(const RandomScene& scene, std::uint64_t seed, long steps, int threads);

}  // namespace sph
