#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bridge/flow/FlowBackend.h"
#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// Blood flow (model 8).
struct FlowParameters {
  static constexpr std::string_view section = "flow";
  static constexpr std::string_view summary = "Steady laminar blood flow through the lumen";

  /// Least mean velocity [m/s] (assumed). OpenFOAM adds 1e-20 to the norms of residuals, which counts in
  /// slower flow: at 1e-12 m/s the stress in a tube was found 4 % too high, at 1e-9 m/s it is that of any
  /// velocity.
  static constexpr double slowest = 1e-9;
  /// Largest mean velocity [m/s] (assumed).
  static constexpr double fastest = 10;

  std::string backend = "foam";
  std::string drive = "flowRate";    ///< see keeps
  double meanVelocity = 0.133;       ///< in the undeformed lumen [m/s]
  double pressureGradient = 3547.0;  ///< -dp/dz [Pa/m]; what meanVelocity needs in a lumen of 1.8 mm
  double perfusionPressure = 90 * 133.322387415;  ///< for drive "resistance" [Pa]
  double distalResistance = 0.0;                  ///< the same [Pa s/m^3]; 0: see distal
  double density = 1000.0;                        ///< [kg/m^3]
  double kinematicViscosity = 2.7e-6;             ///< of Newtonian blood [m^2/s]
  std::string viscosity = "newtonian";            ///< see thinning
  double zeroShearViscosity = 0.056;              ///< [Pa s]
  double infiniteShearViscosity = 0.00345;        ///< of Carreau [Pa s]
  double carreauTime = 3.313;                     ///< [s]
  double carreauIndex = 0.3568;
  double cassonViscosity = 0.00417;    ///< [Pa s]
  double yieldStress = 0.00308;        ///< of Casson [Pa]
  std::string waveform = "none";       ///< see beating
  std::string waveformFile;            ///< table of another waveform; empty for none
  std::int64_t beats = 3;              ///< solved, one after the other
  std::string stressMeasure = "mean";  ///< see beating
  std::string outlets;                 ///< table of several outlets; empty for one
  double straightEnds = 0.0;           ///< of straight tube before the inlet and behind the outlet [m]
  std::string crossCheck = "none";     ///< see FlowBackendNames.h: crossChecks
  double crossCheckShare = 0.1;        ///< of the flow's time
  double crossCheckLimit = 0.1;        ///< of the stress

  void describe(ParameterVisitor& p);
  bool isCrossChecked() const;
  /// What a solution is given, as `drive` says: a flow rate where it is "resistance", too, for that is found
  /// in turn. Throws std::invalid_argument for a word that is none of its.
  FlowConditions::Drive keeps() const;
  /// What lies behind the vessel, where `drive` is "resistance". Without a resistance of its own it lets the
  /// flow rate of `meanVelocity` through, the vessel's own resistance left out.
  std::optional<DistalBed> distal(double lumenDiameter) const;
  /// Whether the flow rate beats.
  bool isBeating() const { return waveform != "none" || !waveformFile.empty(); }
  /// How blood thins, as `viscosity` says; nothing of Newtonian blood. Throws std::invalid_argument for a
  /// word that is none of its.
  std::optional<ViscosityLaw> thinning() const;
  /// Of blood that thins, that at the wall of the undeformed lumen in developed flow [m^2/s].
  double wallViscosity(double lumenDiameter) const;
  /// Of meanVelocity in the undeformed lumen, or what `distal` would let through a vessel without resistance
  /// [m^3/s].
  double givenFlowRate(double lumenDiameter) const;
  /// How the flow rate beats, as `waveform` or the table says; nothing of steady flow. Throws TableError
  /// for a table that cannot be used, and std::invalid_argument for a word that is none of waveform's.
  std::optional<Beating> beating() const;
  /// The outlets of the table, sorted by name; none without one. Throws TableError.
  std::vector<Outlet> outletsOfTable() const;
  /// The conditions of steady flow that a backend solves for; the flow rate is the mean velocity times the
  /// undeformed lumen's area.
  FlowConditions conditions(double lumenDiameter) const;
  /// U D / nu in the undeformed lumen; at a fixed gradient with the mean velocity of developed flow.
  double reynoldsNumber(double lumenDiameter) const;
  /// At a fixed gradient, the mean velocity of developed flow in the undeformed lumen [m/s].
  double drivenVelocity(double lumenDiameter) const;
};

}  // namespace restenosis
