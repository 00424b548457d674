#include "bridge/surface/InnerBalls.h"

#include <algorithm>

namespace restenosis {
namespace {

/// Over its radius, how much a ball may be short of touching a face.
constexpr double shortfall = 0.01;
/// Pushes from face to face after which a ball counts as too large. Each halves what is left, or better,
/// where faces meet at more than 45 degrees.
constexpr int mostPushes = 24;
/// Cosine between inward normals below which two faces are the two sides of a thin part (assumed): they are
/// parallel, or a wedge of less than 45 degrees.
constexpr double oppositeCosine = -0.7;
/// A ball that does not fit is made smaller by this at least.
constexpr double smaller = 0.95;

NearestTriangle nearestOf(const std::vector<Facet>& facets) {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const Facet& facet : facets) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), facet.begin(), facet.end());
    triangles.push_back({first, first + 1, first + 2});
  }
  return {std::move(vertices), std::move(triangles)};
}

struct Contact {
  Vec3 place, inwards;
};

}  // namespace

InnerBalls::InnerBalls(const std::vector<Facet>& facets, double largest, double least)
    : largest_(largest), least_(least), nearest_(nearestOf(facets)) {
  normals_.reserve(facets.size());
  for (const Facet& f : facets) normals_.push_back((f[1] - f[0]).cross(f[2] - f[0]).normalized());
}

std::optional<Ball> InnerBalls::at(const Vec3& place, const Vec3& normal) const {
  for (double radius = largest_; radius >= least_;)
    if (const auto ball = ofRadius(radius, place, normal)) return ball;
  return std::nullopt;
}

/// The ball of this radius, or none and a smaller radius to try next.
std::optional<Ball> InnerBalls::ofRadius(double& radius, const Vec3& place, const Vec3& normal) const {
  std::vector<Contact> contacts{{place, -normal}};
  Vec3 centre = place - radius * normal;
  for (int push = 0; push < mostPushes; ++push) {
    const NearestTriangle::Place near = nearest_.at(centre);
    const Vec3& outwards = normals_[near.triangle];
    const bool inside = (near.point - centre).dot(outwards) > 0;
    const double depth = inside ? near.distance : -near.distance;
    if (depth >= (1 - shortfall) * radius) return Ball{centre, std::min(radius, depth)};
    const Vec3 inwards = inside ? Vec3((centre - near.point) / near.distance) : Vec3(-outwards);
    for (const Contact& contact : contacts) {
      const double gap = (near.point - contact.place).norm();
      if (inwards.dot(contact.inwards) > oppositeCosine || gap >= 2 * radius) continue;
      radius = std::min(smaller * radius, gap / 2);
      return std::nullopt;
    }
    contacts.push_back({near.point, inwards});
    centre += (radius - depth) * inwards;
  }
  radius *= smaller;
  return std::nullopt;
}

}  // namespace restenosis
