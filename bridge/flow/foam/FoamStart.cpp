#include "bridge/flow/foam/FoamStart.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "bridge/flow/foam/FoamBinary.h"
#include "bridge/flow/foam/FoamLog.h"
#include "bridge/surface/PointTree.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {

namespace fs = std::filesystem;

namespace {

/// The folder of the last iteration that was written.
fs::path lastIteration(const fs::path& caseFolder) {
  long last = 0;
  if (fs::is_directory(caseFolder))
    for (const auto& entry : fs::directory_iterator(caseFolder)) {
      const std::string name = entry.path().filename().string();
      if (name.size() < 10 && std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; }))
        last = std::max(last, std::stol(name));
    }
  if (last == 0) throw std::runtime_error(fmt::format("{} holds no solution", caseFolder.string()));
  return caseFolder / std::to_string(last);
}

std::vector<double> readCells(const fs::path& file, std::string_view type, std::size_t components) {
  FoamBinary field(file);
  field.skipPast("internalField");
  field.skipPast(fmt::format("nonuniform List<{}>", type));
  return field.numbers(components);
}

/// The file of a field in the template, uniform and ASCII, that becomes a binary one with values.
class FieldFile {
 public:
  explicit FieldFile(fs::path file) : file_(std::move(file)), text_(foamLog::read(file_)) {
    replace("ascii", "binary");
  }
  void set(std::string_view entry, std::string_view type, std::size_t components,
           const std::vector<double>& values) {
    replace(entry,
            fmt::format("{} nonuniform List<{}>\n{}", entry, type, foamBinaryList(values, components)));
  }
  void write() const { atomicWrite(file_, text_); }

 private:
  void replace(std::string_view from, const std::string& with) {
    const auto start = text_.find(from), end = text_.find(';', start);
    if (start == std::string::npos || end == std::string::npos)
      throw std::runtime_error(fmt::format("{} has no '{}'", file_.string(), from));
    text_.replace(start, end - start, with);
  }

  fs::path file_;
  std::string text_;
};

}  // namespace

FoamSolution readFoamSolution(const fs::path& caseFolder) {
  const fs::path fields = lastIteration(caseFolder);
  FoamSolution solution{readPolyMesh(caseFolder), readCells(fields / "U", "vector", 3),
                        readCells(fields / "p", "scalar", 1)};
  const std::size_t cells = solution.mesh.cells();
  if (solution.velocity.size() != 3 * cells || solution.pressure.size() != cells)
    throw std::runtime_error(fmt::format("{} does not belong to its mesh", fields.string()));
  return solution;
}

std::vector<fs::path> foamSolutionFiles(const fs::path& caseFolder) {
  const fs::path mesh = "constant/polyMesh", fields = lastIteration(caseFolder).filename();
  return {mesh / "points",   mesh / "faces", mesh / "owner", mesh / "neighbour",
          mesh / "boundary", fields / "U",   fields / "p"};
}

FoamStart::FoamStart(const FoamSolution& solution, std::vector<Vec3> centres)
    : solution_(solution), centres_(std::move(centres)) {}

void FoamStart::write(const fs::path& part) const {
  const PolyMesh mesh = readPolyMesh(part);
  const PointTree tree(centres_);
  std::vector<double> velocity, pressure, inletVelocity;
  const auto append = [](std::vector<double>& to, const std::vector<double>& from, std::size_t cell) {
    for (std::size_t k = 0; k < 3; ++k) to.push_back(from[3 * cell + k]);
  };
  for (const Vec3& centre : mesh.cellCentres()) {
    const std::size_t from = tree.nearest(centre, 1).front().index;
    append(velocity, solution_.velocity, from);
    pressure.push_back(solution_.pressure[from]);
  }
  if (const auto* inlet = mesh.patch("inlet"))
    for (std::size_t f = 0; f < inlet->faces; ++f)
      append(inletVelocity, velocity, static_cast<std::size_t>(mesh.owner[inlet->start + f]));
  FieldFile u(part / "0/U"), p(part / "0/p");
  u.set("inletVelocity", "vector", 3, inletVelocity);
  u.set("internalField", "vector", 3, velocity);
  p.set("internalField", "scalar", 1, pressure);
  u.write();
  p.write();
}

}  // namespace restenosis
