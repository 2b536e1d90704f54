// The worst that a tick can be asked: places where more is near the ball than a millisecond has time for. Same scenes
// and hands for tests, which count the work and look for crossings, and for benchmarks, which time it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "haptic/render/touch.h"

namespace handrail::test {

struct WorstCase {
    std::string name;
    std::shared_ptr<const HapticScene> scene;
    std::vector<Vec3> goals_m;  // 1 kHz, world
    TouchTuning tuning;
    // Where the bodies are on a tick, in the scene's order; empty: nothing moves.
    std::function<void(std::size_t tick, std::vector<BodyPose>& poses)> move;
};

inline constexpr int kWorstCases = 10;
inline constexpr double kBox_m = 0.1;  // the side of each box of 7 and 8
// A case by its number, below kWorstCases; made anew on each call, and freed with what is returned. Always the same for
// the same `ticks`.
//   0 a soup of 100,000 triangles crossed at 5 m/s
//   1 3,000 sheets in one place
//   2 and 3: 20 and 128 mesh bodies that overlap and move about the ball
//   4 a sphere of a million triangles, zoomed out until the ball spans 10 cm of it
//   5 the same sphere at 1 m/s with a ball of 5 mm
//   6 one mesh body of 100,000 triangles that comes at the ball, turns and goes
//   7 and 8: 500 and 2,000 boxes that all move, the hand among them
//   9 the soup with a ball of 0.2 mm
WorstCase worst_case(int number, int ticks);

}  // namespace handrail::test
