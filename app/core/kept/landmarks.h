// Landmarks that a person has marked in addition to those in the world's file: how the side file stores them, and how
// they get into the scene. Pure functions over plain values; app thread.
#pragma once

#include <memory>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

// A landmark belongs to the thing with the stored name whose middle has moved by at most this distance.
inline constexpr double kLandmarkMoved_m = 0.5;
struct LandmarkGiven {
    std::string name;
    Vec3 at_m{0.0};
    SideEntry kept = {};  // keys of the file that this version does not know
};

// Returns the landmarks in the order of the file. Entries without a valid name or a place stay in the file but are not
// returned. `faults` receives an error for each of them.
std::vector<LandmarkGiven> read_landmarks(const SideFile& file, std::vector<Error>& faults);
// Adds a landmark in memory; the owner saves the file later.
void keep_landmark(SideFile& file, const Feature& feature);

// Returns the scene with these things marked as landmarks. If there is nothing to mark, returns the same pointer.
// Ignores things that no longer exist.
std::shared_ptr<const Scene> with_landmarks(std::shared_ptr<const Scene> scene,
                                            const std::vector<LandmarkGiven>& landmarks);

}  // namespace handrail::core
