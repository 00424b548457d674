#include <fmt/format.h>
#include <vtkObject.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/app/BenchCommand.h"
#include "bridge/app/CheckCommand.h"
#include "bridge/app/CompareCommand.h"
#include "bridge/app/ExitStatus.h"
#include "bridge/app/ProcessSetup.h"
#include "bridge/app/ReportCommand.h"
#include "bridge/app/RunCommand.h"
#include "bridge/app/SchemaCommand.h"
#include "bridge/app/StandardOutput.h"
#include "bridge/app/TradeoffCommand.h"
#include "bridge/output/Version.h"
#include "bridge/system/PrintableOutput.h"
#include "tissue/parameters/NearestName.h"
#include "tissue/parameters/Shown.h"

namespace {

/// What is said of a command that there is not; empty if it is one, or none is given: CLI11 speaks of missing
/// ones only.
std::string commandProblem(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || *argv[1] == '-') return {};
  std::vector<std::string_view> names;
  for (const CLI::App* command : app.get_subcommands({})) names.emplace_back(command->get_name());
  const std::string_view given = argv[1];
  if (std::ranges::find(names, given) != names.end()) return {};
  return fmt::format("unknown command {}{}\n", restenosis::shown(given),
                     restenosis::suggestion(given, names));
}

/// Does what the command line asks for; returns the exit status.
int runCommand(int argc, char** argv) {
  using namespace restenosis;
  CLI::App app{"restenosisFoam grows tissue in a stented artery, coupled to OpenFOAM."};
  app.set_version_flag("--version", fmt::format("restenosisFoam {}", version()));
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::help);
  int status = ExitStatus::done;
  addRunCommand(app, status, std::span<const char* const>(argv, static_cast<std::size_t>(argc)));
  addCheckCommand(app, status);
  addCompareCommand(app, status);
  addTradeoffCommand(app, status);
  addReportCommand(app, status);
  addSchemaCommand(app, status);
  addBenchCommand(app, status);
  if (argc == 1) {
    std::cout << app.help();
    return ExitStatus::wrongInput;
  }
  if (const std::string problem = commandProblem(app, argc, argv); !problem.empty()) {
    std::cerr << problem;
    return ExitStatus::wrongInput;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // --help and --version end here as well, with status 0.
    return app.exit(error) == 0 ? ExitStatus::done : ExitStatus::wrongInput;
  } catch (const std::exception& error) {
    // Of what a command does before or beside its work, as reading the tables of units
    std::cerr << error.what() << '\n';
    return ExitStatus::failed;
  }
  return status;
}

}  // namespace

/// The program: `restenosisFoam COMMAND`. Exit status: 0 done, 1 the run failed, 2 the input is wrong.
int main(int argc, char** argv) {
  using namespace restenosis;
  setUpProcess();
  const PrintableOutput printableOutput;
  vtkObject::GlobalWarningDisplayOff();  // a file that VTK cannot read is named in our own words
  return statusWithOutput(runCommand(argc, argv));
}
