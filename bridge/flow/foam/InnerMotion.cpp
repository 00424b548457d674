#include "bridge/flow/foam/InnerMotion.h"

#include <Eigen/Sparse>
#include <algorithm>
#include <stdexcept>

#include "bridge/surface/PointTree.h"

namespace restenosis {
namespace {

constexpr double relativeTolerance = 1e-4;

using Edge = std::pair<std::int32_t, std::int32_t>;

std::vector<Edge> edgesOf(const PolyMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(mesh.faceCorners.size());
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const auto corners = mesh.face(f);
    for (std::size_t k = 0; k < corners.size(); ++k)
      edges.push_back(std::minmax(corners[k], corners[(k + 1) % corners.size()]));
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<double> edgeWeights(const PolyMesh& mesh, const std::vector<PointFreedom>& freedom,
                                const std::vector<Edge>& edges) {
  std::vector<Vec3> fixed;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (freedom[i] == PointFreedom::given) fixed.push_back(mesh.points[i]);
  const PointTree tree(std::move(fixed));
  std::vector<double> distance(mesh.points.size(), 0.0);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (freedom[i] != PointFreedom::given) distance[i] = tree.nearest(mesh.points[i], 1).front().distance;
  std::vector<double> weights;
  weights.reserve(edges.size());
  for (const auto& [a, b] : edges) {
    const double length = std::max((mesh.points[a] - mesh.points[b]).norm(), 1e-12);
    const double d = std::max(0.5 * (distance[a] + distance[b]), 0.5 * length);
    weights.push_back(1.0 / (length * d * d));
  }
  return weights;
}

template <class Preconditioner>
using Gradients = Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower, Preconditioner>;

/// Preconditioned as far as that goes: of some regular meshes the incomplete factor has no positive diagonal.
Eigen::MatrixXd solved(const Eigen::SparseMatrix<double>& matrix, const Eigen::MatrixXd& right) {
  const auto with = [&](auto& solver) {
    solver.setTolerance(relativeTolerance);
    Eigen::MatrixXd solution = solver.solve(right);
    if (solver.info() != Eigen::Success || !solution.allFinite())
      throw std::runtime_error("the motion of the mesh's inner points could not be found");
    return solution;
  };
  Gradients<Eigen::IncompleteCholesky<double, Eigen::Lower>> factored(matrix);
  if (factored.preconditioner().info() == Eigen::Success) return with(factored);
  Gradients<Eigen::DiagonalPreconditioner<double>> scaled(matrix);
  return with(scaled);
}

/// Solves for the components `axes` of the displacements of the points that are free in them.
void solve(const std::vector<Edge>& edges, const std::vector<double>& weights,
           const std::vector<bool>& isFree, const std::vector<int>& axes, std::vector<Vec3>& displacements) {
  std::vector<Eigen::Index> row(isFree.size(), -1);
  Eigen::Index rows = 0;
  for (std::size_t i = 0; i < isFree.size(); ++i)
    if (isFree[i]) row[i] = rows++;
  if (rows == 0) return;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * edges.size());
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(axes.size()));
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const auto& [own, other] : {edges[e], Edge(edges[e].second, edges[e].first)}) {
      if (!isFree[own]) continue;
      entries.emplace_back(row[own], row[own], weights[e]);
      if (isFree[other]) {
        entries.emplace_back(row[own], row[other], -weights[e]);
        continue;
      }
      for (std::size_t k = 0; k < axes.size(); ++k)
        right(row[own], static_cast<Eigen::Index>(k)) += weights[e] * displacements[other][axes[k]];
    }
  Eigen::SparseMatrix<double> matrix(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::MatrixXd solution = solved(matrix, right);
  for (std::size_t i = 0; i < isFree.size(); ++i)
    for (std::size_t k = 0; k < axes.size() && isFree[i]; ++k)
      displacements[i][axes[k]] = solution(row[i], static_cast<Eigen::Index>(k));
}

}  // namespace

void moveInside(const PolyMesh& mesh, const std::vector<PointFreedom>& freedom,
                std::vector<Vec3>& displacements) {
  const auto edges = edgesOf(mesh);
  const auto weights = edgeWeights(mesh, freedom, edges);
  std::vector<bool> across(freedom.size()), along(freedom.size());
  for (std::size_t i = 0; i < freedom.size(); ++i) {
    across[i] = freedom[i] != PointFreedom::given;
    along[i] = freedom[i] == PointFreedom::all;
    if (freedom[i] == PointFreedom::inPlane) displacements[i].z() = 0.0;
  }
  solve(edges, weights, across, {0, 1}, displacements);
  solve(edges, weights, along, {2}, displacements);
}

}  // namespace restenosis
