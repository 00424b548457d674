#include "ResultsFolder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "AtomicFile.h"
#include "SecondsPerDay.h"

namespace restenosis {

namespace fs = std::filesystem;

namespace {

/// Marks a results folder as this program's; the lock is on it.
constexpr const char* marker = ".restenosisFoam";
constexpr const char* previous = "previous";

bool writtenByRun(const fs::path& name) {
  static constexpr std::array<std::string_view, 19> names{
      "scene.toml",   "timeSeries.csv", "profile.csv", "thicknessMap.csv",
      "summary.json", "tissue.pvd",     "lumen.pvd",   "tissue",
      "lumen",        "flow",           "checkpoint",  "report.html",
      "figures.log",  "compare.json",   "growth.png",  "lumen.png",
      "section.png",  "lumen3d.png",    "compare"};
  const auto text = name.string();
  const auto whole = text.ends_with(".partial") ? text.substr(0, text.size() - 8) : text;
  return std::ranges::find(names, whole) != names.end();
}

[[noreturn]] void refuseUnreadable(const fs::path& folder, const std::error_code& why) {
  throw FolderRefused(
      fmt::format("cannot read {}: {}: choose another folder with -o", folder.string(), why.message()));
}

/// Whether it is there; refuses a folder that may not be searched.
bool isThere(const fs::path& folder, const fs::path& name = {}) {
  std::error_code error;
  const bool there = fs::exists(name.empty() ? folder : folder / name, error);
  if (error) refuseUnreadable(folder, error);
  return there;
}

bool isEmpty(const fs::path& folder) {
  std::error_code error;
  const bool empty = fs::is_empty(folder, error);
  if (error) refuseUnreadable(folder, error);
  return empty;
}

std::string firstEntry(const fs::path& folder) {
  std::string first;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto name = entry.path().filename().string();
    if (first.empty() || name < first) first = name;
  }
  return first;
}

/// Whether the run in this folder got as far as a row of its time series.
bool hasRecorded(const fs::path& folder) {
  std::ifstream series(folder / "timeSeries.csv");
  std::string header, row;
  return std::getline(series, header) && std::getline(series, row);
}

/// Returns whether there was one.
bool movePreviousRun(const fs::path& folder) {
  std::vector<fs::path> former;
  for (const auto& entry : fs::directory_iterator(folder))
    if (writtenByRun(entry.path().filename())) former.push_back(entry.path());
  if (former.empty()) return false;
  if (hasRecorded(folder / previous) && !hasRecorded(folder)) {
    for (const auto& path : former) fs::remove_all(path);
    return true;
  }
  fs::remove_all(folder / previous);
  fs::create_directory(folder / previous);
  for (const auto& path : former) fs::rename(path, folder / previous / path.filename());
  return true;
}

}  // namespace

void createOutputFolder(const fs::path& folder) {
  try {
    createFolder(folder);
  } catch (const WriteFailed& error) {
    throw FolderRefused(fmt::format("{}: choose another folder with -o", error.what()));
  }
  if (isThere(folder, marker)) return;
  if (!isEmpty(folder)) {
    throw FolderRefused(fmt::format(
        "{} holds files that are not results of restenosisFoam (for example '{}'): choose another "
        "folder with -o, or empty this one",
        folder.string(), firstEntry(folder)));
  }
  std::ofstream mark(folder / marker);
}

int ResultsFolder::acquireLock(const fs::path& folder) {
  const auto file = folder / marker;
  const int lock = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock < 0)
    throw FolderRefused(fmt::format("cannot write into {}: {}: choose another folder with -o",
                                    folder.string(), std::strerror(errno)));
  if (::flock(lock, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    std::array<char, 32> owner{};
    const auto read = ::read(lock, owner.data(), owner.size() - 1);
    ::close(lock);
    if (error != EWOULDBLOCK)
      throw WriteFailed(fmt::format("cannot lock {}: {}", file.string(), std::strerror(error)));
    throw FolderRefused(
        fmt::format("another run{} is writing into {}: wait for it, or choose another folder with -o",
                    read > 0 ? fmt::format(" (process {})", owner.data()) : "", folder.string()));
  }
  const auto owner = fmt::format("{}", ::getpid());
  if (::ftruncate(lock, 0) != 0 ||
      ::pwrite(lock, owner.data(), owner.size(), 0) != static_cast<ssize_t>(owner.size())) {
    const int error = errno;
    ::close(lock);
    throw WriteFailed(fmt::format("cannot write into {}: {}", folder.string(), std::strerror(error)));
  }
  return lock;
}

ResultsFolder ResultsFolder::fresh(const fs::path& folder) {
  createOutputFolder(folder);
  ResultsFolder results(folder, acquireLock(folder));
  results.moveFormerRun();
  return results;
}

bool ResultsFolder::holdsAsResult(const fs::path& folder, const fs::path& file) {
  const fs::path within = fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(folder));
  if (within.empty()) return false;
  const fs::path& first = *within.begin();
  return first == previous || writtenByRun(first);
}

bool ResultsFolder::moveFormerRun() const {
  try {
    return movePreviousRun(folder_);
  } catch (const fs::filesystem_error& error) {
    throw WriteFailed(
        fmt::format("cannot move the former run in {} aside: {}", folder_.string(), error.what()));
  }
}

ResultsFolder ResultsFolder::existing(const fs::path& folder) {
  if (!isThere(folder) || !fs::is_directory(folder))
    throw FolderRefused(fmt::format("there is no folder {}", folder.string()));
  if (!isThere(folder, marker))
    throw FolderRefused(fmt::format("{} is not a results folder of restenosisFoam", folder.string()));
  return ResultsFolder(folder, acquireLock(folder));
}

ResultsFolder ResultsFolder::resumed(const fs::path& folder) {
  const bool nothing = !isThere(folder) || (fs::is_directory(folder) && isEmpty(folder));
  return nothing ? fresh(folder) : existing(folder);
}

ResultsFolder::ResultsFolder(ResultsFolder&& other) noexcept
    : folder_(std::move(other.folder_)), lock_(std::exchange(other.lock_, -1)) {}

ResultsFolder::~ResultsFolder() {
  if (lock_ >= 0) ::close(lock_);
}

fs::path ResultsFolder::flowCase(double time) const {
  // 1e-5 d tell any two steps of a second apart
  std::string day = fmt::format("{:.5f}", time / secondsPerDay);
  day.erase(day.find_last_not_of('0') + 1);
  if (day.back() == '.') day.pop_back();
  return folder_ / "flow" / day;
}

template <class Unwanted>
void ResultsFolder::removeFlowCases(Unwanted&& unwanted) const {
  if (!fs::is_directory(folder_ / "flow")) return;
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder_ / "flow")) {
    const fs::path& path = entry.path();
    // A killed run may leave what copyFoamTemplate was filling
    const std::string name = path.extension() == ".partial" ? path.stem() : path.filename();
    double day = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), day);
    const bool isDay = error == std::errc() && end == name.data() + name.size();
    if (isDay && unwanted(path, day)) found.push_back(path);
  }
  for (const fs::path& folder : found) fs::remove_all(folder);
}

void ResultsFolder::removeFlowCasesAfter(std::optional<double> time) const {
  removeFlowCases([&](const fs::path& folder, double day) {
    return !time || (day > *time / secondsPerDay && folder != flowCase(*time));
  });
}

void ResultsFolder::removeFlowCasesBut(std::span<const fs::path> wanted) const {
  removeFlowCases(
      [&](const fs::path& folder, double) { return std::ranges::find(wanted, folder) == wanted.end(); });
}

}  // namespace restenosis
