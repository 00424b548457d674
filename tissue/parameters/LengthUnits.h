#pragma once

namespace restenosis {

/// Lengths are in metres; what is shown to people counts in these [m].
inline constexpr double mm = 1e-3, um = 1e-6;
/// How many of the first are a metre: a product with it is rounded otherwise than a quotient by `mm`.
inline constexpr double mmPerMetre = 1e3;

}  // namespace restenosis
