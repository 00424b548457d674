#include "bridge/app/ReportCommand.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "bridge/app/ExitStatus.h"
#include "bridge/app/OptionChecks.h"
#include "bridge/app/StopRequest.h"
#include "bridge/output/Figures.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostNames = 3;  ///< in the name of a page

struct ReportArguments {
  std::vector<std::string> folders;
  std::string page;
  bool animation = false;
};

bool isRun(const fs::path& folder) {
  return fs::exists(folder / "summary.json") || fs::exists(folder / "timeSeries.csv");
}

bool isStudy(const fs::path& folder) { return fs::is_directory(folder / "runs") && !isRun(folder); }

/// What keeps a folder from being reported on; empty where nothing is known to.
std::string problemOf(const fs::path& folder) {
  if (!fs::exists(folder)) return "there is no such folder";
  if (!fs::is_directory(folder)) return "is a file; the results folder of a run or a study is expected";
  if (isRun(folder) || isStudy(folder)) return "";
  return "holds no results: neither summary.json nor timeSeries.csv of a run, nor runs/ of a study";
}

std::string nameOf(const fs::path& folder) {
  return (fs::absolute(folder).lexically_normal() / "").parent_path().filename().string();
}

/// report.html of one folder; of several a page beside the first, with their names.
fs::path defaultPage(const std::vector<fs::path>& folders) {
  if (folders.size() == 1) return folders.front() / "report.html";
  std::string name = "report";
  for (std::size_t n = 0; n < std::min(folders.size(), mostNames); ++n)
    name.append("-").append(nameOf(folders[n]));
  if (folders.size() > mostNames) name += fmt::format("-and-{}-more", folders.size() - mostNames);
  return (fs::absolute(folders.front()).lexically_normal() / "").parent_path().parent_path() /
         (name + ".html");
}

/// What keeps a page from being written there; empty where nothing is known to.
std::string problemOfPage(const fs::path& page) {
  if (fs::is_directory(page)) return "is a folder; the file for the page is expected, such as report.html";
  const fs::path parent = fs::absolute(page).parent_path();
  return fs::is_directory(parent) ? "" : fmt::format("there is no folder {}", parent.string());
}

/// A run that was interrupted, or killed, has no pictures yet.
bool lacksPictures(const fs::path& run) {
  return fs::exists(run / "tissue.pvd") && !fs::exists(run / "vessel.png") &&
         !fs::exists(run / "section.png");
}

/// Draws the vessel day by day.
int animate(const fs::path& run, const Figures& figures, const std::atomic<bool>* stopRequested) {
  std::cerr << "drawing the vessel day by day ...\n";
  if (const std::string obstacle = figures.animate(run, stopRequested); !obstacle.empty()) {
    std::cerr << obstacle << '\n';
    return ExitStatus::failed;
  }
  std::cout << fmt::format("{}: open in a browser\n", (run / "animation.gif").string());
  return ExitStatus::done;
}

int report(const ReportArguments& arguments) {
  std::vector<fs::path> folders(arguments.folders.begin(), arguments.folders.end());
  bool wrong = false;
  for (const fs::path& folder : folders) {
    if (const std::string problem = problemOf(folder); !problem.empty()) {
      std::cerr << fmt::format("{}: {}\n", folder.string(), problem);
      wrong = true;
    }
  }
  if (arguments.animation) {
    for (const fs::path& folder : folders) {
      if (fs::exists(folder / "tissue.pvd")) continue;
      std::cerr << fmt::format("--animation: {} has no tissue: there is no tissue.pvd\n", folder.string());
      wrong = true;
    }
  }
  if (wrong) return ExitStatus::wrongInput;
  const fs::path page = arguments.page.empty() ? defaultPage(folders) : fs::path(arguments.page);
  if (const std::string problem = problemOfPage(page); !problem.empty()) {
    std::cerr << fmt::format("-o {}: {}\n", page.string(), problem);
    return ExitStatus::wrongInput;
  }
  const std::atomic<bool>* const stopRequested = &stopOnSignals();
  const Figures figures;
  if (folders.size() == 1 && lacksPictures(folders.front())) {
    std::cerr << "drawing the run's pictures ...\n";
    if (const std::string obstacle = figures.draw(folders.front(), stopRequested); !obstacle.empty())
      std::cerr << obstacle << '\n';
  }
  if (const std::string obstacle = figures.writePage(folders, page, stopRequested); !obstacle.empty()) {
    std::cerr << obstacle << '\n';
    return ExitStatus::failed;
  }
  std::cout << fmt::format("{}: open in a browser\n", page.string());
  int status = ExitStatus::done;
  if (arguments.animation)
    for (const fs::path& folder : folders) status = std::max(status, animate(folder, figures, stopRequested));
  return status;
}

}  // namespace

void addReportCommand(CLI::App& app, int& status) {
  auto* command = app.add_subcommand(
      "report", "write the page of a run again, or one of several runs and studies side by side");
  auto arguments = std::make_shared<ReportArguments>();
  command->add_option("DIR", arguments->folders, "results folders of runs, or of studies")
      ->required()
      ->check(notEmpty("the results folder of a run or a study"));
  command
      ->add_option("-o,--output", arguments->page,
                   "file for the page (default: report.html in the folder; of several, a page beside the "
                   "first, with their names)")
      ->check(notEmpty("a file, or no such option for the default"));
  command->add_flag("--animation", arguments->animation,
                    "animation.gif in each folder too: the vessel cut open, day by day (minutes)");
  command->callback([arguments, &status] { status = report(*arguments); });
}

}  // namespace restenosis
