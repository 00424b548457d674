#include "bridge/output/FormerRun.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/system/AtomicFile.h"

namespace restenosis {

namespace fs = std::filesystem;

namespace {

constexpr const char* previous = "previous";
/// Where the files of a run are gathered before it becomes the previous one.
constexpr const char* gathered = "previous.partial";
/// What was the previous run until then.
constexpr const char* replaced = "previous.replaced";

template <std::size_t N>
bool isAmong(const std::array<std::string_view, N>& names, const fs::path& name) {
  const std::string text = name.string();
  const std::string_view whole =
      text.ends_with(".partial") ? std::string_view(text).substr(0, text.size() - 8) : text;
  return std::ranges::find(names, whole) != names.end();
}

/// Whether something is there, be it a link that leads nowhere.
bool isPresent(const fs::path& path) { return fs::exists(fs::symlink_status(path)); }

std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::vector<fs::path> entries;
  if (isRealFolder(folder))
    for (const auto& entry : fs::directory_iterator(folder)) entries.push_back(entry.path());
  std::ranges::sort(entries);
  return entries;
}

/// Whether a run has made what lies at `path`, two levels below a results folder or one.
bool madeByRun(const fs::path& results, const fs::path& path) {
  const fs::path within = path.lexically_relative(results), first = *within.begin();
  if (!isNameOfResult(first)) return false;
  if (within == first) return true;
  const std::string name = path.filename().string();
  if (first == "tissue" || first == "lumen") return name.starts_with(first.string() + "_");
  if (first == "checkpoint") return name.starts_with("state.bin");
  if (first == "flow" || first == "crossCheck") return dayOfFlowCase(path).has_value();
  return true;
}

/// Hands every entry to `use`: those in a run's folders each by themselves, for a user's may be among them.
template <class Use>
void forEachEntry(const fs::path& results, Use&& use) {
  for (const fs::path& entry : entriesOf(results)) {
    const bool mixed = isNameOfResultFolder(entry.filename()) && isRealFolder(entry);
    if (!mixed) use(entry);
    if (mixed)
      for (const fs::path& inner : entriesOf(entry)) use(inner);
  }
}

/// Removes a run, and its folders where nothing else is in them.
void removeRun(const fs::path& results) {
  forEachEntry(results, [&](const fs::path& entry) {
    if (madeByRun(results, entry)) fs::remove_all(entry);
  });
  for (const fs::path& entry : entriesOf(results))
    if (isNameOfResultFolder(entry.filename()) && isRealFolder(entry) && fs::is_empty(entry))
      fs::remove(entry);
}

bool holdsRun(const fs::path& results) {
  bool found = false;
  forEachEntry(results, [&](const fs::path& entry) { found = found || madeByRun(results, entry); });
  return found;
}

/// Whether the run in this folder got as far as a row of its time series.
bool hasRecorded(const fs::path& results) {
  std::ifstream series(results / "timeSeries.csv");
  std::string header, row;
  return std::getline(series, header) && std::getline(series, row);
}

/// Moves the user's files from one folder of a run to another, beside those of the same name.
void moveUsersFiles(const fs::path& from, const fs::path& to) {
  forEachEntry(from, [&](const fs::path& entry) {
    if (madeByRun(from, entry)) return;
    fs::path target = to / entry.lexically_relative(from);
    while (isPresent(target)) target += ".previous";
    fs::create_directories(target.parent_path());
    fs::rename(entry, target);
  });
}

void removeReplacedRun(const fs::path& results) {
  if (!isPresent(results / replaced)) return;
  moveUsersFiles(results / replaced, results / previous);
  removeRun(results / replaced);
  fs::remove(results / replaced);
}

}  // namespace

bool isNameOfResult(const fs::path& name) {
  static constexpr std::array<std::string_view, 23> files{
      "scene.toml",  "timeSeries.csv", "profile.csv",    "thicknessMap.csv", "summary.json", "tissue.pvd",
      "lumen.pvd",   "report.html",    "figures.log",    "compare.json",     "growth.png",   "lumen.png",
      "section.png", "lumen3d.png",    "crossCheck.png", "growth.pdf",       "lumen.pdf",    "section.pdf",
      "vessel.png",  "view.pvsm",      "struts.vtp",     "animation.gif",    "beats.png"};
  return isAmong(files, name) || isNameOfResultFolder(name);
}

bool isNameOfResultFolder(const fs::path& name) {
  static constexpr std::array<std::string_view, 6> folders{"tissue",     "lumen",      "flow",
                                                           "crossCheck", "checkpoint", "compare"};
  return isAmong(folders, name);
}

bool isRealFolder(const fs::path& path) { return fs::is_directory(fs::symlink_status(path)); }

bool isNameOfFormerRun(const fs::path& name) {
  return name == previous || name == gathered || name == replaced;
}

std::optional<double> dayOfFlowCase(const fs::path& folder) {
  // A killed run may leave what copyFoamTemplate was filling
  const std::string name = folder.extension() == ".partial" ? folder.stem() : folder.filename();
  double day = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), day);
  if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
  return day;
}

bool moveRunAside(const fs::path& results, Unrecorded unrecorded) {
  finishMovingAside(results);
  if (!holdsRun(results)) return false;
  const bool dispensable = unrecorded == Unrecorded::deleted || hasRecorded(results / previous);
  if (dispensable && !hasRecorded(results)) {
    removeRun(results);
    return false;
  }
  fs::create_directory(results / gathered);
  finishMovingAside(results);
  return true;
}

void finishMovingAside(const fs::path& results) {
  const fs::path gathering = results / gathered, former = results / previous, old = results / replaced;
  if (isPresent(gathering) && !isRealFolder(gathering)) fs::remove(gathering);
  if (isRealFolder(gathering)) {
    for (const fs::path& entry : entriesOf(results)) {
      const fs::path target = gathering / entry.filename();
      if (isNameOfResult(entry.filename()) && !isPresent(target)) fs::rename(entry, target);
    }
    for (const fs::path& mixed : {former, old}) moveUsersFiles(mixed, gathering);
    // On the disk before the other run goes
    flushFolder(gathering);
    if (isPresent(former)) {
      removeReplacedRun(results);
      fs::rename(former, old);
    }
    fs::rename(gathering, former);
    flushFolder(results);
  }
  removeReplacedRun(results);
}

}  // namespace restenosis
