// Verlet lists of clusters, built on vectors; the target loop of Highway comes first.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "neighbours/cluster_lists.cpp"
#include "neighbours/cluster_lists.hpp"

#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include <algorithm>

#include "base/memory.hpp"
#include "neighbours/coordinates-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sph {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Distance of coordinates from an interval, as Real: 0 inside.
template <class D, class V>
HWY_INLINE V Beyond(D d, V offset_from_centre, V half_width) {
  return hn::Max(hn::Sub(hn::Abs(offset_from_centre), half_width), hn::Zero(d));
}

template <typename Real>
void Find(const ClusterSet& own, const ClusterSets& others, const Positions<Real>& positions, const ListReach& reach,
          ListBlock& block) {
  const hn::ScalableTag<Real> d;
  const hn::Rebind<std::uint32_t, decltype(d)> du;
  const auto lanes = static_cast<std::uint32_t>(hn::Lanes(d));
  const double per_unit = 1 / Positions<Real>::Unit(reach.support);
  // Found in here and copied, so that the block's own room is hardly more than it needs.
  thread_local std::vector<std::uint32_t> numbers;
  std::uint32_t found = 0;
  block.coarse = true;
  block.begin.assign(block.last - block.first + 1, 0);
  block.reach.assign(block.last - block.first, 1);
  for (std::uint32_t k = block.first; k < block.last; ++k) {
    const Box& box = own.boxes->Of(k);
    const ClusterCourse& course = own.courses[k];
    const auto x = Positions<Real>::ToCoordinate(box.Centre().x, per_unit);
    const auto y = Positions<Real>::ToCoordinate(box.Centre().y, per_unit);
    const auto half_width = hn::Set(d, static_cast<Real>(0.5 * box.Width() * per_unit));
    const auto half_height = hn::Set(d, static_cast<Real>(0.5 * box.Height() * per_unit));
    double longest = reach.support;
    const auto add_near = [&](const Cluster& other, std::uint32_t first, double upto) HWY_ATTR {
      if (numbers.size() < found + lanes) numbers.resize(2 * std::size_t{found + lanes});
      // A little further than asked for, against the rounding of the conversion to Real.
      const auto units = static_cast<Real>(upto * per_unit * (1 + 1e-6));
      const auto dx = Beyond(d, Difference(d, LoadCoordinates(d, positions.X() + first), x), half_width);
      const auto dy = Beyond(d, Difference(d, LoadCoordinates(d, positions.Y() + first), y), half_height);
      const auto within = hn::Lt(hn::MulAdd(dx, dx, hn::Mul(dy, dy)), hn::Set(d, units * units));
      // The same lanes as a mask of the numbers, which are of 32 bits in either precision.
      HWY_ALIGN std::uint8_t bits[8] = {};
      hn::StoreMaskBits(d, hn::And(within, hn::FirstN(d, other.count)), bits);
      const auto mask = hn::LoadMaskBits(du, bits);
      // In a register, because AMD's Zen 4 takes some hundred cycles to compress into memory.
      hn::StoreU(hn::Compress(hn::Iota(du, first), mask), du, numbers.data() + found);
      found += static_cast<std::uint32_t>(hn::CountTrue(du, mask));
    };
    const double greatest = reach.support + TravelOf(course, reach.horizon) + reach.greatest_travel;
    for (std::size_t set = 0; set < others.size(); ++set) {
      const ClusterSet& other = others[set];
      if (other.clusters.empty()) continue;
      other.boxes->FindCells(Grown(box, greatest), block.hints[set], [&](std::size_t near) {
        const double upto = reach.support + ClosingOf(course, other.courses[near], reach.horizon);
        if (!Touch(Grown(box, upto), other.boxes->Of(near))) return;
        longest = std::max(longest, upto);
        add_near(other.clusters[near], other.first + other.clusters[near].first, upto);
      });
    }
    block.reach[k - block.first] = static_cast<float>(longest / reach.support * (1 + 1e-6));
    block.begin[k - block.first + 1] = found;
  }
  block.Take(std::span(numbers).first(found));
}

}  // namespace

int FloatLanes() { return static_cast<int>(hn::Lanes(hn::ScalableTag<float>())); }
int DoubleLanes() { return static_cast<int>(hn::Lanes(hn::ScalableTag<double>())); }

void FindFloat(const ClusterSet& own, const ClusterSets& others, const Positions<float>& positions,
               const ListReach& reach, ListBlock& block) {
  Find<float>(own, others, positions, reach, block);
}
void FindDouble(const ClusterSet& own, const ClusterSets& others, const Positions<double>& positions,
                const ListReach& reach, ListBlock& block) {
  Find<double>(own, others, positions, reach, block);
}

}  // namespace HWY_NAMESPACE
}  // namespace sph
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sph {

void ListBlock::Transfer(Archive& archive, std::size_t end) {
  archive(first, last, coarse, reach, begin, numbers);
  if (!archive.Reading()) return;
  for (auto& of_set : hints) of_set.clear();
  Archive::Require(last >= first && begin.size() == std::size_t{last - first} + 1 && begin.front() == 0);
  Archive::Require(reach.size() == std::size_t{last - first});
  for (std::size_t k = 1; k < begin.size(); ++k) Archive::Require(begin[k - 1] <= begin[k]);
  Archive::Require(numbers.size() >= begin.back() + kPadding);
  for (const std::uint32_t number : numbers) Archive::Require(number < end);
}

void ListBlock::Take(std::span<const std::uint32_t> found) {
  const std::size_t room = found.size() + kPadding;
  if (numbers.capacity() < room) numbers = {};  // first, so that old and new never are there together
  MakeRoom(numbers, room);
  numbers.assign(found.begin(), found.end());
  numbers.resize(room);
}

HWY_EXPORT(FloatLanes);
HWY_EXPORT(DoubleLanes);
HWY_EXPORT(FindFloat);
HWY_EXPORT(FindDouble);

template <>
int Lanes<float>() {
  return HWY_DYNAMIC_DISPATCH(FloatLanes)();
}
template <>
int Lanes<double>() {
  return HWY_DYNAMIC_DISPATCH(DoubleLanes)();
}

template <>
void FindNeighbours<float>(const ClusterSet& own, const ClusterSets& others, const Positions<float>& positions,
                           const ListReach& reach, ListBlock& block) {
  HWY_DYNAMIC_DISPATCH(FindFloat)(own, others, positions, reach, block);
}
template <>
void FindNeighbours<double>(const ClusterSet& own, const ClusterSets& others, const Positions<double>& positions,
                            const ListReach& reach, ListBlock& block) {
  HWY_DYNAMIC_DISPATCH(FindDouble)(own, others, positions, reach, block);
}

}  // namespace sph
#endif  // HWY_ONCE
