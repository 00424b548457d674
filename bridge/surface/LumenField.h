#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "bridge/surface/BandField.h"
#include "bridge/surface/DistanceField.h"
#include "bridge/surface/FieldTopology.h"
#include "bridge/surface/StrutBand.h"
#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// How the lumen is taken from agents. SI units.
struct LumenFieldSettings {
  double resolution = 15e-6;  ///< spacing of the distance field [m] (assumed: half a cell)
  double smoothing =
      30e-6;  ///< cell scale at which the tissue's surface is smoothed [m] (ISR3D); 0: not at all
  double blurFraction = 0.5;  ///< standard deviation of the final blur over `smoothing` (assumed)
  double jointWidth = 2.0;    ///< width over which strut and tissue are joined, over `resolution` (assumed)
};

/// The lumen as a signed distance [m], positive inside, on a regular grid: the space between tissue and
/// struts as seen from the vessel's axis (model 9).
///
/// Tissue (all agents that are not struts) is smoothed at the cell scale in two steps. A ball of radius
/// `smoothing` is rolled over it: gaps it cannot enter close, cells are not shaved off, so the surface of a
/// packed wall is neither pulled into its holes nor pushed inwards. A Gaussian of half that width then takes
/// away the pattern of single cells. Neither step knows a target radius; what bias remains is measured in
/// LumenFieldTest. A lumen narrower than twice `smoothing` is closed by this.
///
/// Struts enter as exact distances after the smoothing, so their edges stay; where they meet tissue, corners
/// are rounded and slits narrower than the grid spacing close (`uniteRounded`). With segments given, agents
/// of kind `strut` are ignored; without, they are the struts.
///
/// Beyond the outermost tissue agent there is no lumen, whatever holes the wall has.
class LumenField {
 public:
  /// Throws std::invalid_argument if there is no tissue or settings are out of range.
  static LumenField fromTissue(const AgentStore& agents, std::span<const StrutSegment> struts, double length,
                               const LumenFieldSettings& settings = {});
  /// The same, with struts that stand still from one time to the next.
  static LumenField fromTissue(const AgentStore& agents, StrutBand& struts, double length,
                               const LumenFieldSettings& settings);
  /// A lumen given as a signed distance function [m], positive inside, within `halfWidth` [m] of the axis.
  static LumenField fromFunction(const std::function<double(const Vec3&)>& distance, double length,
                                 double halfWidth, double resolution);

  const LumenGrid& grid() const { return lumen_.grid(); }
  /// Distance to tissue and struts, positive in the lumen; clipped at some grid spacings.
  const BandField& lumen() const { return lumen_; }
  /// Whether a point on the surface belongs to a strut: is nearer to the struts' than to the tissue's
  /// surface.
  bool isStrut(const Vec3& point) const;
  /// Whether no lumen joins inlet and outlet: a defined outcome. Nothing is flipped then, and no surface can
  /// be taken.
  bool occluded() const { return !topology_.connected; }
  const LumenTopology& topology() const { return topology_; }

 private:
  /// Distances to either, kept where struts are near.
  struct Parts {
    BandField tissue, strut;
  };
  LumenField(const GridField& lumen, std::optional<Parts> parts, const LumenTopology& topology)
      : lumen_(lumen), parts_(std::move(parts)), topology_(topology) {}
  static LumenField fromDistances(GridField tissue, const BandField* strut, double jointWidth);

  BandField lumen_;
  std::optional<Parts> parts_;
  LumenTopology topology_;
};

}  // namespace restenosis
