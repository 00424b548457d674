#pragma once

#include <filesystem>
#include <optional>
#include <span>

namespace restenosis {

/// One axial position of the final lumen. SI units.
struct ProfileRow {
  double z;                                     ///< from the inlet [m]
  double lumenArea;                             ///< of the cross-section [m^2]
  std::optional<double> neointimaAreaFraction;  ///< 1 - area / post-deployment area; empty without tissue
  std::optional<double> neointimaThickness;     ///< mean around the circumference [m]
};

/// Writes profile.csv: z_mm, lumenArea_mm2, neointimaAreaFraction, neointimaThickness_um. Throws WriteFailed.
void writeProfileCsv(const std::filesystem::path& file, std::span<const ProfileRow> rows);

}  // namespace restenosis
