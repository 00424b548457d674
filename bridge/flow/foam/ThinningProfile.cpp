#include "bridge/flow/foam/ThinningProfile.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>

namespace restenosis {
namespace {

/// Powers of w, and places that they are fitted at (assumed: what is left is a per mille of the mean).
constexpr int order = 6, places = 200;

}  // namespace

std::string thinningProfile(const TubeFlow& flow, double radius) {
  // Equal areas: w is then spread evenly
  Eigen::MatrixXd powers(places, order);
  Eigen::VectorXd velocities(places);
  for (int n = 0; n < places; ++n) {
    const double w = (n + 0.5) / places;
    for (int k = 0; k < order; ++k) powers(n, k) = std::pow(w, k + 1);
    velocities(n) = flow.velocity(radius * std::sqrt(1 - w)) / flow.velocity(0);
  }
  const Eigen::VectorXd found = powers.colPivHouseholderQr().solve(velocities);
  std::string text = fmt::format("({:.9g})", found(order - 1));
  for (int k = order - 2; k >= 0; --k) text = fmt::format("({:.9g}+w*{})", found(k), text);
  return "w*" + text;
}

}  // namespace restenosis
