#include "sph/particle_system_sph.hpp"

#include <algorithm>
#include <limits>

namespace sph {

ParticleSystemSPH::ParticleSystemSPH(const Parameters& base, const ParametersSPH& sph)
    : ParticleSystem(base), parameters_sph(sph), initial_parameters_sph_(sph) {
  SPH_CHECK(sph.smoothing_length > 0, "h = {}", sph.smoothing_length);
  if (sph.precision == Precision::kDouble) fluid_ = FluidArrays<double>();
}

void ParticleSystemSPH::RestoreParameters() {
  ParticleSystem::RestoreParameters();
  parameters_sph = initial_parameters_sph_;
}

void ParticleSystemSPH::InitialPositions() {
  ParticleSystem::InitialPositions();
  if (parameters_sph.flow == nullptr || parameters.given != nullptr) return;
  Particles& p = particles_;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const Vec2 velocity = parameters.fluid.velocity + FlowAt(p.Position(i)).velocity;
    p.vx[i] = p.vx_prev[i] = velocity.x;
    p.vy[i] = p.vy_prev[i] = velocity.y;
  }
  if (!parameters_sph.graded_masses || !parameters.start.empty()) return;
  const double rho0 = ReferenceDensity(parameters_sph.equation_of_state);
  double sum = 0;  // [kg/m^3]
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const FlowAtPoint flow = FlowAt(p.Position(i));
    const auto density = [&](const auto& equation) { return equation.Density(flow.pressure); };
    p.mass[i] = rho0 > 0 ? std::visit(density, parameters_sph.equation_of_state) : flow.density;
    sum += p.mass[i];
  }
  // A liquid's particles fill equal areas; a gas has its mass.
  const double area =
      rho0 > 0 ? parameters.particle_mass / rho0 : parameters.particle_mass * static_cast<double>(p.Size()) / sum;
  for (std::size_t i = 0; i < p.Size(); ++i) p.mass[i] *= area;
}

FlowAtPoint ParticleSystemSPH::FlowAt(Vec2 point) const {
  if (parameters_sph.flow == nullptr) return {};
  return parameters_sph.flow->at(point, {parameters.fluid.region.Bounds(), parameters_sph.flow_speed,
                                         ReferenceDensity(parameters_sph.equation_of_state),
                                         parameters.particle_mass * static_cast<double>(parameters.fluid.particles),
                                         parameters.gravity, parameters.central_force});
}

void ParticleSystemSPH::ForgetNeighbours() { neighbours_.Invalidate(); }

void ParticleSystemSPH::ComputeAccelerations() {
  ComputePressures();
  const PhaseTimer timer(phases_, "pressure");
  ForEachBlock([&](const ListBlock& block) {
    const auto [first, last] = ParticlesOf(block);
    ClearAccelerations(first, last);
    AddSpatialInteraction(block);
    AddGravity(first, last);
    AddMotionDamping(first, last);
  });
}

void ParticleSystemSPH::PrepareGrid() {
  const PhaseTimer timer(phases_, "grid");
  Particles& p = particles_;
  SearchTask task = neighbours_.NextTask(Time(), Support());
  const Ends ends = EndsBefore(0);
  if (ends != neighbours_.CurrentEnds() && task == SearchTask::kNothing) task = SearchTask::kLists;
  neighbours_.SetEnds(ends);
  neighbours_.UseThreads(ThreadCount());
  std::visit(
      [&]<typename Real>(FluidArrays<Real>& fluid) {
        if (task == SearchTask::kNothing) {
          SetPositions(p.x, p.y, ends);
          if (neighbours_.Hold(fluid.positions, Time())) return;
        }
        if (task == SearchTask::kSort || !neighbours_.AreCompact(p.x, p.y)) {
          WrapPositions();
          neighbours_.Sort(p.x, p.y, InitialSpacing(), Lanes<Real>());
          Reorder(neighbours_.Order());
          neighbours_.Cut(p.x, p.y);
          const bool equal = std::adjacent_find(p.mass.begin(), p.mass.end(), std::not_equal_to<>()) == p.mass.end();
          equal ? fluid.mass.clear() : Convert<Real>(p.mass, fluid.mass);
        }
        double fastest_wall = 0;  // [m/s]
        for (const Wall& wall : parameters.walls) fastest_wall = std::max(fastest_wall, std::abs(wall.velocity));
        neighbours_.Prepare({p.x, p.y, p.vx, p.vy, p.vx_prev, p.vy_prev, Time(), LastStep()}, ListsHoldBefore(),
                            ListsHoldBefore() * fastest_wall);
        ResizeArrays(p.Size() + neighbours_.Extras());
        if (!fluid.mass.empty()) CopyToImages(fluid.mass);
        SetPositions(p.x, p.y, ends);
        ForEachBlock([&](ListBlock& block) { FindCells(block); });
        FindCellsOfWalls();
        neighbours_.Finish();
      },
      fluid_);
}

void ParticleSystemSPH::WrapPositions() {
  if (!parameters_sph.periods.Any()) return;
  Particles& p = particles_;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const Vec2 wrapped = parameters_sph.periods.Wrap(p.Position(i));
    p.x[i] = wrapped.x;
    p.y[i] = wrapped.y;
  }
}

std::optional<std::pair<std::vector<double>, std::vector<double>>> ParticleSystemSPH::ShownPositions() const {
  if (!parameters_sph.periods.Any()) return std::nullopt;
  const Particles& p = particles_;
  std::pair<std::vector<double>, std::vector<double>> shown{p.x, p.y};
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const Vec2 wrapped = parameters_sph.periods.Wrap(p.Position(i));
    shown.first[i] = wrapped.x;
    shown.second[i] = wrapped.y;
  }
  return shown;
}

Ends ParticleSystemSPH::EndsBefore(double seconds) const {
  Ends ends;
  if (parameters.wall.SeenByFluid()) {
    const Box legal = LegalRegion(parameters.walls, seconds);
    ends = {{legal.x0, legal.x1}, {legal.y0, legal.y1}};
    if (parameters.wall.kind == WallKind::kParticles) ends.site_spacing = InitialSpacing();
  }
  const Periods& periods = parameters_sph.periods;
  if (periods.in_x) ends.x = {periods.box.x0, periods.box.x1, true};
  if (periods.in_y) ends.y = {periods.box.y0, periods.box.y1, true};
  return ends;
}

void ParticleSystemSPH::SetPositions(std::span<const double> x, std::span<const double> y, const Ends& ends) {
  std::visit(
      [&](auto& fluid) {
        ForEachChunk([&](std::size_t, std::size_t first, std::size_t last) {
          fluid.positions.Set(x, y, Support(), first, last);
        });
        neighbours_.PlaceExtras(ends, x, y, extra_x_, extra_y_);
        fluid.positions.SetImages(extra_x_, extra_y_, Support(), x.size());
      },
      fluid_);
}

void ParticleSystemSPH::FindCells(ListBlock& block) {
  std::visit(
      [&]<typename Real>(const FluidArrays<Real>& fluid) {
        const ClusterSets sets = neighbours_.Sets();
        FindNeighbours<Real>(sets[0], sets, fluid.positions, neighbours_.CurrentReach(), block);
      },
      fluid_);
}

/// What wall particles see: the fluid and its images, not each other.
void ParticleSystemSPH::FindCellsOfWalls() {
  std::visit(
      [&]<typename Real>(const FluidArrays<Real>& fluid) {
        const ClusterSets sets = neighbours_.Sets();
        ForEach(neighbours_.WallBlocks(), [&](ListBlock& block) {
          FindNeighbours<Real>(sets[2], {sets[0], sets[1]}, fluid.positions, neighbours_.CurrentReach(), block);
        });
      },
      fluid_);
}

void ParticleSystemSPH::ResizeArrays(std::size_t n) {
  std::visit(
      [n](auto& fluid) {
        fluid.positions.Resize(n);
        fluid.density.resize(n + kPadding);
        fluid.pressure_term.resize(n + kPadding);
        if (!fluid.mass.empty()) fluid.mass.resize(n + kPadding);
      },
      fluid_);
}

void ParticleSystemSPH::ComputeDensities(ListBlock& block) {
  std::visit([&](auto& fluid) { ComputeCubicSplineDensity(InputOf(fluid), block, fluid.density.data()); }, fluid_);
}

void ParticleSystemSPH::PrepareInteraction(std::size_t first, std::size_t last) {
  std::visit(
      [&]<typename Real>(FluidArrays<Real>& fluid, const auto& equation_of_state) {
        for (std::size_t i = first; i < last; ++i) {
          const Real rho = fluid.density[i];
          fluid.pressure_term[i] = equation_of_state.Pressure(rho) / (rho * rho);
        }
      },
      fluid_, parameters_sph.equation_of_state);
}

void ParticleSystemSPH::ComputePressures() {
  PrepareGrid();
  const PhaseTimer timer(phases_, "density");
  ForEachBlock([&](ListBlock& block) {
    ComputeDensities(block);
    const auto [first, last] = ParticlesOf(block);
    PrepareInteraction(first, last);
  });
  if (neighbours_.AllImages().Size() > 0) PrepareImages();
}

void ParticleSystemSPH::PrepareImages() {
  std::visit([&](auto& fluid) { CopyToImages(fluid.pressure_term); }, fluid_);
}

void ParticleSystemSPH::AddSpatialInteraction(const ListBlock& block) {
  std::visit(
      [&](auto& fluid) {
        AddCubicSplinePressure(InputOf(fluid), block, fluid.pressure_term.data(), particles_.ax.data(),
                               particles_.ay.data());
      },
      fluid_);
}

std::pair<std::size_t, std::size_t> ParticleSystemSPH::ParticlesOf(const ListBlock& block) const {
  const auto clusters = neighbours_.Clusters();
  const Cluster& last = clusters[block.last - 1];
  return {clusters[block.first].first, last.first + last.count};
}

std::vector<double> ParticleSystemSPH::Density() const {
  return std::visit(
      [&](const auto& fluid) {
        const auto n = static_cast<std::ptrdiff_t>(std::min(particles_.Size(), fluid.density.size()));
        return std::vector<double>(fluid.density.begin(), fluid.density.begin() + n);
      },
      fluid_);
}

std::vector<double> ParticleSystemSPH::Pressure() const {
  std::vector<double> values = Density();
  std::visit(
      [&](const auto& equation_of_state) {
        for (double& value : values) value = equation_of_state.Pressure(value);
      },
      parameters_sph.equation_of_state);
  return values;
}

double ParticleSystemSPH::InternalEnergy() const {
  const std::vector<double> density = Density();
  return std::visit(
      [&](const auto& equation_of_state) {
        double sum = 0;
        for (std::size_t i = 0; i < density.size(); ++i) {
          sum += particles_.mass[i] * equation_of_state.InternalEnergy(density[i]);
        }
        return sum;
      },
      parameters_sph.equation_of_state);
}

/// The fastest sound: every equation of state here stiffens with density.
double ParticleSystemSPH::FastestSound() const {
  const double densest = std::visit(
      [&](const auto& fluid) {
        const auto n = static_cast<std::ptrdiff_t>(std::min(particles_.Size(), fluid.density.size()));
        return n == 0 ? 0.0 : static_cast<double>(*std::max_element(fluid.density.begin(), fluid.density.begin() + n));
      },
      fluid_);
  return std::visit([&](const auto& equation_of_state) { return equation_of_state.SoundSpeed(densest); },
                    parameters_sph.equation_of_state);
}

/// No further than the support, or than half a period is longer: no particle may have two images of another near it.
double ParticleSystemSPH::LongestMove() const {
  const Periods& periods = parameters_sph.periods;
  const double part = parameters.wall.kind == WallKind::kParticles ? 0.25 : 0.5;  // see FindExtras
  double longest = Support();
  if (periods.in_x) longest = std::min(longest, part * periods.box.Width() - Support());
  if (periods.in_y) longest = std::min(longest, part * periods.box.Height() - Support());
  constexpr double kForShifts = 0.9;
  return longest < Support() ? kForShifts * longest : longest;
}

/// 1.31 to 1.38 for the cubic spline's gas, P = rho c^2/2; more where pressures are lower.
double ParticleSystemSPH::StableSoundStep() const { return 1.31; }

std::vector<StepLimit> ParticleSystemSPH::StepLimits() const {
  std::vector<StepLimit> limits = ParticleSystem::StepLimits();
  const double h = 0.5 * Support();
  const double sound = FastestSound();
  limits.push_back(
      {"speed of sound", sound > 0 ? StableSoundStep() * h / sound : std::numeric_limits<double>::infinity()});
  double fastest2 = 0;
  double pushed2 = 0;
  const Particles& p = particles_;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    fastest2 = std::max(fastest2, p.vx_prev[i] * p.vx_prev[i] + p.vy_prev[i] * p.vy_prev[i]);
    pushed2 = std::max(pushed2, p.ax[i] * p.ax[i] + p.ay[i] * p.ay[i]);
  }
  // No particle passes its neighbours, or is thrown past them, within a step.
  limits.push_back({"speed of the particles", 0.5 * h / std::sqrt(fastest2), LimitKind::kAccuracy});
  limits.push_back({"acceleration", 0.5 * std::sqrt(h / std::sqrt(pushed2)), LimitKind::kAccuracy});
  return limits;
}

double ParticleSystemSPH::MeanNeighbours() const {
  const Particles& p = particles_;
  const double support2 = Support() * Support();
  std::vector<double> x, y;  // of images and wall particles
  neighbours_.PlaceExtras(neighbours_.CurrentEnds(), p.x, p.y, x, y);
  const auto position = [&](std::size_t j) {
    return j < p.Size() ? p.Position(j) : Vec2{x[j - p.Size()], y[j - p.Size()]};
  };
  std::size_t pairs = 0;
  for (const ListBlock& block : neighbours_.Blocks()) {
    for (std::uint32_t k = block.first; k < block.last; ++k) {
      const Cluster& cluster = neighbours_.Clusters()[k];
      for (std::uint32_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
        for (const std::uint32_t j : block.Of(k)) {
          const Vec2 apart = p.Position(i) - position(j);
          pairs += j != i && Dot(apart, apart) < support2 ? 1 : 0;
        }
      }
    }
  }
  return p.Size() == 0 ? 0 : static_cast<double>(pairs) / static_cast<double>(p.Size());
}

std::size_t ParticleSystemSPH::Bytes() const {
  return particles_.Bytes() + neighbours_.Bytes() + std::visit([](const auto& fluid) { return fluid.Bytes(); }, fluid_);
}

void ParticleSystemSPH::Transfer(Archive& archive) {
  ParticleSystem::Transfer(archive);
  if (archive.Wanted() == Archive::Extent::kPhysics) {
    if (archive.Reading()) neighbours_.Invalidate();
    return;
  }
  std::visit(
      [&]<typename Real>(FluidArrays<Real>& fluid) {
        neighbours_.Transfer(archive, particles_.Size(), Lanes<Real>());
        archive(fluid.mass, fluid.density);  // who looks before the next step sees the density of the last
        if (!archive.Reading()) return;
        Archive::Require(fluid.mass.empty() || fluid.mass.size() >= particles_.Size());
        ResizeArrays(particles_.Size() + neighbours_.Extras());
      },
      fluid_);
}

std::vector<PassPlan> ParticleSystemSPH::Plan() const {
  std::vector<PassPlan> plan = {
      {"grid", true, "particles sorted into clusters, and neighbour lists, only when one has left its course"},
      {"density", true, "density (eq. 8) and pressure"},
      {"pressure", true, "pressure acceleration (eq. 10)"},
  };
  const std::vector<PassPlan> base = ParticleSystem::Plan();
  plan.insert(plan.end(), base.begin(), base.end());
  return plan;
}

}  // namespace sph
