#include "bridge/output/ProfileCsv.h"

#include "bridge/output/CsvText.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {

void writeProfileCsv(const std::filesystem::path& file, std::span<const ProfileRow> rows) {
  CsvText csv;
  for (const char* column :
       {"z_mm", "lumenArea_mm2", "neointimaAreaFraction", "neointimaThickness_um", "intimaArea_mm2",
        "mediaArea_mm2", "relativeIntimaArea", "intimaCells", "intimaInCycle", "intimaMatrixShare"})
    csv.field(column);
  csv.endLine();
  for (const auto& row : rows) {
    csv.field(row.z, 1e3);
    csv.field(row.lumenArea, 1e6);
    csv.field(row.neointimaAreaFraction);
    csv.field(row.neointimaThickness, 1e6);
    const auto measured = [&](auto&& value, double scale) {
      csv.field(row.histology ? std::optional(value(*row.histology)) : std::nullopt, scale);
    };
    measured([](const HistologySection& section) { return section.intimaArea; }, 1e6);
    measured([](const HistologySection& section) { return section.mediaArea; }, 1e6);
    measured([](const HistologySection& section) { return section.relativeIntimaArea; }, 1);
    measured([](const HistologySection& section) { return section.intimaCells; }, 1);
    measured([](const HistologySection& section) { return section.inCycle(); }, 1);
    csv.field(row.histology && row.matrix ? std::optional(row.histology->matrixShare()) : std::nullopt, 1);
    csv.endLine();
  }
  atomicWrite(file, csv.text());
}

}  // namespace restenosis
