#include "LumenRefusal.h"

#include <fmt/format.h>

#include <stdexcept>

namespace restenosis {

void refuseLumen(const std::string& reason) {
  throw std::runtime_error("the lumen surface cannot be used: " + reason);
}

std::string shownPlace(const Vec3& place) {
  const Vec3 rounded = (1e6 * place).array().round() * 1e-3 + 0.0;  // [mm], of whole micrometres; -0 is 0
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) mm", rounded.x(), rounded.y(), rounded.z());
}

}  // namespace restenosis
