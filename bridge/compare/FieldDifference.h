#pragma once

#include <cstddef>
#include <vector>

namespace restenosis {

/// How a field differs from a reference over some faces or points.
struct FieldDifference {
  std::size_t count = 0;
  double weight = 0.0;          ///< in all, for faces the area [m^2]
  double referenceMean = 0.0;   ///< weighted
  double mean = 0.0;            ///< of the other field
  double meanDifference = 0.0;  ///< other mean over reference mean, less 1
  double relativeL2 = 0.0;      ///< rms difference over the reference's rms
  double correlation = 0.0;     ///< Pearson's; 0 where a field is uniform
  /// Differences relative to the mean of both at each place, by magnitude, that 95 % of the weight do not
  /// exceed.
  double relativeP95 = 0.0;
  /// Bland and Altman (1986): mean difference, and its limits of agreement, 1.96 standard deviations to
  /// either side.
  double bias = 0.0, lowerLimit = 0.0, upperLimit = 0.0;
};

/// Gathers pairs and sums them up. Pairs with a value that is not finite are counted as unknown and left out.
class FieldDifferenceSum {
 public:
  void add(double reference, double other, double weight);
  FieldDifference result() const;
  std::size_t unknown() const { return unknown_; }

 private:
  struct Pair {
    double reference, other, weight;
  };
  std::vector<Pair> pairs_;
  std::size_t unknown_ = 0;
};

}  // namespace restenosis
