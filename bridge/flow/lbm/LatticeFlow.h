#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "bridge/flow/lbm/Collision.h"
#include "bridge/flow/lbm/LatticeBoundary.h"
#include "bridge/flow/lbm/LumenLattice.h"
#include "bridge/flow/lbm/OpenLinks.h"
#include "bridge/flow/lbm/RunLinks.h"

namespace restenosis {

/// How a lattice flow relaxes, in lattice units.
struct LatticeRelaxation {
  double tau = 1.0;           ///< relaxation time; the kinematic viscosity is (tau - 1/2) / 3
  double magic = 3.0 / 16.0;  ///< (tau - 1/2)(tau of the odd parts - 1/2), for two relaxation times
  bool single = false;        ///< one relaxation time (BGK); `magic` has no meaning then
  Vec3 force = Vec3::Zero();  ///< per volume over the density

  double oddTau() const { return oddTauOf(tau); }
  /// Of a node with its own relaxation time.
  double oddTauOf(double even) const { return single ? even : 0.5 + magic / (even - 0.5); }
};

/// The flow at a node, in lattice units.
struct NodeState {
  double density = 0.0;  ///< departure from 1: 3 times the pressure
  Vec3 velocity = Vec3::Zero();
  /// Viscous stress xx, yy, zz, xy, xz, yz over the density, from the populations' departure from
  /// equilibrium.
  std::array<double, 6> stress{};
};

/// A D3Q19 lattice flow in a lumen, advanced in place with one copy of the populations.
///
/// Streaming follows the AA pattern (Bailey et al. 2009). An even step takes the populations from a node's
/// own slots and leaves each in the slot of its opposite; an odd step takes them from the neighbours' slots,
/// where the even step left them, and leaves them in the neighbours' slots, where the next even step takes
/// them from. Every slot is read and written by one node only, so the order of nodes and threads changes
/// nothing. The surface acts between steps, on the slots of its links (LatticeBoundary): walls and pressures
/// run by run (RunLinks), the others when a step is done everywhere.
class LatticeFlowBase {
 public:
  virtual ~LatticeFlowBase() = default;
  /// Sets all populations to the equilibrium of each node's density and velocity, with the stress if not
  /// zero.
  virtual void initialise(const std::function<NodeState(std::uint32_t place)>& state) = 0;
  /// Advances by pairs of steps: an even and an odd one.
  virtual void advance(int pairs) = 0;
  /// The flow at a place that holds fluid.
  virtual NodeState state(std::uint32_t place) const = 0;
  /// Gives each place that holds fluid a kinematic viscosity of its own, from the next step on; that of the
  /// relaxation time until then. Asked from several threads, of each place once.
  virtual void setViscosity(const std::function<double(std::uint32_t place)>& viscosity) = 0;
  virtual double viscosity(std::uint32_t place) const = 0;
  /// Volume that has left through open links in the last step.
  virtual double openOutflow() const = 0;
};

template <class Real>
class LatticeFlow : public LatticeFlowBase {
 public:
  /// The layout must outlive the flow.
  LatticeFlow(const ColumnLayout& layout, LatticeBoundary boundary, const LatticeRelaxation& relaxation);

  void initialise(const std::function<NodeState(std::uint32_t place)>& state) override;
  void advance(int pairs) override;
  NodeState state(std::uint32_t place) const override;
  void setViscosity(const std::function<double(std::uint32_t place)>& viscosity) override;
  double viscosity(std::uint32_t place) const override { return (1.0 / evenRate(place) - 0.5) / 3.0; }
  double openOutflow() const override { return open_.outflow(); }
  /// Population that arrives at a place in a direction; its departure from the weight.
  double population(std::uint32_t place, int direction) const {
    return static_cast<double>(populations_[slot(place, direction)]);
  }

  /// Bytes that a step reads and writes at least, each population once.
  double bytesPerNode() const { return 2.0 * d3q19::directions * sizeof(Real); }

 private:
  struct Free {
    void operator()(Real* p) const;
  };
  enum class Parity { even, odd };

  void allocate();
  /// Where the populations of a run arrive for a step of that parity.
  Slots<Real> slots(std::size_t run, Parity parity) const;
  void step(std::size_t run, Parity parity, bool first);
  template <bool varying>
  void collide(std::size_t run, const Slots<Real>& at);
  double evenRate(std::uint32_t place) const {
    return evenRates_.empty() ? 1.0 / relaxation_.tau : static_cast<double>(evenRates_[place]);
  }
  /// What the surface does after a step has been done by all runs.
  template <Parity parity>
  void joinEnds();
  std::uint32_t slot(std::uint32_t place, int direction) const {
    return static_cast<std::uint32_t>(direction) * layout_.places() + place;
  }

  const ColumnLayout& layout_;
  LatticeRelaxation relaxation_;
  Collision<Real> collision_;
  bool forced_;
  std::vector<Real> evenRates_, oddRates_;  ///< by place, once they differ
  RunLinks<Real> links_;
  OpenLinks<Real> open_;
  std::vector<LatticeBoundary::ThinLink> thin_;
  std::vector<LatticeBoundary::Passage> passages_;
  std::vector<std::size_t> shares_;  // runs in portions of about equal numbers of nodes
  std::unique_ptr<Real[], Free> populations_;
};

extern template class LatticeFlow<float>;
extern template class LatticeFlow<double>;

}  // namespace restenosis
