#include "bridge/output/Figures.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

#include "bridge/system/AtomicFile.h"
#include "bridge/system/DataFolder.h"
#include "bridge/system/ExternalProgram.h"

namespace restenosis {

namespace fs = std::filesystem;

namespace {

std::string chosenInterpreter() {
  const char* chosen = std::getenv("RESTENOSIS_PYTHON");
  return chosen != nullptr && *chosen != '\0' ? chosen : "/usr/bin/python3";
}

/// A folder to run in, where what is kept from run to run is this run's alone, and no file of the user's
/// lies; gone with this object.
class OwnFolder {
 public:
  explicit OwnFolder(const fs::path& path) : path_(fs::absolute(path)) {
    fs::remove_all(path_);  // of a run that was killed
    fs::create_directory(path_);
  }
  ~OwnFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Links in the place of what is drawn: it would be written where they lead.
void removeLinks(const fs::path& results) {
  for (const char* picture : {"vessel", "section", "growth", "lumen", "lumen3d", "beats", "compareMaps",
                              "compareScatter", "tradeoff"})
    for (const char* kind : {".png", ".partial.png", ".pdf", ".partial.pdf"})
      removeIfLink(results / (std::string(picture) + kind));
  for (const char* text :
       {"report.html", "report.html.partial", "figures.log", "view.pvsm", "view.pvsm.partial"})
    removeIfLink(results / text);
}

/// The last line of a log that is not empty: where a Python program says what went wrong.
std::string lastLine(const fs::path& log) {
  std::ifstream stream(log);
  std::string last;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) last = line;
  return last;
}

}  // namespace

Figures::Figures() : Figures(chosenInterpreter(), dataFolder() / "figures", std::chrono::seconds(300)) {}

Figures::Figures(std::string interpreter, fs::path script, std::chrono::seconds limit)
    : interpreter_(std::move(interpreter)), script_(std::move(script)), limit_(limit) {}

std::string Figures::draw(const fs::path& results, const std::atomic<bool>* stopRequested) const {
  try {
    removeLinks(results);
  } catch (const std::runtime_error& error) {
    return fmt::format("no pictures: {}", error.what());
  }
  return run({.what = "pictures",
              .incomplete = "not all pictures were drawn",
              .arguments = {fs::absolute(results)},
              .folder = results / ".figures",
              .log = results / "figures.log",
              .keepsLog = true},
             stopRequested);
}

std::string Figures::animate(const fs::path& results, const std::atomic<bool>* stopRequested) const {
  const Task task{.what = "animation",
                  .incomplete = "the animation was not drawn",
                  .arguments = {"--animation", fs::absolute(results)},
                  .folder = results / ".figures",
                  .log = results / "animation.log",
                  .longer = 6};
  try {
    for (const char* file : {"animation.gif", "animation.partial.gif", "animation.log"})
      removeIfLink(results / file);
  } catch (const std::runtime_error& error) {
    return fmt::format("no animation: {}", error.what());
  }
  return run(task, stopRequested);
}

std::string Figures::writePage(std::span<const fs::path> results, const fs::path& page,
                               const std::atomic<bool>* stopRequested) const {
  const std::string name = page.string();
  Task task{.what = "page",
            .incomplete = "the page was not written",
            .arguments = {"--page", fs::absolute(page)},
            .folder = name + ".figures",
            .log = name + ".log"};
  for (const fs::path& folder : results) task.arguments.push_back(fs::absolute(folder));
  try {
    for (const fs::path& file : {page, fs::path(name + ".partial"), task.log}) removeIfLink(file);
  } catch (const std::runtime_error& error) {
    return fmt::format("no page: {}", error.what());
  }
  return run(task, stopRequested);
}

std::string Figures::run(const Task& task, const std::atomic<bool>* stopRequested) const {
  std::string reason;
  try {
    const OwnFolder own(task.folder);
    ExternalProgram python(interpreter_);
    const std::chrono::seconds limit = task.longer * limit_;
    python.stopWhen(stopRequested).stopAfter(limit);
    for (const char* variable : {"MPLCONFIGDIR", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"})
      python.setEnvironment(variable, own.path());
    python.withoutEnvironment(
        [](std::string_view variable) { return variable == "MATPLOTLIBRC" || variable.starts_with("MPL"); });
    // -I: nothing that the user has set or installed for other programs; -B: no compiled files beside the
    // script, which lies in the user's source tree
    std::vector<std::string> words{"-I", "-B", "-X", "utf8", fs::absolute(script_)};
    words.insert(words.end(), task.arguments.begin(), task.arguments.end());
    const ProgramExit end = python.run(words, own.path(), task.log);
    if (end.interrupted()) return fmt::format("{} given up: interrupted", task.what);
    if (end.late)
      return fmt::format("{} given up after {} s; see {}", task.what, limit.count(), task.log.string());
    if (end.succeeded()) {
      std::error_code ignored;
      if (!task.keepsLog) fs::remove(task.log, ignored);
      return "";
    }
    reason = lastLine(task.log);
    if (reason.empty()) reason = fmt::format("{}: {}", interpreter_, end.describe());
  } catch (const ProgramMissing& error) {
    return fmt::format("no {}: {} (install python3, or name another with RESTENOSIS_PYTHON)", task.what,
                       error.what());
  } catch (const std::runtime_error& error) {
    return fmt::format("no {}: {}", task.what, error.what());
  }
  return fmt::format("{}: {} (see {})", task.incomplete, reason, task.log.string());
}

}  // namespace restenosis
