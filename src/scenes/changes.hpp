// What may be changed of a system while it runs, and how: walls moved by hand, scene keys set.
#pragma once

#include <string>

#include "scenes/scene.hpp"
#include "sph/particle_system_sph.hpp"

namespace sph {

/// Moves a wall at once, beyond its range if need be; it then stands still. Precondition: there is a wall of that name.
void MoveWallTo(ParticleSystemSPH& system, const std::string& wall, double to);

/// Sets a key of the scene and of its system. UsageError, and nothing is changed, if the key may not change while the
/// scene runs or does not take the value.
void SetWhileRunning(Scene& scene, ParticleSystemSPH& system, const std::string& key, double to);

/// What a key does in that scene alone; nothing if it has no meaning there.
void PressSceneKey(const std::string& key, Scene& scene, ParticleSystemSPH& system);

}  // namespace sph
