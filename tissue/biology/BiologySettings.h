#pragma once

#include <cstdint>
#include <optional>

#include "tissue/biology/ActivationParameters.h"
#include "tissue/biology/CellCycleParameters.h"
#include "tissue/biology/ContactInhibitionParameters.h"
#include "tissue/biology/EndotheliumParameters.h"
#include "tissue/biology/ExtracellularMatrixParameters.h"

namespace restenosis {

/// The sections of a scene on biology. A section that is absent is not modelled: without the cycle nothing
/// divides, without activation synthetic cells leave rest at once, without contact inhibition nothing is
/// inhibited, without endothelium there is no coverage and no nitric oxide.
struct BiologySettings {
  std::optional<CellCycleParameters> cellCycle;
  std::optional<ActivationParameters> activation;
  std::optional<ExtracellularMatrixParameters> extracellularMatrix;
  std::optional<ContactInhibitionParameters> contactInhibition;
  std::optional<EndotheliumParameters> endothelium;
  bool denuded = true;  ///< whether deployment stripped the endothelium; else it covers all from the start
  std::uint64_t seed = 1;
  double step = 3600;       ///< biological step [s]
  double vesselLength = 0;  ///< [m]; 0: no ends
};

}  // namespace restenosis
