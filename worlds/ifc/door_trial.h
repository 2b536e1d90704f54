// Tests whether a walker can get through a door. It moves a walker's body through the door from both sides, and tests
// it against everything in the finished scene except door leaves. The caller owns the DoorTrials; they are used on the
// reading thread only. Each door costs a few milliseconds.
#pragma once

#include <string>
#include <vector>

#include "worlds/geometry/box_index.h"
#include "worlds/ifc/ifc_building.h"
#include "worlds/scene/scene.h"

namespace handrail::ifc {

// The result of a trial: Passed, or the reason why the walker cannot get through.
enum class DoorTrialEnd : std::uint8_t {
    Passed,
    Blocking,  // an obstacle is in the walker's way, although the opening is large enough
    Small,     // the opening is narrower or lower than the walker, or it is too deep
    Step,      // a step is higher than the walker can climb
    NoFloor,   // there is no floor on one side of the door, or in the doorway
};
// Returns the key of the sentence that states the reason; empty if the walker passed.
std::string_view key_of(DoorTrialEnd end);

struct DoorTrial {
    DoorTrialEnd end = DoorTrialEnd::Passed;
    std::vector<int> lines;  // the lines of the file that define the obstacles, in rising order
    double step_m = 0.0;
};

class DoorTrials {
public:
    // `scene` must outlive this object and must not change during its life.
    explicit DoorTrials(const Scene& scene);
    DoorTrial try_door(const WallGap& gap) const;

private:
    // An obstacle above a small square of the floor: its lowest and highest point above that square, and its line in
    // the file.
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
