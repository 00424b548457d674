#include "VesselValidation.h"

#include <fmt/format.h>

#include "AgentCounts.h"
#include "AgentTable.h"
#include "StentDesign.h"

namespace restenosis {
namespace {

constexpr double mm = 1e-3, um = 1e-6;

class Validation {
 public:
  std::vector<ParameterProblem> problems;

  void checkVessel(const VesselParameters& v) {
    if (!v.agents.empty() && !v.lumenSurface.empty()) {
      add("vessel.lumenSurface", "a vessel is made of 'agents' or has a 'lumenSurface', not both");
    }
    if (v.length <= 2 * v.fixedEnds * v.cellRadius) {
      add("vessel.length",
          fmt::format(
              "{:.4g} mm is no longer than the two fixed ends of {:.4g} cell radii (together {:.4g} mm); "
              "make it longer, or vessel.fixedEnds smaller",
              v.length / mm, v.fixedEnds, 2 * v.fixedEnds * v.cellRadius / mm));
    }
    if (v.stenosis > 0 && v.stenosisLength > v.length) {
      add("vessel.stenosisLength", fmt::format("{:.4g} mm is longer than the vessel ({:.4g} mm)",
                                               v.stenosisLength / mm, v.length / mm));
    }
    if (!v.agents.empty()) {
      checkTable("vessel.agents", v.agents, AgentKind::smc);
    } else {
      try {
        countAgents(v);
      } catch (const std::invalid_argument& error) {
        add("vessel.wallThickness", error.what());
      }
    }
  }

  void checkStent(const StentParameters& s, const VesselParameters& v) {
    checkDepth(s, v);
    if (!s.file.empty()) {
      checkStentTable(s, v);
      return;
    }
    if (s.strutThickness >= v.lumenDiameter / 2) {
      add("stent.strutThickness",
          fmt::format("a strut {:.4g} mm thick does not fit a lumen of radius {:.4g} mm (half of "
                      "vessel.lumenDiameter); allowed is less",
                      s.strutThickness / mm, v.lumenDiameter / 2 / mm));
    }
    if (!stentDesign(s.design).spansLength) {
      if (s.strutWidth > v.length) {
        add("stent.strutWidth", fmt::format("a strut {:.4g} mm wide does not fit a vessel of {:.4g} mm",
                                            s.strutWidth / mm, v.length / mm));
      }
      return;
    }
    if (s.length > v.length) {
      add("stent.length",
          fmt::format("a stent of {:.4g} mm is longer than the vessel ({:.4g} mm); allowed is "
                      "at most vessel.length",
                      s.length / mm, v.length / mm));
    }
    checkLayout(s);
  }

 private:
  void add(std::string key, std::string message) { problems.push_back({std::move(key), std::move(message)}); }

  bool checkTable(const std::string& key, const std::string& file, AgentKind defaultKind) {
    try {
      readAgentTable(file, defaultKind);
      return true;
    } catch (const AgentTableError& error) {
      add(key, error.what());
      return false;
    }
  }

  void checkDepth(const StentParameters& s, const VesselParameters& v) {
    const double deepest = v.wallThickness - 2 * v.cellRadius;
    if (s.deploymentDepth > deepest) {
      add("stent.deploymentDepth",
          fmt::format(
              "{:.4g} um is beyond the wall: at most {:.4g} um leave the EEL (vessel.wallThickness less "
              "a cell's diameter)",
              s.deploymentDepth / um, deepest / um));
    }
  }

  void checkStentTable(const StentParameters& s, const VesselParameters& v) {
    if (!checkTable("stent.file", s.file, AgentKind::strut)) return;
    const AgentStore table = readAgentTable(s.file, AgentKind::strut).agents;
    for (Index i = 0; i < table.size(); ++i) {
      if (table.z[i] >= 0 && table.z[i] <= v.length) continue;
      add("stent.file",
          fmt::format("{}: the strut agent at z = {:.4g} um lies outside the vessel (0 to {:.4g} um)", s.file,
                      table.z[i] / um, v.length / um));
      return;
    }
  }

  void checkLayout(const StentParameters& s) {
    const bool sinusoidal = s.design == "biodivysio";
    const double extent = s.strutWidth + (sinusoidal ? 2 * s.ringAmplitude : 0.0);
    if (s.design == "helix") {
      if (s.strutWidth * s.helixTurns > s.length - s.strutWidth) {
        add("stent.helixTurns", fmt::format("{:.4g} turns of a strut {:.4g} mm wide overlap on {:.4g} mm",
                                            s.helixTurns, s.strutWidth / mm, s.length / mm));
      }
    } else if (extent * static_cast<double>(s.ringCount) > s.length) {
      add("stent.ringCount",
          fmt::format("{} rings, each {:.4g} mm along the vessel, do not fit a stent of {:.4g} mm",
                      s.ringCount, extent / mm, s.length / mm));
    }
    if (sinusoidal && s.linkCount > s.ringWaves) {
      add("stent.linkCount", fmt::format("{} links need as many crests, but a ring has {} (stent.ringWaves)",
                                         s.linkCount, s.ringWaves));
    }
  }
};

}  // namespace

std::vector<ParameterProblem> validate(const VesselParameters& vessel, const StentParameters* stent) {
  Validation validation;
  validation.checkVessel(vessel);
  if (stent) validation.checkStent(*stent, vessel);
  return std::move(validation.problems);
}

}  // namespace restenosis
