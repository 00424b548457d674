#include "bridge/surface/FieldTopology.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>

namespace restenosis {
namespace {

/// Consecutive nodes of one sign along x: the unit in which components are joined.
struct Run {
  int first, last;
  bool free;
};

struct Runs {
  std::vector<Run> runs;
  std::vector<std::size_t> start;  ///< first run of each row (j, k), one more at the end
  std::vector<std::uint32_t> parent;

  explicit Runs(const GridField& field) {
    const LumenGrid& g = field.grid;
    for (std::size_t row = 0; row < static_cast<std::size_t>(g.ny) * g.nz; ++row) {
      start.push_back(runs.size());
      const float* v = field.values.data() + row * g.nx;
      for (int i = 0; i < g.nx; ++i) {
        if (i == 0 || (v[i] > 0) != (v[i - 1] > 0)) runs.push_back({i, i, v[i] > 0});
        runs.back().last = i;
      }
    }
    start.push_back(runs.size());
    parent.resize(runs.size());
    std::iota(parent.begin(), parent.end(), 0U);
  }

  std::uint32_t root(std::uint32_t n) {
    while (parent[n] != n) n = parent[n] = parent[parent[n]];
    return n;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    if (a != b) parent[std::max(a, b)] = std::min(a, b);
  }
  /// Joins runs of one sign that share a node's x in two neighbouring rows.
  void joinRows(std::size_t rowA, std::size_t rowB) {
    std::size_t a = start[rowA], b = start[rowB];
    while (a < start[rowA + 1] && b < start[rowB + 1]) {
      if (runs[a].free == runs[b].free) join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
      const int endA = runs[a].last, endB = runs[b].last;
      if (endA <= endB) ++a;
      if (endB <= endA) ++b;
    }
  }
  void joinAll(const LumenGrid& g) {
    for (int k = 0; k < g.nz; ++k) {
      for (int j = 0; j < g.ny; ++j) {
        const std::size_t row = static_cast<std::size_t>(k) * g.ny + j;
        if (j + 1 < g.ny) joinRows(row, row + 1);
        if (k + 1 < g.nz) joinRows(row, row + g.ny);
      }
    }
    for (std::uint32_t n = 0; n < parent.size(); ++n) parent[n] = root(n);
  }
};

/// What is known of one component; indexed by its root.
struct Component {
  std::size_t nodes = 0;
  bool inlet = false, outlet = false, side = false, strut = false, change = false;
};

template <class F>
void forEachRun(const LumenGrid& g, const Runs& runs, F&& f) {
  for (int k = 0; k < g.nz; ++k)
    for (int j = 0; j < g.ny; ++j) {
      const std::size_t row = static_cast<std::size_t>(k) * g.ny + j;
      for (std::size_t n = runs.start[row]; n < runs.start[row + 1]; ++n) f(runs.runs[n], n, j, k);
    }
}

/// Components of one sign; the others stay empty.
std::vector<Component> survey(const LumenGrid& g, const Runs& runs, bool free, const BandField* strut) {
  std::vector<Component> components(runs.runs.size());
  forEachRun(g, runs, [&](const Run& r, std::size_t n, int j, int k) {
    if (r.free != free) return;
    Component& c = components[runs.parent[n]];
    c.nodes += r.last - r.first + 1;
    c.inlet = c.inlet || k == 0;
    c.outlet = c.outlet || k == g.nz - 1;
    c.side = c.side || j == 0 || j == g.ny - 1 || r.first == 0 || r.last == g.nx - 1;
    if (strut && !c.strut)
      for (int i = r.first; i <= r.last; ++i) c.strut = c.strut || (*strut)(i, j, k) < 0;
  });
  return components;
}

void flip(GridField& field, const Runs& runs, const std::vector<Component>& components) {
  forEachRun(field.grid, runs, [&](const Run& r, std::size_t n, int j, int k) {
    if (!components[runs.parent[n]].change) return;
    for (int i = r.first; i <= r.last; ++i) {
      float& v = field.values[field.grid.index(i, j, k)];
      // A node exactly on the surface counts as obstacle and must not do so after being freed.
      v = v == 0 ? static_cast<float>(1e-6 * field.grid.spacing) : -v;
    }
  });
}

}  // namespace

LumenTopology keepLumen(GridField& field, const BandField* strut) {
  LumenTopology found;
  Runs spaces(field);
  spaces.joinAll(field.grid);
  auto free = survey(field.grid, spaces, true, nullptr);
  const Component* lumen = nullptr;
  for (const Component& c : free)
    if (c.inlet && c.outlet && (!lumen || c.nodes > lumen->nodes)) lumen = &c;
  if (!lumen) return found;
  found.connected = true;
  for (Component& c : free)
    if (c.nodes > 0 && &c != lumen) c.change = true, ++found.cavities;
  flip(field, spaces, free);

  Runs obstacles(field);
  obstacles.joinAll(field.grid);
  auto solid = survey(field.grid, obstacles, false, strut);
  for (Component& c : solid) {
    if (c.nodes == 0 || c.side) continue;
    c.change = !c.strut;
    ++(c.strut ? found.floatingStruts : found.islands);
  }
  flip(field, obstacles, solid);
  return found;
}

}  // namespace restenosis
