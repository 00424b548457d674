#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "bridge/surface/Histology.h"

namespace restenosis {

/// One axial position of the final lumen. SI units.
struct ProfileRow {
  double z;                                     ///< from the inlet [m]
  double lumenArea;                             ///< of the cross-section [m^2]
  std::optional<double> neointimaAreaFraction;  ///< 1 - area / post-deployment area; empty without tissue
  std::optional<double> neointimaThickness;     ///< mean around the circumference [m]
  std::optional<HistologySection> histology;    ///< empty without both laminae
  bool matrix = false;                          ///< whether it is modelled
};

/// Writes profile.csv: z_mm, lumenArea_mm2, neointimaAreaFraction, neointimaThickness_um, and as columns of
/// timeSeries.csv what histology measures. Throws WriteFailed.
void writeProfileCsv(const std::filesystem::path& file, std::span<const ProfileRow> rows);

}  // namespace restenosis
