#pragma once

#include <map>
#include <string>
#include <vector>

#include "bridge/scene/Scene.h"

namespace restenosis {

/// Every key of every modelled section as "section.key" -> value, in SI units and exact; what two scenes
/// differ in can be read off two of these.
std::map<std::string, std::string> sceneValues(const Scene& scene);

/// The same, of what a run's state depends on: without `scene.title`, [output] and the cross-check of the
/// flow, and without `scene.duration`, so that a finished run can be resumed for longer. Input files count
/// with their contents, wherever they lie. Throws std::runtime_error when one cannot be read.
std::map<std::string, std::string> decisiveValues(const Scene& scene);

/// Of these, what may not change in the course of a run: without what only says how accurately the flow is
/// computed and how often, which are `scene.fidelity`, [foam], [lbm] and the keys of [coupling] that a
/// fidelity decides.
std::map<std::string, std::string> lastingValues(const Scene& scene);

/// What the `lastingValues` of two scenes differ in: "section.key", or "[section]" for one that only one of
/// them models.
std::vector<std::string> lastingDifferences(const Scene& a, const Scene& b);

/// Digests of the files that a scene names, by "section.key". Throws std::runtime_error when one cannot be
/// read.
std::map<std::string, std::string> inputDigests(const Scene& scene);

/// The settings that the scene's flow is computed by, given or those that `scene.fidelity` stands for, of its
/// backend and of [coupling]: "section.key" -> value as above. Empty without a flow.
std::map<std::string, std::string> flowSettings(const Scene& scene);

/// Where `now` differs from `before`, both flowSettings of one backend: "lbm.dx = 20 um (before: 30 um)".
std::string settingsInPlace(const std::map<std::string, std::string>& before,
                            const std::map<std::string, std::string>& now);

/// A hash over `decisiveValues`: two scenes with one fingerprint, run from the start, have the same states at
/// the same times.
std::string sceneFingerprint(const Scene& scene);

/// A hash over `lastingValues`: a checkpoint may be resumed under any scene with its fingerprint.
std::string checkpointFingerprint(const Scene& scene);

}  // namespace restenosis
