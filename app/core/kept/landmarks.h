// Landmarks that a person has marked in addition to those of the world's file: how the side file stores them, and how
// the scene gets them. Pure functions over plain values; app thread.
#pragma once

#include <memory>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

// A thing is recognised by its stored name and its middle, which may have moved by up to this distance.
inline constexpr double kLandmarkMoved_m = 0.5;
struct LandmarkGiven {
    std::string name;
    Vec3 at_m{0.0};
    SideEntry kept = {};  // keys of the file that this version does not know
};

// In the order of the file. Entries without a valid name or a place are left out but stay in the file; `faults`
// receives an error for each.
std::vector<LandmarkGiven> read_landmarks(const SideFile& file, std::vector<Error>& faults);
// Adds a landmark, in memory until the file is saved.
void keep_landmark(SideFile& file, const Feature& feature);

// The scene with these things marked; the same pointer if there are none to mark. Things that no longer exist are left
// out.
std::shared_ptr<const Scene> with_landmarks(std::shared_ptr<const Scene> scene,
                                            const std::vector<LandmarkGiven>& landmarks);

}  // namespace handrail::core
