// Work on numbered pieces, shared out among OpenMP's threads.
#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

#include "base/first_failure.hpp"

namespace sph {

/// Calls work(piece) once for every piece < count. Each of the threads first takes the pieces of its own part, the same
/// ones every time, so that what it wrote last is still in its cache; then it helps the others, so that none waits long
/// for one whose processor is busy elsewhere. It takes a run of pieces at a time: asking for the next one waits until
/// all that was written before has reached the cache. What work throws is thrown again when all are done.
template <typename Work>
void ShareOut(std::size_t count, int threads, Work work) {
  FirstFailure failure;
  if (threads == 1) {
    for (std::size_t piece = 0; piece < count; ++piece) failure.Catch([&] { work(piece); });
    return failure.Rethrow();
  }
  struct alignas(128) Part {  // two cache lines: processors fetch them in pairs
    std::atomic<std::size_t> next = 0;
    std::size_t end = 0;
  };
  thread_local std::vector<Part> kept;  // for the next time
  const auto number = static_cast<std::size_t>(threads);
  if (kept.size() < number) kept = std::vector<Part>(number);
  std::vector<Part>& parts = kept;  // of the thread that shares out
  constexpr std::size_t kRunsOfAPart = 32;
  const std::size_t run = std::max<std::size_t>(1, count / number / kRunsOfAPart);
  for (std::size_t part = 0; part < number; ++part) {
    parts[part].next = count * part / number;
    parts[part].end = count * (part + 1) / number;
  }
#pragma omp parallel num_threads(threads)
  {
    const auto own = static_cast<std::size_t>(omp_get_thread_num());
    for (std::size_t others = 0; others < number; ++others) {
      Part& part = parts[(own + others) % number];
      while (true) {
        const std::size_t first = part.next.fetch_add(run, std::memory_order_relaxed);
        if (first >= part.end) break;
        for (std::size_t piece = first; piece < std::min(first + run, part.end); ++piece) {
          failure.Catch([&] { work(piece); });
        }
      }
    }
  }
  failure.Rethrow();
}

}  // namespace sph
