#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace restenosis {

/// A file of the results could not be written; `what()` names the file and the system's reason.
struct WriteFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Whether the system's `errno` tells of a disk, a quota or a size limit that is used up.
bool isForWantOfRoom(int error);

/// The system's words for an `errno`, and what to do where there is no room.
std::string writeFailureReason(int error);

/// Takes a piece of a file's content.
using PieceWriter = std::function<void(std::string_view)>;

/// Replaces `file` by the pieces that `content` hands over, one after the other, so that a reader, or a run
/// killed at any moment, finds either the old content or the new one: written to `<file>.partial`, flushed to
/// the disk, renamed, and the folder flushed. A symbolic link is replaced, not followed. On failure (disk
/// full, no permission, an exception of `content`) the old file stays as it was, the partial one is removed;
/// WriteFailed is thrown, or the exception passed on.
void atomicWrite(const std::filesystem::path& file, const std::function<void(const PieceWriter&)>& content);
void atomicWrite(const std::filesystem::path& file, std::string_view text);

/// Makes a file's content survive a power cut. Throws WriteFailed.
void flushFile(const std::filesystem::path& file);

/// Makes what has been created, renamed and removed in a folder survive a power cut; file systems that cannot
/// do it are left alone. Throws WriteFailed.
void flushFolder(const std::filesystem::path& folder);

/// Removes what is there if it is a symbolic link, which what is written next would follow; what it leads to
/// stays. Throws WriteFailed.
void removeIfLink(const std::filesystem::path& path);

/// Tries whether a folder has room for a file of 64 KiB, which it removes again: throws WriteFailed where
/// disk, quota or size limit are used up. For those who wonder why a program failed there that does not say.
void requireRoom(const std::filesystem::path& folder);

/// Creates a folder and those above it; throws WriteFailed.
void createFolder(const std::filesystem::path& folder);

}  // namespace restenosis
