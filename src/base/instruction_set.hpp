// Which of the processor's instruction sets the passes over particles use.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sph {

/// The sets that this program has code for and this processor has: "baseline", then "avx2" and "avx512" if they are
/// there.
std::vector<std::string> AvailableInstructionSets();

/// From now on the named set is used; "best" for the last of AvailableInstructionSets, which is the default. To be
/// called before the first pass. UsageError, naming `source` and what is available, for any other name.
void UseInstructionSet(std::string_view name, std::string_view source);

/// The set in use.
std::string InstructionSetInUse();

}  // namespace sph
