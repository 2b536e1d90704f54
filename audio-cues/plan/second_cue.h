// What tells behind from ahead and high from low where filtering for the ears alone is weak: a sound behind flutters,
// one above rises again and again, one below falls. Audible in one ear and in mono. Pure function; any thread.
#pragma once

#include "worlds/base/vec.h"

namespace handrail {

struct SecondCue {
    double gain = 1.0;   // factor
    double pitch = 1.0;  // factor
};

inline constexpr double kFlutter_hz = 9.0, kFlutterDepth = 0.7;  // share of the loudness that goes straight behind
inline constexpr double kGlide_s = 0.9,
                        kGlideOctaves = 0.25;  // how long a rise takes and how far it goes for what is high above
inline constexpr double kLevelWithin_rad = 0.35,
                        kHigh_rad = 0.87;  // 20 and 50 degrees: no glide below, all of it above

// `head_m`: where the sound is from the head, x right, y ahead, z up. `time_s` may start anywhere.
SecondCue second_cue(const Vec3& head_m, double time_s, bool behind, bool height);

}  // namespace handrail
