#include "bridge/output/ProfileCsv.h"

#include "bridge/output/CsvText.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {

void writeProfileCsv(const std::filesystem::path& file, std::span<const ProfileRow> rows) {
  CsvText csv;
  for (const char* column : {"z_mm", "lumenArea_mm2", "neointimaAreaFraction", "neointimaThickness_um"})
    csv.field(column);
  csv.endLine();
  for (const auto& row : rows) {
    csv.field(row.z, 1e3);
    csv.field(row.lumenArea, 1e6);
    csv.field(row.neointimaAreaFraction);
    csv.field(row.neointimaThickness, 1e6);
    csv.endLine();
  }
  atomicWrite(file, csv.text());
}

}  // namespace restenosis
