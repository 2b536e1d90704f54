// Moves a walker's body through a door from both sides, against everything in the finished scene except door leaves.
// The caller owns the DoorTrials, and one reading thread uses it. Costs a few milliseconds for each door.
#pragma once

#include <string>
#include <vector>

#include "worlds/geometry/box_index.h"
#include "worlds/ifc/ifc_building.h"
#include "worlds/scene/scene.h"

namespace handrail::ifc {

// Why the walker does not get through a door.
enum class DoorTrialEnd : std::uint8_t {
    Passed,
    InTheWay,  // an obstacle, although the door is high enough for the walker
    Small,     // the opening is narrower or lower than the walker, or too deep
    Step,      // a step higher than the walker climbs
    NoFloor,   // no floor on one side of the door, or in the doorway
};
// The key of the sentence that states the reason; empty if the walker passed.
std::string_view key_of(DoorTrialEnd end);

struct DoorTrial {
    DoorTrialEnd end = DoorTrialEnd::Passed;
    std::vector<int> lines;  // lines of the file that define the obstacles, in rising order
    double step_m = 0.0;
};

class DoorTrials {
public:
    // `scene` must outlive this object and must not change meanwhile.
    explicit DoorTrials(const Scene& scene);
    DoorTrial try_door(const WallGap& gap) const;

private:
    // One obstacle above a small square of the floor: its lowest and highest point there, and its line in the file.
    struct Stretch {
        double low_m = 0.0, high_m = 0.0;
        int line = 0;
    };
    std::vector<Stretch> column(const Frame& axes, double x_m, double y_m, double half_m, const Reach& height) const;
    DoorTrial walk(const WallGap& gap, double x_m, bool back) const;

    const Scene& scene_;
    BoxIndex solids_, triangles_;
};

}  // namespace handrail::ifc
