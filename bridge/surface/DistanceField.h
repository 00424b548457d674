#pragma once

#include <span>
#include <vector>

#include "bridge/surface/BandField.h"
#include "bridge/surface/LumenGrid.h"
#include "tissue/stent/Stent.h"

namespace restenosis {

/// A spherical obstacle, or the space a rolling ball takes.
struct Ball {
  Vec3 centre;    ///< [m]
  double radius;  ///< [m]
};

/// Signed distance [m] to the union of spheres, positive outside them, clipped at `clip`. Within a distance
/// of `clip` from a sphere the values outside the union are exact; inside, they are the depth in the deepest
/// sphere. The vessel's ends are mirrors, so that a surface meets them at a right angle instead of flaring
/// where the spheres end. The same bit for bit for any number of threads.
GridField sphereDistance(const LumenGrid& grid, std::vector<Ball> spheres, double clip);
/// The same for few spheres, far from which the field is even.
BandField sphereBand(const LumenGrid& grid, std::vector<Ball> spheres, double clip);

/// Signed distance [m] to the union of strut segments, positive outside them, clipped at `clip`.
BandField strutBand(const LumenGrid& grid, std::span<const StrutSegment> struts, double clip);

/// Takes a distance field to obstacles (exact up to `probe` + one spacing) and makes it that to the obstacles
/// closed by a rolling ball of radius `probe` [m]: the space the ball can sweep stays free, every gap it
/// cannot enter is filled, and nothing that juts out is shaved off. Clipped at +-clip.
///
/// The space the ball's centre can reach is {distance >= probe}. Its boundary is sampled where it crosses
/// grid edges, and the swept space is the union of that space and of balls around the samples. Scallops
/// between the balls are at most spacing^2 / (4 probe) deep.
void closeByBall(GridField& field, double probe, double clip);

/// Gaussian blur of standard deviation `sigma` [m], truncated at three sigma; ends are mirrors.
void blur(GridField& field, double sigma);

/// Minimum of two fields with the corner between them rounded: where they differ by less than `width`, up to
/// width/4 below the minimum, so that slits narrower than width/2 between the two close. Elsewhere it is the
/// exact minimum.
void uniteRounded(GridField& field, const BandField& other, double width);

}  // namespace restenosis
