#include "bridge/output/ThicknessMapCsv.h"

#include <numbers>

#include "bridge/output/CsvText.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {

void writeThicknessMapCsv(const std::filesystem::path& file, const RadialMap& postDeployment,
                          const RadialMap& present) {
  CsvText csv;
  for (const char* column : {"z_mm", "angle_deg", "lumenRadius_um", "neointimaThickness_um"})
    csv.field(column);
  csv.endLine();
  for (int k = 0; k < present.planes(); ++k) {
    for (int a = 0; a < present.angles(); ++a) {
      csv.field(present.z(k), 1e3);
      csv.field(present.angle(a), 180 / std::numbers::pi);
      csv.field(present.radius(k, a), 1e6);
      csv.field(postDeployment.radius(k, a) - present.radius(k, a), 1e6);
      csv.endLine();
    }
  }
  atomicWrite(file, csv.text());
}

}  // namespace restenosis
