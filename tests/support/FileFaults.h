#pragma once

#include <filesystem>
#include <set>

#include "tests/support/WholeProgram.h"

namespace restenosis {

/// A ring in a vessel of 800 agents, packed, deployed, injured and grown for three steps, with flow
/// and every file that a run writes.
inline constexpr std::string_view shortScene = R"([scene]
title = "Short"
duration = "6 h"
step = "2 h"
[vessel]
length = "0.21 mm"
lumenDiameter = "0.2 mm"
wallThickness = "0.105 mm"
cellRadius = "17 um"
[stent]
design = "ring"
strutWidth = "0.04 mm"
strutThickness = "0.04 mm"
deploymentDepth = "10 um"
deploymentSteps = 1
[injury]
denudation = "none"
removeIel = true
synthetic = "all"
[mechanics]
[cellCycle]
[endothelium]
scenario = "fast"
[flow]
backend = "analytic"
[output]
interval = "6 h"
checkpointInterval = "4 h"
pictures = false
)";

/// Operations on files are counted by a library that is loaded into the program, and one is met by a fault.
class FileFaults : public WholeProgram {
 protected:
  /// The environment in which the program's `at`-th operation below `results` meets a fault.
  Environment faulty(const std::string& results, const std::string& kind, std::size_t at) const {
    return {{"LD_PRELOAD", RESTENOSIS_FAULTY_FILES},
            {"FAULTY_FILES_PROGRAM", RESTENOSIS_PROGRAM},
            {"FAULTY_FILES_UNDER", (std::filesystem::canonical(folder.path()) / results).string()},
            {"FAULTY_FILES_LOG", (folder / "operations").string()},
            {"FAULTY_FILES_KIND", kind},
            {"FAULTY_FILES_AT", std::to_string(at)}};
  }
  /// What the program has done since this was last asked, an operation a line: its name and the file's.
  std::vector<std::string> operations() const {
    std::istringstream lines(readText(folder / "operations"));
    std::filesystem::remove(folder / "operations");
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) all.push_back(line);
    return all;
  }
  std::vector<std::string> start(const std::string& results, bool resume) const {
    std::vector<std::string> arguments = {"run", "short.toml", "-o", results, "--threads", "1"};
    if (resume) arguments.emplace_back("--resume");
    return arguments;
  }
  /// Every file's content by its place in the results. What tells of times is left out: the checkpoint, logs,
  /// and of summary.json the costs, where and when it ran, and the forces that a resumed run computes again.
  std::map<std::string, std::string> lasting(const std::string& results) const {
    std::map<std::string, std::string> files;
    for (const auto& [path, text] : contents(results))
      files[std::filesystem::path(path).lexically_relative(folder / results)] = text;
    files.at("checkpoint/state.bin").clear();
    for (auto& [name, text] : files)
      if (std::filesystem::path(name).filename().string().starts_with("log.")) text.clear();
    auto numbers = nlohmann::json::parse(files.at("summary.json"));
    for (const char* cost : {"parts", "totalSeconds", "relaxation", "provenance"}) numbers.erase(cost);
    files["summary.json"] = numbers.dump();
    return files;
  }
  /// The names at which two sets of files differ.
  static std::set<std::string> differing(const std::map<std::string, std::string>& a,
                                         const std::map<std::string, std::string>& b) {
    std::set<std::string> names;
    for (const auto* files : {&a, &b})
      for (const auto& [name, text] : *files)
        if (!a.contains(name) || !b.contains(name) || a.at(name) != b.at(name)) names.insert(name);
    return names;
  }
  /// A message names the file that an operation failed at, or the folder that it is in; of an OpenFOAM case,
  /// the case.
  static bool names(const std::string& message, const std::string& operation) {
    std::filesystem::path file = operation.substr(operation.find(' ') + 1);
    if (file.extension() == ".partial") file.replace_extension();
    const std::string::size_type inCase = file.string().find(".partial/");
    return message.find(file.filename()) != std::string::npos ||
           message.find(file.parent_path().filename()) != std::string::npos ||
           (inCase != std::string::npos &&
            message.find(file.string().substr(0, inCase)) != std::string::npos);
  }

  /// Runs the scene "short" once for every `stride`-th operation, which meets a fault, and goes on with it:
  /// it is to end as the whole run.
  void expectEveryFaultMended(const std::string& kind, std::size_t stride = 1) const {
    ASSERT_EXIT_STATUS(run(start("out", false), faulty("out", "", 0)), 0);
    const auto whole = lasting("out");
    const auto all = operations();
    std::filesystem::remove_all(folder / "out");
    ASSERT_GT(all.size(), 100U);
    std::size_t met = 0, failed = 0;
    for (std::size_t n = 1; n <= all.size(); n += stride) {
      const std::string& operation = all[n - 1];
      if (kind == "torn" && !operation.starts_with("write")) continue;  // it is as if killed before the next
      SCOPED_TRACE(std::to_string(n) + ": " + operation);
      const ProcessEnd end = run(start("out", false), faulty("out", kind, n));
      ++met;
      if (kind != "fail") {
        EXPECT_EQ(end.signal, SIGKILL) << toString(end);
      } else if (end.status != 0) {
        // Where not even the folder can be made, the command line is what is wrong
        EXPECT_EXIT_STATUS(end, end.err.find("choose another folder") != std::string::npos ? 2 : 1);
        EXPECT_TRUE(names(end.err, operation)) << toString(end);
        ++failed;
      }
      if (end.status != 0) {
        ASSERT_EXIT_STATUS(run(start("out", true)), 0);
      }
      ASSERT_EQ(differing(lasting("out"), whole), std::set<std::string>());
      std::filesystem::remove_all(folder / "out");
      std::filesystem::remove(folder / "operations");
    }
    EXPECT_GT(met, 20U);
    if (kind == "fail") {
      EXPECT_GT(failed, met * 2 / 3);
    }
  }
};

}  // namespace restenosis
