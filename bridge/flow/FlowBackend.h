#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bridge/flow/BeatStress.h"
#include "bridge/flow/ViscosityLaw.h"
#include "bridge/flow/Waveform.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// What blood goes on to behind the vessel: the small vessels of the heart, with one resistance.
struct DistalBed {
  double resistance = 0.0;  ///< pressure lost over the flow rate [Pa s/m^3]
  double pressure = 0.0;    ///< lost along the vessel and the bed together [Pa]
};

/// One outlet of several, and what decides how much goes through it.
struct Outlet {
  std::string name;         ///< of its solid in the surface's file
  double share = 0.0;       ///< of the flow rate; with a resistance a guess
  double resistance = 0.0;  ///< of what lies behind it, as DistalBed's [Pa s/m^3]; 0: the share is given
};

/// What went through an outlet.
struct OutletFlow {
  double flowRate = 0.0;  ///< [m^3/s]
  double pressure = 0.0;  ///< mean over its area, less that of the first outlet [Pa]

  template <class Archive>
  void archive(Archive& a) {
    a(flowRate, pressure);
  }
};

/// How the flow rate at the inlet beats.
struct Beating {
  Waveform waveform;
  int beats = 3;  ///< solved one after the other, two at least
  /// Whether WallFace::traction is that of the last beat, TAWSS along the mean traction, or of steady flow.
  bool meanStress = true;
};

/// What drives the flow and what flows; the same for every backend. SI units.
struct FlowConditions {
  enum class Drive { flowRate, pressureGradient };
  Drive drive = Drive::flowRate;
  double flowRate = 0.0;          ///< volume per time through the inlet [m^3/s]
  double pressureGradient = 0.0;  ///< -dp/dz [Pa/m], for Drive::pressureGradient
  double density = 1000.0;        ///< [kg/m^3]
  /// [m^2/s]; of blood that thins, that at the wall of the undeformed lumen.
  double kinematicViscosity = 0.0;
  std::optional<ViscosityLaw> thinning = std::nullopt;  ///< how it thins; none of a Newtonian fluid
  /// What the flow rate follows from (DistalResistance); `flowRate` is a guess then.
  std::optional<DistalBed> distal = std::nullopt;
  std::vector<Outlet> outlets = {};  ///< in the order of the lumen's regions; none where there is one
  std::optional<Beating> beating = std::nullopt;  ///< about `flowRate` as its mean; none of steady flow
  double dynamicViscosity() const { return density * kinematicViscosity; }
};

/// One face of a backend's wall: where it is and the traction it feels.
struct WallFace {
  Vec3 centre;           ///< [m]
  double area;           ///< [m^2]
  Vec3 traction;         ///< tangential traction of the fluid on the wall, along the flow [Pa]
  SurfaceRegion region;  ///< wall or strut
  BeatStress beat = {};  ///< of the last beat, where the flow was solved for beats

  template <class Archive>
  void archive(Archive& a) {
    a(centre.x(), centre.y(), centre.z(), area, traction.x(), traction.y(), traction.z(), region, beat);
  }
};

/// What beats have shown about a solution. Differences are over all faces, weighted by area.
struct BeatSummary {
  int beats = 0;                  ///< solved; 0 of a steady flow
  double period = 0.0;            ///< [s]
  double meanStress = 0.0;        ///< mean TAWSS [Pa]
  double change = 0.0;            ///< of TAWSS from the last beat but one to the last, relative L2 norm
  double steadyMean = 0.0;        ///< mean stress of steady flow over mean TAWSS, less 1
  double steadyDifference = 0.0;  ///< of the stress of steady flow from TAWSS, relative L2 norm
  double seconds = 0.0;           ///< that the beats took

  template <class Archive>
  void archive(Archive& a) {
    a(beats, period, meanStress, change, steadyMean, steadyDifference, seconds);
  }
};

/// A steady solution, as far as anything outside the backend needs it, and how it was obtained.
struct FlowSolution {
  std::vector<WallFace> wall;
  double flowRate = 0.0;       ///< volume per time through the inlet [m^3/s]
  double pressureDrop = 0.0;   ///< inlet minus outlet, the first of several, area-weighted [Pa]
  double massImbalance = 0.0;  ///< |out - in| / in
  std::size_t cells = 0;
  int iterations = 0;
  double meshSeconds = 0.0, solveSeconds = 0.0;
  std::vector<std::string> remarks;  ///< retries, warnings; empty when all went as planned
  bool meshMoved = false;            ///< the mesh is that of the former solve, moved onto the lumen
  std::string remeshedBecause;       ///< why not, as a category; empty where no mesh is ever moved
  BeatSummary beats;
  std::vector<OutletFlow> outlets;  ///< of several outlets, in the order of the conditions

  template <class Archive>
  void archive(Archive& a) {
    a(wall, flowRate, pressureDrop, massImbalance, cells, iterations, meshSeconds, solveSeconds, remarks,
      meshMoved, remeshedBecause, beats, outlets);
  }
};

/// A flow that could not be computed; `what()` says which step failed and why, `log` is the file to read.
struct FlowFailed : std::runtime_error {
  FlowFailed(const std::string& message, std::filesystem::path logFile)
      : std::runtime_error(message), log(std::move(logFile)) {}
  std::filesystem::path log;
};

/// Solves steady blood flow in a lumen. A backend sees a surface, never an agent.
class FlowBackend {
 public:
  virtual ~FlowBackend() = default;
  virtual std::string_view name() const = 0;
  /// Solves for this lumen. `caseFolder` is the backend's to create and fill; what it leaves there is what a
  /// user opens. Throws FlowFailed, or WriteFailed where the case cannot be written.
  virtual FlowSolution solve(const TriSurface& lumen, const FlowConditions& conditions,
                             const std::filesystem::path& caseFolder) = 0;
  /// The next solve may make use of the solution that a former one has left in this folder, which stays as it
  /// is. What is to be had from it must depend on the folder alone, not on what this object has solved
  /// before: a run that is resumed has a new one.
  virtual void startFrom(const std::filesystem::path& /*formerCase*/) {}
  /// Whether what `solve` returns depends on the folder given to startFrom.
  virtual bool needsFormerCase() const { return false; }
  /// The files of a former case that the next solve would read after startFrom, relative to the case. Throws
  /// std::runtime_error where there is no solution.
  virtual std::vector<std::filesystem::path> filesToStartFrom(const std::filesystem::path&) const {
    return {};
  }
  /// Velocity of the last solution [m/s] at points in its lumen [m]; NaN where it is not known. Empty from a
  /// backend that keeps none.
  virtual std::vector<Vec3> velocities(const std::vector<Vec3>&) const { return {}; }
};

}  // namespace restenosis
