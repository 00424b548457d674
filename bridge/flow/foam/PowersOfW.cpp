#include "bridge/flow/foam/PowersOfW.h"

#include <fmt/format.h>

#include <cmath>

namespace restenosis {
namespace {

/// Powers of w, and places that they are fitted at (assumed: of blood that thins a per mille of the mean is
/// left, of a beating flow in a coronary artery 1e-10).
constexpr Eigen::Index order = 8, places = 200;

}  // namespace

PowersOfW::PowersOfW(const std::function<double(double)>& function) {
  // Equal areas: w is then spread evenly
  Eigen::MatrixXd powers(places, order);
  Eigen::VectorXd values(places);
  for (Eigen::Index n = 0; n < places; ++n) {
    const double w = (static_cast<double>(n) + 0.5) / places;
    for (Eigen::Index k = 0; k < order; ++k) powers(n, k) = std::pow(w, k + 1);
    values(n) = function(std::sqrt(1 - w));
  }
  coefficients_ = powers.colPivHouseholderQr().solve(values);
  error_ = (powers * coefficients_ - values).norm() / std::sqrt(static_cast<double>(places));
}

std::string PowersOfW::expression() const {
  std::string text = fmt::format("({:.9g})", coefficients_(order - 1));
  for (Eigen::Index k = order - 1; k-- > 0;) text = fmt::format("({:.9g}+w*{})", coefficients_(k), text);
  return "w*" + text;
}

}  // namespace restenosis
