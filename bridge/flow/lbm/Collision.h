#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#if defined(__AVX__)
#include <immintrin.h>
#endif

#include "bridge/flow/lbm/D3Q19.h"

namespace restenosis {

/// Rates and force of a collision in lattice units. Populations are kept as departures from the weights,
/// which saves digits in single precision.
template <class Real>
struct Collision {
  Real evenRate;              ///< 1 / tau, of the symmetric parts of opposite populations: sets the viscosity
  Real oddRate;               ///< of the antisymmetric parts
  std::array<Real, 3> force;  ///< per volume over the density
};

/// Rates of each node of a run, in the order of its nodes, where they differ from node to node.
template <class Real>
struct NodeRates {
  const Real *even = nullptr, *odd = nullptr;
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

/// Loads and stores whole vectors.
template <class Real>
struct Whole {
  using V = typename Of<Real>::type;
  V load(const Real* from) const {
    V v;
    std::memcpy(&v, from, sizeof(V));
    return v;
  }
  void store(Real* to, const V& v) const { std::memcpy(to, &v, sizeof(V)); }
};

/// Loads and stores the first `count` elements of vectors; touches no memory of the others, which may be
/// another thread's.
template <class Real>
class Part {
 public:
  using V = typename Of<Real>::type;
#if defined(__AVX512F__)
  explicit Part(std::size_t count) : mask_(static_cast<Mask>((1U << count) - 1U)) {}
  V load(const Real* from) const {
    if constexpr (sizeof(Real) == 4)
      return (V)_mm512_maskz_loadu_ps(mask_, from);
    else
      return (V)_mm512_maskz_loadu_pd(mask_, from);
  }
  void store(Real* to, const V& v) const {
    if constexpr (sizeof(Real) == 4)
      _mm512_mask_storeu_ps(to, mask_, (__m512)v);
    else
      _mm512_mask_storeu_pd(to, mask_, (__m512d)v);
  }

 private:
  using Mask = std::conditional_t<sizeof(Real) == 4, __mmask16, __mmask8>;
  Mask mask_;
#elif defined(__AVX__)
  explicit Part(std::size_t count) {
    alignas(bytes) std::array<Word, Of<Real>::count> mask{};
    for (std::size_t k = 0; k < count; ++k) mask[k] = -1;
    std::memcpy(&mask_, mask.data(), sizeof mask_);
  }
  V load(const Real* from) const {
    if constexpr (sizeof(Real) == 4)
      return (V)_mm256_maskload_ps(from, mask_);
    else
      return (V)_mm256_maskload_pd(from, mask_);
  }
  void store(Real* to, const V& v) const {
    if constexpr (sizeof(Real) == 4)
      _mm256_maskstore_ps(to, mask_, (__m256)v);
    else
      _mm256_maskstore_pd(to, mask_, (__m256d)v);
  }

 private:
  using Word = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
  __m256i mask_;
#else
  explicit Part(std::size_t count) : size_(count * sizeof(Real)) {}
  V load(const Real* from) const {
    V v{};
    std::memcpy(&v, from, size_);
    return v;
  }
  void store(Real* to, const V& v) const { std::memcpy(to, &v, size_); }

 private:
  std::size_t size_;
#endif
};
}  // namespace lanes

/// How far ahead populations are asked for [bytes]; from 256 to 1024 makes no difference.
inline constexpr std::size_t prefetched = 512;

/// Collides `lanes::Of<Real>::count` nodes that follow each other, in place. slots[i] is where the first
/// node's population i arrives; the population leaving in direction i is written where that of the opposite
/// direction arrived. That is all there is to in-place streaming (the AA pattern): in an even step the slots
/// are the node's own, in an odd step those of its neighbours, see LatticeFlow.
///
/// Two relaxation times with the equilibrium of He and Luo (1997) for incompressible flow,
///     w (rho' + 3 cu + 4.5 cu^2 - 1.5 u^2),
/// in which density departs from 1 only by the pressure; with equal rates, BGK. The force is that of Guo et
/// al. (2002), its even and odd parts weighted by the even and odd rates.
///
/// `memory` is how vectors are loaded and stored: all of them, or as many nodes as are left. `varying`: the
/// rates are those of each node, and not those of the collision.
template <class Real, bool forced, bool varying, class Memory>
inline void collideLanes(Real* const* slots, std::ptrdiff_t at, const Collision<Real>& k,
                         const NodeRates<Real>& rates, const Memory& memory) {
  using V = typename lanes::Of<Real>::type;
  using namespace d3q19;
  const auto load = [&](const Real* slot) -> V {
    // 19 streams are more than processors follow by themselves
    __builtin_prefetch(slot + at + prefetched / sizeof(Real));
    return memory.load(slot + at);
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
  const auto rateOf = [&](Real ofAll, [[maybe_unused]] const Real* ofNodes) {
    if constexpr (varying)
      return memory.load(ofNodes + at);
    else
      return ofAll;
  };
  const auto evenRate = rateOf(k.evenRate, rates.even), oddRate = rateOf(k.oddRate, rates.odd);
  const auto evenKeep = Real(0.5) * (1 - evenRate), oddKeep = Real(0.5) * (1 - oddRate);
  const auto evenForce = 1 - Real(0.5) * evenRate, oddForce = 1 - Real(0.5) * oddRate;
  const auto store = [&](Real* slot, const V& v) { memory.store(slot + at, v); };

  constexpr Real restWeight = Real(weight(0));
  V stay = (1 - evenRate) * rest + (restWeight * evenRate) * base;
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
    V even = evenKeep * sum[p] + (w * evenRate) * (base + (Real(4.5) * cu) * cu);
    V odd = oddKeep * difference[p] + (3 * w * oddRate) * cu;
    if constexpr (forced) {
      even += (w * evenForce) * (9 * cForce * cu - 3 * uForce);
      odd += 3 * w * oddForce * cForce;
    }
    store(slots[2 * p + 2], even + odd);
    store(slots[2 * p + 1], even - odd);
  }
}

/// Collides `count` nodes that follow each other; `rates` are theirs where they vary.
template <class Real, bool forced, bool varying>
inline void collideRun(Real* const* slots, std::size_t count, const Collision<Real>& collision,
                       const NodeRates<Real>& rates = {}) {
  const Collision<Real> k = collision;  // a copy that no population can be part of stays in registers
  constexpr std::size_t lane = lanes::Of<Real>::count;
  std::size_t at = 0;
  for (; at + lane <= count; at += lane)
    collideLanes<Real, forced, varying>(slots, static_cast<std::ptrdiff_t>(at), k, rates,
                                        lanes::Whole<Real>());
  if (at < count)
    collideLanes<Real, forced, varying>(slots, static_cast<std::ptrdiff_t>(at), k, rates,
                                        lanes::Part<Real>(count - at));
}

}  // namespace restenosis
