// Sends a body through a door from both sides, over everything that stands in the finished scene but leaves of doors.
// Costs a few milliseconds for each door. The index belongs to its caller; one reading thread.
#pragma once

#include <string>
#include <vector>

#include "worlds/geometry/box_index.h"
#include "worlds/ifc/ifc_building.h"
#include "worlds/scene/scene.h"

namespace handrail {

// Why a body does not pass.
enum class DoorTrialEnd : std::uint8_t {
    Passed,
    InTheWay,  // something that is not the door's own wall, or the door is large enough
    Small,     // the opening itself is narrower or lower than the body
    Step,      // higher than a body climbs
    NoFloor,   // on one side, or within
};
// Of the sentence that says it; empty where it passed.
std::string_view key_of(DoorTrialEnd end);

struct DoorTrial {
    DoorTrialEnd end = DoorTrialEnd::Passed;
    std::vector<int> lines;  // of the file, of what stands in the way; rising
    double step_m = 0.0;
};

class DoorTrials {
public:
    // `scene` outlives it and does not change meanwhile.
    explicit DoorTrials(const Scene& scene);
    DoorTrial try_door(const WallGap& gap) const;

private:
    // What stands over a small square of the floor: how far up and down, and its line.
    struct Stretch {
        double low_m = 0.0, high_m = 0.0;
        int line = 0;
    };
    std::vector<Stretch> column(const Frame& axes, double x_m, double y_m, double half_m, const Reach& height) const;
    DoorTrial walk(const WallGap& gap, double x_m, bool back) const;

    const Scene& scene_;
    BoxIndex solids_, triangles_;
};

}  // namespace handrail
