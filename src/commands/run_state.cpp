#include "commands/run_state.hpp"

#include "base/error.hpp"
#include "io/checkpoint.hpp"

namespace sph {
namespace {

void TransferRun(Archive& archive, RunState run) {
  run.session.Transfer(archive);
  run.keys.Transfer(archive);
  run.series.Transfer(archive);
}

/// The saved request; the archive stands behind it then.
SceneRequest SavedRequest(Archive& archive) {
  SceneRequest request;
  TransferRequest(archive, request);
  return request;
}

/// UsageError where an option was given and was not so when the run was saved.
template <typename T>
void CheckSame(const std::string& option, const std::optional<T>& given, const std::optional<T>& saved) {
  if (!given || given == saved) return;
  const std::string had = saved ? fmt::format("{} {}", option, *saved) : "no " + option;
  const std::string has = fmt::format("{} {}", option, *given);
  throw UsageError("--restart goes on with the run that was saved, and that had {}, not {}: leave it out", had, has);
}

}  // namespace

void SaveRun(const std::string& path, const SceneRequest& request, RunState run) {
  std::vector<std::byte> state;
  Archive archive = Archive::Writer(state, Archive::Extent::kSameBits);
  SceneRequest copy = request;
  TransferRequest(archive, copy);
  TransferRun(archive, run);
  WriteCheckpoint(path, state);
}

SceneRequest RequestToGoOnWith(const std::string& path, const SceneRequest& given, bool scene_given) {
  const std::vector<std::byte> state = ReadCheckpoint(path);
  Archive archive = Archive::Reader(state, Archive::Extent::kSameBits);
  SceneRequest request = SavedRequest(archive);
  request.threads = given.threads;
  if (scene_given && given.scene != request.scene) {
    throw UsageError(
        "--restart goes on with the run that was saved, and that was of the scene {}, not {}: leave it out",
        request.scene, given.scene);
  }
  CheckSame("--solver", given.solver, request.solver);
  CheckSame("--precision", given.precision, request.precision);
  CheckSame("--particles", given.particles, request.particles);
  CheckSame("--seed", given.seed, request.seed);
  const auto joined = [](const std::vector<std::string>& settings) {
    std::optional<std::string> text;
    for (const std::string& setting : settings) text = (text ? *text + " --set " : "") + setting;
    return text;
  };
  CheckSame("--set", joined(given.settings), joined(request.settings));
  return request;
}

void RestoreRun(const std::string& path, RunState run) {
  const std::vector<std::byte> state = ReadCheckpoint(path);
  Archive archive = Archive::Reader(state, Archive::Extent::kSameBits);
  SavedRequest(archive);
  try {
    TransferRun(archive, run);
    Archive::Require(archive.AtEnd());
  } catch (const TroubleError& error) {
    throw TroubleError("cannot go on from {}: {}", path, error.what());
  }
}

}  // namespace sph
