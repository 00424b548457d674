#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace restenosis {

/// Where a scene says something: a line of a file, or an option of the command line ("--set
/// vessel.length", "--flow"), which has no line.
struct ScenePlace {
  std::string file;
  int line = 0;    ///< from 1; 0: the file as a whole, or not a file
  int column = 0;  ///< from 1; 0: unknown
};

/// One thing that is wrong with a scene.
struct Diagnostic {
  std::string file;
  int line = 0;
  int column = 0;
  std::string message;
};

/// "scenes/x.toml:12: message", or "--set vessel.length: message", in one line and printable.
std::string toString(const Diagnostic& diagnostic);

/// A scene that cannot be used; carries everything found wrong, in the order of the file. `what()` has one
/// line for each.
class SceneError : public std::runtime_error {
 public:
  explicit SceneError(std::vector<Diagnostic> diagnostics);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace restenosis
