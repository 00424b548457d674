#include "bridge/sampling/ShearResponse.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <unsupported/Eigen/FFT>

namespace restenosis {
namespace {

using Row = std::vector<std::complex<double>>;

/// Wave number of entry n of a transform of `count` points that span `period` [1/m].
double waveNumber(int n, int count, double period) {
  return 2 * std::numbers::pi * (2 * n <= count ? n : n - count) / period;
}

/// Multiplies a field on a periodic grid, rows times columns, by a function of its wave numbers.
template <class Response>
void filter(std::vector<Row>& field, double rowPeriod, double columnPeriod, const Response& response) {
  const int rows = static_cast<int>(field.size()), columns = static_cast<int>(field.front().size());
  Eigen::FFT<double> transform;
  Row there(columns), column(rows), columnThere(rows);
  for (Row& row : field) {
    transform.fwd(there, row);
    row = there;
  }
  for (int c = 0; c < columns; ++c) {
    for (int r = 0; r < rows; ++r) column[r] = field[r][c];
    transform.fwd(columnThere, column);
    for (int r = 0; r < rows; ++r)
      columnThere[r] *= response(waveNumber(r, rows, rowPeriod), waveNumber(c, columns, columnPeriod));
    transform.inv(column, columnThere);
    for (int r = 0; r < rows; ++r) field[r][c] = column[r];
  }
  for (Row& row : field) {
    transform.inv(there, row);
    row = there;
  }
}

}  // namespace

ShearResponse::ShearResponse(const RadialMap& before, const RadialMap& after, FlowConditions::Drive drive,
                             double cutoff)
    : map_(before) {
  if (!before.comparable(after) || before.planes() < 2)
    throw std::invalid_argument("radial maps differ in planes or angles, or have fewer than two planes");
  const int planes = before.planes(), angles = before.angles(), rows = 2 * (planes - 1);
  const auto sourcePlane = [&](int row) { return row < planes ? row : rows - row; };
  std::vector<Row> field(rows, Row(angles));
  for (int r = 0; r < rows; ++r)
    for (int a = 0; a < angles; ++a)
      field[r][a] = before.radius(sourcePlane(r), a) - after.radius(sourcePlane(r), a);

  const double radius = before.meanRadius();
  const double mean = (drive == FlowConditions::Drive::flowRate ? 3 : -1) / radius;
  filter(field, 2 * (before.z(planes - 1) - before.z(0)), 2 * std::numbers::pi * radius,
         [&](double along, double around) {
           const double k = std::hypot(along, around);
           if (k == 0) return mean;
           return (k + along * along / k) * std::exp(-0.5 * k * cutoff * k * cutoff);
         });
  for (int r = 0; r < planes; ++r)
    for (int a = 0; a < angles; ++a) change_.push_back(field[r][a].real());
}

double ShearResponse::factorAt(const Vec3& point) const {
  const double change = map_.interpolate(change_, point);
  return change < 0 ? 1 / (1 - change) : 1 + change;
}

}  // namespace restenosis
