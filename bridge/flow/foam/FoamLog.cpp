#include "bridge/flow/foam/FoamLog.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>

namespace restenosis::foamLog {
namespace {

/// The rest of the first line that contains `words`, after them.
std::optional<std::string> after(const std::string& text, std::string_view words) {
  const auto at = text.find(words);
  if (at == std::string::npos) return std::nullopt;
  const auto start = at + words.size();
  return text.substr(start, std::min(text.find('\n', start), text.size()) - start);
}

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// The word at the end of a text, before blanks; empty where there is none.
std::string wordBefore(std::string_view text) {
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  std::size_t start = text.size();
  while (start > 0 && (std::isalnum(static_cast<unsigned char>(text[start - 1])) || text[start - 1] == '_'))
    --start;
  return std::string(text.substr(start));
}

/// The number of an entry such as "nFaces  128;"; nothing where there is none, or one that no mesh can have.
std::optional<std::size_t> countOf(std::string_view key, std::string_view entries) {
  for (std::size_t at = 0; (at = entries.find(key, at)) != entries.npos;) {
    at += key.size();
    const std::size_t digits = std::min(entries.find_first_not_of(" \t\r\n", at), entries.size());
    std::int32_t count = 0;  // as OpenFOAM's labels are
    const auto [end, error] =
        std::from_chars(entries.data() + digits, entries.data() + entries.size(), count);
    if (digits > at && error == std::errc() && count >= 0 && end != entries.data() + entries.size() &&
        *end == ';')
      return static_cast<std::size_t>(count);
  }
  return std::nullopt;
}

/// Where a line begins behind the "[1] " that a parallel program puts before its errors.
std::size_t afterRank(const std::string& line) {
  if (!line.starts_with('[')) return 0;
  const auto end = line.find_first_not_of("0123456789", 1);
  return end != std::string::npos && end > 1 && line[end] == ']' ? end + 1 : 0;
}

}  // namespace

std::string read(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::optional<std::string> meshingProblem(const std::string& snappyLog) {
  if (snappyLog.find("Finished meshing without any errors") != std::string::npos) return std::nullopt;
  if (const auto rest = after(snappyLog, "Finished meshing with "))
    return std::string("finished meshing with ").append(*rest);
  return "did not finish meshing";
}

MeshReport meshReport(const std::string& checkMeshLog) {
  MeshReport report;
  report.ok = checkMeshLog.find("\nMesh OK.") != std::string::npos;
  if (const auto cells = after(checkMeshLog, "    cells: ")) std::istringstream(*cells) >> report.cells;
  if (const auto volume = after(checkMeshLog, "Total volume = "))
    std::istringstream(*volume) >> report.volume;
  if (const auto angle = after(checkMeshLog, "Mesh non-orthogonality Max: "))
    std::istringstream(*angle) >> report.nonOrthogonality;
  if (report.ok) return report;
  std::istringstream lines(checkMeshLog);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(" ***")) continue;
    if (!report.problem.empty()) report.problem += "; ";
    report.problem.append(line, 4);
  }
  if (checkMeshLog.find("\nFailed 1 mesh checks") != std::string::npos) {
    if (const auto rest = after(checkMeshLog, " ***Max skewness = ")) {
      char comma = 0;
      std::istringstream(*rest) >> report.skewness >> comma >> report.skewFaces;
    }
  }
  if (report.problem.empty()) report.problem = "did not report \"Mesh OK\"";
  return report;
}

std::optional<int> convergedAfter(const std::string& solverLog) {
  const auto rest = after(solverLog, "SIMPLE solution converged in ");
  int iterations = 0;
  if (!rest || !(std::istringstream(*rest) >> iterations)) return std::nullopt;
  return iterations;
}

std::optional<std::string> fatalError(const std::string& log) {
  const auto at = log.find("FOAM FATAL");
  if (at == std::string::npos) {
    if (log.find("Foam::sigFpe::sigHandler") != std::string::npos) return "floating point exception";
    return std::nullopt;
  }
  std::istringstream lines(log.substr(log.find('\n', at) + 1));
  std::string reason;
  for (std::string line; std::getline(lines, line) && reason.size() < 300;) {
    const auto start = line.find_first_not_of(" \t", afterRank(line));
    if (start == std::string::npos) {
      if (!reason.empty()) break;
      continue;
    }
    if (!reason.empty()) reason += ' ';
    reason.append(line, start);
  }
  return reason;
}

std::vector<Patch> patches(std::string_view boundaryFile) {
  std::vector<Patch> patches;
  for (std::size_t open = 0; (open = boundaryFile.find('{', open)) != boundaryFile.npos;) {
    const std::size_t close = boundaryFile.find('}', open);
    if (close == boundaryFile.npos) break;
    const std::string_view entries = boundaryFile.substr(open + 1, close - open - 1);
    const std::string name = wordBefore(boundaryFile.substr(0, open));
    const auto faces = countOf("nFaces", entries);
    if (!name.empty() && faces) patches.push_back({name, *faces, countOf("startFace", entries)});
    open = faces ? close : open + 1;
  }
  return patches;
}

std::map<std::string, std::size_t> patchFaces(std::string_view boundaryFile) {
  std::map<std::string, std::size_t> faces;
  for (const Patch& patch : patches(boundaryFile)) faces[patch.name] = patch.faces;
  return faces;
}

std::optional<double> lastValue(const std::string& table) {
  std::istringstream lines(table);
  std::optional<double> value;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    double time = 0.0;
    std::string number;
    value.reset();
    if (words >> time >> number) {
      try {
        value = std::stod(number);
      } catch (const std::exception&) {
      }
    }
  }
  return value;
}

}  // namespace restenosis::foamLog
