#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/Process.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TinyScene.h"

namespace restenosis {

/// Columns of a CSV file by name, in the order of the file; an empty field is an empty optional. Throws on a
/// field that is not a number, or a line with another number of fields than the header.
struct CsvColumns {
  std::vector<std::string> names;
  std::map<std::string, std::vector<std::optional<double>>> values;

  explicit CsvColumns(const std::filesystem::path& file) {
    std::istringstream lines(readText(file));
    std::string line;
    std::getline(lines, line);
    names = fields(line);
    while (std::getline(lines, line)) {
      const auto texts = fields(line);
      if (texts.size() != names.size()) throw std::runtime_error("wrong number of fields: " + line);
      for (std::size_t n = 0; n < texts.size(); ++n)
        values[names[n]].push_back(texts[n].empty() ? std::nullopt : std::optional(std::stod(texts[n])));
    }
  }
  std::size_t rows() const { return values.at(names.front()).size(); }
  double last(const std::string& name) const { return values.at(name).back().value(); }

 private:
  static std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> texts(1);
    for (const char c : line) {
      if (c == ',')
        texts.emplace_back();
      else
        texts.back() += c;
    }
    return texts;
  }
};

/// A test that starts the program in a folder of its own.
class WholeProgram : public ::testing::Test {
 protected:
  using Environment = Process::Environment;
  static constexpr std::chrono::seconds patience{400};  ///< far beyond any run here, on a busy machine too

  /// Writes a scene and returns its name for the command line.
  std::string scene(const std::string& name, std::string_view text) const {
    writeText(folder / (name + ".toml"), std::string(text));
    return name + ".toml";
  }
  /// The command line of the program.
  static std::vector<std::string> command(std::vector<std::string> arguments) {
    std::vector<std::string> all = {RESTENOSIS_PROGRAM};
    std::ranges::move(arguments, std::back_inserter(all));
    return all;
  }
  /// Runs the program to its end.
  ProcessEnd run(std::vector<std::string> arguments, Environment environment = {}) const {
    environment.try_emplace("OMP_WAIT_POLICY", "passive");
    return Process(command(std::move(arguments)), folder.path(), environment).wait(patience);
  }
  nlohmann::json summary(const std::string& results) const {
    return nlohmann::json::parse(readText(folder.path() / results / "summary.json"));
  }
  std::string digest(const std::string& results) const { return summary(results)["stateDigest"]; }
  bool exists(const std::string& path) const { return std::filesystem::exists(folder.path() / path); }
  /// Names and contents of the files of a results folder, but for the lock, which holds a process's id.
  std::map<std::string, std::string> contents(const std::string& results) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path() / results))
      if (entry.is_regular_file() && entry.path().filename() != ".restenosisFoam")
        files[entry.path().string()] = readText(entry.path());
    return files;
  }

  TemporaryFolder folder;
};

#define EXPECT_EXIT_STATUS(end, expected) EXPECT_EQ((end).status, (expected)) << toString(end)
#define ASSERT_EXIT_STATUS(end, expected) ASSERT_EQ((end).status, (expected)) << toString(end)

}  // namespace restenosis
