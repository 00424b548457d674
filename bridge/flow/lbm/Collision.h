#pragma once

#include <array>
#include <cstddef>
#include <cstring>

#include "D3Q19.h"

namespace restenosis {

/// Rates and force of a collision in lattice units. Populations are kept as departures from the weights,
/// which saves digits in single precision.
template <class Real>
struct Collision {
  Real evenRate;              ///< 1 / tau, of the symmetric parts of opposite populations: sets the viscosity
  Real oddRate;               ///< of the antisymmetric parts
  std::array<Real, 3> force;  ///< per volume over the density
};

namespace lanes {
/// Numbers of a node each on which arithmetic works element by element.
#if defined(__AVX512F__)
inline constexpr std::size_t bytes = 64;
#elif defined(__AVX__)
inline constexpr std::size_t bytes = 32;
#else
inline constexpr std::size_t bytes = 16;
#endif
template <class Real>
struct Of {
  typedef Real type __attribute__((vector_size(bytes)));
  static constexpr std::size_t count = bytes / sizeof(Real);
};
}  // namespace lanes

/// Collides `lanes::Of<Real>::count` nodes that follow each other, in place. slots[i] is where the first
/// node's population i arrives; the population leaving in direction i is written where that of the opposite
/// direction arrived. That is all there is to in-place streaming (the AA pattern): in an even step the slots
/// are the node's own, in an odd step those of its neighbours, see LatticeFlow.
///
/// Two relaxation times with the equilibrium of He and Luo (1997) for incompressible flow,
///     w (rho' + 3 cu + 4.5 cu^2 - 1.5 u^2),
/// in which density departs from 1 only by the pressure; with equal rates, BGK. The force is that of Guo et
/// al. (2002), its even and odd parts weighted by the even and odd rates.
template <class Real, bool forced>
inline void collideLanes(Real* const* slots, std::ptrdiff_t at, const Collision<Real>& k) {
  using V = typename lanes::Of<Real>::type;
  using namespace d3q19;
  const auto load = [at](const Real* slot) {
    V v;
    std::memcpy(&v, slot + at, sizeof(V));
    return v;
  };
  V sum[pairs], difference[pairs];
  V rho = load(slots[0]);
  const V rest = rho;
  V u[3] = {V{}, V{}, V{}};
#pragma GCC unroll 9
  for (int p = 0; p < pairs; ++p) {
    const V a = load(slots[2 * p + 1]), b = load(slots[2 * p + 2]);
    sum[p] = a + b;
    difference[p] = a - b;
    rho += sum[p];
    const Step& s = c[static_cast<std::size_t>(2 * p + 1)];
#pragma GCC unroll 3
    for (int d = 0; d < 3; ++d) {
      if (s[static_cast<std::size_t>(d)] == 1) u[d] += difference[p];
      if (s[static_cast<std::size_t>(d)] == -1) u[d] -= difference[p];
    }
  }
  V uForce = V{};
  if constexpr (forced) {
    for (std::size_t d = 0; d < 3; ++d) {
      u[d] += Real(0.5) * k.force[d];
      uForce += u[d] * k.force[d];
    }
  }
  const V base = rho - Real(1.5) * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  const Real evenKeep = Real(0.5) * (1 - k.evenRate), oddKeep = Real(0.5) * (1 - k.oddRate);
  const Real evenForce = 1 - Real(0.5) * k.evenRate, oddForce = 1 - Real(0.5) * k.oddRate;
  const auto store = [at](Real* slot, const V& v) { std::memcpy(slot + at, &v, sizeof(V)); };

  constexpr Real restWeight = Real(weight(0));
  V stay = (1 - k.evenRate) * rest + (restWeight * k.evenRate) * base;
  if constexpr (forced) stay -= (3 * restWeight * evenForce) * uForce;
  store(slots[0], stay);
#pragma GCC unroll 9
  for (int p = 0; p < pairs; ++p) {
    const Step& s = c[static_cast<std::size_t>(2 * p + 1)];
    const Real w = Real(weight(2 * p + 1));
    V cu = V{};
    Real cForce = 0;
#pragma GCC unroll 3
    for (int d = 0; d < 3; ++d) {
      if (s[static_cast<std::size_t>(d)] == 1) cu += u[d], cForce += k.force[static_cast<std::size_t>(d)];
      if (s[static_cast<std::size_t>(d)] == -1) cu -= u[d], cForce -= k.force[static_cast<std::size_t>(d)];
    }
    V even = evenKeep * sum[p] + (w * k.evenRate) * (base + (Real(4.5) * cu) * cu);
    V odd = oddKeep * difference[p] + (3 * w * k.oddRate) * cu;
    if constexpr (forced) {
      even += (w * evenForce) * (9 * cForce * cu - 3 * uForce);
      odd += 3 * w * oddForce * cForce;
    }
    store(slots[2 * p + 2], even + odd);
    store(slots[2 * p + 1], even - odd);
  }
}

/// Collides `count` nodes that follow each other. Nodes that do not fill the lanes are collided in a copy.
template <class Real, bool forced>
inline void collideRun(Real* const* slots, std::size_t count, const Collision<Real>& k) {
  constexpr std::size_t lane = lanes::Of<Real>::count;
  std::size_t at = 0;
  for (; at + lane <= count; at += lane)
    collideLanes<Real, forced>(slots, static_cast<std::ptrdiff_t>(at), k);
  if (at == count) return;
  alignas(lanes::bytes) Real copy[d3q19::directions][lane] = {};
  Real* copySlots[d3q19::directions];
  for (int i = 0; i < d3q19::directions; ++i) {
    copySlots[i] = copy[i];
    std::memcpy(copy[i], slots[i] + at, (count - at) * sizeof(Real));
  }
  collideLanes<Real, forced>(copySlots, 0, k);
  for (int i = 0; i < d3q19::directions; ++i)
    std::memcpy(slots[i] + at, copy[i], (count - at) * sizeof(Real));
}

}  // namespace restenosis
