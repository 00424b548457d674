#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "bridge/flow/FlowParameters.h"
#include "bridge/flow/foam/FoamSettings.h"
#include "bridge/flow/lbm/LbmSettings.h"
#include "bridge/scene/RunParameters.h"
#include "bridge/surface/LumenCap.h"
#include "tissue/biology/ActivationParameters.h"
#include "tissue/biology/CellCycleParameters.h"
#include "tissue/biology/ContactInhibitionParameters.h"
#include "tissue/biology/EndotheliumParameters.h"
#include "tissue/biology/ExtracellularMatrixParameters.h"
#include "tissue/equilibrium/RelaxationParameters.h"
#include "tissue/forces/MechanicsParameters.h"
#include "tissue/stent/InjuryParameters.h"
#include "tissue/stent/StentParameters.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {

/// A scene as read: a section that is absent is not modelled. `coupling` and `output` say how, not what, and
/// have defaults throughout.
struct Scene {
  std::string name;  ///< the file's stem
  std::filesystem::path file;
  SceneParameters scene;
  VesselParameters vessel;
  std::optional<StentParameters> stent;
  std::optional<InjuryParameters> injury;
  std::optional<MechanicsParameters> mechanics;
  std::optional<RelaxationParameters> relaxation;  ///< with `mechanics`; its defaults where it is not given
  std::optional<CellCycleParameters> cellCycle;
  std::optional<ActivationParameters> activation;
  std::optional<ExtracellularMatrixParameters> extracellularMatrix;
  std::optional<ContactInhibitionParameters> contactInhibition;
  std::optional<EndotheliumParameters> endothelium;
  std::optional<FlowParameters> flow;
  std::optional<FoamSettings> foam;  ///< where absent, those of `scene.fidelity`
  std::optional<LbmSettings> lbm;    ///< the same
  CouplingParameters coupling;
  OutputParameters output;
  /// What was found in the surface of `vessel.lumenSurface`, a line a part (`lumenParts`).
  std::vector<std::string> lumenParts;
  /// What may be a mistake in the lumen, and keys that are given where they used to be.
  std::vector<std::string> remarks;

  /// Whether there is a wall of agents; without one the lumen is the vessel's own shape.
  bool hasTissue() const { return mechanics.has_value(); }
  /// How many outlets a loaded lumen may have.
  Outlets outlets() const { return flow && !flow->outlets.empty() ? Outlets::several : Outlets::one; }
  /// Whether the lumen is a surface from a file, which never changes. Around one with tissue a wall is built.
  bool hasLoadedLumen() const { return !hasTissue() && !vessel.lumenSurface.empty(); }
  /// What the backends are given: the sections, or what `scene.fidelity` stands for.
  FoamSettings foamSettings() const { return foam ? *foam : FoamSettings::forFidelity(scene.fidelity); }
  LbmSettings lbmSettings() const { return lbm ? *lbm : LbmSettings::forFidelity(scene.fidelity); }

  /// Calls f(section, present) for every section in the order of the contract; `section` is the parameters,
  /// of a section that is absent as well (with its defaults).
  template <class F>
  void forEachSection(F&& f);

  /// Calls f(section) for the std::optional of every section that may be absent.
  template <class F>
  void forEachOptionalSection(F&& f);
};

template <class F>
void Scene::forEachOptionalSection(F&& f) {
  f(stent);
  f(injury);
  f(mechanics);
  f(relaxation);
  f(cellCycle);
  f(activation);
  f(extracellularMatrix);
  f(contactInhibition);
  f(endothelium);
  f(flow);
  f(foam);
  f(lbm);
}

template <class F>
void Scene::forEachSection(F&& f) {
  auto optional = [&f](auto& section) {
    if (section) {
      f(*section, true);
    } else {
      typename std::remove_reference_t<decltype(section)>::value_type defaults;
      f(defaults, false);
    }
  };
  f(scene, true);
  f(vessel, true);
  forEachOptionalSection(optional);
  f(coupling, true);
  f(output, true);
}

}  // namespace restenosis
