// `sphlab scenes` and `sphlab info`: what there is, and what a scene will do.
#pragma once

#include "commands/options.hpp"

namespace sph {

/// The scenes, one a line: name, title.
void ListScenes(bool json);

/// Program, GL back-ends, processor, threads.
void DescribeProgram(bool json);

/// A scene's parameters and its plan: which passes run, and which are skipped and why.
void DescribeScene(const SceneRequest& request, bool json);

}  // namespace sph
