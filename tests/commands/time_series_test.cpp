// The CSV file of `run --csv`: what its columns are, when it has a row, and that every number reads back.
#include "commands/time_series.hpp"

#include <charconv>
#include <locale>
#include <sstream>

#include "commands/program.hpp"
#include "io/scratch.hpp"
#include "window/session.hpp"

namespace sph {
namespace {

using Row = std::vector<std::string>;

std::vector<Row> ReadCsv(const std::filesystem::path& file) {
  std::vector<Row> rows;
  std::istringstream lines(Contents(file));
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

double Number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  EXPECT_TRUE(error == std::errc() && end == text.data() + text.size()) << "no number: " << text;
  return value;
}

TEST(TimeSeries, HasNamedColumnsWithUnitsAndOnlyNumbersBelow) {
  const ScratchDirectory scratch;
  const std::filesystem::path file = scratch.Path() / "new/folder/run.csv";
  EXPECT_EQ(RunProgram({"run", "--steps", "10", "--csv", file, "--quiet"}).exit_code, 0);
  const std::vector<Row> rows = ReadCsv(file);
  ASSERT_EQ(rows.size(), 1u + 11u) << "a row before every step and one at the end";
  EXPECT_EQ(rows[0],
            (Row{"time [s]", "step", "particles", "kinetic_energy [J/m]", "potential_energy [J/m]",
                 "internal_energy [J/m]", "momentum_x [kg/s]", "momentum_y [kg/s]", "angular_momentum [kg m/s]",
                 "max_speed [m/s]", "density_min [kg/m^3]", "density_mean [kg/m^3]", "density_max [kg/m^3]"}));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), rows[0].size());
    for (const std::string& cell : rows[i]) Number(cell);
    EXPECT_EQ(rows[i][1], std::to_string(i - 1));
    EXPECT_NEAR(Number(rows[i][0]), 0.004 * static_cast<double>(i - 1), 1e-12);
    EXPECT_EQ(rows[i][2], "600");
  }
}

TEST(TimeSeries, HasARowWhenOneIsDueAndOneAtTheEnd) {
  const ScratchDirectory scratch;
  const std::filesystem::path file = scratch.Path() / "run.csv";
  EXPECT_EQ(RunProgram({"run", "--until", "0.25", "--csv", file, "--every", "0.1", "--quiet"}).exit_code, 0);
  const std::vector<Row> rows = ReadCsv(file);
  ASSERT_EQ(rows.size(), 5u);
  const std::vector<double> times = {0, 0.1, 0.2, 0.252};  // [s]; a step is 0.004 s
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(Number(rows[i + 1][0]), times[i], 1e-9);
}

TEST(TimeSeries, OfARunWithoutStepsHasTheStart) {
  const ScratchDirectory scratch;
  const std::filesystem::path file = scratch.Path() / "run.csv";
  EXPECT_EQ(RunProgram({"run", "--steps", "0", "--csv", file, "--quiet"}).exit_code, 0);
  const std::vector<Row> rows = ReadCsv(file);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(Number(rows[1][0]), 0);
}

TEST(TimeSeries, NumbersReadBackAsTheSameBits) {
  const ScratchDirectory scratch;
  const std::filesystem::path file = scratch.Path() / "run.csv";
  SceneRequest request;
  request.threads = 1;
  Session session(request);
  for (int i = 0; i < 3; ++i) session.Step();
  TimeSeries series(file, 0);
  series.Finish(session.System());
  double mass_velocity = 0;
  const Particles& p = session.System().State();
  EXPECT_EQ(Number(ReadCsv(file)[1][0]), session.System().Time());
  for (std::size_t i = 0; i < p.Size(); ++i) mass_velocity += p.mass[i] * p.vx[i];
  EXPECT_NEAR(Number(ReadCsv(file)[1][6]), mass_velocity, 1e-12);
}

/// A locale that writes 1.234,5 - without one being installed.
class GermanNumbers : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(TimeSeries, HasAPointWhateverTheLocale) {
  const ScratchDirectory scratch;
  const std::filesystem::path file = scratch.Path() / "run.csv";
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new GermanNumbers));
  SceneRequest request;
  request.settings = {"method.time_step=0.0025"};  // read under this locale, too
  Session session(request);
  session.Step();
  TimeSeries series(file, 0);
  series.Finish(session.System());
  std::locale::global(before);
  const std::vector<Row> rows = ReadCsv(file);
  ASSERT_EQ(rows[1].size(), 13u);
  EXPECT_EQ(rows[1][0], "0.0025");
}

}  // namespace
}  // namespace sph
