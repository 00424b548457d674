#pragma once

#include <vector>

namespace restenosis {

/// Judges from a sequence of samples how far the last is from where they tend to.
///
/// With the relative changes d1, d2, ... between samples shrinking by a factor r each time, what is still to
/// come after d is d r / (1 - r). The factor is the largest of the last three, and at most 0.98, so a change
/// that shrinks slowly does not pass for convergence.
class SteadyState {
 public:
  /// Adds a sample. Samples must have equal sizes.
  void add(std::vector<double> sample);
  /// Estimated distance, relative to the last sample's norm; infinite before there are five samples.
  double distance() const;

 private:
  std::vector<double> last_, changes_;
};

}  // namespace restenosis
