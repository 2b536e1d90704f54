// Stores the landmarks that a person has marked in addition to those in the world's file, and adds them to the scene.
// Pure functions over plain values, for the app thread.
#pragma once

#include <memory>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

// A landmark belongs to the thing with the stored name whose middle has moved by no more than this distance.
inline constexpr double kLandmarkMoved_m = 0.5;
struct LandmarkGiven {
    std::string name;
    Vec3 at_m{0.0};
    SideEntry kept = {};  // keys of the side file that this version does not know
};

// Returns the landmarks in the order of the file. Entries without a valid name or a place stay in the file but are not
// returned. `faults` receives an error for each of them.
std::vector<LandmarkGiven> read_landmarks(const SideFile& file, std::vector<Error>& faults);
// Adds a landmark in memory. The owner saves `file` later.
void keep_landmark(SideFile& file, const Feature& feature);

// Returns the scene with these things marked as landmarks. If there is nothing to mark, returns the same pointer.
// Landmarks whose things no longer exist are ignored.
std::shared_ptr<const Scene> with_landmarks(std::shared_ptr<const Scene> scene,
                                            const std::vector<LandmarkGiven>& landmarks);

}  // namespace handrail::core
