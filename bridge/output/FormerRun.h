#pragma once

#include <filesystem>
#include <optional>

namespace restenosis {

/// Whether a name in a results folder is one that a run writes there, or a comparison.
bool isNameOfResult(const std::filesystem::path& name);

/// Whether such a name is that of a folder.
bool isNameOfResultFolder(const std::filesystem::path& name);

/// Whether a name in a results folder is that of the former run's folder, or of one that a move aside that
/// was cut short has left.
bool isNameOfFormerRun(const std::filesystem::path& name);

/// Whether a folder is there, and no link to one.
bool isRealFolder(const std::filesystem::path& path);

/// The day that a flow case in `flow/` is named after; nothing for what is the user's.
std::optional<double> dayOfFlowCase(const std::filesystem::path& folder);

/// What becomes of a run that has recorded nothing.
enum class Unrecorded {
  keptUnlessItReplaces,  ///< it is moved as any other, but deleted where the one in `previous/` has recorded
  deleted
};

/// Moves the run in a results folder to `previous/`, in place of the one there; the user's own files, here
/// and in `previous/`, stay. Returns whether there was one that has been moved.
///
/// The files are gathered in `previous.partial/`, which one rename then makes `previous/`: when the program
/// is killed on the way, both runs are whole, and `finishMovingAside` goes on. Throws
/// std::filesystem::filesystem_error.
bool moveRunAside(const std::filesystem::path& results,
                  Unrecorded unrecorded = Unrecorded::keptUnlessItReplaces);

/// Finishes a move that was cut short; nothing happens where there was none. Throws the same.
void finishMovingAside(const std::filesystem::path& results);

}  // namespace restenosis
