#include "bridge/output/Checkpoint.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <system_error>

#include "bridge/output/Version.h"
#include "bridge/system/AtomicFile.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {

namespace {

using Reason = CheckpointRefused::Reason;

constexpr std::array<char, 8> magic{'r', 'F', 'o', 'a', 'm', 'S', 't', '\n'};
constexpr std::uint32_t formatVersion = 21;

/// The first bytes of every format; they never change their place.
struct Prefix {
  std::array<char, 8> magic;
  std::uint32_t format;
  std::uint32_t headerSize;  ///< of what follows the prefix [bytes]
};

/// What follows the prefix, before the state.
struct Header {
  std::string fingerprint, writtenBy, digest;
  CheckpointOrigin origin;
  std::uint64_t stateSize = 0;

  template <class Archive>
  void archive(Archive& a) {
    a(fingerprint, writtenBy, origin, stateSize, digest);
  }
  /// Size of a state, and checksum of everything but the checksum itself, so that damage to the header shows
  /// as well.
  void measure(const Checkpoint::StateWriter& state) {
    HashingArchive hash;
    hash.bytes(fingerprint.data(), fingerprint.size());
    hash.bytes(writtenBy.data(), writtenBy.size());
    hash(origin);
    stateSize = 0;
    StreamingArchive archive([&](std::string_view piece) {
      hash.bytes(piece.data(), piece.size());
      stateSize += piece.size();
    });
    state(archive);
    digest = hash.digest();
  }
};

/// A state that is there as bytes.
Checkpoint::StateWriter writerOf(std::string_view state) {
  return [state](StreamingArchive& archive) { archive.bytes(state.data(), state.size()); };
}

}  // namespace

void Checkpoint::save(std::string_view fingerprint, std::string_view state) const {
  save(fingerprint, writerOf(state));
}

void Checkpoint::save(std::string_view fingerprint, const StateWriter& state) const {
  Header header{std::string(fingerprint), std::string(version()), "", origin_, 0};
  header.measure(state);
  WritingArchive archive;
  archive(header);
  const Prefix prefix{magic, formatVersion, static_cast<std::uint32_t>(archive.buffer().size())};
  createFolder(folder_);
  atomicWrite(file(), [&](const PieceWriter& write) {
    write({reinterpret_cast<const char*>(&prefix), sizeof(prefix)});
    write(archive.buffer());
    StreamingArchive stream(write);
    state(stream);
  });
}

std::vector<std::string> Checkpoint::inputsChangedSince(const CheckpointOrigin& before) const {
  std::vector<std::string> changed;
  for (const auto& [name, digest] : before.inputs) {
    const auto now = origin_.inputs.find(name);
    if (now != origin_.inputs.end() && now->second != digest) changed.push_back(name);
  }
  return changed;
}

bool Checkpoint::exists() const {
  std::error_code error;
  return std::filesystem::exists(file(), error) || error;
}

std::string Checkpoint::load(std::string_view fingerprint) const { return loadWithOrigin(fingerprint).bytes; }

StoredState Checkpoint::loadWithOrigin(std::string_view fingerprint) const {
  const auto refuse = [this](Reason reason, const std::string& why,
                             std::vector<std::string> inputs = {}) -> CheckpointRefused {
    return {reason, fmt::format("checkpoint {}: {}", file().string(), why), std::move(inputs)};
  };
  const auto truncated = [&refuse] {
    return refuse(Reason::truncated, "is cut off; it cannot be gone on from, start the run again");
  };
  const auto corrupt = [&refuse] {
    return refuse(Reason::corrupt,
                  "is damaged (its checksum does not fit); it cannot be gone on from, start the run again");
  };

  std::error_code error;
  const std::uint64_t fileSize = std::filesystem::file_size(file(), error);
  std::ifstream stream(file(), std::ios::binary);
  if (!error && !stream) error.assign(errno, std::generic_category());
  if (error) {
    throw refuse(Reason::missing, exists()
                                      ? "cannot be read: " + error.message()
                                      : "is not there; run without --resume to start from the beginning");
  }
  Prefix prefix{};
  stream.read(reinterpret_cast<char*>(&prefix), sizeof(prefix));
  if (stream && prefix.magic != magic)
    throw refuse(Reason::notACheckpoint, "is not a checkpoint of restenosisFoam");
  if (!stream) throw truncated();
  if (prefix.format != formatVersion) {
    throw refuse(Reason::otherFormat, fmt::format("has format {}, this program reads format {}; go on with "
                                                  "the version that wrote it, or start the run again",
                                                  prefix.format, formatVersion));
  }
  if (prefix.headerSize > fileSize - sizeof(prefix)) throw truncated();
  std::string headerBytes(prefix.headerSize, '\0');
  stream.read(headerBytes.data(), static_cast<std::streamsize>(headerBytes.size()));
  Header header;
  try {
    ReadingArchive archive(std::move(headerBytes));
    archive(header);
    if (!archive.atEnd()) throw corrupt();
  } catch (const ArchiveTruncated&) {
    throw corrupt();
  }
  const std::uint64_t present = fileSize - sizeof(prefix) - prefix.headerSize;
  if (header.stateSize > present) throw truncated();
  if (header.stateSize < present) throw corrupt();
  std::string state(header.stateSize, '\0');
  stream.read(state.data(), static_cast<std::streamsize>(state.size()));
  if (!stream) throw truncated();
  Header measured = header;
  measured.measure(writerOf(state));
  if (header.digest != measured.digest) throw corrupt();
  if (header.fingerprint != fingerprint) {
    throw refuse(
        Reason::foreign,
        fmt::format(
            "belongs to another scene or to other settings (it was written by {}); resume with the scene "
            "it was started with, or start again",
            header.writtenBy),
        inputsChangedSince(header.origin));
  }
  return {std::move(state), std::move(header.origin)};
}

}  // namespace restenosis
