#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/FixedScale.h"
#include "tissue/agents/Lanes.h"

namespace restenosis {

/// An agent as the force loop reads it in double precision.
struct alignas(32) Sphere {
  double x, y, z, r;  ///< [m]

  bool operator==(const Sphere&) const = default;
};

/// An agent as the force loop reads it in mixed precision: the position in whole units of a FixedScale,
/// modulo 2^32.
struct alignas(16) FixedSphere {
  std::uint32_t x, y, z;
  float r;  ///< [m]

  bool operator==(const FixedSphere&) const = default;
};

/// An agent as FixedSphere.
inline FixedSphere fixedSphere(const FixedScale& scale, const Vec3& position, float radius) {
  const auto [x, y, z] = scale.of(position);
  return {x, y, z, radius};
}

/// Radius of the sphere that stands in for "no agent": so far below zero that it touches nothing.
inline constexpr double noAgentRadius = -1e6;

/// Half as many agents at a time, in double precision.
class ExactSpheres {
 public:
  static constexpr int lanes = floatLanes / 2;
  using Values = Numbers<double, lanes>;
  struct Places {
    Values x, y, z, r;
  };
  explicit ExactSpheres(std::span<const Sphere> spheres) : spheres_(spheres) {}

  Places at(const Index* agents) const {
    Places p;
    for (int k = 0; k < lanes; ++k) {
      const Sphere& s = spheres_[agents[k]];
      p.x.set(k, s.x), p.y.set(k, s.y), p.z.set(k, s.z), p.r.set(k, s.r);
    }
    return p;
  }
  /// Nothing: few forces are computed in double precision.
  void prefetch(const Index*) const {}
  void prefetchOne(Index) const {}
  /// From each of `b` to that of `a` [m].
  static void separation(const Places& a, const Places& b, Values& dx, Values& dy, Values& dz) {
    dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z;
  }

 private:
  std::span<const Sphere> spheres_;
};

/// `width` agents at a time, eight or sixteen, in mixed precision. The width changes no bit of what is
/// computed for an agent.
template <int width>
class FixedSpheresOf {
 public:
  static constexpr int lanes = width;
  using Values = Numbers<float, lanes>;
  using Words [[gnu::vector_size(4 * lanes)]] = std::uint32_t;
  struct Places {
    Words x, y, z;
    Values r;
  };
  FixedSpheresOf(std::span<const FixedSphere> spheres, double unit)
      : spheres_(spheres), unit_(static_cast<float>(unit)) {}

  Places at(const Index* agents) const;
  /// Prefetches what at() of these agents reads.
  void prefetch(const Index* agents) const {
    for (int k = 0; k < lanes; ++k) __builtin_prefetch(&spheres_[agents[k]]);
  }
  void prefetchOne(Index agent) const { __builtin_prefetch(&spheres_[agent]); }
  void separation(const Places& a, const Places& b, Values& dx, Values& dy, Values& dz) const {
    dx = metres(a.x - b.x), dy = metres(a.y - b.y), dz = metres(a.z - b.z);
  }

 private:
  using EightWords = std::uint32_t __attribute__((vector_size(32)));
  /// x, y, z and r of eight agents.
  std::array<EightWords, 4> eight(const Index* agents) const;
  Values metres(Words difference) const;

  std::span<const FixedSphere> spheres_;
  float unit_;
};

using FixedSpheres =
    FixedSpheresOf<floatLanes>;  // its functions are `inline`, or GCC leaves calls in the loop

/// The agents for ExactSpheres, followed by spheres of radius noAgentRadius up to the index `none`.
std::vector<Sphere> packSpheres(const AgentStore& agents, Index none);
/// The same for FixedSpheres.
std::vector<FixedSphere> packSpheres(const AgentStore& agents, Index none, const FixedScale& scale);

template <int width>
inline auto FixedSpheresOf<width>::eight(const Index* agents) const -> std::array<EightWords, 4> {
  using Half = std::uint32_t __attribute__((vector_size(16)));
  static_assert(sizeof(Half) == sizeof(FixedSphere));
  const auto half = [&](int k) {
    Half h;
    __builtin_memcpy(&h, &spheres_[agents[k]], sizeof h);
    return h;
  };
  // Transposes eight times four to four times eight.
  const auto pair = [&](int k) {
    return __builtin_shufflevector(half(k), half(k + 4), 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const EightWords a = pair(0), b = pair(1), c = pair(2), d = pair(3);
  const EightWords xyab = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
  const EightWords xycd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
  const EightWords zrab = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
  const EightWords zrcd = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
  return {__builtin_shufflevector(xyab, xycd, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(xyab, xycd, 2, 3, 10, 11, 6, 7, 14, 15),
          __builtin_shufflevector(zrab, zrcd, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(zrab, zrcd, 2, 3, 10, 11, 6, 7, 14, 15)};
}

template <int width>
inline auto FixedSpheresOf<width>::at(const Index* agents) const -> Places {
  std::array<std::array<EightWords, lanes / 8>, 4> columns;
  for (int part = 0; part < lanes / 8; ++part) {
    const auto ofEight = eight(agents + 8 * part);
    for (int c = 0; c < 4; ++c) columns[c][part] = ofEight[c];
  }
  return {joined(columns[0]), joined(columns[1]), joined(columns[2]),
          Values((typename Values::Vector)joined(columns[3]))};
}

template <int width>
inline auto FixedSpheresOf<width>::metres(Words difference) const -> Values {
  return Values(__builtin_convertvector((typename Values::Mask)difference, typename Values::Vector)) * unit_;
}

}  // namespace restenosis
