#pragma once

#include <string_view>
#include <vector>

namespace restenosis {

/// Names of the flow backends: what a scene may write and what the table of backends is keyed by.
namespace flowBackendNames {
inline constexpr std::string_view foam = "foam";
inline constexpr std::string_view lbm = "lbm";
inline constexpr std::string_view analytic = "analytic";
inline constexpr std::string_view none = "none";  ///< no flow at all; has no entry in the table

inline std::vector<std::string_view> all() { return {foam, lbm, analytic, none}; }

/// By what a flow may be cross-checked: another backend, or the same one at the fidelity `reference`.
inline constexpr std::string_view reference = "reference";
inline std::vector<std::string_view> crossChecks() { return {none, lbm, foam, reference}; }
}  // namespace flowBackendNames

}  // namespace restenosis
