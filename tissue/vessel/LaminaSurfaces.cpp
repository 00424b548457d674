#include "tissue/vessel/LaminaSurfaces.h"

#include <algorithm>
#include <limits>

#include "tissue/vessel/Cylindrical.h"

namespace restenosis {

void LaminaSurfaces::project(AgentKind kind, double, Vec3& position) const {
  switch (kind) {
    case AgentKind::iel:
      position = atRadius(position, shape_.iel.at(position));
      break;
    case AgentKind::eel:
      position = atRadius(position, shape_.eel.at(position));
      break;
    case AgentKind::smc: {
      const double radius = radiusOf(position);
      const double allowed = std::clamp(radius, shape_.inner.at(position), shape_.outer.at(position));
      if (radius != allowed) position = atRadius(position, allowed);
      break;
    }
    case AgentKind::strut:
      break;
  }
}

double LaminaSurfaces::margin(AgentKind kind, double, const Vec3&) const {
  return kind == AgentKind::strut ? std::numeric_limits<double>::infinity() : 0;
}

void LaminaSurfaces::release(AgentKind kind, double, const Vec3& position, Vec3& force) const {
  const auto slideOn = [&](const SurfaceFromAxis& surface) {
    const Vec3 out = surface.normalAt(position);
    force -= force.dot(out) * out;
  };
  switch (kind) {
    case AgentKind::iel:
      slideOn(shape_.iel);
      break;
    case AgentKind::eel:
      slideOn(shape_.eel);
      break;
    case AgentKind::smc: {
      const double radius = radiusOf(position);
      if (radius <= shape_.inner.at(position) * (1 + onSurface)) {
        if (force.dot(shape_.inner.normalAt(position)) < 0) slideOn(shape_.inner);
      } else if (radius >= shape_.outer.at(position) * (1 - onSurface)) {
        if (force.dot(shape_.outer.normalAt(position)) > 0) slideOn(shape_.outer);
      }
      break;
    }
    case AgentKind::strut:
      break;
  }
}

}  // namespace restenosis
