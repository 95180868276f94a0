// What `sphlab run` says at its end, as JSON and in words.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "window/session.hpp"

namespace sph {

/// The fields of `run --json`. The system's fields must be those of its current time (ComputeFields).
nlohmann::ordered_json ReportRun(const Session& session, double wall_seconds);

/// The same in words, for people.
std::string DescribeRun(const nlohmann::ordered_json& report);

/// Metrics against the exact solution that the scene's reference declares; empty without one.
std::map<std::string, double> ErrorsAgainstReference(const Session& session);

}  // namespace sph
