// Breaks text into lines that are not too wide.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace sph {

/// The width of a piece of text on one line [pixels].
using TextWidth = std::function<double(std::string_view)>;

/// `text` with as many line breaks as it takes for every line to be at most `room` wide: where three spaces part two
/// fields, else between words, else (only a word that is too wide on its own) between UTF-8 characters.
std::string Wrapped(std::string_view text, double room, const TextWidth& width);

}  // namespace sph
