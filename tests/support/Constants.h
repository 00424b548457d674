#pragma once

#include <limits>
#include <numbers>

#include "tissue/parameters/LengthUnits.h"

/// Numbers that many tests use. All tests of a label are compiled in a few pieces (tests/CMakeLists.txt), so
/// what two of them need is here and not in each.
namespace restenosis::support {

/// Radius of a smooth muscle cell of the reference wall [m].
inline constexpr double r = 15e-6;
/// The reduced radius of two of them [m], and their modulus [Pa].
inline constexpr double R = r / 2, modulus = 0.2e6;
using restenosis::um;
/// [s]
inline constexpr double hour = 3600, oneDay = 24 * hour;
/// Of a straight vessel [m].
inline constexpr double vesselRadius = 0.9e-3, vesselLength = 1.2e-3;
inline constexpr double pi = std::numbers::pi;
/// A time that does not come.
inline constexpr double never = std::numeric_limits<double>::infinity();

}  // namespace restenosis::support
