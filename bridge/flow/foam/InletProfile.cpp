#include "InletProfile.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "LumenShape.h"
#include "Rotation.h"

namespace restenosis {
namespace {

/// Places on an edge of the rim at which w is asked to vanish (assumed).
constexpr int placesOnEdge = 4;

struct RimPlace {
  std::complex<double> place;
  double length;  ///< of the rim that it stands for
};

std::vector<RimPlace> rimPlaces(const TriSurface& lumen, const InletProfile& profile) {
  const auto inPlane = [&](std::uint32_t v) {
    const Vec3 d = (lumen.vertices[v] - profile.centre) / profile.radius;
    return std::complex<double>(d.dot(profile.xAxis), d.dot(profile.yAxis));
  };
  std::vector<RimPlace> places;
  for (const auto& [from, to] : endRim(lumen, SurfaceRegion::inlet)) {
    const auto a = inPlane(from), b = inPlane(to);
    for (int n = 0; n < placesOnEdge; ++n)
      places.push_back({a + (n + 0.5) / placesOnEdge * (b - a), std::abs(b - a) / placesOnEdge});
  }
  return places;
}

}  // namespace

double InletProfile::operator()(double x, double y) const {
  const std::complex<double> z(x, y);
  std::complex<double> power = z;
  double value = constant - std::norm(z);
  for (std::size_t k = 0; k < order; ++k, power *= z)
    value += cosine[k] * power.real() + sine[k] * power.imag();
  return value;
}

std::string InletProfile::expression() const {
  std::string text = fmt::format("{:.9g}-r2", constant);
  for (std::size_t k = 0; k < order; ++k)
    text += fmt::format("+({:.9g})*c{}+({:.9g})*s{}", cosine[k], k + 1, sine[k], k + 1);
  return text;
}

InletProfile developedProfile(const TriSurface& lumen) {
  const EndPlane inlet = endPlane(lumen, SurfaceRegion::inlet);
  InletProfile profile;
  profile.centre = inlet.centre;
  profile.direction = -inlet.normal;
  const Eigen::Matrix3d turn = rotationOnto(Vec3::UnitZ(), profile.direction);
  profile.xAxis = turn * Vec3::UnitX();
  profile.yAxis = turn * Vec3::UnitY();
  profile.radius = std::sqrt(inlet.area / std::numbers::pi);

  const auto rim = rimPlaces(lumen, profile);
  constexpr Eigen::Index unknowns = 1 + 2 * InletProfile::order;
  Eigen::MatrixXd terms(rim.size(), unknowns);
  Eigen::VectorXd squares(rim.size());
  for (std::size_t n = 0; n < rim.size(); ++n) {
    const auto row = static_cast<Eigen::Index>(n);
    const double weight = std::sqrt(rim[n].length);
    std::complex<double> power = 1.0;
    terms(row, 0) = weight;
    for (std::size_t k = 0; k < InletProfile::order; ++k) {
      power *= rim[n].place;
      terms(row, 1 + 2 * static_cast<Eigen::Index>(k)) = weight * power.real();
      terms(row, 2 + 2 * static_cast<Eigen::Index>(k)) = weight * power.imag();
    }
    squares(row) = weight * std::norm(rim[n].place);
  }
  const Eigen::VectorXd found = terms.colPivHouseholderQr().solve(squares);
  profile.constant = found[0];
  for (std::size_t k = 0; k < InletProfile::order; ++k) {
    profile.cosine[k] = found[1 + 2 * static_cast<Eigen::Index>(k)];
    profile.sine[k] = found[2 + 2 * static_cast<Eigen::Index>(k)];
  }
  for (const RimPlace& p : rim)
    profile.rimError = std::max(profile.rimError, std::abs(profile(p.place.real(), p.place.imag())));
  profile.rimError /= std::abs(profile.constant);
  return profile;
}

}  // namespace restenosis
