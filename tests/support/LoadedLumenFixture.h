#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "bridge/flow/LumenShape.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/StlFile.h"
#include "tests/support/Constants.h"
#include "tests/support/ExpectSays.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis::support {

/// Writes a surface to an STL file and loads it as a lumen.
class LoadedLumenFixture : public ::testing::Test {
 protected:
  /// Writes a surface without names, in mm, and loads it.
  TriSurface load(const TriSurface& surface, std::span<const SurfaceRegion> regions = {}) const {
    writeStl(file, surface, 1e-3, regions);
    return loadLumen(file, 1e-3);
  }
  /// Why a surface is refused; "accepted" where it is not.
  std::string refusal(const TriSurface& surface, double metresPerUnit = 1e-3) const {
    writeStl(file, surface, 1e-3);
    return refusalOfFile(metresPerUnit);
  }
  std::string refusalOfFile(double metresPerUnit = 1e-3) const {
    try {
      loadLumen(file, metresPerUnit);
      return "accepted";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }
  /// The same for a surface without these triangles.
  std::string refusalWithout(TriSurface surface, const std::vector<std::size_t>& triangles) const {
    for (auto t = triangles.rbegin(); t != triangles.rend(); ++t)
      surface.triangles.erase(surface.triangles.begin() + static_cast<std::ptrdiff_t>(*t));
    surface.region.resize(surface.triangles.size());
    return refusal(surface);
  }
  void expectEnds(const TriSurface& lumen, const Vec3& inlet, const Vec3& outlet) const {
    EXPECT_NO_THROW(requireLumenWithPlanarEnds(lumen));
    EXPECT_NEAR((endPlane(lumen, SurfaceRegion::inlet).centre - inlet).norm(), 0.0, 1e-8);
    EXPECT_NEAR((endPlane(lumen, SurfaceRegion::outlet).centre - outlet).norm(), 0.0, 1e-8);
    EXPECT_NEAR(endDiameter(lumen, SurfaceRegion::inlet), 2 * vesselRadius, 1e-8);
  }

  TemporaryFolder folder;
  std::filesystem::path file = folder / "lumen.stl";
};

}  // namespace restenosis::support
