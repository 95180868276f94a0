// From a scene to a running system: resolution, defaults, forces that follow from others.
#pragma once

#include <memory>

#include "scenes/scene.hpp"
#include "sph/particle_system_sph.hpp"
#include "sph/toy_star.hpp"

namespace sph {

/// The same fluid with N instead of N0 = scene.base.fluid.particles particles: with f = N/N0, mass is divided by f,
/// lengths (h, spacings) and the time step by sqrt(f), and a dropped block has f times the particles. Walls of scaling
/// kDerived keep the same penetration in spacings: K times f, damping times sqrt(f).
void ScaleToParticles(Scene& scene, std::size_t particles);

/// What the system is made of: the scene's parameters with everything filled in that follows from others: the number
/// of particles that fills the region, with a mass that makes them as heavy as those asked for, the star's central
/// force, the block to drop, the particle limit.
Parameters CompleteParameters(const Scene& scene);

/// How many particles the scene starts with, and, where that is not the number asked for, which numbers would fit.
std::string DescribePlacement(const Scene& scene);

/// A system of the scene's solver at its start. UsageError if that is none: a position, density or force that is not a
/// number. TroubleError if the fluid is to settle before, and breaks down.
std::unique_ptr<ParticleSystemSPH> MakeSystem(const Scene& scene);

/// The star that the scene's forces and equation of state make, if it has one.
std::optional<ToyStar> StarOf(const Scene& scene);

/// What a window shows at first [m].
Box InitialView(const Scene& scene);

}  // namespace sph
