#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace restenosis {

/// Numbers in single precision that are computed at once: as many as a register holds with AVX-512, else
/// eight, in as many registers as they need.
#ifdef __AVX512F__
inline constexpr int floatLanes = 16;
#else
inline constexpr int floatLanes = 8;
#endif

/// n numbers on which arithmetic, sqrt(), min() and max() work element by element, in as many vector
/// registers as the processor needs for them (GCC's and Clang's vector extension). All operations are those
/// of IEEE 754, none is approximated, so results do not depend on the width of the registers.
template <class Real, int n>
class Numbers {
 public:
  using Number = Real;
  using Vector [[gnu::vector_size(sizeof(Real) * n)]] = Real;
  using Word = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
  using Mask [[gnu::vector_size(sizeof(Real) * n)]] = Word;

  Numbers() = default;
  Numbers(Real value) : v_(value - Vector{}) {}
  explicit Numbers(const Vector& v) : v_(v) {}

  /// The n numbers from `stored` on.
  template <class Stored>
  static Numbers from(const Stored* stored) {
    Numbers numbers;
    if constexpr (std::is_same_v<Stored, Real>) {
      std::memcpy(&numbers.v_, stored, sizeof numbers.v_);
    } else {
      for (int k = 0; k < n; ++k) numbers.v_[k] = stored[k];
    }
    return numbers;
  }

  /// Stores them from `to` on.
  void store(Real* to) const { std::memcpy(to, &v_, sizeof v_); }

  Real operator[](int k) const { return v_[k]; }
  void set(int k, Real value) { v_[k] = value; }
  const Vector& vector() const { return v_; }

  friend Numbers operator+(const Numbers& a, const Numbers& b) { return Numbers(a.v_ + b.v_); }
  friend Numbers operator-(const Numbers& a, const Numbers& b) { return Numbers(a.v_ - b.v_); }
  friend Numbers operator*(const Numbers& a, const Numbers& b) { return Numbers(a.v_ * b.v_); }
  friend Numbers operator/(const Numbers& a, const Numbers& b) { return Numbers(a.v_ / b.v_); }
  Numbers& operator+=(const Numbers& b) { return *this = *this + b; }
  Numbers& operator-=(const Numbers& b) { return *this = *this - b; }
  friend Mask operator<(const Numbers& a, const Numbers& b) { return a.v_ < b.v_; }
  friend Mask operator<=(const Numbers& a, const Numbers& b) { return a.v_ <= b.v_; }
  friend Mask operator==(const Numbers& a, const Numbers& b) { return a.v_ == b.v_; }

  Numbers min(const Numbers& b) const { return Numbers(Vector(b.v_ < v_ ? b.v_ : v_)); }
  Numbers max(const Numbers& b) const { return Numbers(Vector(b.v_ > v_ ? b.v_ : v_)); }
  Numbers abs() const { return max(Numbers(Vector(-v_))); }
  Numbers sqrt() const {
    Numbers root;
    for (int k = 0; k < n; ++k) root.v_[k] = std::sqrt(v_[k]);
    return root;
  }
  /// Added in their order.
  Real sum() const {
    Real total = v_[0];
    for (int k = 1; k < n; ++k) total += v_[k];
    return total;
  }
  Real smallest() const {
    Real least = v_[0];
    for (int k = 1; k < n; ++k) least = v_[k] < least ? v_[k] : least;
    return least;
  }
  /// These where `mask` is set, 0 elsewhere.
  Numbers where(const Mask& mask) const { return Numbers(Vector(mask ? v_ : Vector{})); }

 private:
  Vector v_;
};

/// One vector of one or two of eight.
template <class Eight, std::size_t count>
[[gnu::always_inline]] inline auto joined(const std::array<Eight, count>& parts) {
  static_assert(count == 1 || count == 2);
  if constexpr (count == 1)
    return parts[0];
  else
    return __builtin_shufflevector(parts[0], parts[1], 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}

/// Bit k is set where element k of a mask is.
inline unsigned bitsOf(const Numbers<double, 8>::Mask& mask) {
  const auto bits = mask & Numbers<double, 8>::Mask{1, 2, 4, 8, 16, 32, 64, 128};
  const auto halves = bits | __builtin_shufflevector(bits, bits, 4, 5, 6, 7, 0, 1, 2, 3);
  const auto quarters = halves | __builtin_shufflevector(halves, halves, 2, 3, 0, 1, 6, 7, 4, 5);
  return static_cast<unsigned>(quarters[0] | quarters[1]);
}

}  // namespace restenosis
