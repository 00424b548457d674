#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

#include "bridge/scene/Units.h"
#include "tissue/agents/RandomStream.h"

namespace restenosis {
namespace {

class UnitsTest : public ::testing::Test {
 protected:
  std::string errorOf(std::string_view quantity, std::string_view unit) const {
    try {
      const double value = units.parse(quantity, unit);
      return "accepted as " + std::to_string(value);
    } catch (const UnitError& error) {
      return error.what();
    }
  }
  Units units;
};

// The values are those of the literals, to the last bit: a scene that states a default changes nothing.
TEST_F(UnitsTest, ConvertsToExactlyTheLiteral) {
  EXPECT_EQ(units.parse("1.8 mm", "mm"), 1.8e-3);
  EXPECT_EQ(units.parse("110 um", "mm"), 110e-6);
  EXPECT_EQ(units.parse("110 µm", "mm"), 110e-6);
  EXPECT_EQ(units.parse("2.7e-6 m^2/s", "m^2/s"), 2.7e-6);
  EXPECT_EQ(units.parse("2.7 mm²/s", "m^2/s"), 2.7e-6);
  EXPECT_EQ(units.parse("2.7e-6 m2 s-1", "m^2/s"), 2.7e-6);
  EXPECT_EQ(units.parse("16 h", "h"), 16 * 3600.0);
  EXPECT_EQ(units.parse("72 d", "h"), 72 * 86400.0);
  EXPECT_EQ(units.parse("0.2 MPa", "Pa"), 0.2e6);
  EXPECT_EQ(units.parse("1000 kg/m^3", "kg/m^3"), 1000.0);
  EXPECT_EQ(units.parse("1 g/cm^3", "kg/m^3"), 1000.0);
  EXPECT_EQ(units.parse("0.001 nmol/mm^3", "nmol/mm^3"), 0.001);
  EXPECT_EQ(units.parse("866 Pa/m", "Pa/m"), 866.0);
  EXPECT_EQ(units.parse(" +1.8mm ", "m"), 1.8e-3);
  EXPECT_EQ(units.parse("-3 1/s", "s^-1"), -3.0);
}

TEST_F(UnitsTest, RefusesWhatIsNoQuantity) {
  EXPECT_NE(errorOf("", "mm").find("is empty"), std::string::npos);
  EXPECT_NE(errorOf("   ", "mm").find("is empty"), std::string::npos);
  EXPECT_NE(errorOf("1.8", "mm").find("has no unit"), std::string::npos);
  EXPECT_NE(errorOf("mm", "mm").find("does not start with a number"), std::string::npos);
  EXPECT_NE(errorOf("+-1 mm", "mm").find("does not start with a number"), std::string::npos);
  EXPECT_NE(errorOf("nan mm", "mm").find("not a finite number"), std::string::npos);
  EXPECT_NE(errorOf("-inf mm", "mm").find("not a finite number"), std::string::npos);
  EXPECT_NE(errorOf("1e999 mm", "mm").find("beyond the range"), std::string::npos);
  EXPECT_NE(errorOf("1e308 km", "mm").find("beyond the range"), std::string::npos);
  EXPECT_NE(errorOf("1,8 mm", "mm").find("comma"), std::string::npos);
}

TEST_F(UnitsTest, RefusesAnotherDimensionAndNamesBoth) {
  EXPECT_EQ(errorOf("1.8 s", "mm"), "\"1.8 s\" is a time; expected a length, for example in mm");
  EXPECT_EQ(errorOf("1.8 mm^2", "mm"), "\"1.8 mm^2\" is an area; expected a length, for example in mm");
  EXPECT_NE(errorOf("0.2 MPa", "Pa/m").find("expected a pressure gradient"), std::string::npos);
}

// UDUNITS alone accepts some of these: numbers as units, products by juxtaposition, dates, origins.
TEST_F(UnitsTest, RefusesTrailingAndOddUnits) {
  for (const char* odd : {"1.8 M",
                          "1.8 mm 3",
                          "1.8 mm 3 mm",
                          "1.8 2 mm",
                          "1.8 mm!",
                          "1.8 mm /",
                          "1.8 mm//s",
                          "1.8 / mm",
                          "1.8 mm since 2000-01-01",
                          "1.8 mm @ 3",
                          "1.8 (mm)",
                          "1.8 lg(re mm)",
                          "1.8 mm^",
                          "1.8 mm^0",
                          "1.8 mm^1.5",
                          "1.8 mm^99999999999",
                          "1.8 kg/m s",
                          "1.8 °C",
                          "0x10 mm",
                          "1.8 mmm",
                          "1.8 UM"}) {
    const std::string error = errorOf(odd, "mm");
    EXPECT_EQ(error.find("accepted"), std::string::npos) << odd << ": " << error;
  }
  EXPECT_NE(errorOf("20 degC", "K").find("its own zero"), std::string::npos);
  EXPECT_NE(errorOf("1 kg/m s", "kg/m/s").find("ambiguous"), std::string::npos);
}

TEST_F(UnitsTest, WritesTheShortestText) {
  EXPECT_EQ(units.format(1.8e-3, "mm"), "1.8 mm");
  EXPECT_EQ(units.format(110e-6, "um"), "110 um");
  EXPECT_EQ(units.format(2.7e-6, "m^2/s"), "2.7e-6 m^2/s");
  EXPECT_EQ(units.format(1e6, "m"), "1000000 m");
  EXPECT_EQ(units.format(72 * 86400.0, "d"), "72 d");
  EXPECT_EQ(units.format(0.06, ""), "0.06");
  EXPECT_EQ(units.format(0, "mm"), "0 mm");
}

TEST_F(UnitsTest, WhatItWritesReadsBackToTheLastBit) {
  for (const char* unit : {"mm", "um", "d", "h", "MPa", "nmol/mm^3", "m^2/s", "Pa/m", "mmHg"}) {
    for (std::uint64_t k = 0; k < 40; ++k) {
      const double si = RandomStream(1, k, 0, RandomPurpose::packing).uniform() * 1e-3;
      EXPECT_EQ(units.parse(units.format(si, unit), unit), si) << unit << ' ' << si;
    }
  }
}

TEST_F(UnitsTest, ServesSeveralThreads) {
  std::vector<std::thread> threads;
  std::vector<double> sums(4, 0.0);
  for (double& sum : sums) {
    threads.emplace_back([this, &sum] {
      for (int k = 0; k < 10; ++k) sum += units.parse("1 mm", "m") + Units().parse("1 h", "d");
    });
  }
  for (auto& thread : threads) thread.join();
  for (const double sum : sums) EXPECT_NEAR(sum, 10 * (1e-3 + 3600.0), 1e-6);
}

}  // namespace
}  // namespace restenosis
