#include "bridge/system/FileContent.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace restenosis {
namespace {

struct FileHandle {
  explicit FileHandle(int opened) : number(opened) {}
  ~FileHandle() {
    if (number >= 0) ::close(number);
  }
  FileHandle(const FileHandle&) = delete;
  FileHandle& operator=(const FileHandle&) = delete;
  const int number;
};

std::string sizeText(std::uintmax_t bytes) {
  constexpr std::uintmax_t mebi = 1 << 20;
  return bytes < mebi || bytes % mebi != 0 ? fmt::format("{} bytes", bytes)
                                           : fmt::format("{} MiB", bytes / mebi);
}

std::string tooLarge(std::uintmax_t most) {
  return fmt::format("is larger than {}, the most that is read", sizeText(most));
}

std::string kindOf(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "a device";
  return "something else";
}

std::string obstacleOf(const struct stat& status, std::uintmax_t most) {
  if (!S_ISREG(status.st_mode)) return fmt::format("is {}, not a file", kindOf(status.st_mode));
  if (static_cast<std::uintmax_t>(status.st_size) > most) return tooLarge(most);
  return {};
}

}  // namespace

std::string fileObstacle(const std::filesystem::path& file, std::uintmax_t most) {
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0) return obstacleOf(status, most);
  if (errno == ENOENT || errno == ENOTDIR) return "does not exist";
  return fmt::format("cannot be reached: {}", std::strerror(errno));
}

std::string contentOf(const std::filesystem::path& file, std::uintmax_t most) {
  const auto refuse = [&file](std::string_view reason) {
    throw std::runtime_error(fmt::format("{} {}", file.string(), reason));
  };
  // A pipe is opened at once too, whether it has a writer or not
  const FileHandle handle(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  struct stat status {};
  if (handle.number < 0 || ::fstat(handle.number, &status) != 0)
    refuse(fmt::format("cannot be read: {}", std::strerror(errno)));
  if (const std::string obstacle = obstacleOf(status, most); !obstacle.empty()) refuse(obstacle);
  std::string content;
  content.reserve(static_cast<std::size_t>(status.st_size));
  char piece[1 << 16];
  while (true) {
    const ssize_t got = ::read(handle.number, piece, sizeof piece);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse(fmt::format("cannot be read: {}", std::strerror(errno)));
    if (got == 0) return content;
    // Files of the system's own tell no size
    if (content.size() + static_cast<std::size_t>(got) > most) refuse(tooLarge(most));
    content.append(piece, static_cast<std::size_t>(got));
  }
}

}  // namespace restenosis
