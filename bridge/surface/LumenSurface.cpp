#include "bridge/surface/LumenSurface.h"

#include "bridge/surface/Isosurface.h"

namespace restenosis {

TriSurface extractSurface(const LumenField& field) {
  if (field.occluded()) throw Occluded();
  TriSurface surface = isosurface(field.lumen());
#pragma omp parallel for schedule(static)
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    if (surface.region[t] == SurfaceRegion::wall && field.isStrut(surface.centre(t)))
      surface.region[t] = SurfaceRegion::strut;
  return surface;
}

}  // namespace restenosis
