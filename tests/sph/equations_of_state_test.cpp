// Pressure, speed of sound and internal energy belong together: dP/drho = c^2 and du/drho = P/rho^2.
#include "sph/equations_of_state.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

template <typename Equation>
Equation Example();
template <>
Polytrope Example() {
  return {0.1};
}
template <>
Tait Example() {
  return {0.5, 2.861, 7};
}
template <>
IdealGas Example() {
  return {2000, 300};
}

/// Central differences with a step of 1e-5 rho: error 1e-10 f''' rho^2/6 and round-off 1e-11 f/(f' rho): together, for
/// powers up to the seventh, below 1e-8 of (f + f' rho)/rho.
constexpr double kStep = 1e-5;
constexpr double kBound = 1e-8;

template <typename F>
double Derivative(F f, double rho) {
  return (f(rho * (1 + kStep)) - f(rho * (1 - kStep))) / (2 * kStep * rho);
}

template <typename Equation>
class EveryEquationOfState : public ::testing::Test {
 protected:
  const Equation equation_ = Example<Equation>();
  const std::vector<double> densities_ = {0.5, 1.0, 2.0, 2.861, 5.0, 299.0, 301.0};  // [kg/m^3]
};
using Equations = ::testing::Types<Polytrope, Tait, IdealGas>;
TYPED_TEST_SUITE(EveryEquationOfState, Equations);

TYPED_TEST(EveryEquationOfState, SquareOfTheSpeedOfSoundIsThePressuresDerivative) {
  for (const double rho : this->densities_) {
    const double c2 = std::pow(this->equation_.SoundSpeed(rho), 2);
    const double measured = Derivative([&](double s) { return this->equation_.Pressure(s); }, rho);
    EXPECT_NEAR(measured, c2, kBound * (c2 + std::abs(this->equation_.Pressure(rho)) / rho)) << rho;
  }
}

TYPED_TEST(EveryEquationOfState, InternalEnergysDerivativeIsPressureOverDensitySquared) {
  for (const double rho : this->densities_) {
    const double expected = this->equation_.Pressure(rho) / (rho * rho);
    const double measured = Derivative([&](double s) { return this->equation_.InternalEnergy(s); }, rho);
    const double c2 = std::pow(this->equation_.SoundSpeed(rho), 2);  // P may vanish; c^2 is the scale of u
    EXPECT_NEAR(measured, expected, kBound * (std::abs(expected) + c2 / rho)) << rho;
  }
}

TEST(Tait, WithExponentSevenEqualsTheGeneralForm) {
  const Tait seven = Example<Tait>();
  const Tait almost{0.5, 2.861, std::nextafter(7.0, 8.0)};  // takes the way through std::pow
  for (const double rho : {0.1, 1.0, 2.861, 5.0, 50.0}) {
    const double power = std::pow(rho / 2.861, 7);
    // Four products, and the exponent's last bit: s^7 differs by eps (4 + 8 |ln s|) < 30 eps.
    EXPECT_NEAR(seven.Pressure(rho), almost.Pressure(rho), 0.5 * 30 * 2.3e-16 * (power + 1)) << rho;
    EXPECT_NEAR(seven.SoundSpeed(rho), almost.SoundSpeed(rho), 1e-14 * almost.SoundSpeed(rho)) << rho;
  }
}

TEST(Tait, HasNoPressureAtItsReferenceDensityAndIsNotClippedBelow) {
  const Tait tait = Example<Tait>();
  EXPECT_EQ(tait.Pressure(2.861), 0);
  EXPECT_LT(tait.Pressure(2.8), 0);
  EXPECT_EQ(tait.Pressure(0.0), -0.5);
}

TEST(Tait, OfTableTwoIsVeryCompressible) {
  // c = sqrt(7 k/rho0) = 1.106 m/s at rho0, a third of sqrt(g H) = 3.4 m/s: the published fluid is not water.
  EXPECT_NEAR(Example<Tait>().SoundSpeed(2.861), 1.106, 5e-4);
}

TEST(IdealGas, HasOneSpeedOfSound) {
  EXPECT_EQ(Example<IdealGas>().SoundSpeed(1), std::sqrt(2000.0));
  EXPECT_EQ(Example<IdealGas>().SoundSpeed(1000), std::sqrt(2000.0));
}

TEST(InternalEnergy, IsZeroAtTheReferenceDensityAndAMinimumThere) {
  const Tait tait = Example<Tait>();
  const IdealGas gas = Example<IdealGas>();
  EXPECT_NEAR(tait.InternalEnergy(2.861), 0, 1e-16);  // k/rho0 is 0.17: a difference of equal numbers
  EXPECT_NEAR(gas.InternalEnergy(300), 0, 1e-12);     // k is 2000
  for (const double factor : {0.9, 1.1}) {
    EXPECT_GT(tait.InternalEnergy(2.861 * factor), 0);
    EXPECT_GT(gas.InternalEnergy(300 * factor), 0);
  }
}

}  // namespace
}  // namespace sph
