#include <gtest/gtest.h>

#include "bridge/flow/foam/FoamLog.h"

namespace restenosis::foamLog {
namespace {

TEST(FoamLog, mesherMustSayThatItMadeNoErrors) {
  EXPECT_FALSE(meshingProblem("...\nFinished meshing without any errors\nFinished meshing in = 3 s.\nEnd\n"));
  EXPECT_EQ(meshingProblem("Finished meshing with 58588 illegal faces (concave, ...)\nEnd\n"),
            "finished meshing with 58588 illegal faces (concave, ...)");
  EXPECT_EQ(meshingProblem("Create time\n"), "did not finish meshing");
}

TEST(FoamLog, meshReportIsRead) {
  const auto good = meshReport(
      "    cells:            20476\n    Min volume = 2.8e-06. Max volume = 0.00078.  Total volume = "
      "3.008409536.  "
      "Cell volumes OK.\n    Mesh non-orthogonality Max: 48.0335 average: 12.5\n\nMesh OK.\n\nEnd\n");
  EXPECT_TRUE(good.ok);
  EXPECT_EQ(good.cells, 20476u);
  EXPECT_DOUBLE_EQ(good.volume, 3.008409536);
  EXPECT_DOUBLE_EQ(good.nonOrthogonality, 48.0335);
}

TEST(FoamLog, failedMeshChecksAreQuoted) {
  const auto bad =
      meshReport(" ***Max skewness = 9, 4 highly skew faces detected\n\nFailed 1 mesh checks.\n");
  EXPECT_FALSE(bad.ok);
  EXPECT_NE(bad.problem.find("Max skewness = 9"), std::string::npos);
  EXPECT_FALSE(meshReport("").ok);
  EXPECT_FALSE(meshReport("").problem.empty());
}

TEST(FoamLog, skewFacesAreCountedWhereNothingElseIsWrong) {
  const std::string skew = " ***Max skewness = 5.5, 3 highly skew faces detected which may impair\n";
  const auto onlySkew = meshReport(skew + "\nFailed 1 mesh checks.\n");
  EXPECT_EQ(onlySkew.skewFaces, 3u);
  EXPECT_DOUBLE_EQ(onlySkew.skewness, 5.5);
  EXPECT_EQ(meshReport(skew + " ***Zero or negative cell volume\n\nFailed 2 mesh checks.\n").skewFaces, 0u);
  EXPECT_EQ(meshReport("\nMesh OK.\n").skewFaces, 0u);
}

TEST(FoamLog, convergenceIsReportedOrAbsent) {
  EXPECT_EQ(convergedAfter("Time = 24\n\nSIMPLE solution converged in 24 iterations\n"), 24);
  EXPECT_FALSE(convergedAfter("Time = 400\n\nEnd\n"));
}

TEST(FoamLog, fatalErrorIsOneLine) {
  EXPECT_EQ(
      fatalError("\n--> FOAM FATAL ERROR: \nUnable to set reference cell\n    for field p\n\n    From ..."),
      "Unable to set reference cell for field p");
  EXPECT_EQ(
      fatalError("[1] \n[1] --> FOAM FATAL ERROR: \n[1] Cannot find patchField entry\n[1]     for sides\n"
                 "[1] \n[1]     From ..."),
      "Cannot find patchField entry for sides");
  EXPECT_EQ(fatalError("#1 Foam::sigFpe::sigHandler(int)\n"), "floating point exception");
  EXPECT_FALSE(fatalError("End\n"));
}

TEST(FoamLog, patchesAreCounted) {
  const auto faces = patchFaces(R"(FoamFile { class polyBoundaryMesh; }
2
(
    inlet { type patch; nFaces 520; startFace 60952; }
    wall
    {
        type            wall;
        inGroups        1(wall);
        nFaces          4032;
    }
))");
  EXPECT_EQ(faces.size(), 2u);
  EXPECT_EQ(faces.at("inlet"), 520u);
  EXPECT_EQ(faces.at("wall"), 4032u);
}

TEST(FoamLog, lastValueOfATable) {
  EXPECT_EQ(lastValue("# Time sum(phi)\n23 \t-1\n24 \t-3.3844500000e+02\n"), -338.445);
  EXPECT_FALSE(lastValue("# Time sum(phi)\n"));
  EXPECT_FALSE(lastValue("24 \t\n"));
}

}  // namespace
}  // namespace restenosis::foamLog
