// The checks that random scenes are held to fire on what they are made for, and are silent on healthy runs.
#include "lab/run_checks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sph {
namespace {

constexpr int kLooks = 400;

/// Energies of a swing whose kinetic energy turns into stored energy and back, times (1 + growth)^look.
std::string FlawOfSwing(double growth, double put_in_per_look = 0, double mass = 1, double slide = 0) {
  EnergyBudget budget(1e-6, mass, slide);
  double energy = 1;
  for (int k = 0; k < kLooks; ++k) {
    const double kinetic = energy * std::pow(std::cos(0.7 * k), 2);
    budget.Add(kinetic, 5 + energy - kinetic, put_in_per_look * k);
    energy *= 1 + growth;
  }
  return budget.Flaw();
}

TEST(EnergyBudget, LetsEnergySwingAndBeLost) {
  EXPECT_EQ(FlawOfSwing(0), "");
  EXPECT_EQ(FlawOfSwing(-0.01), "");
}

TEST(EnergyBudget, FindsEnergyThatGrows) {
  EXPECT_EQ(FlawOfSwing(1e-4), "") << "4 % in all";
  EXPECT_NE(FlawOfSwing(3e-4), "") << "13 % in all";
}

TEST(EnergyBudget, FindsGrowthAfterEnergyWasLost) {
  EnergyBudget budget(1e-6, 1, 0);
  for (int k = 0; k < kLooks; ++k) budget.Add(k < 200 ? std::exp(-0.02 * k) : 0.02 + 1e-3 * (k - 200), 0, 0);
  EXPECT_NE(budget.Flaw(), "") << "it never exceeds what was there at first";
}

TEST(EnergyBudget, GrantsWhatIsPutIn) {
  EnergyBudget budget(1e-6, 1, 0), unpaid(1e-6, 1, 0);
  for (int k = 0; k < kLooks; ++k) {
    budget.Add(1 + 0.1 * k, 0, 0.1 * k);
    unpaid.Add(1 + 0.1 * k, 0, 0.05 * k);
  }
  EXPECT_EQ(budget.Flaw(), "");
  EXPECT_NE(unpaid.Flaw(), "");
}

TEST(EnergyBudget, GrantsASlidingWallItsOwnSpeedAndNoMore) {
  const auto flaw_at = [](double speed) {  // of a fluid of 2 kg/m dragged along from rest by a wall of 3 m/s
    EnergyBudget budget(1e-6, 2, 3);
    for (int k = 0; k < kLooks; ++k) budget.Add(std::pow(speed * k / kLooks, 2), 0, 0);
    return budget.Flaw();
  };
  EXPECT_EQ(flaw_at(3), "");
  EXPECT_NE(flaw_at(12), "");
}

TEST(EnergyBudget, LooksOverWhatIsTooSlowToMatter) {
  EnergyBudget budget(1, 1, 0);
  for (int k = 0; k < kLooks; ++k) budget.Add(0.002 * k, 0, 0);
  EXPECT_EQ(budget.Flaw(), "");
}

TEST(VolumeCheck, FindsDensitiesThatDrift) {
  VolumeCheck check(2);
  for (const double volume : {2.0, 2.09, 1.91}) check.Add(volume, std::nullopt);
  EXPECT_EQ(check.Flaw(), "");
  check.Add(1.89, std::nullopt);
  EXPECT_NE(check.Flaw(), "");
}

TEST(VolumeCheck, FindsWaterThatSinksWhileItsDensitiesStay) {
  VolumeCheck check(2);
  check.Add(2, 1.98);
  check.Add(2, 1.9);
  EXPECT_EQ(check.Flaw(), "");
  for (int k = 0; k < VolumeCheck::kLooksInARow; ++k) check.Add(2, 1.87);
  EXPECT_NE(check.Flaw(), "");
}

TEST(VolumeCheck, LooksOverAGapThatSeemsFilledJustBeforeItCloses) {
  VolumeCheck check(2);
  for (const double area : {2.0, 2.2, 2.2, 2.0, 2.2, 2.2, 2.0}) check.Add(2, area);
  EXPECT_EQ(check.Flaw(), "");
}

TEST(VolumeCheck, LeavesRoomForWhatIsUnsure) {
  VolumeCheck check(2), unsure(2);
  for (int k = 0; k < 2 * VolumeCheck::kLooksInARow; ++k) {
    check.Add(2, k == 0 ? 2.0 : 1.87);
    unsure.Add(2, k == 0 ? 2.0 : 1.87, 0.05);
  }
  EXPECT_NE(check.Flaw(), "");
  EXPECT_EQ(unsure.Flaw(), "");
}

TEST(VolumeCheck, LetsTheHolesOfARandomStartClose) {
  VolumeCheck check(2);
  for (const double area : {1.6, 1.8, 2.0, 2.05}) check.Add(2, area);
  EXPECT_EQ(check.Flaw(), "");
  for (int k = 0; k < VolumeCheck::kLooksInARow; ++k) check.Add(2, 1.5);
  EXPECT_NE(check.Flaw(), "");
}

std::string FlawOfRest(double rate) {
  RestCheck check(1e-6);
  for (int k = 0; k < kLooks; ++k) check.Add(1e-3 * std::exp(rate * k) * (1 + 0.5 * std::sin(k)));
  return check.Flaw();
}

TEST(RestCheck, FindsMotionThatGrowsInTheSecondHalf) {
  EXPECT_EQ(FlawOfRest(0), "");
  EXPECT_EQ(FlawOfRest(-0.01), "");
  EXPECT_NE(FlawOfRest(0.01), "");
}

TEST(RestCheck, AsksNothingOfAFluidThatIsStill) {
  RestCheck check(1e-6);
  for (int k = 0; k < kLooks; ++k) check.Add(1e-9 * k);
  EXPECT_EQ(check.Flaw(), "");
}

}  // namespace
}  // namespace sph
