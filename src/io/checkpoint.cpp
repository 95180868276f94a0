#include "io/checkpoint.hpp"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "base/archive.hpp"
#include "base/error.hpp"
#include "base/hash.hpp"
#include "io/whole_file.hpp"

namespace sph {
namespace {

constexpr char kMagic[] = {'s', 'p', 'h', 'l', 'a', 'b', '\r', '\n'};  // a copy as text would change the line's end

/// To be raised whenever what is saved changes.
constexpr std::uint32_t kVersion = 2;

/// Reads as another number where bytes have another order.
constexpr std::uint32_t kByteOrder = 0x01020304;

/// Magic, version, byte order, length of the state.
constexpr std::size_t kFirst = sizeof kMagic + 4 + 4 + 8;

/// FNV-1a makes another sum of any two inputs of a length that differ in one byte: both of its operations can be
/// undone.
std::uint64_t ChecksumOf(std::span<const std::byte> bytes) {
  Hash hash;
  hash.Add(bytes);
  return hash.Value();
}

template <typename T>
void Append(std::vector<std::byte>& bytes, const T& value) {
  const auto* first = reinterpret_cast<const std::byte*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof value);
}

template <typename T>
T Get(std::span<const std::byte> bytes, std::size_t at) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

}  // namespace

void WriteCheckpoint(const std::filesystem::path& path, std::span<const std::byte> state) {
  std::vector<std::byte> file;
  file.reserve(kFirst + state.size() + sizeof(std::uint64_t));
  Append(file, kMagic);
  Append(file, kVersion);
  Append(file, kByteOrder);
  Append(file, std::uint64_t{state.size()});
  file.insert(file.end(), state.begin(), state.end());
  Append(file, ChecksumOf(file));
  WriteWholeFile(path, file);
}

std::vector<std::byte> DecodeCheckpoint(std::span<const std::byte> file, const std::string& name) {
  if (file.size() < sizeof kMagic || std::memcmp(file.data(), kMagic, sizeof kMagic) != 0) {
    throw TroubleError("{} is no checkpoint of sphlab", name);
  }
  if (file.size() < kFirst) throw TroubleError("the checkpoint {} ends after {} bytes", name, file.size());
  const auto version = Get<std::uint32_t>(file, sizeof kMagic);
  const auto byte_order = Get<std::uint32_t>(file, sizeof kMagic + 4);
  const auto length = Get<std::uint64_t>(file, sizeof kMagic + 8);
  if (byte_order != kByteOrder) throw TroubleError("the checkpoint {} is damaged, or of another kind of machine", name);
  if (version != kVersion) {
    throw TroubleError("the checkpoint {} has version {}; this program reads version {}", name, version, kVersion);
  }
  const std::size_t rest = file.size() - kFirst;
  if (rest < sizeof(std::uint64_t) || rest - sizeof(std::uint64_t) != length) {
    throw TroubleError("the checkpoint {} is not whole: it has {} bytes behind its head, not the {} that were written",
                       name, rest, length + sizeof(std::uint64_t));
  }
  const auto state = file.subspan(kFirst, length);
  if (Get<std::uint64_t>(file, kFirst + length) != ChecksumOf(file.first(kFirst + length))) {
    throw TroubleError("the checkpoint {} is damaged: its checksum is another", name);
  }
  return {state.begin(), state.end()};
}

std::vector<std::byte> ReadCheckpoint(const std::filesystem::path& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  std::vector<std::byte> file(error ? 0 : size);
  if (error || !stream.read(reinterpret_cast<char*>(file.data()), static_cast<std::streamsize>(file.size()))) {
    const std::string why = error ? error.message() : std::generic_category().message(errno);
    throw TroubleError("cannot read the checkpoint {}: {}", path.string(), why);
  }
  return DecodeCheckpoint(file, path.string());
}

}  // namespace sph
