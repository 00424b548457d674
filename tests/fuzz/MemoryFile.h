#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace restenosis {

/// A file in memory, for readers that take the name of one.
class MemoryFile {
 public:
  MemoryFile() : handle_(::memfd_create("input", MFD_CLOEXEC)) {
    if (handle_ < 0) throw std::runtime_error("no file in memory can be made");
  }
  ~MemoryFile() { ::close(handle_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// Its name, after its content has been replaced.
  std::filesystem::path holding(std::string_view content) const {
    const auto size = static_cast<ssize_t>(content.size());
    if (::ftruncate(handle_, 0) != 0 || ::pwrite(handle_, content.data(), content.size(), 0) != size)
      throw std::runtime_error("a file in memory cannot be written");
    return "/proc/self/fd/" + std::to_string(handle_);
  }

 private:
  int handle_;
};

}  // namespace restenosis
