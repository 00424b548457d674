#include "bridge/flow/FlowParameters.h"

#include <array>
#include <numbers>

#include "bridge/flow/CoronaryWaveforms.h"
#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/OutletTable.h"
#include "bridge/flow/TubeFlow.h"
#include "tissue/parameters/NamedTable.h"

namespace restenosis {
namespace {

constexpr std::string_view byResistance = "resistance";
constexpr std::array drives{
    Named<FlowConditions::Drive>{"flowRate", FlowConditions::Drive::flowRate},
    Named<FlowConditions::Drive>{"pressureGradient", FlowConditions::Drive::pressureGradient},
    Named<FlowConditions::Drive>{byResistance, FlowConditions::Drive::flowRate}};

constexpr std::string_view newtonian = "newtonian";
constexpr std::array laws{Named<ViscosityLaw::Kind>{"carreau", ViscosityLaw::Kind::carreau},
                          Named<ViscosityLaw::Kind>{"casson", ViscosityLaw::Kind::casson}};

constexpr std::string_view steady = "none";

std::vector<std::string_view> viscosityNames() {
  std::vector<std::string_view> names{newtonian};
  for (const auto& law : laws) names.push_back(law.name);
  return names;
}

std::vector<std::string_view> waveformNames() {
  std::vector<std::string_view> names{steady};
  for (const std::string_view name : coronaryWaveformNames()) names.push_back(name);
  return names;
}

/// Over the density [m^2/s^2], in developed flow.
double wallStressOfGradient(const FlowParameters& flow, double radius) {
  return flow.pressureGradient * radius / 2 / flow.density;
}

}  // namespace

FlowConditions::Drive FlowParameters::keeps() const { return findNamed(drives, "flow.drive", drive).value; }

void FlowParameters::describe(ParameterVisitor& p) {
  p.choice(backend, flowBackendNames::all(),
           {.key = "backend",
            .source = "model 8",
            .description = "OpenFOAM, lattice Boltzmann, Poiseuille from the local radius, or no flow"});
  p.choice(drive, namesOf(drives),
           {.key = "drive", .source = "model 8", .description = "what stays fixed while the lumen narrows"});
  p.quantity(meanVelocity, {.key = "meanVelocity",
                            .unit = "m/s",
                            .minimum = slowest,
                            .maximum = fastest,
                            .source = "ISR3D",
                            .description = "mean velocity in the undeformed lumen; sets the flow rate"});
  p.quantity(pressureGradient,
             {.key = "pressureGradient",
              .unit = "Pa/m",
              .minimum = 0,
              .maximum = 1e7,
              .source = "8 mu U / R^2",
              .description = "pressure lost along the vessel, for drive = \"pressureGradient\""});
  p.quantity(
      perfusionPressure,
      {.key = "perfusionPressure",
       .unit = "mmHg",
       .minimum = 0,
       .maximum = 1000,
       .minimumAllowed = false,
       .source = "a mean arterial pressure of 95 mmHg, a venous one of 5",
       .description = "pressure lost along vessel and small vessels behind it, for drive = \"resistance\""});
  p.quantity(
      distalResistance,
      {.key = "distalResistance",
       .unit = "mmHg min/ml",
       .minimum = 0,
       .maximum = 1e6,
       .source = "perfusionPressure / flow rate of meanVelocity",
       .description = "of the small vessels behind the vessel, for drive = \"resistance\"; 0: the one named "
                      "as its source"});
  p.quantity(density, {.key = "density",
                       .unit = "kg/m^3",
                       .minimum = 1,
                       .maximum = 20000,
                       .source = "ISR3D",
                       .description = "density of blood"});
  p.quantity(kinematicViscosity, {.key = "kinematicViscosity",
                                  .unit = "m^2/s",
                                  .minimum = 1e-8,
                                  .maximum = 1,
                                  .source = "ISR3D",
                                  .description = "kinematic viscosity of Newtonian blood"});
  p.choice(
      viscosity, viscosityNames(),
      {.key = "viscosity",
       .source = "assumed",
       .description = "Newtonian blood, or how its viscosity falls with the shear rate: Carreau's law or "
                      "Casson's"});
  const auto viscous = [&](double& value, const char* key, const char* source, const char* description) {
    p.quantity(value, {.key = key,
                       .unit = "Pa s",
                       .minimum = 0,
                       .maximum = 100,
                       .minimumAllowed = false,
                       .source = source,
                       .description = description});
  };
  viscous(zeroShearViscosity, "zeroShearViscosity", "Cho and Kensey 1991",
          "viscosity at rest: of Carreau's law, and the most of Casson's");
  viscous(infiniteShearViscosity, "infiniteShearViscosity", "Cho and Kensey 1991",
          "viscosity at infinite shear, of Carreau's law");
  p.quantity(carreauTime, {.key = "carreauTime",
                           .unit = "s",
                           .minimum = 0,
                           .maximum = 1e6,
                           .source = "Cho and Kensey 1991",
                           .description = "time constant of Carreau's law"});
  p.quantity(carreauIndex, {.key = "carreauIndex",
                            .minimum = 0,
                            .maximum = 1,
                            .minimumAllowed = false,
                            .source = "Cho and Kensey 1991",
                            .description = "power of Carreau's law: 1 does not thin"});
  viscous(cassonViscosity, "cassonViscosity", "Fournier 2011",
          "viscosity at infinite shear, of Casson's law");
  p.quantity(yieldStress, {.key = "yieldStress",
                           .unit = "Pa",
                           .minimum = 0,
                           .maximum = 100,
                           .source = "Fournier 2011",
                           .description = "stress below which blood does not shear, of Casson's law"});
  p.choice(waveform, waveformNames(),
           {.key = "waveform",
            .source = "docs/model/beats.md",
            .description =
                "how the flow rate of a heart beat goes about its mean: not at all, or as measured in a "
                "left or right coronary artery; foam only"});
  p.file(waveformFile,
         {.key = "waveformFile",
          .source = "none",
          .description = "another waveform: a table with the columns time (s) and flowRate (any unit) "
                         "over one beat"});
  p.integer(beats, {.key = "beats",
                    .minimum = 2,
                    .maximum = 100,
                    .source = "docs/results/beats.md",
                    .description = "heart beats that are solved; the stress is that of the last"});
  p.choice(stressMeasure, {"mean", "steady"},
           {.key = "stressMeasure",
            .source = "assumed",
            .description =
                "of a beating flow, the stress that cells feel: the mean over the beat (TAWSS), or that of "
                "steady flow at the mean flow rate"});
  p.file(outlets, {.key = "outlets",
                   .source = "none",
                   .description =
                       "several outlets of a lumen without tissue: a table with the columns solid, and share "
                       "(of the flow rate) or resistance (of what lies behind, Pa s/m^3); foam only"});
  p.quantity(
      straightEnds,
      {.key = "straightEnds",
       .unit = "mm",
       .minimum = 0,
       .maximum = 1000,
       .source = "assumed",
       .description = "length of straight tube that the flow is solved in before the "
                      "lumen's inlet and behind its outlet; of a bent vessel they go on along the arc"});
  p.choice(crossCheck, flowBackendNames::crossChecks(),
           {.key = "crossCheck",
            .source = "assumed",
            .description = "another method, or the same with the finest cells, that solves some of the flows "
                           "too; the state does not depend on it"});
  p.quantity(crossCheckShare,
             {.key = "crossCheckShare",
              .minimum = 0,
              .maximum = 10,
              .source = "assumed",
              .description = "time for cross-checks, over that of the flow; the first and the "
                             "last solve are checked in any case"});
  p.quantity(crossCheckLimit, {.key = "crossCheckLimit",
                               .minimum = 0,
                               .maximum = 10,
                               .source = "assumed",
                               .description = "relative difference of the mean stress on smooth wall, near "
                                              "struts or on struts beyond which it is said"});
}

bool FlowParameters::isCrossChecked() const {
  return crossCheck != flowBackendNames::none && backend != flowBackendNames::none;
}

std::optional<DistalBed> FlowParameters::distal(double lumenDiameter) const {
  if (drive != byResistance) return std::nullopt;
  const double usual = meanVelocity * std::numbers::pi * lumenDiameter * lumenDiameter / 4;
  return DistalBed{.resistance = distalResistance > 0 ? distalResistance : perfusionPressure / usual,
                   .pressure = perfusionPressure};
}

double FlowParameters::givenFlowRate(double lumenDiameter) const {
  if (const auto behind = distal(lumenDiameter)) return behind->pressure / behind->resistance;
  return meanVelocity * std::numbers::pi * lumenDiameter * lumenDiameter / 4.0;
}

double FlowParameters::drivenVelocity(double lumenDiameter) const {
  const double radius = lumenDiameter / 2;
  if (const auto law = thinning(); law && pressureGradient > 0)
    return TubeFlow::ofWallStress(*law, wallStressOfGradient(*this, radius), radius).flowRate() /
           (std::numbers::pi * radius * radius);
  return pressureGradient * radius * radius / (8 * density * kinematicViscosity);
}

std::vector<Outlet> FlowParameters::outletsOfTable() const {
  return outlets.empty() ? std::vector<Outlet>() : readOutlets(outlets);
}

std::optional<Beating> FlowParameters::beating() const {
  if (!isBeating()) return std::nullopt;
  const auto points = waveformFile.empty() ? coronaryWaveform(waveform) : readWaveform(waveformFile);
  return Beating{.waveform = waveformThrough(points),
                 .beats = static_cast<int>(beats),
                 .meanStress = stressMeasure == "mean"};
}

std::optional<ViscosityLaw> FlowParameters::thinning() const {
  if (viscosity == newtonian) return std::nullopt;
  const auto kind = findNamed(laws, "flow.viscosity", viscosity).value;
  return ViscosityLaw{
      .kind = kind,
      .zeroShear = zeroShearViscosity / density,
      .infiniteShear =
          (kind == ViscosityLaw::Kind::carreau ? infiniteShearViscosity : cassonViscosity) / density,
      .time = carreauTime,
      .index = carreauIndex,
      .yieldStress = yieldStress / density};
}

double FlowParameters::wallViscosity(double lumenDiameter) const {
  const auto law = thinning();
  if (!law) return kinematicViscosity;
  const double radius = lumenDiameter / 2;
  if (keeps() == FlowConditions::Drive::pressureGradient)
    return (*law)(law->shearRateAt(wallStressOfGradient(*this, radius)));
  return (*law)(TubeFlow::ofFlowRate(*law, givenFlowRate(lumenDiameter), radius).wallShearRate());
}

double FlowParameters::reynoldsNumber(double lumenDiameter) const {
  const double velocity =
      keeps() == FlowConditions::Drive::flowRate
          ? givenFlowRate(lumenDiameter) / (std::numbers::pi * lumenDiameter * lumenDiameter / 4)
          : drivenVelocity(lumenDiameter);
  return velocity * lumenDiameter / wallViscosity(lumenDiameter);
}

FlowConditions FlowParameters::conditions(double lumenDiameter) const {
  return {.drive = keeps(),
          .flowRate = givenFlowRate(lumenDiameter),
          .pressureGradient = pressureGradient,
          .density = density,
          .kinematicViscosity = wallViscosity(lumenDiameter),
          .thinning = thinning(),
          .distal = distal(lumenDiameter)};
}

}  // namespace restenosis
