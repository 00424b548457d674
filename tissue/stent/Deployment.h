#pragma once

#include <functional>

#include "tissue/equilibrium/Relaxation.h"
#include "tissue/stent/DeploymentStatistics.h"
#include "tissue/stent/Stent.h"
#include "tissue/stent/StentParameters.h"
#include "tissue/vessel/Wall.h"

namespace restenosis {

/// Presses a stent into the wall in equal steps (model 4). After k of n steps the struts' outer face is at
/// lumen radius + depth k / n, exactly, and the wall is relaxed. Struts, vessel ends and, where the scene
/// says so, the EEL do not move; cells stay inside the EEL and between the vessel's ends.
///
/// Everything that changes is in the Wall, so a run is checkpointed between two steps by keeping the wall and
/// the number of steps done.
class Deployment {
 public:
  /// Factor on `relaxation.tolerance` in each step. Where the wall is free outside, residuals of the steps
  /// add up along modes in which all of it moves: without this factor the thesis vessel rests 3.6 um rms from
  /// where a tenth of the tolerance leads (docs/results/wall.md). Assumed.
  static constexpr double stepShare = 0.1;

  /// Appends the obstacle agents of a stent with its outer face at the lumen's surface to the wall, or, if it
  /// holds struts already (a wall read back after `stepsDone` steps), uses those; they must be as many as
  /// the stent has. Before the first step, the EEL is fixed or freed as the stent's `outerLamina`
  /// says, and the ends as `vessel` says; later the same agents stay fixed, even where others have moved into
  /// the ends. Throws std::invalid_argument for struts that are not this stent's. The wall must outlive the
  /// deployment.
  Deployment(Wall& wall, Stent stent, const StentParameters& parameters, const VesselParameters& vessel,
             const MechanicsParameters& mechanics, const RelaxationParameters& relaxation, int stepsDone = 0);

  int steps() const { return steps_; }
  int stepsDone() const { return stepsDone_; }
  bool done() const { return stepsDone_ == steps_; }
  /// Depth of the outer face beyond the undeformed lumen after k steps [m].
  double depthAfter(int k) const;

  /// Moves the stent by one step and relaxes the wall, and again where bonds break: to `stepShare` of the
  /// tolerance, or, where the iterations do not suffice, to the tolerance at least. With
  /// `relaxation.stopAtMaximum` the wall gets its fixed effort only. Throws RelaxationFailed where the
  /// tolerance is not reached.
  RelaxationReport step();
  /// All remaining steps; calls `progress` after each.
  void run(const std::function<void(const Deployment&, const RelaxationReport&)>& progress = {});

  /// The stent where it now stands.
  const Stent& stent() const { return stent_; }
  DeploymentStatistics statistics() const { return measureDeployment(wall_, stent_); }

 private:
  void attachStruts();
  void fixAgents(const StentParameters& parameters, const VesselParameters& vessel);
  void placeStent();
  /// Relaxes the wall, and again where bonds break.
  RelaxationReport relaxBy(Relaxation& relaxation);
  /// Moves the agents as the last step did. Returns their positions before, x, y, z by agent [m], in the
  /// memory of Wall::lastMove, which is empty until the step is over.
  std::vector<double> continueLastMove();

  Wall& wall_;
  Stent undeployed_, stent_;
  MechanicsParameters mechanics_;
  RelaxationParameters asked_;
  Relaxation relaxation_;
  double depth_;
  int steps_, stepsDone_;
  std::vector<Index> strutAgents_;  ///< of each sphere of the stent
};

}  // namespace restenosis
