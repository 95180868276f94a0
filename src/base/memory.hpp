// How much memory arrays take as they grow, and what becomes of memory that is freed.
#pragma once

#include <cstddef>
#include <vector>

namespace sph {

/// Room for `size` values; where there was less, with a sixteenth to spare: resize and push_back would double it.
template <typename T>
void MakeRoom(std::vector<T>& values, std::size_t size) {
  if (values.capacity() < size) values.reserve(size + size / 16);
}

/// From now on memory that is freed stays with the program (with glibc; elsewhere nothing changes). Who draws frames
/// asks for the same few megabytes again in each: OpenGL in software for its lists of what is in each tile. Given back
/// and had anew they cost a page fault each 4 kB: measured with llvmpipe, 9 of the 41 ms of processor time that a frame
/// of 100 000 disks took.
void KeepFreedMemory();

}  // namespace sph
