// Things that a person has marked as landmarks in a world whose file does not: how they are kept in the side file and
// laid upon the world. Pure functions over plain values; app thread.
#pragma once

#include <memory>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/scene/scene.h"

namespace handrail {

// The thing is known by its stored name and its middle, which may have moved by so much since.
inline constexpr double kLandmarkMoved_m = 0.5;
struct LandmarkGiven {
    std::string name;
    Vec3 at_m{0.0};
    SideEntry kept = {};  // keys of the file that this version does not know
};

// In the order of the file. Entries without a good name or a place are left out and stay in the file; `faults` tells of
// each.
std::vector<LandmarkGiven> read_landmarks(const SideFile& file, std::vector<Error>& faults);
// One more, in memory until the file is saved.
void keep_landmark(SideFile& file, const Feature& feature);

// The world with these things marked; the same one where there is none to mark. Those that are not there any more are
// left out.
std::shared_ptr<const Scene> with_landmarks(std::shared_ptr<const Scene> scene,
                                            const std::vector<LandmarkGiven>& landmarks);

}  // namespace handrail
