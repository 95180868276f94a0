#include "base/instruction_set.hpp"

#include <fmt/ranges.h>
#include <hwy/highway.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/nearest_name.hpp"

namespace sph {
namespace {

/// Highway's targets are bits; a better one is a lower bit. Those of one name are used together.
struct Named {
  const char* name;
  std::int64_t targets;
};
constexpr Named kSets[] = {
    {"avx512", HWY_AVX3 | HWY_AVX3_DL},
    {"avx2", HWY_AVX2},
};

bool Available(const Named& set) { return (hwy::SupportedTargets() & set.targets) != 0; }

std::vector<std::string> Available() {
  std::vector<std::string> names = {"baseline"};
  for (const Named& set : {kSets[1], kSets[0]}) {
    if (Available(set)) names.emplace_back(set.name);
  }
  return names;
}

std::string in_use;  // empty: the best

}  // namespace

std::vector<std::string> AvailableInstructionSets() {
  static const std::vector<std::string> names = Available();  // before any is disabled
  return names;
}

void UseInstructionSet(std::string_view name, std::string_view source) {
  const std::vector<std::string> names = AvailableInstructionSets();
  const bool known = std::find(names.begin(), names.end(), name) != names.end();
  if (!known && name != "best") {
    throw UsageError("{}: the instruction set '{}' is not available.{} There are: {}, best", source, name,
                     DidYouMean(name, names), fmt::join(names, ", "));
  }
  in_use = name == "best" ? names.back() : std::string(name);
  hwy::DisableTargets(0);
  std::int64_t disabled = 0;
  if (in_use == "baseline") disabled = kSets[0].targets | kSets[1].targets;
  if (in_use == "avx2") disabled = kSets[0].targets;
  hwy::DisableTargets(disabled);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

std::string InstructionSetInUse() { return in_use.empty() ? AvailableInstructionSets().back() : in_use; }

}  // namespace sph
