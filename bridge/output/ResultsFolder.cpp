#include "ResultsFolder.h"

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

#include "AtomicFile.h"
#include "FormerRun.h"
#include "SecondsPerDay.h"

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
void refuseLinkedFolders(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!isNameOfResultFolder(entry.path().filename()) || !entry.is_symlink()) continue;
    throw FolderRefused(
        fmt::format("{} is a link, and links among results are not followed: put the folder itself there, or "
                    "choose another folder with -o",
                    entry.path().string()));
  }
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
  if (::ftruncate(lock, 0) != 0 ||
      ::pwrite(lock, owner.data(), owner.size(), 0) != static_cast<ssize_t>(owner.size())) {
    const int error = errno;
    ::close(lock);
    throw WriteFailed(fmt::format("cannot write into {}: {}", folder.string(), writeFailureReason(error)));
  }
  return lock;
}

ResultsFolder ResultsFolder::forOutput(const fs::path& folder) {
  createOutputFolder(folder);
  return ResultsFolder(folder, acquireLock(folder));
}

bool ResultsFolder::isMarked(const fs::path& folder) { return isThere(folder, marker); }

ResultsFolder ResultsFolder::fresh(const fs::path& folder) {
  ResultsFolder results = forOutput(folder);
  results.moveFormerRun();
  return results;
}

bool ResultsFolder::holdsAsResult(const fs::path& folder, const fs::path& file) {
  const fs::path within = fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(folder));
  if (within.empty()) return false;
  const fs::path& first = *within.begin();
  return isNameOfFormerRun(first) || isNameOfResult(first);
}

bool ResultsFolder::moveFormerRun() const {
  bool moved = false;
  movingAside(folder_, [&] { moved = moveRunAside(folder_); });
  return moved;
}

ResultsFolder ResultsFolder::existing(const fs::path& folder) {
  if (!isThere(folder) || !fs::is_directory(folder))
    throw FolderRefused(fmt::format("there is no folder {}", folder.string()));
  if (!isThere(folder, marker))
    throw FolderRefused(fmt::format("{} is not a results folder of restenosisFoam", folder.string()));
  ResultsFolder results(folder, acquireLock(folder));
  movingAside(folder, [&] { finishMovingAside(folder); });
  refuseLinkedFolders(folder);
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
    const auto day = dayOfFlowCase(entry.path());
    if (day && unwanted(entry.path(), *day)) found.push_back(entry.path());
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
