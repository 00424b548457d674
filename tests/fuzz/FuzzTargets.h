#pragma once

#include <span>
#include <string_view>

namespace restenosis {

/// Hands bytes to what reads one kind of input, as the program would have them from a file. Input may be
/// refused in the way that the reader documents; anything else it throws passes on, and ends the program: a
/// finding, as what a sanitizer reports is.
struct FuzzTarget {
  std::string_view name;  ///< its corpus is in tests/fuzz/corpus/<name>
  void (*run)(std::string_view input);
};

/// All of them.
std::span<const FuzzTarget> fuzzTargets();

void fuzzScene(std::string_view input);
void fuzzStl(std::string_view input);
void fuzzTable(std::string_view input);
void fuzzLog(std::string_view input);
void fuzzMesh(std::string_view input);

}  // namespace restenosis
