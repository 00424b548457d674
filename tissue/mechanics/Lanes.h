#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace restenosis {

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

  Real operator[](int k) const { return v_[k]; }
  void set(int k, Real value) { v_[k] = value; }

  friend Numbers operator+(const Numbers& a, const Numbers& b) { return Numbers(a.v_ + b.v_); }
  friend Numbers operator-(const Numbers& a, const Numbers& b) { return Numbers(a.v_ - b.v_); }
  friend Numbers operator*(const Numbers& a, const Numbers& b) { return Numbers(a.v_ * b.v_); }
  friend Numbers operator/(const Numbers& a, const Numbers& b) { return Numbers(a.v_ / b.v_); }
  Numbers& operator+=(const Numbers& b) { return *this = *this + b; }
  Numbers& operator-=(const Numbers& b) { return *this = *this - b; }
  friend Mask operator<(const Numbers& a, const Numbers& b) { return a.v_ < b.v_; }
  friend Mask operator==(const Numbers& a, const Numbers& b) { return a.v_ == b.v_; }

  Numbers min(const Numbers& b) const { return Numbers(Vector(b.v_ < v_ ? b.v_ : v_)); }
  Numbers max(const Numbers& b) const { return Numbers(Vector(b.v_ > v_ ? b.v_ : v_)); }
  Numbers abs() const { return max(Numbers(Vector(-v_))); }
  Numbers sqrt() const {
    Numbers root;
    for (int k = 0; k < n; ++k) root.v_[k] = std::sqrt(v_[k]);
    return root;
  }
  /// These where `mask` is set, 0 elsewhere.
  Numbers where(const Mask& mask) const { return Numbers(Vector(mask ? v_ : Vector{})); }

 private:
  Vector v_;
};

/// Agents whose partners stand side by side in a PairTable. Fixed, whatever the processor.
inline constexpr int laneCount = 8;

/// Force of a contact law at one overlap [N].
template <class Law>
double forceOf(const Law& law, double overlap, double reducedRadius) {
  Numbers<double, 1> force, stiffness;
  law.evaluate(Numbers<double, 1>(overlap), Numbers<double, 1>(reducedRadius), force, stiffness);
  return force[0];
}

/// Slope of a contact law at one overlap [N/m].
template <class Law>
double stiffnessOf(const Law& law, double overlap, double reducedRadius) {
  Numbers<double, 1> force, stiffness;
  law.evaluate(Numbers<double, 1>(overlap), Numbers<double, 1>(reducedRadius), force, stiffness);
  return stiffness[0];
}

}  // namespace restenosis
