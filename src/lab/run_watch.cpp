#include "lab/run_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/filled_area.hpp"

namespace sph {
namespace {

double Mass(const ParticleSystem& system) {
  double mass = 0;
  for (const double m : system.State().mass) mass += m;
  return mass;
}

double Extent(const ParticleSystem& system) {
  const Box box = system.parameters.fluid.region.Bounds();
  return std::hypot(box.Width(), box.Height());
}

/// What the forces could give a particle on its way across the fluid as it is at the start [J/kg].
double FallAcross(const ParticleSystem& system) {
  const double extent = Extent(system);
  return Length(system.parameters.gravity) * extent + std::abs(system.parameters.central_force) * extent * extent;
}

double Sound(const ParticleSystemSPH& system) {
  const double rho0 = ReferenceDensity(system.parameters_sph.equation_of_state);
  const double density = rho0 > 0 ? rho0 : Diagnose(system).density.mean;
  return std::visit([&](const auto& e) { return e.SoundSpeed(density); }, system.parameters_sph.equation_of_state);
}

/// The kinetic energy of a fluid so slow that it makes no difference: 5e-5 of what its forces could give it, or at 1e-4
/// of its sound.
double StillEnergy(const ParticleSystemSPH& system) {
  return Mass(system) * std::max(5e-5 * FallAcross(system), 0.5e-8 * std::pow(Sound(system), 2));
}

/// What energies need not be known to: a liquid's centre of mass to half a per cent of its extent, which is a tenth of
/// the drift that its volume may have; and what noise there is at 1/200 of sound, as densities are to be right to some
/// per mille.
double EnergyThatMayBeMissed(const ParticleSystemSPH& system) {
  if (ReferenceDensity(system.parameters_sph.equation_of_state) <= 0) return StillEnergy(system);
  return Mass(system) * std::max(5e-3 * FallAcross(system), 0.5 * std::pow(0.005 * Sound(system), 2));
}

/// What a surface may set free: no more than if every particle were a square of its own.
double SurfaceEnergy(const ParticleSystemSPH& system) {
  const double edges = 4 * system.InitialSpacing() * static_cast<double>(system.State().Size());
  return system.parameters_sph.delta.surface_tension * edges;
}

/// Gravity along directions in which everything repeats, where it has no potential.
Vec2 GravityAlongPeriods(const ParticleSystemSPH& system) {
  const Periods& periods = system.parameters_sph.periods;
  const Vec2 g = system.parameters.gravity;
  return {periods.in_x ? g.x : 0.0, periods.in_y ? g.y : 0.0};
}

/// What penalty walls hold of the particles that are inside them, as springs do.
double EnergyInWalls(const ParticleSystem& system) {
  if (system.parameters.wall.kind != WallKind::kPenalty) return 0;
  const Particles& p = system.State();
  double sum = 0;
  for (const Wall& wall : system.parameters.walls) {
    for (std::size_t i = 0; i < p.Size(); ++i) {
      const double depth = std::max(0.0, wall.Depth(p.Position(i)));
      sum += 0.5 * p.mass[i] * system.parameters.wall.stiffness * depth * depth;
    }
  }
  return sum;
}

/// Sprays and sheets have no area that could be seen to half a spacing: the layer of particles at the edge is most of
/// them. A square of 14 x 14 that is free on all sides has a layer of 0.29, in a tank one of 0.07.
constexpr double kLongestEdge = 0.25;  // over area and spacing
/// Part of a spacing to which an edge is known where its particles are in no row: dents between them are filled.
constexpr double kRaggedness = 0.25;
/// A sheet two and a half spacings thick is no fluid to any method with neighbours: its energy means nothing.
constexpr double kEdgeOfASheet = 0.8;

/// The particles, and near the ends of periods their images, too.
std::vector<Vec2> PointsOf(const ParticleSystemSPH& system) {
  const Periods& periods = system.parameters_sph.periods;
  const Particles& p = system.State();
  const double near = 2 * system.InitialSpacing();
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < p.Size(); ++i)
    points.push_back(periods.Any() ? periods.Wrap(p.Position(i)) : p.Position(i));
  const auto repeat = [&](Vec2 period, auto coordinate, double low, double high) {
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (coordinate(points[i]) < low + near) points.push_back(points[i] + period);
      if (coordinate(points[i]) > high - near) points.push_back(points[i] - period);
    }
  };
  const Box& box = periods.box;
  if (periods.in_x)
    repeat(
        {box.Width(), 0}, [](Vec2 v) { return v.x; }, box.x0, box.x1);
  if (periods.in_y)
    repeat(
        {0, box.Height()}, [](Vec2 v) { return v.y; }, box.y0, box.y1);
  return points;
}

}  // namespace

RunWatch::RunWatch(const Scene& scene, ParticleSystemSPH& system)
    : scene_(scene),
      system_(system),
      promises_(PromisesOf(scene, system)),
      energy_(NewBudget()),
      volume_(NewVolume()),
      rest_(StillEnergy(system)) {}

EnergyBudget RunWatch::NewBudget() const {
  return {EnergyThatMayBeMissed(system_) + SurfaceEnergy(system_), Mass(system_), FastestSlide(scene_)};
}

VolumeCheck RunWatch::NewVolume() const {
  return VolumeCheck(Mass(system_) / ReferenceDensity(scene_.sph.equation_of_state));
}

void RunWatch::Look() {
  if (system_.Trouble()) return;
  system_.ComputeFields();
  if (system_.Trouble()) return;
  constexpr double kSinceItWasChosen = 1.1;  // limits of an adaptive step move from one step to the next
  step_is_kept_ = system_.parameters.time_step <= kSinceItWasChosen * LargestStep(system_.StepLimits());
  if (WallsMove()) return Disturbed();
  const Diagnostics d = Diagnose(system_);
  AddWork(d);
  if (promises_.volume && looks_ % kLooksApart == 0) LookAtVolume();
  if (!step_is_kept_ || is_a_sheet_) energy_ = NewBudget();
  if (promises_.energy) energy_.Add(d.kinetic_energy, StoredEnergy(d), work_);
  if (promises_.rest && !disturbed_) rest_.Add(d.kinetic_energy);
  Keep(energy_.Flaw());
  Keep(volume_.Flaw());
  ++looks_;
}

void RunWatch::Disturbed() {
  disturbed_ = true;
  const Promises now = PromisesOf(scene_, system_);
  promises_.energy = promises_.energy && now.energy;
  promises_.volume = promises_.volume && now.volume;
  promises_.calm = promises_.calm && now.calm;
  if (IsSqueezed()) promises_ = {};
  energy_ = NewBudget();
  volume_ = NewVolume();
}

void RunWatch::BrokeDown(const std::string& how) {
  if (promises_.calm && step_is_kept_ && !is_a_sheet_ && !WallsMove())
    Keep("broke down with a step that kept its limits: " + how);
  Disturbed();
}

std::string RunWatch::Flaw() const {
  if (!flaw_.empty()) return flaw_;
  return promises_.rest && !disturbed_ ? rest_.Flaw() : "";
}

void RunWatch::Keep(const std::string& flaw) {
  if (flaw_.empty() && !flaw.empty()) flaw_ = fmt::format("by step {}: {}", system_.Steps(), flaw);
}

/// Whether moved walls have left a liquid less room than it has volume.
bool RunWatch::IsSqueezed() const {
  constexpr double kMuch = 0.01;
  if (ReferenceDensity(scene_.sph.equation_of_state) <= 0) return false;
  const Particles& p = system_.State();
  const std::vector<double> density = system_.Density();
  double volume = 0;
  for (std::size_t i = 0; i < density.size(); ++i) volume += p.mass[i] / density[i];
  const double nominal = Mass(system_) / ReferenceDensity(scene_.sph.equation_of_state);
  const bool behind = std::ranges::any_of(system_.parameters.walls, [&](const Wall& wall) {
    for (std::size_t i = 0; i < p.Size(); ++i) {
      if (wall.Depth(p.Position(i)) > 0) return true;
    }
    return false;
  });
  return behind || volume < (1 - kMuch) * nominal;
}

bool RunWatch::WallsMove() const {
  return std::ranges::any_of(system_.parameters.walls, [](const Wall& wall) { return wall.velocity != 0; });
}

double RunWatch::StoredEnergy(const Diagnostics& d) const {
  return d.potential_energy + Mass(system_) * Dot(GravityAlongPeriods(system_), d.centre_of_mass) + d.internal_energy +
         EnergyInWalls(system_);
}

/// The momentum times gravity, summed over the time by the trapezium rule.
void RunWatch::AddWork(const Diagnostics& d) {
  const double power = Dot(GravityAlongPeriods(system_), d.momentum);
  work_ += 0.5 * (power_ + power) * (system_.Time() - time_);
  power_ = power;
  time_ = system_.Time();
}

void RunWatch::LookAtVolume() {
  const std::vector<double> density = system_.Density();
  double by_density = 0;
  for (std::size_t i = 0; i < density.size(); ++i) by_density += system_.State().mass[i] / density[i];
  const double spacing = system_.InitialSpacing();
  const auto shape = FilledShapeOf(PointsOf(system_), spacing, Bounds());
  const double edge = shape ? shape->edge * spacing / shape->area : std::numeric_limits<double>::infinity();
  is_a_sheet_ = edge > kEdgeOfASheet;
  if (edge > kLongestEdge) return volume_.Add(by_density, std::nullopt);
  volume_.Add(by_density, shape->area, kRaggedness * spacing * shape->edge);
}

/// What walls and periods leave.
Box RunWatch::Bounds() const {
  Box bounds = LegalRegion(system_.parameters.walls);
  const Periods& periods = system_.parameters_sph.periods;
  if (periods.in_x) bounds = {periods.box.x0, bounds.y0, periods.box.x1, bounds.y1};
  if (periods.in_y) bounds = {bounds.x0, periods.box.y0, bounds.x1, periods.box.y1};
  return bounds;
}

}  // namespace sph
