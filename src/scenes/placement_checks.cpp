#include "scenes/placement_checks.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace sph {
namespace {

/// To be printed as what is still accepted.
double RoundedDown(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 3);
  return std::floor(value / unit) * unit;
}

/// The largest spacing [m] of a square lattice that has room for so many particles in the box.
double LargestSpacing(const Box& box, std::size_t particles) {
  const auto n = static_cast<double>(particles);
  double largest = 0;
  for (double columns = 1; columns <= n && box.Width() / columns > largest; ++columns) {
    largest = std::max(largest, std::min(box.Width() / columns, box.Height() / std::ceil(n / columns)));
  }
  return largest;
}

/// Of particles in rows from the bottom up, `height` [m] being what there is room for.
std::string WhatFits(const Block& fluid, double height) {
  Box room = fluid.region.box;
  room.y1 = room.y0 + height;
  const double spacing = Spacing(fluid);
  constexpr double kRoundOff = 1e-9;
  const double rows = std::floor(height / spacing + kRoundOff);
  const double columns = std::max(1.0, std::floor(room.Width() / spacing + kRoundOff));
  return fmt::format("fluid.particles = {} would fit, or fluid.spacing = {:.4g} m", columns * rows,
                     RoundedDown(LargestSpacing(room, fluid.particles)));
}

double DepthOf(const Wall& wall, const Box& box) {
  return std::max(wall.Depth({box.x0, box.y0}), wall.Depth({box.x1, box.y1}));
}

void CheckStartBehindWalls(const Scene& scene, const std::string& source) {
  constexpr double kRoundOff = 1e-9;
  const Block fluid = Fitted(scene.base.fluid);
  const Box extent = StartBounds(fluid);
  for (const Wall& wall : scene.base.walls) {
    const double depth = DepthOf(wall, extent);
    if (depth <= kRoundOff * Spacing(fluid)) continue;
    if (depth <= fluid.jitter) {
      throw UsageError(
          "{}: fluid.jitter = {} m may move particles behind the wall '{}' at {} m: it takes {:.4g} m or less", source,
          fluid.jitter, wall.name, wall.at, std::max(0.0, fluid.jitter - depth));
    }
    throw UsageError(
        "{}: the fluid's lattice goes on above its region, up to y = {:.6g} m, and behind the wall '{}' at {} m: {}",
        source, extent.y1, wall.name, wall.at, WhatFits(fluid, wall.at - fluid.region.box.y0));
  }
}

void CheckWithinPeriods(const Scene& scene, const std::string& source) {
  const Periods& periods = scene.sph.periods;
  const Block fluid = Fitted(scene.base.fluid);
  const Box region = fluid.region.Bounds();
  constexpr double kRoundOff = 1e-9;
  const auto exceeds = [](double length, double period) { return length > period * (1 + kRoundOff); };
  const bool in_x = periods.in_x && exceeds(region.Width(), periods.box.Width());
  const bool in_y = periods.in_y && exceeds(region.Height(), periods.box.Height());
  if (in_x || in_y) {
    throw UsageError(
        "{}: the fluid's region is {:.6g} m {} and repeats every {:.6g} m (periodic.box): particles would start at the "
        "places of others",
        source, in_x ? region.Width() : region.Height(), in_x ? "wide" : "high",
        in_x ? periods.box.Width() : periods.box.Height());
  }
  const double top = StartBounds(fluid).y1 + 0.5 * Spacing(fluid) - fluid.jitter;
  if (fluid.spacing <= 0 || !periods.in_y || !exceeds(top - region.y0, periods.box.Height())) return;
  throw UsageError(
      "{}: the fluid's lattice goes on above its region, up to y = {:.6g} m, and repeats every {:.6g} m "
      "(periodic.box): "
      "{}",
      source, top, periods.box.Height(), WhatFits(fluid, periods.box.Height()));
}

/// Of double precision's 52 bits half are left to the spacing, so that a lattice is even to a hundred-millionth. The
/// passes in float count in 2^-28 supports, and positions beyond 2^23 supports are no such numbers any more; half of
/// that leaves the fluid a way to go.
void CheckDistances(const Scene& scene, const std::string& source) {
  Block fluid = scene.base.fluid;
  if (!fluid.IsLattice()) fluid.spacing = 0;  // which only lattices have
  const double spacing = Spacing(fluid);
  if (!(spacing > 0)) {
    throw UsageError("{}: the fluid's region is too small for {} particles", source, fluid.particles);
  }
  const bool in_float = scene.sph.precision == Precision::kFloat;
  const double furthest_in_float = in_float ? 0x1p22 * scene.sph.smoothing_length : HUGE_VAL;  // or 2 h, or 3 h
  const double furthest = std::min(0x1p26 * spacing, furthest_in_float);
  for (const Box& box : {fluid.region.Bounds(), scene.base.drop.region.Bounds(), scene.sph.periods.box}) {
    const double away = std::max({std::abs(box.x0), std::abs(box.x1), std::abs(box.y0), std::abs(box.y1)});
    if (away <= furthest) continue;
    throw UsageError(
        "{}: {:.6g} m from the origin positions cannot be told apart well enough for a spacing of {:.4g} m{}: it takes "
        "{:.4g} m or less",
        source, away, spacing, in_float ? " in float" : "", RoundedDown(furthest));
  }
}

struct Side {
  const char* name;
  FluidSide wall;  ///< that bounds the fluid there
  bool repeats;
  double end;  ///< of the region [m]
};

/// A wall to which the fluid is nearer than two spacings, so that it leans on it.
bool Leans(const Scene& scene, const Side& side) {
  const double reach = 2 * Spacing(scene.base.fluid);
  return std::ranges::any_of(scene.base.walls, [&](const Wall& wall) {
    return wall.fluid == side.wall && std::abs(wall.at - side.end) <= reach;
  });
}

void CheckWeight(const Scene& scene, const std::string& source) {
  if (scene.sph.flow == nullptr || scene.sph.flow->weight == Weight::kNone) return;
  const std::string& flow = scene.sph.flow->name;
  const Vec2 g = scene.base.gravity;
  if (scene.sph.flow->weight == Weight::kDownwards && (g.x != 0 || g.y > 0)) {
    throw UsageError("{}: fluid.flow = '{}' takes a gravity straight down; here it is [{}, {}] m/s^2", source, flow,
                     g.x, g.y);
  }
  const Box region = scene.base.fluid.region.Bounds();
  const Periods& periods = scene.sph.periods;
  const Side along_x = g.x < 0 ? Side{"left", FluidSide::kRight, periods.in_x, region.x0}
                               : Side{"right", FluidSide::kLeft, periods.in_x, region.x1};
  const Side along_y = g.y < 0 ? Side{"bottom", FluidSide::kAbove, periods.in_y, region.y0}
                               : Side{"top", FluidSide::kBelow, periods.in_y, region.y1};
  for (const auto& [side, component] : {std::pair{along_x, g.x}, std::pair{along_y, g.y}}) {
    if (component == 0) continue;
    if (side.repeats) {
      throw UsageError(
          "{}: fluid.flow = '{}': gravity [{}, {}] points to the {}, where the fluid repeats and no wall "
          "holds it",
          source, flow, g.x, g.y, side.name);
    }
    if (Leans(scene, side)) continue;
    throw UsageError(
        "{}: fluid.flow = '{}': gravity [{}, {}] presses the fluid against its {}, and no wall holds it "
        "there: it takes one at {} m",
        source, flow, g.x, g.y, side.name, side.end);
  }
}

}  // namespace

void CheckPlacement(const Scene& scene, const std::string& source) {
  CheckDistances(scene, source);
  CheckWithinPeriods(scene, source);
  CheckStartBehindWalls(scene, source);
  CheckWeight(scene, source);
}

}  // namespace sph
