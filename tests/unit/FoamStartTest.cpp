#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

#include "bridge/flow/foam/FoamStart.h"
#include "tests/support/PolyMeshFiles.h"
#include "tests/support/TubeMesh.h"

namespace restenosis {
namespace {

using namespace support;

class FoamStartTest : public ::testing::Test {
 protected:
  PolyMesh mesh = tubeMesh(0.9e-3, 1.2e-3, 8, 2, 2);
  std::vector<double> velocity, pressure;
  TemporaryFolder scratch;

  FoamStartTest() {
    for (std::size_t c = 0; c < mesh.cells(); ++c) {
      const auto value = static_cast<double>(c);
      velocity.insert(velocity.end(), {value, -value, 100 + value});
      pressure.push_back(0.5 * value);
    }
  }
  /// A case with the mesh and a solution in iteration 12, and another in 9.
  void writeSolved(const std::filesystem::path& folder) const {
    writePolyMesh(mesh, folder);
    for (const auto& [iteration, factor] : {std::pair{"9", 7.0}, {"12", 1.0}}) {
      std::filesystem::create_directories(folder / iteration);
      auto u = velocity;
      for (double& v : u) v *= factor;
      writeText(folder / iteration / "U", foamHeader("volVectorField") +
                                              "internalField   nonuniform List<vector> \n" +
                                              foamBinaryList(u, 3) + "\n;\n\nboundaryField\n{\n}\n");
      writeText(folder / iteration / "p", foamHeader("volScalarField") +
                                              "internalField   nonuniform List<scalar> \n" +
                                              foamBinaryList(pressure, 1) + "\n;\n\nboundaryField\n{\n}\n");
    }
  }
};

TEST_F(FoamStartTest, theLastIterationIsRead) {
  writeSolved(scratch.path());
  const FoamSolution solution = readFoamSolution(scratch.path());
  EXPECT_EQ(solution.velocity, velocity);
  EXPECT_EQ(solution.pressure, pressure);
  EXPECT_EQ(solution.mesh.points, mesh.points);
}

TEST_F(FoamStartTest, whatIsReadIsNamed) {
  writeSolved(scratch.path());
  const auto files = foamSolutionFiles(scratch.path());
  EXPECT_EQ(files.size(), 7U);
  for (const auto& file : files) {
    const auto aside = scratch / "aside";
    std::filesystem::rename(scratch.path() / file, aside);
    EXPECT_ANY_THROW({
      if (readFoamSolution(scratch.path()).mesh.patches.empty()) throw std::runtime_error("no patches");
    }) << file;
    std::filesystem::rename(aside, scratch.path() / file);
  }
  std::filesystem::create_directory(scratch / "99");
  EXPECT_NE(foamSolutionFiles(scratch.path()), files);
}

TEST_F(FoamStartTest, whatIsMissingOrDoesNotFitIsRefused) {
  EXPECT_THROW(readFoamSolution(scratch / "nowhere"), std::runtime_error);
  writePolyMesh(mesh, scratch.path());
  EXPECT_THROW(readFoamSolution(scratch.path()), std::runtime_error);
  velocity.resize(velocity.size() - 3);
  writeSolved(scratch.path());
  EXPECT_THROW(readFoamSolution(scratch.path()), std::runtime_error);
}

/// The new mesh's cells lie a little off the former ones', and their numbers run the other way.
TEST_F(FoamStartTest, cellsStartWithTheValuesOfTheNearestPlace) {
  const FoamSolution solution{mesh, velocity, pressure};
  std::vector<Vec3> centres = mesh.cellCentres();
  for (Vec3& c : centres) c += Vec3(0.01e-3, -0.01e-3, 0.02e-3);
  PolyMesh reversed = mesh;
  const auto last = static_cast<std::int32_t>(mesh.cells()) - 1;
  for (auto& c : reversed.owner) c = last - c;
  for (auto& c : reversed.neighbour) c = last - c;
  writePolyMesh(reversed, scratch.path());
  std::filesystem::create_directories(scratch / "0");
  const std::string source = RESTENOSIS_SOURCE_DIR;
  for (const char* field : {"U", "p"})
    std::filesystem::copy_file(source + "/foamCase/0.orig/" + field, scratch / "0" / field);

  FoamStart(solution, centres).write(scratch.path());
  const auto read = [&](const char* field, const char* entry, const char* type, std::size_t components) {
    const std::string text = readText(scratch / "0" / field);
    EXPECT_NE(text.find("boundaryField"), std::string::npos);
    const auto at = text.find(std::string(entry) + " nonuniform List<" + type + ">\n");
    EXPECT_NE(at, std::string::npos);
    const auto begin = text.find('(', at) + 1;
    std::vector<double> values(std::stoul(text.substr(text.find('\n', at))) * components);
    std::memcpy(values.data(), &text[begin], values.size() * sizeof(double));
    EXPECT_EQ(text.substr(begin + values.size() * sizeof(double), 2), ");");
    return values;
  };
  const auto u = read("U", "internalField", "vector", 3), p = read("p", "internalField", "scalar", 1),
             inlet = read("U", "inletVelocity", "vector", 3);
  ASSERT_EQ(u.size(), velocity.size());
  ASSERT_EQ(p.size(), pressure.size());
  for (std::size_t c = 0; c < p.size(); ++c) {
    const std::size_t former = p.size() - 1 - c;
    EXPECT_EQ(p[c], pressure[former]);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(u[3 * c + k], velocity[3 * former + k]);
  }
  const auto* patch = mesh.patch("inlet");
  ASSERT_EQ(inlet.size(), 3 * patch->faces);
  for (std::size_t f = 0; f < patch->faces; ++f)
    EXPECT_EQ(inlet[3 * f], velocity[3 * static_cast<std::size_t>(mesh.owner[patch->start + f])]);
}

}  // namespace
}  // namespace restenosis
