#include "bridge/output/PvdSeries.h"

#include <fmt/format.h>

#include <system_error>

#include "bridge/output/ResultsFolder.h"
#include "bridge/system/AtomicFile.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

namespace fs = std::filesystem;

std::string PvdSeries::relativeFile(std::uint64_t step) const {
  return fmt::format("{0}/{0}_{1:06}.vtp", name_, step);
}

fs::path PvdSeries::dataFile(std::uint64_t step) const { return folder_ / relativeFile(step); }

void PvdSeries::begin() {
  createFolder(folder_ / name_);
  const std::set<fs::path> present = ownFiles();
  std::erase_if(entries_, [&](const Entry& entry) { return !present.contains(dataFile(entry.step)); });
  write();
  std::set<fs::path> named;
  for (const auto& entry : entries_) named.insert(dataFile(entry.step));
  std::error_code error;
  for (const auto& file : present)
    if (!named.contains(file)) fs::remove(file, error);
}

std::set<fs::path> PvdSeries::ownFiles() const {
  const fs::path folder = folder_ / name_;
  std::error_code error;
  std::set<fs::path> found;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().filename().string().starts_with(name_ + "_")) found.insert(entry->path());
  if (error) throw FolderRefused(fmt::format("cannot read {}: {}", folder.string(), error.message()));
  return found;
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
