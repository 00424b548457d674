#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tissue/agents/StateArchive.h"

namespace restenosis {

/// A checkpoint that cannot be gone on from; `reason` tells why without parsing the message.
struct CheckpointRefused : std::runtime_error {
  enum class Reason {
    missing,
    notACheckpoint,
    otherFormat,
    truncated,
    corrupt,
    foreign,
    beyond,
    caseMissing,
    caseChanged
  };
  CheckpointRefused(Reason why, const std::string& message, std::vector<std::string> inputs = {})
      : std::runtime_error(message), reason(why), changedInputs(std::move(inputs)) {}
  Reason reason;
  std::vector<std::string> changedInputs;  ///< names in CheckpointOrigin::inputs of files that are others now
};

/// Where a state comes from, beside its scene: kept with it, to tell what has changed since.
struct CheckpointOrigin {
  std::map<std::string, std::string> traits;  ///< of the build and the machine (buildTraits)
  std::map<std::string, std::string> inputs;  ///< digests of the files that the scene names, by their keys

  template <class Archive>
  void archive(Archive& a) {
    a(traits, inputs);
  }
};

/// A state as it was saved, and where.
struct StoredState {
  std::string bytes;
  CheckpointOrigin origin;
};

/// The stored state of a run in a folder of its own: one file that is replaced atomically, so that a run
/// killed at any moment, or a full disk, leaves the last complete state. The state is bytes of an archive;
/// the file adds what is needed to trust it: format, the scene it belongs to, its size and its XXH3 checksum.
class Checkpoint {
 public:
  explicit Checkpoint(std::filesystem::path folder, CheckpointOrigin origin = {})
      : folder_(std::move(folder)), origin_(std::move(origin)) {}

  std::filesystem::path file() const { return folder_ / "state.bin"; }
  /// Also where the system does not tell: `load` then says why.
  bool exists() const;

  /// Passes a state to an archive.
  using StateWriter = std::function<void(StreamingArchive&)>;

  /// Replaces the stored state. `fingerprint` identifies what of the scene may not change when the run goes
  /// on. `state` is called twice, for the checksum and for the file, and must pass the same both times: a
  /// copy in memory would double what a run needs. Throws WriteFailed; the former checkpoint is then still
  /// there and complete.
  void save(std::string_view fingerprint, const StateWriter& state) const;
  void save(std::string_view fingerprint, std::string_view state) const;
  /// The state as it was saved. Throws CheckpointRefused when there is none, it is damaged, of another
  /// format, or of a scene with another fingerprint.
  std::string load(std::string_view fingerprint) const;
  /// The same, with the origin that it was saved with.
  StoredState loadWithOrigin(std::string_view fingerprint) const;

 private:
  std::vector<std::string> inputsChangedSince(const CheckpointOrigin& before) const;

  std::filesystem::path folder_;
  CheckpointOrigin origin_;
};

}  // namespace restenosis
