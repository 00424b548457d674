#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace restenosis {

/// XXH3 digests of files, by their path below a folder.
using FileDigests = std::map<std::string, std::string>;

/// The digests of files in a folder. Throws std::runtime_error, naming the file, where one cannot be read.
FileDigests digestsOf(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files);

/// How the files that `before` is of differ from those of `now`, as the end of a sentence that begins with
/// the folder: "where p/points has been changed". Empty where they do not.
std::string changeOfFiles(const FileDigests& before, const FileDigests& now);

/// Makes files of a folder survive a power cut: themselves, the folders that they lie in, and the folder's
/// own place. One that is gone is left out. Throws WriteFailed.
void flushFiles(const std::filesystem::path& folder, const FileDigests& files);

}  // namespace restenosis
