#include "bridge/flow/foam/InletProfile.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <vector>

#include "bridge/flow/LumenShape.h"
#include "bridge/flow/foam/PlaceInEnd.h"
#include "bridge/surface/Rotation.h"

namespace restenosis {
namespace {

/// Places on an edge of the rim at which w is asked to vanish (assumed).
constexpr int placesOnEdge = 4;

struct RimPlace {
  std::complex<double> place;
  double length;  ///< of the rim that it stands for
};

using Edges = std::vector<std::array<std::uint32_t, 2>>;

std::complex<double> inPlane(const InletProfile& profile, const Vec3& place) {
  const Vec3 d = (place - profile.centre) / profile.radius;
  return {d.dot(profile.xAxis), d.dot(profile.yAxis)};
}

std::vector<RimPlace> rimPlaces(const TriSurface& lumen, const Edges& rim, const InletProfile& profile) {
  std::vector<RimPlace> places;
  for (const auto& [from, to] : rim) {
    const auto a = inPlane(profile, lumen.vertices[from]), b = inPlane(profile, lumen.vertices[to]);
    for (int n = 0; n < placesOnEdge; ++n)
      places.push_back({a + (n + 0.5) / placesOnEdge * (b - a), std::abs(b - a) / placesOnEdge});
  }
  return places;
}

/// What a hole's coefficients belong to.
std::array<double, 3> termsOf(const InletProfile::Hole& hole, double x, double y) {
  const double alongX = x - hole.x, alongY = y - hole.y, square = alongX * alongX + alongY * alongY;
  return {0.5 * std::log(square), alongX / square, alongY / square};
}

/// The rims that go around the other way than the outermost, which encloses the largest area.
std::vector<InletProfile::Hole> holesOf(const TriSurface& lumen, const Edges& rim,
                                        const InletProfile& profile) {
  struct Loop {
    double area = 0.0;
    std::complex<double> moment;
  };
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto& [from, to] : rim) next.emplace(from, to);
  std::vector<Loop> loops;
  while (!next.empty()) {
    Loop& loop = loops.emplace_back();
    for (auto edge = next.begin(); edge != next.end();) {
      const auto [from, to] = *edge;
      next.erase(edge);
      const auto a = inPlane(profile, lumen.vertices[from]), b = inPlane(profile, lumen.vertices[to]);
      const double part = 0.5 * (std::conj(a) * b).imag();
      loop.area += part;
      loop.moment += part / 3.0 * (a + b);
      edge = next.find(to);
    }
  }
  const auto outermost = std::ranges::max_element(loops, {}, [](const Loop& l) { return std::abs(l.area); });
  std::vector<InletProfile::Hole> holes;
  for (const Loop& loop : loops) {
    if (loop.area * outermost->area >= 0.0) continue;
    const auto middle = loop.moment / loop.area;
    holes.push_back({middle.real(), middle.imag(), {}});
  }
  return holes;
}

}  // namespace

double InletProfile::operator()(double x, double y) const {
  const std::complex<double> z(x, y);
  std::complex<double> power = z;
  double value = constant - std::norm(z);
  for (std::size_t k = 0; k < order; ++k, power *= z)
    value += cosine[k] * power.real() + sine[k] * power.imag();
  for (const Hole& hole : holes) {
    const auto terms = termsOf(hole, z.real(), z.imag());
    for (std::size_t k = 0; k < terms.size(); ++k) value += hole.coefficients[k] * terms[k];
  }
  return value;
}

double InletProfile::peak() const {
  const auto place = inPlane(*this, inside);
  return (*this)(place.real(), place.imag());
}

std::string InletProfile::expression() const {
  std::string text = fmt::format("{:.9g}-r2", constant);
  for (std::size_t k = 0; k < order; ++k)
    text += fmt::format("+({:.9g})*c{}+({:.9g})*s{}", cosine[k], k + 1, sine[k], k + 1);
  for (const Hole& hole : holes) {
    const std::string x = fmt::format("(c1-({:.9g}))", hole.x), y = fmt::format("(s1-({:.9g}))", hole.y);
    const std::string square = fmt::format("(pow({},2)+pow({},2))", x, y);
    const auto& [log, alongX, alongY] = hole.coefficients;
    text += fmt::format("+({:.9g})*log({})+(({:.9g})*{}+({:.9g})*{})/{}", 0.5 * log, square, alongX, x,
                        alongY, y, square);
  }
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

  profile.inside = placeInEnd(lumen, SurfaceRegion::inlet);

  const Edges edges = endRim(lumen, SurfaceRegion::inlet);
  profile.holes = holesOf(lumen, edges, profile);
  const auto rim = rimPlaces(lumen, edges, profile);
  constexpr Eigen::Index ofShape = 1 + 2 * InletProfile::order;
  const Eigen::Index unknowns = ofShape + 3 * static_cast<Eigen::Index>(profile.holes.size());
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
    for (Eigen::Index h = 0; const InletProfile::Hole& hole : profile.holes)
      for (const double term : termsOf(hole, rim[n].place.real(), rim[n].place.imag()))
        terms(row, ofShape + h++) = weight * term;
    squares(row) = weight * std::norm(rim[n].place);
  }
  const Eigen::VectorXd found = terms.colPivHouseholderQr().solve(squares);
  profile.constant = found[0];
  for (std::size_t k = 0; k < InletProfile::order; ++k) {
    profile.cosine[k] = found[1 + 2 * static_cast<Eigen::Index>(k)];
    profile.sine[k] = found[2 + 2 * static_cast<Eigen::Index>(k)];
  }
  for (Eigen::Index h = 0; InletProfile::Hole & hole : profile.holes)
    for (double& coefficient : hole.coefficients) coefficient = found[ofShape + h++];
  for (const RimPlace& p : rim)
    profile.rimError = std::max(profile.rimError, std::abs(profile(p.place.real(), p.place.imag())));
  profile.rimError /= std::abs(profile.peak());
  return profile;
}

}  // namespace restenosis
