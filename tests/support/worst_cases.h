// Defines the hardest ticks, in which more obstacles are near the proxy than a millisecond has time for. Tests count
// the work and look for crossings, and benchmarks measure the time, with the same scenes and hands.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "haptic/render/touch.h"
#include "tests/support/names.h"

namespace handrail::test {

struct WorstCase {
    std::string name;
    std::shared_ptr<const HapticScene> scene;
    std::vector<Vec3> goals_m;  // positions of the hand at 1 kHz, world
    TouchTuning tuning;
    // Sets the poses of the bodies in a tick, in the scene's order. Empty: no body moves.
    std::function<void(std::size_t tick, std::vector<BodyPose>& poses)> move;
};

inline constexpr int kWorstCases = 10;
inline constexpr double kBox_m = 0.1;  // length of the edges of each box in cases 7 and 8
// Returns case `number`, below kWorstCases. Each call makes a new case, which is freed with the result. The same
// `ticks` always give the same case.
//   0 a soup of 100,000 triangles crossed at 5 m/s
//   1 3,000 sheets in one place
//   2 and 3: 20 and 128 overlapping mesh bodies that move around the proxy
//   4 a sphere of a million triangles, at so large a scale that the proxy spans 10 cm of it
//   5 the same sphere at 1 m/s with a proxy of 5 mm
//   6 one mesh body of 100,000 triangles that approaches the proxy, turns and leaves
//   7 and 8: 500 and 2,000 boxes that all move, with the hand among them
//   9 the soup of case 0 with a proxy of 0.2 mm
WorstCase worst_case(int number, int ticks);

}  // namespace handrail::test
