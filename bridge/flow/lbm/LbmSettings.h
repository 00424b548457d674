#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

enum class StressRule;
enum class WallRule;

/// How finely and how exactly the lattice Boltzmann backend works.
struct LbmSettings {
  static constexpr std::string_view section = "lbm";
  static constexpr std::string_view summary =
      "Settings of the lattice Boltzmann backend; dx and tolerance follow scene.fidelity where they are not "
      "given";
  /// Fewest nodes across the inlet before the run.
  static constexpr double leastNodesAcross = 8;
  /// Fewest along the lumen: with two layers, of which each is an end, the flow diverges.
  static constexpr double leastNodesAlong = 3;

  double dx = 15e-6;                   ///< lattice spacing [m]
  std::string collision = "trt";       ///< trt or bgk
  double magic = 3.0 / 16.0;           ///< magic parameter of the two relaxation times
  std::string wall = "interpolated";   ///< interpolated or bounceBack
  std::string stress = "adaptive";     ///< adaptive or nearest
  std::string precision = "float";     ///< double or float
  double latticeVelocity = 0.3;        ///< largest expected velocity [spacings per time step]
  double tolerance = 1e-3;             ///< estimated distance of WSS from its steady state, relative
  std::int64_t coarseLevels = 2;       ///< lattices of twice, four times ... the spacing to start from
  bool warmStart = true;               ///< from the former flow, where there is one
  std::int64_t maximumSteps = 200000;  ///< on the finest lattice
  double maximumNodes = 1e8;           ///< in the box around the lumen

  bool operator==(const LbmSettings&) const = default;
  void describe(ParameterVisitor& p);
  /// What `collision`, `wall`, `stress` and `precision` say. Throw std::invalid_argument for a word that is
  /// none of theirs.
  bool singleRelaxation() const;
  WallRule wallRule() const;
  StressRule stressRule() const;
  bool singlePrecision() const;
  /// The settings of a fidelity level: draft (25 um, tolerance 0.5 %), standard (20 um, 0.2 %) or
  /// reference (15 um, 0.1 %). Throws
  /// std::invalid_argument for others.
  static LbmSettings forFidelity(std::string_view fidelity);
};

}  // namespace restenosis
