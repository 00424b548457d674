#include "bridge/system/AtomicFile.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

namespace restenosis {

namespace fs = std::filesystem;

namespace {

/// Opens a file that is not there: what a killed run has left of it is removed, and so is a link, which would
/// lead elsewhere. Returns its descriptor, or -1 and `errno`.
int createAnew(const fs::path& file) {
  if (::unlink(file.c_str()) != 0 && errno != ENOENT) return -1;
  return ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

/// Returns the error, 0 for none.
int flushAndClose(int handle) {
  const int error = ::fsync(handle) != 0 ? errno : 0;
  ::close(handle);
  return error;
}

/// A file being written; closed and removed unless `commit` is reached.
class PartialFile {
 public:
  explicit PartialFile(fs::path target) : target_(std::move(target)), partial_(target_) {
    partial_ += ".partial";
    file_ = createAnew(partial_);
    if (file_ < 0) fail("create");
  }
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  ~PartialFile() {
    if (file_ >= 0) ::close(file_);
    if (!committed_) ::unlink(partial_.c_str());
  }

  void write(std::string_view text) {
    if (waiting_.size() + text.size() > largestWaiting) {
      send(waiting_);
      waiting_.clear();
    }
    if (text.size() > largestWaiting) {
      send(text);
    } else {
      waiting_ += text;
    }
  }

  void commit() {
    send(waiting_);
    if (::fsync(file_) != 0) fail("write");
    const int file = std::exchange(file_, -1);
    if (::close(file) != 0) fail("write");
    if (::rename(partial_.c_str(), target_.c_str()) != 0) fail("replace");
    committed_ = true;
    flushFolder(target_.parent_path());
  }

 private:
  static constexpr std::size_t largestWaiting = 65536;

  void send(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = ::write(file_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail("write");
      text.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  [[noreturn]] void fail(const char* what) const {
    throw WriteFailed(fmt::format("cannot {} {}: {}", what, target_.string(), writeFailureReason(errno)));
  }

  fs::path target_, partial_;
  std::string waiting_;  ///< pieces too small to be worth a call of the system each
  int file_ = -1;
  bool committed_ = false;
};

}  // namespace

bool isForWantOfRoom(int error) { return error == ENOSPC || error == EDQUOT || error == EFBIG; }

std::string writeFailureReason(int error) {
  return isForWantOfRoom(error) ? fmt::format("{}: make room and go on with --resume", std::strerror(error))
                                : std::strerror(error);
}

void atomicWrite(const fs::path& file, const std::function<void(const PieceWriter&)>& content) {
  PartialFile partial(file);
  content([&partial](std::string_view piece) { partial.write(piece); });
  partial.commit();
}

void atomicWrite(const fs::path& file, std::string_view text) {
  atomicWrite(file, [text](const PieceWriter& write) { write(text); });
}

void flushFolder(const fs::path& folder) {
  const fs::path named = folder.empty() ? fs::path(".") : folder;
  const int handle = ::open(named.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0) return;  // it may be written into, but not be read
  const int error = flushAndClose(handle);
  const bool unknownHere = error == EINVAL || error == ENOTSUP || error == ENOSYS;
  if (error != 0 && !unknownHere)
    throw WriteFailed(fmt::format("cannot write into {}: {}", named.string(), writeFailureReason(error)));
}

void flushFile(const fs::path& file) {
  const int handle = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const int error = handle < 0 ? errno : flushAndClose(handle);
  if (error != 0)
    throw WriteFailed(fmt::format("cannot write {}: {}", file.string(), writeFailureReason(error)));
}

void removeIfLink(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return;  // nor where nothing is
  fs::remove(path, error);
  if (error) throw WriteFailed(fmt::format("cannot replace {}: {}", path.string(), error.message()));
}

void requireRoom(const fs::path& folder) {
  static constexpr std::size_t tried = 65536;
  const fs::path file = folder / ".room";
  const int handle = createAnew(file);
  int error = handle < 0 ? errno : 0;
  if (handle >= 0) {
    const std::string text(tried, '\0');
    const ssize_t written = ::write(handle, text.data(), text.size());
    // What fits is written, and only the next write says why there is no more
    if (written < 0 || (written < static_cast<ssize_t>(tried) && ::write(handle, text.data(), tried) < 0))
      error = errno;
    if (::close(handle) != 0 && error == 0) error = errno;
    ::unlink(file.c_str());
  }
  if (isForWantOfRoom(error))
    throw WriteFailed(fmt::format("cannot write into {}: {}", folder.string(), writeFailureReason(error)));
}

void createFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw WriteFailed(fmt::format("cannot create folder {}: {}", folder.string(), error.message()));
  if (!fs::is_directory(folder, error))
    throw WriteFailed(fmt::format("cannot create folder {}: a file of that name is there", folder.string()));
}

}  // namespace restenosis
