#include "bridge/scene/FlowChecks.h"

#include <fmt/format.h>

#include <numbers>

#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/OutletTable.h"

namespace restenosis {
namespace {

Finding driveWithoutGradient(const Scene& s, const Units&) {
  if (!s.flow || s.flow->drive != "pressureGradient") return {};
  const double velocity = s.flow->drivenVelocity(s.vessel.lumenDiameter);
  if (velocity >= FlowParameters::slowest) return {};
  if (s.flow->pressureGradient > 0)
    return fmt::format(
        "'pressureGradient' in [flow] drives {:.3g} m/s through the lumen; allowed is what drives "
        "at least {:g} m/s",
        velocity, FlowParameters::slowest);
  return "'pressureGradient' in [flow] is 0, so nothing flows with drive = \"pressureGradient\"; take [flow] "
         "out "
         "instead";
}

Finding distalFlow(const Scene& s, const Units&) {
  if (!s.flow) return {};
  const auto distal = s.flow->distal(s.vessel.lumenDiameter);
  if (!distal) return {};
  const double radius = s.vessel.lumenDiameter / 2;
  const double velocity =
      s.flow->givenFlowRate(s.vessel.lumenDiameter) / (std::numbers::pi * radius * radius);
  if (velocity >= FlowParameters::slowest && velocity <= FlowParameters::fastest) return {};
  return fmt::format(
      "'distalResistance' in [flow] lets {:.3g} m/s through the lumen at 'perfusionPressure'; allowed are "
      "{:g} to "
      "{:g} m/s",
      velocity, FlowParameters::slowest, FlowParameters::fastest);
}

Finding crossCheckByItself(const Scene& s, const Units&) {
  if (!s.flow || !s.flow->isCrossChecked()) return {};
  const FlowParameters& flow = *s.flow;
  if (flow.crossCheck == flow.backend)
    return fmt::format(
        "'crossCheck' in [flow] is \"{}\", the backend itself; allowed is another one, or \"reference\"",
        flow.crossCheck);
  if (flow.crossCheck != flowBackendNames::reference) return {};
  if (flow.backend == flowBackendNames::analytic)
    return "'crossCheck' in [flow] is \"reference\", but backend = \"analytic\" has no cells to make finer; "
           "allowed are \"lbm\" and \"foam\"";
  const bool ownCells = flow.backend == flowBackendNames::foam ? s.foam.has_value() : s.lbm.has_value();
  if (s.scene.fidelity != flowBackendNames::reference || ownCells) return {};
  return "'crossCheck' in [flow] is \"reference\", the scene's own fidelity; allowed is the other backend";
}

Finding thinningBlood(const Scene& s, const Units&) {
  if (!s.flow || !s.flow->thinning()) return {};
  const FlowParameters& flow = *s.flow;
  if (flow.backend == flowBackendNames::analytic)
    return fmt::format(
        "'viscosity' in [flow] is \"{}\", which backend = \"analytic\" cannot solve; allowed are "
        "\"foam\" and \"lbm\"",
        flow.viscosity);
  if (flow.thinning()->infiniteShear > flow.thinning()->zeroShear)
    return "'zeroShearViscosity' in [flow] is below the viscosity at infinite shear: blood thins, it does "
           "not thicken";
  return {};
}

Finding beatingFlow(const Scene& s, const Units&) {
  if (!s.flow || !s.flow->isBeating()) return {};
  const FlowParameters& flow = *s.flow;
  const std::string_view key = flow.waveformFile.empty() ? "waveform" : "waveformFile";
  if (!flow.waveformFile.empty() && flow.waveform != "none")
    return fmt::format("'waveformFile' in [flow] is a waveform, and so is \"{}\"; take one of them out",
                       flow.waveform);
  if (flow.backend != flowBackendNames::foam)
    return fmt::format(
        "'{}' in [flow] makes the flow beat, which backend = \"{}\" cannot solve; allowed is \"foam\"", key,
        flow.backend);
  if (flow.keeps() != FlowConditions::Drive::flowRate)
    return fmt::format(
        "'{}' in [flow] says how the flow rate beats, but drive = \"{}\" gives none; allowed are "
        "\"flowRate\" and \"resistance\"",
        key, flow.drive);
  if (flow.isCrossChecked())
    return fmt::format(
        "'{}' in [flow] makes the flow beat, and crossCheck = \"{}\" compares steady flows; allowed is "
        "\"none\"",
        key, flow.crossCheck);
  if (flow.waveformFile.empty()) return {};
  try {
    readWaveform(flow.waveformFile);
    return {};
  } catch (const TableError& error) {
    return fmt::format("'waveformFile' in [flow]: {}", error.what());
  }
}

Finding severalOutlets(const Scene& s, const Units&) {
  if (s.outlets() == Outlets::one) return {};
  const FlowParameters& flow = *s.flow;
  if (s.hasTissue())
    return "'outlets' in [flow] is for lumens that branch, around which no tissue is grown; take it or "
           "[mechanics] "
           "out";
  if (s.vessel.lumenSurface.empty())
    return "'outlets' in [flow] is for lumens that branch: those of a 'lumenSurface' in [vessel], which is "
           "not given";
  if (flow.backend != flowBackendNames::foam)
    return fmt::format("'outlets' in [flow] cannot be solved by backend = \"{}\"; allowed is \"foam\"",
                       flow.backend);
  if (flow.drive != "flowRate")
    return fmt::format(
        "'outlets' in [flow] shares out a flow rate, but drive = \"{}\" gives none; allowed is "
        "\"flowRate\"",
        flow.drive);
  if (flow.isBeating())
    return "'outlets' in [flow] shares out a steady flow; take it out, or 'waveform' and 'waveformFile'";
  if (flow.isCrossChecked())
    return fmt::format(
        "'outlets' in [flow] leaves nothing to compare with; crossCheck is \"{}\", allowed is \"none\"",
        flow.crossCheck);
  try {
    flow.outletsOfTable();
    return {};
  } catch (const TableError& error) {
    return fmt::format("'outlets' in [flow]: {}", error.what());
  }
}

}  // namespace

const std::vector<SceneCheck>& flowChecks() {
  static const std::vector<SceneCheck> table = {
      {{"flow.pressureGradient", "flow.drive", "flow.density", "flow.kinematicViscosity", "flow.viscosity",
        "flow.zeroShearViscosity", "flow.infiniteShearViscosity", "flow.carreauTime", "flow.carreauIndex",
        "flow.cassonViscosity", "flow.yieldStress", "vessel.lumenDiameter"},
       driveWithoutGradient},
      {{"flow.distalResistance", "flow.perfusionPressure", "flow.drive", "vessel.lumenDiameter"}, distalFlow},
      {{"flow.crossCheck", "flow.backend", "scene.fidelity"}, crossCheckByItself},
      {{"flow.viscosity", "flow.backend", "flow.crossCheck", "flow.density", "flow.zeroShearViscosity",
        "flow.infiniteShearViscosity", "flow.cassonViscosity"},
       thinningBlood},
      {{"flow.waveformFile", "flow.waveform", "flow.backend", "flow.drive", "flow.crossCheck", "flow.beats"},
       beatingFlow},
      {{"flow.outlets", "flow.backend", "flow.drive", "flow.waveform", "flow.waveformFile", "flow.crossCheck",
        "vessel.lumenSurface", "mechanics"},
       severalOutlets},
  };
  return table;
}

}  // namespace restenosis
