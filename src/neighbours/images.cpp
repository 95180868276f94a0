#include "neighbours/images.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"

namespace sph {

Vec2 Periods::Wrap(Vec2 point) const {
  if (in_x) point.x -= box.Width() * std::floor((point.x - box.x0) / box.Width());
  if (in_y) point.y -= box.Height() * std::floor((point.y - box.y0) / box.Height());
  return point;
}

Ends Ends::WithImages() const {
  if (site_spacing == 0) return *this;
  return {x.periodic ? x : AxisEnds{}, y.periodic ? y : AxisEnds{}};
}

namespace {

double Coordinate(const AxisEnds& ends, ImageOf image, double at) {
  switch (image) {
    case ImageOf::kSame:
      return at;
    case ImageOf::kPeriodUp:
      return at + (ends.high - ends.low);
    case ImageOf::kPeriodDown:
      return at - (ends.high - ends.low);
    case ImageOf::kMirrorLow:
      return 2 * ends.low - at;
    case ImageOf::kMirrorHigh:
      return 2 * ends.high - at;
  }
  return at;
}

/// The images that a coordinate has beside itself, for particles within `margin` of an end, or as far again of a seam,
/// which others may cross.
struct Beside {
  ImageOf images[2];
  int count = 0;
};
Beside ImagesOf(const AxisEnds& ends, double margin, double travel, double at) {
  Beside beside;
  if (ends.periodic) margin += travel;
  if (at < ends.low + margin) beside.images[beside.count++] = ends.periodic ? ImageOf::kPeriodUp : ImageOf::kMirrorLow;
  if (at > ends.high - margin)
    beside.images[beside.count++] = ends.periodic ? ImageOf::kPeriodDown : ImageOf::kMirrorHigh;
  return beside;
}

}  // namespace

void Images::Find(const Ends& ends, double support, double travel, std::span<const double> x,
                  std::span<const double> y) {
  sources_.clear();
  in_x_.clear();
  in_y_.clear();
  if (!ends.Any()) return;
  for (const AxisEnds& axis : {ends.x, ends.y}) {
    SPH_CHECK(!axis.periodic || axis.high - axis.low > 2 * support, "a period of {} m is too short for a reach of {} m",
              axis.high - axis.low, support);
  }
  double drift = 0;  // [m], of the particle furthest out
  for (std::size_t i = 0; i < x.size(); ++i) {
    drift = std::max({drift, ends.x.low - x[i], x[i] - ends.x.high, ends.y.low - y[i], y[i] - ends.y.high});
  }
  const double margin = support + travel + drift;
  const auto add = [&](std::size_t i, ImageOf image_x, ImageOf image_y) {
    sources_.push_back(static_cast<std::uint32_t>(i));
    in_x_.push_back(image_x);
    in_y_.push_back(image_y);
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Beside beside_x = ImagesOf(ends.x, margin, travel, x[i]);
    const Beside beside_y = ImagesOf(ends.y, margin, travel, y[i]);
    for (int a = 0; a < beside_x.count; ++a) add(i, beside_x.images[a], ImageOf::kSame);
    for (int b = 0; b < beside_y.count; ++b) add(i, ImageOf::kSame, beside_y.images[b]);
    for (int a = 0; a < beside_x.count; ++a) {
      for (int b = 0; b < beside_y.count; ++b) add(i, beside_x.images[a], beside_y.images[b]);
    }
  }
}

void Images::Place(const Ends& ends, std::span<const double> x, std::span<const double> y, std::vector<double>& image_x,
                   std::vector<double>& image_y) const {
  image_x.resize(Size());
  image_y.resize(Size());
  for (std::size_t k = 0; k < Size(); ++k) {
    image_x[k] = Coordinate(ends.x, in_x_[k], x[sources_[k]]);
    image_y[k] = Coordinate(ends.y, in_y_[k], y[sources_[k]]);
  }
}

void Images::Reorder(std::span<const std::uint32_t> order) {
  const auto apply = [&](auto& values, auto& scratch) {
    scratch.resize(values.size());
    for (std::size_t k = 0; k < order.size(); ++k) scratch[k] = values[order[k]];
    values.swap(scratch);
  };
  apply(sources_, sources_scratch_);
  apply(in_x_, scratch_);
  apply(in_y_, scratch_);
}

void Images::Transfer(Archive& archive, std::size_t particles) {
  archive(sources_, in_x_, in_y_);
  Archive::Require(in_x_.size() == Size() && in_y_.size() == Size());
  for (const std::uint32_t source : sources_) Archive::Require(source < particles);
  for (const auto* axis : {&in_x_, &in_y_}) {
    for (const ImageOf image : *axis) Archive::Require(image <= ImageOf::kMirrorHigh);
  }
}

std::size_t Images::Bytes() const {
  return sizeof(std::uint32_t) * (sources_.capacity() + sources_scratch_.capacity()) +
         sizeof(ImageOf) * (in_x_.capacity() + in_y_.capacity() + scratch_.capacity());
}

}  // namespace sph
