// What the fuzzers share: an input may be refused as an error of the user's or of a file, and as nothing else.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "base/error.hpp"
#include "io/scratch.hpp"
#include "scenes/build.hpp"
#include "scenes/request.hpp"

namespace sph {

inline std::string TextOf(const std::uint8_t* data, std::size_t size) { return {data, data + size}; }

/// Ends the program, which the fuzzer reports.
inline void Require(bool condition) {
  if (!condition) std::abort();
}

template <typename Work>
void RefusalIsFine(Work work) {
  try {
    work();
  } catch (const Error& error) {
    Require(error.what()[0] != '\0');
  }
}

/// Two steps of a scene that is not too large to be tried often.
inline void StepIfSmall(const Scene& scene) {
  constexpr std::size_t kSmall = 200;
  if (scene.base.fluid.particles > kSmall) return;
  const auto system = MakeSystem(scene);
  const std::size_t particles = system->State().Size();
  for (int step = 0; step < 2; ++step) system->Step();
  Require(system->State().Size() == particles);
  if (system->Trouble()) return;
  for (const double x : system->State().x) Require(std::isfinite(x));
}

}  // namespace sph
