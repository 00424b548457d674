#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bridge/flow/ViscosityLaw.h"
#include "bridge/flow/lbm/LumenLattice.h"

namespace restenosis {

/// Developed flow along z through a cross-section of any shape: div(nu grad u) = -f on the nodes of one layer
/// of the lattice, at rest on the wall where the links cross it (Shortley and Weller 1938), by successive
/// over-relaxation. All in lattice units.
class DevelopedProfile {
 public:
  /// `layer`: one layer of nodes, with the links in its plane that the wall cuts.
  explicit DevelopedProfile(const LumenLattice& layer);

  /// The flow of this volume per time, with the viscosity of a relaxation time. Throws std::invalid_argument
  /// where there is no node to flow through.
  void solve(double flowRate, double relaxationTime);
  /// The same of blood that thins: in turn the velocity with the viscosity of before, at first
  /// that of the relaxation time, and the viscosity with the shear rate found.
  void solve(double flowRate, const ViscosityLaw& law, double relaxationTime);

  double velocity(std::uint32_t place) const { return velocity_[place]; }
  double viscosity(std::uint32_t place) const { return viscosity_[place]; }
  /// What drives it, per volume over the density.
  double force() const { return force_; }

 private:
  struct Arm {
    double length = 1.0;
    bool wall = false;
    std::uint32_t place = 0;
  };
  struct Node {
    std::uint32_t place;
    std::array<Arm, 4> arms;  ///< +x, -x, +y, -y
  };
  /// The velocity of a unit force with the viscosity of relative_, from that of before.
  void sweep();
  double shearRate(const Node& node) const;

  std::vector<Node> nodes_;
  std::vector<double> shape_;     ///< by place: velocity per unit of force over viscosity
  std::vector<double> relative_;  ///< by place: viscosity over the one that shape_ is for
  std::vector<double> velocity_, viscosity_;
  double force_ = 0.0;
};

}  // namespace restenosis
