#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// The parts of a lumen in which two flows are compared, each with its own reasons to differ.
enum class ComparedPart : std::uint8_t {
  smoothWall,     ///< wall away from struts and ends
  betweenStruts,  ///< wall near a strut, or on a buried one: recirculation, or grown tissue
  strut,          ///< struts: sharp edges
  ends            ///< wall and struts near inlet and outlet: their conditions differ between methods
};
inline constexpr std::array comparedParts = {ComparedPart::smoothWall, ComparedPart::betweenStruts,
                                             ComparedPart::strut, ComparedPart::ends};
/// As it stands in compare.json.
std::string_view partName(ComparedPart part);

/// Where the parts end (assumed).
struct ComparedPartsSettings {
  double endLength = 0.1e-3;    ///< faces nearer than this to inlet or outlet belong to the ends [m]
  double strutReach = 0.3e-3;   ///< wall nearer than this to a strut lies between struts [m]
  double buriedFrom = 0.15e-3;  ///< a strut's middle farther than this from all struts one sees is buried [m]
};

/// The triangles of wall and struts of a lumen, each with its part.
struct ComparedFaces {
  std::vector<std::uint32_t> triangle;  ///< of the surface
  std::vector<ComparedPart> part;
  std::vector<double> area;  ///< [m^2]
  std::size_t size() const { return triangle.size(); }
};

/// `struts`: places on the struts' middles, as far as known [m]. Tissue grows over struts until the surface
/// shows none of them; how near the wall is to a buried one is seen from the vessel's axis, along the wall.
ComparedFaces comparedFaces(const TriSurface& lumen, std::span<const Vec3> struts = {},
                            const ComparedPartsSettings& settings = {});

}  // namespace restenosis
