#include "render/wrap.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <vector>

namespace sph {
namespace {

// What parts two pieces of text, the best place for a line break first; nothing parts characters.
constexpr std::array<std::string_view, 3> kSeparators = {"   ", " ", ""};

std::vector<std::string_view> Characters(std::string_view text) {
  std::vector<std::string_view> characters;
  while (!text.empty()) {
    std::size_t length = 1;
    while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xc0) == 0x80) ++length;
    characters.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return characters;
}

std::vector<std::string_view> Split(std::string_view text, std::string_view separator) {
  if (separator.empty()) return Characters(text);
  std::vector<std::string_view> parts;
  for (std::size_t end = 0; end != std::string_view::npos;) {
    end = text.find(separator);
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + separator.size());
  }
  return parts;
}

std::string WrappedAt(std::string_view text, double room, const TextWidth& width,
                      std::span<const std::string_view> separators) {
  if (separators.empty() || width(text) <= room) return std::string(text);
  std::string lines;
  std::string line;
  for (const std::string_view part : Split(text, separators.front())) {
    const std::string longer = line.empty() ? std::string(part) : fmt::format("{}{}{}", line, separators.front(), part);
    if (line.empty() || width(longer) <= room) {
      line = longer;
      continue;
    }
    lines += WrappedAt(line, room, width, separators.subspan(1)) + "\n";
    line = part;
  }
  return lines + WrappedAt(line, room, width, separators.subspan(1));
}

}  // namespace

std::string Wrapped(std::string_view text, double room, const TextWidth& width) {
  std::string wrapped;
  for (const std::string_view line : Split(text, "\n")) {
    if (!wrapped.empty()) wrapped += "\n";
    wrapped += WrappedAt(line, room, width, kSeparators);
  }
  return wrapped;
}

}  // namespace sph
