// Sessions to press keys in.
#pragma once

#include <string>

#include "window/controls.hpp"
#include "window/session.hpp"

namespace sph {

inline Session SessionOf(const std::string& scene, std::size_t particles = 100,
                         std::vector<std::string> settings = {}) {
  SceneRequest request;
  request.scene = scene;
  request.particles = particles;
  request.threads = 1;
  request.settings = std::move(settings);
  return Session(request);
}

/// One whose first unstable step is its last.
inline Session SessionWithoutRetries() { return SessionOf("dam-break", 100, {"method.retries=0"}); }

/// The wall of that name; the scene must have it.
inline Wall& WallOf(Session& session, const std::string& name) {
  return *FindWall(session.System().parameters.walls, name);
}

/// As --keys types it: down and up again.
inline void Type(Session& session, const std::string& key) {
  PressKey(session, key);
  ReleaseKey(session, key);
}

}  // namespace sph
