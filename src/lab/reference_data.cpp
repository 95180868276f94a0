#include "lab/reference_data.hpp"

#include <charconv>
#include <fstream>

#include "base/error.hpp"
#include "scenes/catalogue.hpp"

namespace sph {

std::vector<std::vector<double>> ReadReferenceRows(const std::string& name, std::size_t columns) {
  const auto file = AssetsFolder() / "reference" / (name + ".csv");
  std::ifstream stream(file);
  std::vector<std::vector<double>> rows;
  bool past_names = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#')) continue;
    if (!past_names) {
      past_names = true;
      continue;
    }
    std::vector<double> row(columns);
    const char* at = line.data();
    const char* const end = line.data() + line.size();
    for (double& value : row) {
      if (&value != row.data() && at != end && *at == ',') ++at;
      const auto [after, error] = std::from_chars(at, end, value);
      if (error != std::errc()) {
        throw TroubleError("{}: '{}' does not begin with {} numbers", file.string(), line, columns);
      }
      at = after;
    }
    rows.push_back(row);
  }
  if (rows.empty()) throw TroubleError("{}: cannot be read, or is empty", file.string());
  return rows;
}

std::vector<Vec2> ReadReference(const std::string& name) {
  std::vector<Vec2> points;
  for (const auto& row : ReadReferenceRows(name, 2)) points.push_back({row[0], row[1]});
  return points;
}

}  // namespace sph
