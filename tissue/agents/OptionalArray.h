#pragma once

#include <cstddef>
#include <vector>

namespace restenosis {

/// A quantity of agents that only some scenes model. Elsewhere it has no memory, is no part of the state, and
/// is 0 for every agent.
template <class T>
class OptionalArray {
 public:
  /// Models the quantity from now on, for so many agents.
  void model(std::size_t agents) {
    modelled_ = true;
    values_.resize(agents);
  }
  bool modelled() const { return modelled_; }
  T operator[](std::size_t i) const { return modelled_ ? values_[i] : T{}; }
  /// The quantity is modelled.
  void set(std::size_t i, T value) { values_[i] = value; }
  std::vector<T>& values() { return values_; }

  template <class Archive>
  void archive(Archive& a) {
    if (modelled_) a(values_);
  }

 private:
  bool modelled_ = false;
  std::vector<T> values_;
};

}  // namespace restenosis
