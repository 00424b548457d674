#include "bridge/flow/foam/FoamVelocity.h"

#include <fmt/format.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOpenFOAMReader.h>
#include <vtkUnstructuredGrid.h>

#include <Eigen/Dense>
#include <stdexcept>

#include "bridge/surface/PointTree.h"
#include "tissue/parameters/LengthUnits.h"

namespace restenosis {
namespace {

/// Cells that a fit takes in; a quadratic function has ten coefficients. In a cubic grid 32 may lie in four
/// columns, which do not determine it.
constexpr std::size_t fitted = 64;

struct CellVelocities {
  std::vector<Vec3> centre, velocity;  // [m], [m/s]
};

CellVelocities readCells(const std::filesystem::path& caseFolder) {
  vtkNew<vtkOpenFOAMReader> reader;
  const std::string file = (caseFolder / "case.foam").string();
  reader->SetFileName(file.c_str());
  reader->CreateCellToPointOff();
  reader->DecomposePolyhedraOff();
  reader->UpdateInformation();
  vtkDoubleArray* times = reader->GetTimeValues();
  const vtkIdType count = times ? times->GetNumberOfTuples() : 0;
  if (count == 0) throw std::runtime_error(fmt::format("{} has no times", caseFolder.string()));
  reader->UpdateTimeStep(times->GetValue(count - 1));
  for (unsigned block = 0; block < reader->GetOutput()->GetNumberOfBlocks(); ++block) {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(reader->GetOutput()->GetBlock(block));
    vtkDataArray* velocity = grid ? grid->GetCellData()->GetArray("U") : nullptr;
    if (!velocity) continue;
    CellVelocities cells;
    for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
      std::array<double, 6> box{};
      grid->GetCellBounds(c, box.data());
      cells.centre.push_back(0.5 * Vec3(box[0] + box[1], box[2] + box[3], box[4] + box[5]));
      Vec3 u;
      velocity->GetTuple(c, u.data());
      cells.velocity.push_back(u);
    }
    return cells;
  }
  throw std::runtime_error(fmt::format("{} has no velocities", caseFolder.string()));
}

/// Value at `place` of the quadratic function fitted to these cells, nearer ones weighing more.
Vec3 fit(const CellVelocities& cells, const std::vector<PointTree::Near>& near, const Vec3& place) {
  const double reach = near.back().distance;
  Eigen::Matrix<double, Eigen::Dynamic, 10> terms(near.size(), 10);
  Eigen::Matrix<double, Eigen::Dynamic, 3> values(near.size(), 3);
  for (std::size_t i = 0; i < near.size(); ++i) {
    const Vec3 d = (cells.centre[near[i].index] - place) / reach;
    const double weight = std::exp(-2.0 * d.squaredNorm());
    const auto row = static_cast<Eigen::Index>(i);
    terms.row(row) << 1.0, d.x(), d.y(), d.z(), d.x() * d.x(), d.y() * d.y(), d.z() * d.z(), d.x() * d.y(),
        d.x() * d.z(), d.y() * d.z();
    terms.row(row) *= weight;
    values.row(row) = weight * cells.velocity[near[i].index].transpose();
  }
  return terms.colPivHouseholderQr().solve(values).row(0).transpose();
}

}  // namespace

std::vector<Vec3> foamVelocities(const std::filesystem::path& caseFolder, const std::vector<Vec3>& points) {
  const CellVelocities cells = readCells(caseFolder);
  const PointTree tree(cells.centre);
  std::vector<Vec3> result;
  for (const Vec3& p : points) result.push_back(fit(cells, tree.nearest(p, fitted), p));
  return result;
}

}  // namespace restenosis
