#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace restenosis {

/// What the logs and small files of an OpenFOAM case say. OpenFOAM's programs end with status 0 in many cases
/// that went wrong, so what counts is what they report. Functions return nothing where a report is absent.
namespace foamLog {

/// The whole file; empty where it cannot be read.
std::string read(const std::filesystem::path& file);

/// Whether snappyHexMesh reports "Finished meshing without any errors". Otherwise says what it reported.
std::optional<std::string> meshingProblem(const std::string& snappyLog);

struct MeshReport {
  bool ok = false;  ///< "Mesh OK."
  std::size_t cells = 0;
  double volume = 0.0;            ///< [m^3]
  double nonOrthogonality = 0.0;  ///< the largest [degrees]
  std::string problem;            ///< the checks that failed, where not ok
  std::size_t skewFaces =
      0;                  ///< faces that are all that is wrong with the mesh; 0 where other checks failed too
  double skewness = 0.0;  ///< the largest of theirs
};
MeshReport meshReport(const std::string& checkMeshLog);

/// Iterations after which "SIMPLE solution converged".
std::optional<int> convergedAfter(const std::string& solverLog);

/// The reason of a fatal error, on one line, where the log (of a serial or parallel program) has one.
std::optional<std::string> fatalError(const std::string& log);

/// A patch's number of faces, and the first of them where the file says so.
struct Patch {
  std::string name;
  std::size_t faces = 0;
  std::optional<std::size_t> startFace;
};

/// The patches of constant/polyMesh/boundary.
std::vector<Patch> patches(std::string_view boundaryFile);

/// Faces of each patch, from constant/polyMesh/boundary.
std::map<std::string, std::size_t> patchFaces(std::string_view boundaryFile);

/// The last value of a surfaceFieldValue.dat.
std::optional<double> lastValue(const std::string& table);

}  // namespace foamLog
}  // namespace restenosis
