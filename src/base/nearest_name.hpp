// The accepted name that a mistyped one was probably meant to be.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sph {

/// Number of single-character insertions, deletions and replacements that turn `a` into `b` (Levenshtein).
std::size_t EditDistance(std::string_view a, std::string_view b);

/// The member of `names` nearest to `typed` if it is near enough to be a likely slip (at most a third of the letters,
/// at least two, differ), else an empty string. Ties go to the earlier name.
std::string NearestName(std::string_view typed, std::span<const std::string> names);

/// " Did you mean 'name'?" for NearestName, or an empty string: to be appended to a message.
std::string DidYouMean(std::string_view typed, std::span<const std::string> names);

}  // namespace sph
