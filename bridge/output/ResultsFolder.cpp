#include "bridge/output/ResultsFolder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <functional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "bridge/system/AtomicFile.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

namespace fs = std::filesystem;

namespace {

/// Marks a results folder as this program's; the lock is on it.
constexpr const char* marker = ".restenosisFoam";

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

/// Opens the marker, made where it is not there.
int openMarker(const fs::path& folder) {
  const auto file = folder / marker;
  const int handle = ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (handle >= 0) return handle;
  if (errno == ELOOP)
    throw FolderRefused(
        fmt::format("{} is a link: remove it, or choose another folder with -o", file.string()));
  throw FolderRefused(fmt::format("cannot write into {}: {}: choose another folder with -o", folder.string(),
                                  std::strerror(errno)));
}

/// Does what moves a former run aside. Throws WriteFailed.
void movingAside(const fs::path& folder, const std::function<void()>& move) {
  try {
    move();
  } catch (const fs::filesystem_error& error) {
    const int number = error.code().value();
    throw WriteFailed(fmt::format("cannot move the former run in {} aside: {}{}", folder.string(),
                                  error.what(),
                                  isForWantOfRoom(number) ? ": make room and start again" : ""));
  }
}

/// Links that lead elsewhere: to write through them, or to delete what is behind them, is not this program's.
/// Refuses those whose names `concerns` is true of.
void refuseLinks(const fs::path& folder, const std::function<bool(const fs::path&)>& concerns) {
  if (!fs::is_directory(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.is_symlink() || !concerns(entry.path().filename())) continue;
    throw FolderRefused(
        fmt::format("{} is a link, and links among results are not followed: put the folder itself there, or "
                    "choose another folder with -o",
                    entry.path().string()));
  }
}

bool holdsLogsAlone(const fs::path& folder) {
  if (!isRealFolder(folder) || fs::is_empty(folder)) return false;
  return std::ranges::all_of(fs::directory_iterator(folder), [](const auto& entry) {
    return entry.path().filename().string().starts_with("log.") && entry.is_regular_file();
  });
}

void removeAllButLogs(const fs::path& flowCase) {
  if (!isRealFolder(flowCase)) {
    fs::remove(flowCase);
    return;
  }
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(flowCase)) entries.push_back(entry.path());
  for (const fs::path& entry : entries)
    if (!holdsLogsAlone(entry)) fs::remove_all(entry);
  if (fs::is_empty(flowCase)) fs::remove(flowCase);
}

std::string dayName(double time) {
  // 1e-5 d tell any two steps of a second apart
  std::string day = fmt::format("{:.5f}", time / secondsPerDay);
  day.erase(day.find_last_not_of('0') + 1);
  if (day.back() == '.') day.pop_back();
  return day;
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
  ::close(openMarker(folder));
}

int ResultsFolder::acquireLock(const fs::path& folder) {
  const int lock = openMarker(folder);
  if (::flock(lock, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    std::array<char, 32> owner{};
    const auto read = ::read(lock, owner.data(), owner.size() - 1);
    ::close(lock);
    if (error != EWOULDBLOCK)
      throw WriteFailed(fmt::format("cannot lock {}: {}", (folder / marker).string(), std::strerror(error)));
    throw FolderRefused(
        fmt::format("another run{} is writing into {}: wait for it, or choose another folder with -o",
                    read > 0 ? fmt::format(" (process {})", owner.data()) : "", folder.string()));
  }
  const auto owner = fmt::format("{}", ::getpid());
  bool written = ::ftruncate(lock, 0) == 0;
  // A write may take less than it is given
  for (std::size_t at = 0; written && at < owner.size();) {
    const ssize_t more = ::pwrite(lock, owner.data() + at, owner.size() - at, static_cast<off_t>(at));
    written = more > 0 || (more < 0 && errno == EINTR);
    if (more > 0) at += static_cast<std::size_t>(more);
  }
  if (!written) {
    const int error = errno;
    ::close(lock);
    throw WriteFailed(fmt::format("cannot write into {}: {}", folder.string(), writeFailureReason(error)));
  }
  return lock;
}

ResultsFolder ResultsFolder::forOutput(const fs::path& folder) {
  createOutputFolder(folder);
  ResultsFolder results(folder, acquireLock(folder));
  static constexpr std::array<std::string_view, 5> folders{"deployment", "flow", "foam", "lbm", "runs"};
  refuseLinks(folder, [](const fs::path& name) {
    return std::ranges::find(folders, name.string()) != folders.end();
  });
  refuseLinks(folder / "runs", [](const fs::path&) { return true; });
  return results;
}

bool ResultsFolder::isMarked(const fs::path& folder) { return isThere(folder, marker); }

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
  return isNameOfFormerRun(first) || isNameOfResult(first);
}

bool ResultsFolder::moveFormerRun(Unrecorded unrecorded) const {
  bool moved = false;
  movingAside(folder_, [&] { moved = moveRunAside(folder_, unrecorded); });
  return moved;
}

ResultsFolder ResultsFolder::existing(const fs::path& folder) {
  if (!isThere(folder) || !fs::is_directory(folder))
    throw FolderRefused(fmt::format("there is no folder {}", folder.string()));
  if (!isThere(folder, marker))
    throw FolderRefused(fmt::format("{} is not a results folder of restenosisFoam", folder.string()));
  ResultsFolder results(folder, acquireLock(folder));
  movingAside(folder, [&] { finishMovingAside(folder); });
  refuseLinks(folder, isNameOfResultFolder);
  return results;
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

fs::path ResultsFolder::flowCase(double time) const { return folder_ / "flow" / dayName(time); }

fs::path ResultsFolder::crossCheckCase(double time) const { return folder_ / "crossCheck" / dayName(time); }

template <class Unwanted>
std::vector<fs::path> ResultsFolder::cases(const char* folder, Unwanted&& unwanted) const {
  std::vector<fs::path> found;
  if (!fs::is_directory(folder_ / folder)) return found;
  for (const auto& entry : fs::directory_iterator(folder_ / folder)) {
    const auto day = dayOfFlowCase(entry.path());
    if (day && unwanted(entry.path(), *day)) found.push_back(entry.path());
  }
  return found;
}

void ResultsFolder::removeFlowCasesAfter(std::optional<double> time) const {
  const auto later = [&](const fs::path& folder, double day) {
    return !time || (day > *time / secondsPerDay && folder != flowCase(*time));
  };
  for (const fs::path& folder : cases("flow", later)) fs::remove_all(folder);
}

void ResultsFolder::removeFlowCasesBut(std::span<const fs::path> wanted) const {
  const auto unwanted = [&](const fs::path& folder, double) {
    return std::ranges::find(wanted, folder) == wanted.end();
  };
  for (const fs::path& folder : cases("flow", unwanted)) removeAllButLogs(folder);
}

void ResultsFolder::removeCrossChecksBut(const fs::path& wanted) const {
  const auto unwanted = [&](const fs::path& folder, double) { return folder != wanted; };
  for (const fs::path& folder : cases("crossCheck", unwanted)) removeAllButLogs(folder);
}

}  // namespace restenosis
