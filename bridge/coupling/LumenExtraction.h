#pragma once

#include <optional>

#include "bridge/coupling/Quantities.h"
#include "bridge/output/PartTimer.h"
#include "bridge/scene/Scene.h"
#include "bridge/surface/LumenField.h"
#include "bridge/surface/TriSurface.h"
#include "tissue/stent/Stent.h"
#include "tissue/vessel/Wall.h"

namespace restenosis {

/// Takes the lumen's shape and surface from the agents and struts, from the vessel's shape where there is no
/// tissue, or from a file. Keeps what it needs for the surface until it is asked for; nothing of it is part
/// of the state.
class LumenExtraction {
 public:
  /// `stent` is where it stands after deployment. All must outlive this.
  LumenExtraction(const Scene& scene, const Wall& wall, const std::optional<Stent>& stent, PartTimer& timer)
      : scene_(scene), wall_(wall), stent_(stent), timer_(timer) {}

  /// Takes the lumen's shape from the present agents; the first one is that after deployment.
  void extract(LumenState& lumen);
  /// The triangulated lumen of when extract was last called; after a resumption, of the present agents.
  /// Throws Occluded.
  const TriSurface& surface();
  /// Agents are about to move: what was taken of the lumen to make its surface is given back.
  void release();

 private:
  void extractField();

  const Scene& scene_;
  const Wall& wall_;
  const std::optional<Stent>& stent_;
  PartTimer& timer_;
  std::optional<StrutBand> struts_;    ///< where the stent stands after deployment
  std::optional<LumenField> field_;    ///< of tissue, until the surface is made
  std::optional<TriSurface> surface_;  ///< of the field, or loaded; made when it is asked for
};

}  // namespace restenosis
