#pragma once

#include <Eigen/Dense>
#include <functional>
#include <string>

namespace restenosis {

/// A function of the distance from the axis that vanishes at the wall, as a polynomial of w = 1 - r^2 / R^2
/// without a constant, fitted over the section's area.
class PowersOfW {
 public:
  /// `function` of r / R.
  explicit PowersOfW(const std::function<double(double)>& function);
  /// As an expression of OpenFOAM, a product that begins with w.
  std::string expression() const;
  /// Root mean square of what is missed, over the section.
  double error() const { return error_; }

 private:
  Eigen::VectorXd coefficients_;
  double error_ = 0.0;
};

}  // namespace restenosis
