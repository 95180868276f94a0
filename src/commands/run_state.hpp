// A run as a file, to go on with later: the session, where its key script stands, and the rows of its time series.
#pragma once

#include <string>

#include "commands/run.hpp"
#include "commands/time_series.hpp"
#include "window/key_script.hpp"
#include "window/session.hpp"

namespace sph {

struct RunState {
  Session& session;
  KeyScript& keys;
  TimeSeries& series;
};

/// Replaces the checkpoint at `path`, whole or not at all; `request` is what the run began with.
void SaveRun(const std::string& path, const SceneRequest& request, RunState run);

/// What a run has to begin with to go on from `path`: the request that was saved, with the number of threads of
/// `given`. TroubleError as ReadCheckpoint; UsageError where something else that was given differs from what was saved.
SceneRequest RequestToGoOnWith(const std::string& path, const SceneRequest& given, bool scene_given);

/// Puts a run of that request where it was saved. TroubleError if the state does not fit it.
void RestoreRun(const std::string& path, RunState run);

}  // namespace sph
