#include "bridge/surface/LumenRefusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace restenosis {

void refuseLumen(const std::string& reason) {
  throw std::runtime_error("the lumen surface cannot be used: " + reason);
}

std::string shownPlace(const Vec3& place) {
  const Vec3 rounded = (1e6 * place).array().round() * 1e-3 + 0.0;  // [mm], of whole micrometres; -0 is 0
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) mm", rounded.x(), rounded.y(), rounded.z());
}

std::string shownEdges(const TriSurface& s, const std::vector<OpenEdge>& edges) {
  std::string list;
  for (std::size_t n = 0; n < std::min(edges.size(), placesShown); ++n) {
    const Vec3 &a = s.vertices[edges[n][0]], &b = s.vertices[edges[n][1]];
    list += fmt::format("{}one of {:.3g} mm at {}", n == 0 ? "" : ", ", 1e3 * (b - a).norm(),
                        shownPlace((a + b) / 2));
  }
  return list + (edges.size() > placesShown ? ", and more" : "");
}

}  // namespace restenosis
