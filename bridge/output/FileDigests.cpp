#include "FileDigests.h"

#include <fmt/format.h>

#include <set>

#include "AtomicFile.h"
#include "FileContent.h"
#include "StateArchive.h"

namespace restenosis {

namespace fs = std::filesystem;

FileDigests digestsOf(const fs::path& folder, const std::vector<fs::path>& files) {
  FileDigests digests;
  for (const fs::path& file : files) digests[file.string()] = digestOf(contentOf(folder / file));
  return digests;
}

std::string changeOfFiles(const FileDigests& before, const FileDigests& now) {
  for (const auto& [file, digest] : before) {
    const auto found = now.find(file);
    if (found == now.end()) return fmt::format("where {} is missing", file);
    if (found->second != digest) return fmt::format("where {} has been changed", file);
  }
  for (const auto& [file, digest] : now)
    if (!before.contains(file)) return fmt::format("where {} has been added", file);
  return {};
}

void flushFiles(const fs::path& folder, const FileDigests& files) {
  std::set<fs::path> folders;
  for (const auto& [file, digest] : files) {
    if (!fs::exists(folder / file)) continue;
    flushFile(folder / file);
    for (fs::path above = fs::path(file).parent_path(); !above.empty(); above = above.parent_path())
      folders.insert(folder / above);
  }
  for (const fs::path& each : folders) flushFolder(each);
  for (const fs::path& each : {folder, folder.parent_path(), folder.parent_path().parent_path()})
    flushFolder(each);
}

}  // namespace restenosis
