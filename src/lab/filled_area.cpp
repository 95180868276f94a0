#include "lab/filled_area.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sph {
namespace {

constexpr int kCellsPerSpacing = 6;

struct Offset {
  long column = 0, row = 0;
};

std::vector<Offset> DiskOf(long cells) {
  std::vector<Offset> disk;
  for (long row = -cells; row <= cells; ++row) {
    for (long column = -cells; column <= cells; ++column) {
      if (row * row + column * column <= cells * cells) disk.push_back({column, row});
    }
  }
  return disk;
}

/// Cells around the points, with room for their disks and for what is taken off.
class Cells {
 public:
  Cells(std::span<const Vec2> points, double spacing, const Box& bounds)
      : size_(spacing / kCellsPerSpacing), bounds_(bounds) {
    const auto nowhere = [](Vec2 p) { return !std::isfinite(p.x + p.y); };
    if (std::ranges::any_of(points, nowhere)) return;
    Box box{points[0].x, points[0].y, points[0].x, points[0].y};
    for (const Vec2 point : points) {
      box = {std::min(box.x0, point.x), std::min(box.y0, point.y), std::max(box.x1, point.x),
             std::max(box.y1, point.y)};
    }
    origin_ = {Aligned(box.x0 - 2 * spacing, bounds.x0), Aligned(box.y0 - 2 * spacing, bounds.y0)};
    width_ = (box.x1 + 2 * spacing - origin_.x) / size_;
    height_ = (box.y1 + 2 * spacing - origin_.y) / size_;
  }

  bool Fit() const { return width_ * height_ < kMost; }
  /// Covers the disks around the points.
  void Fill(std::span<const Vec2> points, double radius) {
    columns_ = std::lround(std::ceil(width_)) + 1;
    rows_ = std::lround(std::ceil(height_)) + 1;
    covered_.assign(static_cast<std::size_t>(columns_ * rows_), false);
    const std::vector<Offset> disk = DiskOf(kCellsPerSpacing + 1);
    for (const Vec2 point : points) {
      const Offset centre = CellOf(point);
      for (const Offset& offset : disk) {
        const long column = centre.column + offset.column, row = centre.row + offset.row;
        if (Length(Centre(column, row) - point) <= radius) covered_[Index(column, row)] = true;
      }
    }
  }
  long Columns() const { return columns_; }
  long Rows() const { return rows_; }
  bool Covered(long column, long row) const {
    return column >= 0 && row >= 0 && column < columns_ && row < rows_ && covered_[Index(column, row)];
  }
  /// Of the covered cells within the bounds [m^2].
  double Area() const {
    std::size_t count = 0;
    for (long row = 0; row < rows_; ++row) {
      for (long column = 0; column < columns_; ++column) {
        count += Covered(column, row) && Inside(column, row) ? 1 : 0;
      }
    }
    return static_cast<double>(count) * size_ * size_;
  }
  void Uncover(long column, long row) { covered_[Index(column, row)] = false; }
  /// Whether the cell is in the bounds.
  bool Inside(long column, long row) const {
    const Vec2 p = Centre(column, row);
    return p.x > bounds_.x0 && p.x < bounds_.x1 && p.y > bounds_.y0 && p.y < bounds_.y1;
  }
  /// Whether liquid could be there, but is not.
  bool IsFree(long column, long row) const { return !Covered(column, row) && Inside(column, row); }

 private:
  static constexpr double kMost = 1e6;

  /// A wall lies between two cells.
  double Aligned(double low, double wall) const {
    return std::isfinite(wall) ? wall + std::floor((low - wall) / size_) * size_ : low;
  }
  std::size_t Index(long column, long row) const { return static_cast<std::size_t>(row * columns_ + column); }

  Vec2 Centre(long column, long row) const {
    return {origin_.x + (static_cast<double>(column) + 0.5) * size_,
            origin_.y + (static_cast<double>(row) + 0.5) * size_};
  }
  Offset CellOf(Vec2 point) const {
    return {std::lround(std::floor((point.x - origin_.x) / size_)),
            std::lround(std::floor((point.y - origin_.y) / size_))};
  }

  double size_;  // [m]
  Box bounds_;
  Vec2 origin_;
  double width_ = kMost, height_ = kMost;  // in cells
  long columns_ = 0, rows_ = 0;
  std::vector<bool> covered_;
};

/// Takes half a spacing off the edge.
void Erode(Cells& cells) {
  const std::vector<Offset> edge = DiskOf(kCellsPerSpacing / 2);
  const Cells covered = cells;
  for (long row = 0; row < cells.Rows(); ++row) {
    for (long column = 0; column < cells.Columns(); ++column) {
      if (!covered.Covered(column, row)) continue;
      const bool near_edge = std::ranges::any_of(
          edge, [&](const Offset& offset) { return covered.IsFree(column + offset.column, row + offset.row); });
      if (near_edge) cells.Uncover(column, row);
    }
  }
}

}  // namespace

std::optional<FilledShape> FilledShapeOf(std::span<const Vec2> points, double spacing, const Box& bounds) {
  if (points.empty()) return FilledShape{};
  Cells cells(points, spacing, bounds);
  if (!cells.Fit()) return std::nullopt;
  cells.Fill(points, spacing);
  const double wider = cells.Area();
  Erode(cells);
  const double area = cells.Area();
  return FilledShape{area, (wider - area) / (0.5 * spacing)};
}

}  // namespace sph
