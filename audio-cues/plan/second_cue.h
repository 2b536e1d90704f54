// A cue that distinguishes behind from ahead and high from low where head-related filtering alone is weak. A sound
// behind flutters, one above rises again and again, one below falls. Audible in one ear and in mono. Pure function; any
// thread.
#pragma once

#include "worlds/base/vec.h"

namespace handrail::cues {

struct SecondCue {
    double gain = 1.0;   // factor
    double pitch = 1.0;  // factor
};

// KFlutterDepth: share of the loudness that is lost directly behind.
inline constexpr double kFlutter_hz = 9.0, kFlutterDepth = 0.7;
inline constexpr double kGlide_s = 0.9,
                        kGlideOctaves = 0.25;  // duration of a glide, and how far it goes for a sound high above
inline constexpr double kLevelWithin_rad = 0.35,
                        kHigh_rad = 0.87;  // 20 and 50 degrees: no glide below the first, full glide above the second

// `head_m`: position of the sound relative to the head, x right, y ahead, z up. `time_s` may start anywhere.
SecondCue second_cue(const Vec3& head_m, double time_s, bool behind, bool height);

}  // namespace handrail::cues
