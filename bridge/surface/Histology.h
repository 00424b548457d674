#pragma once

#include <vector>

#include "bridge/surface/RadialMap.h"
#include "tissue/agents/AgentStore.h"
#include "tissue/vessel/RadiusMap.h"

namespace restenosis {

/// A cross-section as histology measures it (model 10).
struct HistologySection {
  double intimaArea = 0;          ///< [m^2]; may be a little below 0
  double mediaArea = 0;           ///< [m^2]
  double relativeIntimaArea = 0;  ///< intima / (intima + lumen)
  double intimaCells = 0;         ///< smooth muscle cells of the intima
  double intimaCellsInCycle = 0;  ///< of these, in G1 to M
  double intimaVolume = 0;        ///< of these cells with their matrix, over 4 pi / 3 [m^3]
  double intimaMatrix = 0;        ///< of their matrix, likewise

  double inCycle() const { return intimaCells > 0 ? intimaCellsInCycle / intimaCells : 0; }
  double matrixShare() const { return intimaVolume > 0 ? intimaMatrix / intimaVolume : 0; }
};

/// The lines that divide a section: the inner elastic lamina, which goes on between what is left of it where
/// it is injured, and the outer one; both through the centres of their agents. Intima is what lies between
/// the lumen and the inner line, less what lay there after deployment: struts, clefts beside them and half of
/// the lamina. Media is what lies between the lines.
class Histology {
 public:
  /// `cellRadius`: mean radius of the wall's agents [m].
  Histology(const AgentStore& agents, double cellRadius);

  /// Whether both laminae have agents: without, nothing can be measured.
  bool possible() const { return !iel_.empty() && !eel_.empty(); }
  /// Areas between the lumen and the inner line, by plane of the map [m^2].
  std::vector<double> insideIel(const RadialMap& lumen) const;
  /// Whether a place lies in the intima.
  bool inIntima(const Vec3& place) const;
  /// The sections at the planes of the map; a cell belongs to the plane nearest to it. `afterDeployment`:
  /// insideIel() of then.
  std::vector<HistologySection> sections(const RadialMap& lumen,
                                         const std::vector<double>& afterDeployment) const;
  /// Their mean between two axial positions [m], each plane by the length it stands for; cells are summed.
  static HistologySection mean(const RadialMap& lumen, const std::vector<HistologySection>& sections,
                               double from, double to);

 private:
  /// Area between two radii, given by angle of the map.
  template <class Inner, class Outer>
  static double areaBetween(const RadialMap& lumen, const Inner& inner, const Outer& outer);

  const AgentStore& agents_;
  RadiusMap iel_, eel_;
};

}  // namespace restenosis
