#include "lab/reference_data.hpp"

#include <charconv>
#include <fstream>

#include "base/error.hpp"
#include "scenes/catalogue.hpp"

namespace sph {

std::vector<Vec2> ReadReference(const std::string& name) {
  const auto file = AssetsFolder() / "reference" / (name + ".csv");
  std::ifstream stream(file);
  std::vector<Vec2> points;
  bool past_names = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#')) continue;
    if (!past_names) {
      past_names = true;
      continue;
    }
    Vec2 point;
    const char* const end = line.data() + line.size();
    const auto [comma, first] = std::from_chars(line.data(), end, point.x);
    const bool two = first == std::errc() && comma != end && *comma == ',';
    if (!two || std::from_chars(comma + 1, end, point.y).ec != std::errc()) {
      throw TroubleError("{}: '{}' does not begin with two numbers", file.string(), line);
    }
    points.push_back(point);
  }
  if (points.empty()) throw TroubleError("{}: cannot be read, or is empty", file.string());
  return points;
}

}  // namespace sph
