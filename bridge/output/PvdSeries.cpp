#include "PvdSeries.h"

#include <fmt/format.h>

#include <set>

#include "AtomicFile.h"
#include "SecondsPerDay.h"

namespace restenosis {

namespace fs = std::filesystem;

std::string PvdSeries::relativeFile(std::uint64_t step) const {
  return fmt::format("{0}/{0}_{1:06}.vtp", name_, step);
}

fs::path PvdSeries::dataFile(std::uint64_t step) const { return folder_ / relativeFile(step); }

void PvdSeries::begin() {
  createFolder(folder_ / name_);
  write();
  std::set<fs::path> named;
  for (const auto& entry : entries_) named.insert(dataFile(entry.step).filename());
  std::error_code error;
  for (const auto& file : fs::directory_iterator(folder_ / name_)) {
    const auto name = file.path().filename();
    if (name.string().starts_with(name_ + "_") && !named.contains(name)) fs::remove(file.path(), error);
  }
}

void PvdSeries::add(std::uint64_t step, double time) {
  entries_.push_back({step, time});
  write();
}

void PvdSeries::write() const {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const auto& entry : entries_)
    text += fmt::format("    <DataSet timestep=\"{:.10g}\" group=\"\" part=\"0\" file=\"{}\"/>\n",
                        entry.time / secondsPerDay, relativeFile(entry.step));
  text += "  </Collection>\n</VTKFile>\n";
  atomicWrite(index(), text);
}

}  // namespace restenosis
