#include <array>
#include <stdexcept>
#include <string>

#include "bridge/flow/foam/PolyMesh.h"
#include "tests/fuzz/FuzzTargets.h"

namespace restenosis {
namespace {

/// Separates the five files of a mesh in the input.
constexpr std::string_view fileEnds = "\n====\n";

}  // namespace

void fuzzMesh(std::string_view input) {
  PolyMeshFiles files;
  for (std::string* file : {&files.points, &files.faces, &files.owner, &files.neighbour, &files.boundary}) {
    const auto end = input.find(fileEnds);
    *file = input.substr(0, end);
    input.remove_prefix(end == std::string_view::npos ? input.size() : end + fileEnds.size());
  }
  try {
    const PolyMesh mesh = parsePolyMesh("constant/polyMesh", std::move(files));
    // What is made of one that was accepted
    mesh.cellCentres();
    for (const auto& patch : mesh.patches)
      for (std::size_t f = patch.start; f < patch.start + patch.faces; ++f)
        for (const auto p : mesh.face(f))
          if (!(mesh.points[static_cast<std::size_t>(p)].norm() >= 0)) return;
  } catch (const std::runtime_error&) {
    // Refused, as it says
  }
}

}  // namespace restenosis
