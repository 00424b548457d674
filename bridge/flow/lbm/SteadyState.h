#pragma once

#include <vector>

namespace restenosis {

/// Judges from a sequence of samples how far the last is from where they tend to.
///
/// With the relative changes d1, d2, ... between samples shrinking by a factor r each time, what is still to
/// come after d is d r / (1 - r). Flows settle with decaying oscillations, so d is the largest of the last
/// four changes and r compares the mean of these with that of the four before; it counts as 0.98 at most.
class SteadyState {
 public:
  /// Adds a sample. Samples must have equal sizes.
  void add(std::vector<double> sample);
  /// Estimated distance, relative to the last sample's norm; infinite before there are nine samples.
  double distance() const;

 private:
  std::vector<double> last_, changes_;
};

}  // namespace restenosis
