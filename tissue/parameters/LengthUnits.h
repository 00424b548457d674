#pragma once

namespace restenosis {

/// Lengths are in metres; messages show them in these units [m].
inline constexpr double mm = 1e-3, um = 1e-6;
/// Millimetres per metre. A product with it and a quotient by `mm` differ by rounding.
inline constexpr double mmPerMetre = 1e3;

}  // namespace restenosis
