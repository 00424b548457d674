#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

#include "tests/support/LatticeSupport.h"

namespace restenosis {
namespace {

using namespace support;

/// A tube twelve nodes wide and five layers long, periodic and at rest but for what a test sets.
template <class Real>
struct SmallTube {
  explicit SmallTube(WallRule rule, LatticeRelaxation relaxation = {})
      : surface(tube(6.3, 5.0, 5)), lattice(makeLumenLattice(surface, 1.0)) {
    LatticeEnds ends;
    ends.inlet = LatticeEnds::Inlet::periodic;
    flow = std::make_unique<LatticeFlow<Real>>(lattice.layout,
                                               makeBoundary(lattice, surface.region, rule, ends), relaxation);
  }
  template <class F>
  void forEachPlace(F&& f) const {
    for (const NodeRun& run : lattice.layout.runs())
      for (std::uint32_t n = 0; n < run.count; ++n) f(run.first + n);
  }
  double mass() const {
    double sum = 0.0;
    forEachPlace([&](std::uint32_t place) { sum += flow->state(place).density; });
    return sum;
  }
  TriSurface surface;
  LumenLattice lattice;
  std::unique_ptr<LatticeFlow<Real>> flow;
};

/// Some smooth state that is not symmetric in anything.
NodeState uneven(std::uint32_t place) {
  NodeState s;
  s.density = 1e-3 * std::sin(0.3 * place);
  s.velocity = 0.02 * Vec3(std::sin(0.7 * place), std::cos(0.2 * place), 1.0 + std::sin(0.11 * place));
  return s;
}

TEST(LatticeFlow, holdsTheStateItIsGiven) {
  LatticeRelaxation relaxation;
  relaxation.tau = 0.8;
  relaxation.force = Vec3(1e-4, -2e-4, 3e-4);
  SmallTube<double> t(WallRule::interpolated, relaxation);
  const auto given = [](std::uint32_t place) {
    NodeState s = uneven(place);
    s.stress = {1e-4, -3e-4, 2e-4, 5e-5, -6e-5, 7e-5};  // without trace
    return s;
  };
  t.flow->initialise(given);
  t.forEachPlace([&](std::uint32_t place) {
    const NodeState expected = given(place), found = t.flow->state(place);
    ASSERT_NEAR(found.density, expected.density, 1e-14);
    ASSERT_LT((found.velocity - expected.velocity).norm(), 1e-14);
  });
}

TEST(LatticeFlow, stressIsHeldWithoutForce) {
  SmallTube<double> t(WallRule::interpolated);
  t.flow->initialise([](std::uint32_t) {
    NodeState s;
    s.stress = {1e-4, -3e-4, 2e-4, 5e-5, -6e-5, 7e-5};
    return s;
  });
  t.forEachPlace([&](std::uint32_t place) {
    const auto found = t.flow->state(place).stress;
    const std::array<double, 6> expected = {1e-4, -3e-4, 2e-4, 5e-5, -6e-5, 7e-5};
    for (std::size_t k = 0; k < 6; ++k) ASSERT_NEAR(found[k], expected[k], 1e-15);
  });
}

TEST(LatticeFlow, restStaysAtRest) {
  for (const WallRule rule : {WallRule::bounceBack, WallRule::interpolated}) {
    SmallTube<double> t(rule);
    t.flow->initialise([](std::uint32_t) { return NodeState{}; });
    t.flow->advance(10);
    t.forEachPlace([&](std::uint32_t place) {
      ASSERT_EQ(t.flow->state(place).density, 0.0);
      ASSERT_EQ(t.flow->state(place).velocity, Vec3::Zero());
    });
  }
}

TEST(LatticeFlow, bounceBackConservesMass) {
  SmallTube<double> t(WallRule::bounceBack);
  t.flow->initialise(uneven);
  const double before = t.mass();
  t.flow->advance(50);
  EXPECT_NEAR(t.mass(), before, 1e-12);
}

TEST(LatticeFlow, collisionLeavesDensityAndVelocityToTheForceAlone) {
  // Uniform flow far from the wall for one pair of steps: the force accelerates it by 2 F
  LatticeRelaxation relaxation;
  relaxation.tau = 0.7;
  relaxation.force = Vec3(0.0, 0.0, 1e-4);
  SmallTube<double> t(WallRule::bounceBack, relaxation);
  t.flow->initialise([](std::uint32_t) {
    NodeState s;
    s.velocity.z() = 0.01;
    return s;
  });
  t.flow->advance(1);
  const auto position = placePositions(t.lattice);
  int seen = 0;
  t.forEachPlace([&](std::uint32_t place) {
    if (position[place].head<2>().norm() > 3.0) return;
    const NodeState s = t.flow->state(place);
    EXPECT_NEAR(s.velocity.z(), 0.01 + 2e-4, 1e-13);
    EXPECT_NEAR(s.density, 0.0, 1e-13);
    ++seen;
  });
  EXPECT_GT(seen, 20);
}

template <class Real>
std::vector<double> populations(int threads) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  SmallTube<Real> t(WallRule::interpolated);
  t.flow->initialise(uneven);
  t.flow->advance(7);
  omp_set_num_threads(before);
  std::vector<double> result;
  t.forEachPlace([&](std::uint32_t place) {
    for (int i = 0; i < d3q19::directions; ++i) result.push_back(t.flow->population(place, i));
  });
  return result;
}

TEST(LatticeFlow, goesOnAsIfItHadNotStopped) {
  // What comes back from walls and ends is put in place between two steps, and at the end of a call
  const TriSurface surface = tube(6.3, 9.0, 9);
  const LumenLattice lattice = makeLumenLattice(surface, 1.0);
  LatticeEnds ends;
  ends.inlet = LatticeEnds::Inlet::pressure;
  ends.inletDensity = 0.02;
  const auto after = [&](std::vector<int> calls) {
    auto boundary = makeBoundary(lattice, surface.region, WallRule::interpolated, ends);
    EXPECT_FALSE(boundary.wall.empty());
    EXPECT_FALSE(boundary.pressureNodes.empty());
    boundary.expectedOutflow = 1.0;  // so that the outlet's density follows the flow
    LatticeFlow<double> flow(lattice.layout, std::move(boundary), {});
    flow.initialise([](std::uint32_t) { return NodeState{}; });
    for (const int pairs : calls) flow.advance(pairs);
    std::vector<double> result;
    for (const NodeRun& run : lattice.layout.runs())
      for (std::uint32_t n = 0; n < run.count; ++n)
        for (int i = 0; i < d3q19::directions; ++i) result.push_back(flow.population(run.first + n, i));
    return result;
  };
  const auto whole = after({7});
  EXPECT_EQ(after({3, 4}), whole);
  EXPECT_EQ(after({1, 0, 5, 1}), whole);
  EXPECT_NE(after({6}), whole);
}

TEST(LatticeFlow, threadsChangeNothing) {
  EXPECT_EQ(populations<double>(1), populations<double>(3));
  EXPECT_EQ(populations<float>(1), populations<float>(3));
}

TEST(LatticeFlow, singlePrecisionFollowsDouble) {
  const auto d = populations<double>(1), f = populations<float>(1);
  for (std::size_t i = 0; i < d.size(); ++i) ASSERT_NEAR(d[i], f[i], 1e-6);
}

}  // namespace
}  // namespace restenosis
