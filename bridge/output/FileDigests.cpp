#include "bridge/output/FileDigests.h"

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <stdexcept>

#include "bridge/system/AtomicFile.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {

namespace fs = std::filesystem;

namespace {

/// Of a file of any size, a piece at a time: a copy of the whole takes ten times as long as its digest.
std::string digestOfFile(const fs::path& file) {
  std::ifstream stream;
  stream.rdbuf()->pubsetbuf(nullptr, 0);
  stream.open(file, std::ios::binary);
  std::vector<char> piece(1 << 18);
  HashingArchive hash;
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) || stream.gcount() > 0)
    hash.bytes(piece.data(), static_cast<std::size_t>(stream.gcount()));
  // At the end of a file that was read whole only eof and fail are set
  if (!stream.eof() || stream.bad())
    throw std::runtime_error(fmt::format("{} cannot be read", file.string()));
  return hash.digest();
}

}  // namespace

FileDigests digestsOf(const fs::path& folder, const std::vector<fs::path>& files) {
  FileDigests digests;
  for (const fs::path& file : files) digests[file.string()] = digestOfFile(folder / file);
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
