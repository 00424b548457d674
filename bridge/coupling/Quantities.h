#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bridge/coupling/AlikeRemarks.h"
#include "bridge/flow/FlowBackend.h"
#include "bridge/output/FileDigests.h"
#include "bridge/surface/RadialMap.h"
#include "tissue/vessel/Wall.h"

namespace restenosis {

/// What the parts of the loop hand to each other.
enum class Quantity : std::uint8_t {
  cellStates,       ///< cycle states, sizes and number of cells
  agentPositions,   ///< where agents are
  exposure,         ///< which cells face the lumen, which are crowded
  coverage,         ///< which cells carry endothelium
  lumen,            ///< shape of the lumen
  wallTraction,     ///< on the faces of the flow's wall
  wallShearStress,  ///< on cells
  nitricOxide       ///< of cells
};
inline constexpr std::size_t quantityCount = 8;

/// The lumen: its shape now, and after deployment. Empty for a lumen from a file: it has no radial map.
struct LumenState {
  RadialMap present;
  RadialMap afterDeployment;  ///< what neointima is measured against
  /// Histology::insideIel then, what intima is measured against; empty where nothing can be measured
  std::vector<double> insideIelAfterDeployment;
  std::uint64_t detachedPieces = 0;  ///< pieces of tissue in the lumen that no flow sees
  bool closed = false;               ///< whether nothing open joins its ends

  template <class Archive>
  void archive(Archive& a) {
    a(present, afterDeployment, insideIelAfterDeployment, detachedPieces, closed);
  }
};

/// The last flow solution, as long as it holds.
struct FlowState {
  std::optional<FlowSolution> last;
  double time = 0;                ///< of that solve [s]
  RadialMap lumen;                ///< of that solve: what `lumenTolerance` is measured against
  std::uint64_t solves = 0;       ///< since the start
  std::uint64_t meshesMoved = 0;  ///< solves whose mesh was the former one, moved
  std::map<std::string, std::uint64_t> remeshedBecause;  ///< how often it was not, by reason
  std::map<std::string, std::string> settings;           ///< of its backend (flowSettings)
  bool mixed = false;                                    ///< whether earlier solves had others
  AlikeRemarks remarked;                                 ///< in RunState::remarks
  FileDigests startFiles;  ///< what the next solve reads of the case of that one; empty for nothing
  bool fromRest = false;   ///< the next solve has no case to start from: it was lost
  /// Case of the last solve that the checkpoint knows; empty for none. A resumed run may need it. Not part of
  /// the state.
  std::filesystem::path caseInCheckpoint;

  /// Whether the last flow was solved with these settings. True before the first.
  bool hasSettings(const std::map<std::string, std::string>& given) const {
    return solves == 0 || settings == given;
  }

  template <class Archive>
  void archive(Archive& a) {
    a(last, time, lumen, solves, meshesMoved, remeshedBecause, settings, mixed, remarked, startFiles,
      fromRest);
  }
};

/// The quantities, and how often each has changed. Parts get at them through what they declare
/// (Part::read, Part::write). Part of a checkpoint.
class Quantities {
 public:
  explicit Quantities(Wall initial) : wall(std::move(initial)) {}

  Wall wall;  ///< holds all quantities of agents
  LumenState lumen;
  FlowState flow;

  /// The data that hold a quantity.
  template <Quantity q>
  auto& data() {
    if constexpr (q == Quantity::lumen)
      return lumen;
    else if constexpr (q == Quantity::wallTraction)
      return flow;
    else if constexpr (q == Quantity::cellStates || q == Quantity::agentPositions)
      return wall;
    else
      return wall.agents;
  }
  std::uint64_t changes(Quantity q) const { return changes_[static_cast<std::size_t>(q)]; }
  void countChange(Quantity q) { ++changes_[static_cast<std::size_t>(q)]; }

  template <class Archive>
  void archive(Archive& a) {
    a(wall, lumen, flow, changes_);
  }

 private:
  std::array<std::uint64_t, quantityCount> changes_{};
};

/// A quantity that its holder reads.
template <Quantity q>
class Read {
 public:
  using Data = std::remove_reference_t<decltype(std::declval<Quantities&>().template data<q>())>;
  explicit Read(Quantities& quantities) : data_(quantities.data<q>()) {}
  const Data& operator*() const { return data_; }
  const Data* operator->() const { return &data_; }

 private:
  const Data& data_;
};

/// A quantity that its holder writes; each change is counted.
template <Quantity q>
class Write {
 public:
  using Data = typename Read<q>::Data;
  explicit Write(Quantities& quantities) : quantities_(quantities) {}
  const Data& operator*() const { return quantities_.data<q>(); }
  const Data* operator->() const { return &quantities_.data<q>(); }

  /// Calls f(data). Where f returns a bool, it says whether anything has changed.
  template <class F>
  void change(F&& f) {
    Data& data = quantities_.data<q>();
    if constexpr (std::is_same_v<std::invoke_result_t<F, Data&>, bool>) {
      if (f(data)) quantities_.countChange(q);
    } else {
      f(data);
      quantities_.countChange(q);
    }
  }

 private:
  Quantities& quantities_;
};

}  // namespace restenosis
