#pragma once

#include <span>
#include <vector>

#include "tissue/stent/Stent.h"
#include "tissue/stent/StentParameters.h"

namespace restenosis {

/// The cylinder that a stent is laid out on.
struct StentLayout {
  double vesselLength;  ///< [m]
  double outerRadius;   ///< of the struts' outer face [m]
};

/// A point of a centreline on the unrolled surface. Angles may exceed a turn.
struct SurfacePoint {
  double angle;  ///< about the axis
  double z;      ///< [m]
};

/// The longest segment that stays within a tenth of a micrometre of its arc [m].
double longestSegment(double radius);

/// Appends a chain of segments through the points to `segments`, with the cross-section of `stent`, its
/// outer face at the layout's radius. A chain that ends where it begins is closed. Points should be no
/// further apart than `longestSegment`.
void appendChain(std::vector<StrutSegment>& segments, std::span<const SurfacePoint> points,
                 const StentParameters& stent, const StentLayout& layout);

/// Appends the closed chain z(angle) = z0 + amplitude sin(waves angle + phase).
void appendRing(std::vector<StrutSegment>& segments, double z0, double amplitude, std::int64_t waves,
                double phase, const StentParameters& stent, const StentLayout& layout);

/// Appends a chain from one point to another, straight on the unrolled surface.
void appendLine(std::vector<StrutSegment>& segments, const SurfacePoint& from, const SurfacePoint& to,
                const StentParameters& stent, const StentLayout& layout);

/// Middles of `count` rings, each `halfExtent` to both sides, evenly over the stent's length, which is
/// centred in the vessel [m].
std::vector<double> ringPlaces(std::int64_t count, double halfExtent, const StentParameters& stent,
                               const StentLayout& layout);

}  // namespace restenosis
