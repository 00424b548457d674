#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "tissue/stent/Deployment.h"
#include "tissue/stent/StrutAgents.h"
#include "tissue/vessel/WallPacking.h"

namespace restenosis::support {

/// How far a deployed wall is from one deployed ten times as tightly, in double precision.
struct DeploymentDifference {
  double rms = 0;      ///< of all agents of the wall [m]
  double largest = 0;  ///< [m]
  /// Agents that took another way: they are apart by more than half of their radius, for a gap beside them
  /// closed on its other side.
  Index branched = 0;
  Index agents = 0;
  double rmsOfOthers = 0;  ///< [m]
  double moved = 0;        ///< rms that deployment itself moved the reference [m]
  double iel = 0;          ///< of the mean radius of the IEL under struts [m]
};

/// Both from one packed wall: a packing is an accident of its last bit, and where two packings differ so do
/// the ways from there.
inline DeploymentDifference differenceFromTighter(const VesselParameters& vessel,
                                                  const StentParameters& stent) {
  const RelaxationParameters usual;
  RelaxationParameters tight;
  tight.tolerance = usual.tolerance / 10;
  tight.precision = "double";
  tight.maximumIterations = 100000;

  const Wall packed = packWall(vessel, {}, usual, 1);
  Wall wall = packed, reference = packed;
  Deployment one(wall, stentOfDesign(stent, vessel), stent, vessel, {}, usual);
  Deployment other(reference, stentOfDesign(stent, vessel), stent, vessel, {}, tight);
  one.run(), other.run();

  DeploymentDifference difference;
  double squares = 0, squaresOfOthers = 0, moved = 0;
  for (Index i = 0; i < packed.agents.size(); ++i) {
    EXPECT_EQ(wall.agents.id[i], reference.agents.id[i]);
    const Vec3 place = reference.agents.position(i);
    const double apart = (wall.agents.position(i) - place).norm();
    squares += apart * apart;
    difference.largest = std::max(difference.largest, apart);
    if (apart > packed.agents.radius[i] / 2)
      ++difference.branched;
    else
      squaresOfOthers += apart * apart;
    moved += (place - packed.agents.position(i)).squaredNorm();
  }
  difference.agents = packed.agents.size();
  const auto agents = static_cast<double>(difference.agents);
  difference.rms = std::sqrt(squares / agents);
  difference.rmsOfOthers = std::sqrt(squaresOfOthers / (agents - difference.branched));
  difference.moved = std::sqrt(moved / agents);
  difference.iel = one.statistics().ielUnderStrut.value() - other.statistics().ielUnderStrut.value();
  return difference;
}

/// For the pages of results, in micrometres.
inline std::ostream& operator<<(std::ostream& out, const DeploymentDifference& difference) {
  return out << 1e6 * difference.rms << " um rms apart, but for " << difference.branched << " of "
             << difference.agents << " agents " << 1e6 * difference.rmsOfOthers << " (largest "
             << 1e6 * difference.largest << "), moved by " << 1e6 * difference.moved
             << ", IEL under struts apart by " << 1e6 * difference.iel;
}

}  // namespace restenosis::support
