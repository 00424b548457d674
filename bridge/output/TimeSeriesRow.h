#pragma once

#include <cstdint>
#include <optional>

#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

/// What is recorded of one step (model 10). SI units; an empty optional is a quantity that is not known, such
/// as WSS before the first flow solve.
struct TimeSeriesRow {
  double time = 0;                              ///< since deployment [s]
  std::uint64_t agents = 0;                     ///< all of them, struts included
  std::uint64_t smc = 0;                        ///< agents of kind smc
  std::uint64_t divisions = 0;                  ///< since deployment
  std::optional<double> neointimaThickness;     ///< mean over the stented section [m]
  std::optional<double> neointimaAreaFraction;  ///< mean over the stented section
  std::optional<double> minLumenArea;           ///< smallest cross-section of the stented stretch [m^2]
  std::optional<double> coverage;               ///< share of exposed synthetic cells that carry endothelium
  std::optional<double> wssMean;                ///< area-weighted over the wall [Pa]
  std::optional<double> wssLowAreaFraction;     ///< share of the wall's area below the arrest threshold
  std::uint64_t flowSolved = 0;                 ///< 1 when the flow was solved since the last row
  std::uint64_t iel = 0, eel = 0;               ///< agents of these kinds
  std::uint64_t g0 = 0, g1 = 0, sg2m = 0;       ///< SMC by phase of the cycle
  std::uint64_t synthetic = 0, inhibited = 0, covered = 0, exposed = 0;  ///< SMC by flag
  std::uint64_t flowSolves = 0;                                          ///< since the start
  std::optional<double> lumenMovement;          ///< 99th percentile, since the last flow solve [m]
  std::optional<double> neointimaThicknessMax;  ///< largest of an axial position [m]
  std::optional<double> wssP5, wssP50, wssP95;  ///< area-weighted percentiles over the wall [Pa]
  std::optional<double> nitricOxideMean;        ///< over covered cells [nmol/mm^3]
  std::optional<double> stressMean;             ///< mean structural stress of the SMC [Pa]
  // As histology measures it (Histology), over the stented section; empty without both laminae.
  std::optional<double> intimaArea, mediaArea;  ///< mean of the sections [m^2]
  std::optional<double> relativeIntimaArea;     ///< intima / (intima + lumen), mean of the sections
  std::optional<double> intimaCells;            ///< smooth muscle cells of the intima
  std::optional<double> intimaInCycle;          ///< share of these in G1 to M
  std::optional<double> intimaMatrixShare;      ///< of the volume of these, what is matrix

  // Of the last flow that another method solved too, in the row after it: that method's stress over the
  // run's own, less 1, and the covered cells that it would have decided otherwise (CrossCheckRecord).
  std::optional<double> crossCheckSmoothMean, crossCheckSmoothL2;
  std::optional<double> crossCheckNearStrutsMean, crossCheckNearStrutsL2;
  std::optional<double> crossCheckStrutsMean, crossCheckStrutsL2;
  std::optional<double> crossCheckDecidedOtherwise;
  std::optional<double> flowRate, pressureDrop;  ///< of the last flow [m^3/s, Pa]

  /// Calls f(column, value, scale) for every column in the order of the file; value times scale is written.
  template <class F>
  void forEachColumn(F&& f) {
    f("day", time, 1.0 / secondsPerDay);
    f("agents", agents, 1.0), f("smc", smc, 1.0), f("divisions", divisions, 1.0);
    f("neointimaThickness_um", neointimaThickness, 1e6);
    f("neointimaAreaFraction", neointimaAreaFraction, 1.0);
    f("minLumenArea_mm2", minLumenArea, 1e6);
    f("coverage", coverage, 1.0);
    f("wssMean_Pa", wssMean, 1.0), f("wssLowAreaFraction", wssLowAreaFraction, 1.0);
    f("flowSolved", flowSolved, 1.0);
    f("iel", iel, 1.0), f("eel", eel, 1.0);
    f("g0", g0, 1.0), f("g1", g1, 1.0), f("sg2m", sg2m, 1.0);
    f("synthetic", synthetic, 1.0), f("inhibited", inhibited, 1.0);
    f("covered", covered, 1.0), f("exposed", exposed, 1.0);
    f("flowSolves", flowSolves, 1.0);
    f("lumenMovement_um", lumenMovement, 1e6);
    f("neointimaThicknessMax_um", neointimaThicknessMax, 1e6);
    f("wssP5_Pa", wssP5, 1.0), f("wssP50_Pa", wssP50, 1.0), f("wssP95_Pa", wssP95, 1.0);
    f("nitricOxideMean_nmolPerMm3", nitricOxideMean, 1.0);
    f("stressMean_Pa", stressMean, 1.0);
    f("intimaArea_mm2", intimaArea, 1e6), f("mediaArea_mm2", mediaArea, 1e6);
    f("relativeIntimaArea", relativeIntimaArea, 1.0);
    f("intimaCells", intimaCells, 1.0), f("intimaInCycle", intimaInCycle, 1.0);
    f("intimaMatrixShare", intimaMatrixShare, 1.0);
    f("crossCheckSmoothMean", crossCheckSmoothMean, 1.0), f("crossCheckSmoothL2", crossCheckSmoothL2, 1.0);
    f("crossCheckNearStrutsMean", crossCheckNearStrutsMean, 1.0);
    f("crossCheckNearStrutsL2", crossCheckNearStrutsL2, 1.0);
    f("crossCheckStrutsMean", crossCheckStrutsMean, 1.0), f("crossCheckStrutsL2", crossCheckStrutsL2, 1.0);
    f("crossCheckDecidedOtherwise", crossCheckDecidedOtherwise, 1.0);
    f("flowRate_mlPerMin", flowRate, 60e6), f("pressureDrop_Pa", pressureDrop, 1.0);
  }
  template <class F>
  void forEachColumn(F&& f) const {
    const_cast<TimeSeriesRow*>(this)->forEachColumn(
        [&f](const char* column, const auto& value, double scale) { f(column, value, scale); });
  }

  template <class Archive>
  void archive(Archive& a) {
    forEachColumn([&a](const char*, auto& value, double) { a(value); });
  }
};

}  // namespace restenosis
