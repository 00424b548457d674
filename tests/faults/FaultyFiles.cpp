/// A library to be preloaded: counts what one program does to the files below one folder, and lets one of
/// these operations fail, tear or be the program's last. By the environment:
///
/// - FAULTY_FILES_PROGRAM: the program's file; its children, which inherit the environment, are left alone
/// - FAULTY_FILES_UNDER: the folder, absolute
/// - FAULTY_FILES_LOG: where each operation is told, a line each: its name and the file's
/// - FAULTY_FILES_AT: the number of the operation that is met, from 1; none by default
/// - FAULTY_FILES_KIND: `fail` (it is not done: no room, or an error of the device), `torn` (half of what is
/// to be
///   written is, and the program is killed), `kill` (before it is done), `short` (every write takes half of
///   what it is given, as the system may)
#include <dlfcn.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

enum class Fate { done, fails, torn, halved };

/// The function that the program would have called without this library.
template <class Function>
Function* original(Function*, const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}
#define ORIGINAL(name) (original(static_cast<decltype(&::name)>(nullptr), #name))

struct Plan {
  std::string under, kind;
  long at = 0;
  int log = -1;
  bool active = false;

  Plan() {
    const auto text = [](const char* name) {
      const char* value = std::getenv(name);
      return std::string(value ? value : "");
    };
    char self[4096];
    const ssize_t length = ::readlink("/proc/self/exe", self, sizeof self);
    under = text("FAULTY_FILES_UNDER");
    active = length > 0 && !under.empty() &&
             text("FAULTY_FILES_PROGRAM") == std::string(self, static_cast<std::size_t>(length));
    if (!active) return;
    kind = text("FAULTY_FILES_KIND");
    at = std::atol(text("FAULTY_FILES_AT").c_str());
    const std::string file = text("FAULTY_FILES_LOG");
    if (!file.empty()) log = ORIGINAL(open)(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  }
  bool concerns(const std::string& path) const {
    return path.compare(0, under.size(), under) == 0 &&
           (path.size() == under.size() || path[under.size()] == '/');
  }
};

const Plan& plan() {
  static const Plan made;
  return made;
}

std::string pathOf(int handle) {
  char path[4096];
  const std::string link = "/proc/self/fd/" + std::to_string(handle);
  const ssize_t length = ::readlink(link.c_str(), path, sizeof path);
  return length > 0 ? std::string(path, static_cast<std::size_t>(length)) : "";
}

std::string absolute(int folder, const char* path) {
  if (path == nullptr) return "";
  if (*path == '/') return path;
  char here[4096];
  const std::string base = folder != AT_FDCWD ? pathOf(folder) : ::getcwd(here, sizeof here) ? here : "";
  return base + "/" + path;
}

[[noreturn]] void die() {
  ::kill(::getpid(), SIGKILL);
  for (;;) ::pause();
}

/// Counts an operation. `divisible`: it can be done by half.
Fate meet(const char* operation, const std::string& path, bool divisible = false) {
  if (!plan().active || !plan().concerns(path)) return Fate::done;
  static std::atomic<long> count{0};
  const int before = errno;
  const long number = ++count;
  if (plan().log >= 0) {
    const std::string line = std::string(operation) + " " + path + "\n";
    if (ORIGINAL(write)(plan().log, line.data(), line.size()) < 0) std::abort();
  }
  errno = before;
  if (plan().kind == "short") return divisible ? Fate::halved : Fate::done;
  if (number != plan().at) return Fate::done;
  if (plan().kind == "fail") return Fate::fails;
  if (plan().kind == "torn" && divisible) return Fate::torn;
  die();
}

int failure(int error) {
  errno = error;
  return -1;
}

bool forWriting(int handle) { return (::fcntl(handle, F_GETFL) & O_ACCMODE) != O_RDONLY; }

std::size_t half(std::size_t size) { return size > 1 ? size / 2 : size; }

/// Writes all, half or nothing: `write` takes a size.
template <class Write>
ssize_t met(const char* operation, int handle, std::size_t size, Write&& write) {
  switch (meet(operation, pathOf(handle), size > 0)) {
    case Fate::fails:
      return failure(ENOSPC);
    case Fate::torn:
      if (size > 1) write(size / 2);
      die();
    case Fate::halved:
      return write(half(size));
    default:
      return write(size);
  }
}

/// Whether an operation on a path, or on nothing but a handle, is to fail with this error.
bool fails(const char* operation, const std::string& path, int error) {
  if (meet(operation, path) != Fate::fails) return false;
  errno = error;
  return true;
}

bool writes(int flags) { return (flags & O_ACCMODE) != O_RDONLY || (flags & O_CREAT) != 0; }
bool writes(const char* mode) { return std::strpbrk(mode, "wa+") != nullptr; }

mode_t modeOf(int flags, va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? static_cast<mode_t>(va_arg(arguments, int)) : 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = modeOf(flags, arguments);
  va_end(arguments);
  if (writes(flags) && fails("open", absolute(AT_FDCWD, path), ENOSPC)) return -1;
  return ORIGINAL(open)(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = modeOf(flags, arguments);
  va_end(arguments);
  if (writes(flags) && fails("open", absolute(AT_FDCWD, path), ENOSPC)) return -1;
  return ORIGINAL(open64)(path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = modeOf(flags, arguments);
  va_end(arguments);
  if (writes(flags) && fails("open", absolute(folder, path), ENOSPC)) return -1;
  return ORIGINAL(openat)(folder, path, flags, mode);
}

FILE* fopen(const char* path, const char* mode) {
  if (writes(mode) && fails("open", absolute(AT_FDCWD, path), ENOSPC)) return nullptr;
  return ORIGINAL(fopen)(path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
  if (writes(mode) && fails("open", absolute(AT_FDCWD, path), ENOSPC)) return nullptr;
  return ORIGINAL(fopen64)(path, mode);
}

ssize_t write(int handle, const void* data, size_t size) {
  return met("write", handle, size, [&](size_t part) { return ORIGINAL(write)(handle, data, part); });
}

ssize_t pwrite(int handle, const void* data, size_t size, off_t offset) {
  return met("write", handle, size,
             [&](size_t part) { return ORIGINAL(pwrite)(handle, data, part, offset); });
}

ssize_t pwrite64(int handle, const void* data, size_t size, off64_t offset) {
  return met("write", handle, size,
             [&](size_t part) { return ORIGINAL(pwrite64)(handle, data, part, offset); });
}

ssize_t writev(int handle, const struct iovec* pieces, int count) {
  size_t size = 0;
  for (int n = 0; n < count; ++n) size += pieces[n].iov_len;
  return met("write", handle, size, [&](size_t part) {
    if (part == size) return ORIGINAL(writev)(handle, pieces, count);
    for (int n = 0; n < count; ++n)
      if (pieces[n].iov_len > 0)
        return ORIGINAL(write)(handle, pieces[n].iov_base,
                               pieces[n].iov_len < part ? pieces[n].iov_len : part);
    return ssize_t{0};
  });
}

ssize_t sendfile(int to, int from, off_t* offset, size_t size) {
  return met("write", to, size, [&](size_t part) { return ORIGINAL(sendfile)(to, from, offset, part); });
}

ssize_t copy_file_range(int from, off64_t* fromOffset, int to, off64_t* toOffset, size_t size,
                        unsigned flags) {
  return met("write", to, size, [&](size_t part) {
    return ORIGINAL(copy_file_range)(from, fromOffset, to, toOffset, part, flags);
  });
}

int fsync(int handle) { return fails("fsync", pathOf(handle), EIO) ? -1 : ORIGINAL(fsync)(handle); }

int fdatasync(int handle) { return fails("fsync", pathOf(handle), EIO) ? -1 : ORIGINAL(fdatasync)(handle); }

int ftruncate(int handle, off_t size) noexcept {
  return fails("truncate", pathOf(handle), EIO) ? -1 : ORIGINAL(ftruncate)(handle, size);
}

int ftruncate64(int handle, off64_t size) noexcept {
  return fails("truncate", pathOf(handle), EIO) ? -1 : ORIGINAL(ftruncate64)(handle, size);
}

int close(int handle) {
  const bool failing = forWriting(handle) && fails("close", pathOf(handle), EIO);
  const int result = ORIGINAL(close)(handle);
  return failing ? failure(EIO) : result;
}

int fclose(FILE* file) {
  const int handle = ::fileno(file);
  const bool failing = handle >= 0 && forWriting(handle) && fails("close", pathOf(handle), EIO);
  const int result = ORIGINAL(fclose)(file);
  return failing ? failure(EIO) : result;
}

int rename(const char* from, const char* to) noexcept {
  return fails("rename", absolute(AT_FDCWD, to), ENOSPC) ? -1 : ORIGINAL(rename)(from, to);
}

int unlink(const char* path) noexcept {
  return fails("unlink", absolute(AT_FDCWD, path), EIO) ? -1 : ORIGINAL(unlink)(path);
}

int unlinkat(int folder, const char* path, int flags) noexcept {
  return fails("unlink", absolute(folder, path), EIO) ? -1 : ORIGINAL(unlinkat)(folder, path, flags);
}

int remove(const char* path) noexcept {
  return fails("unlink", absolute(AT_FDCWD, path), EIO) ? -1 : ORIGINAL(remove)(path);
}

int rmdir(const char* path) noexcept {
  return fails("rmdir", absolute(AT_FDCWD, path), EIO) ? -1 : ORIGINAL(rmdir)(path);
}

int mkdir(const char* path, mode_t mode) noexcept {
  return fails("mkdir", absolute(AT_FDCWD, path), ENOSPC) ? -1 : ORIGINAL(mkdir)(path, mode);
}

int link(const char* from, const char* to) noexcept {
  return fails("link", absolute(AT_FDCWD, to), ENOSPC) ? -1 : ORIGINAL(link)(from, to);
}

int symlink(const char* from, const char* to) noexcept {
  return fails("link", absolute(AT_FDCWD, to), ENOSPC) ? -1 : ORIGINAL(symlink)(from, to);
}
}
