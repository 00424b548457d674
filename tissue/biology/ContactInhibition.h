#pragma once

#include <memory>
#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/biology/ContactInhibitionLaw.h"
#include "tissue/biology/ContactInhibitionParameters.h"
#include "tissue/biology/ExposureMeasure.h"
#include "tissue/biology/ReferenceConfiguration.h"
#include "tissue/neighbours/MirroredNeighbours.h"

namespace restenosis {

/// Work of an evaluation of contact inhibition.
struct InhibitionReport {
  Index disturbances = 0;  ///< places where agents moved, grew, appeared or went
  Index evaluated = 0;     ///< cells evaluated
};

/// Sets the flags `inhibited` (by the law) and `exposed` (by the exposure measure) of every cell that could
/// use them: free synthetic SMC. All other agents have neither.
///
/// The flags are always those of a full evaluation of a reference configuration, in which every agent is
/// where it was when it last moved or grew by more than `changeTolerance` of its radius; only cells near a
/// change of it are evaluated again. So the work follows the motion, and the flags depend on the reference
/// configuration alone, which is part of a checkpoint (archive()).
///
/// The wall continues beyond the ends of the vessel: near z = 0 and z = `vesselLength` a cell's neighbours
/// include the mirror images of the agents around it, and its own image where that does not overlap it.
class ContactInhibition {
 public:
  /// `law` empty: no cell is inhibited, exposure is measured all the same. `vesselLength` [m]; 0: no ends.
  ContactInhibition(const ContactInhibitionParameters& parameters,
                    std::unique_ptr<const ContactInhibitionLaw> law, double vesselLength);

  InhibitionReport evaluate(AgentStore& agents);

  /// As Biology::reorder().
  void reorder(std::span<const Index> order) { reference_.reorder(order); }

  template <class Archive>
  void archive(Archive& a) {
    a(reference_);
  }

 private:
  /// The cell's marks in the reference configuration.
  std::uint8_t marksOf(const MirroredNeighbours& neighbours, Index cell,
                       std::vector<ContactNeighbour>& scratch) const;

  ExposureMeasure measure_;
  std::unique_ptr<const ContactInhibitionLaw> law_;
  double range_;
  /// Whether near neighbours are searched first: most cells are covered by those they touch, and more
  /// neighbours can only cover more.
  bool startsNear_;
  double tolerance_;
  double vesselLength_;
  ReferenceConfiguration reference_;
};

}  // namespace restenosis
