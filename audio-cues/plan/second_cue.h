// Computes a second cue that distinguishes behind from ahead, and high from low, where head-related filtering alone is
// too weak. A sound behind the person flutters. The pitch of a sound above rises again and again, and that of a sound
// below falls. The person can hear the cue with one ear and in mono. Pure function; any thread.
#pragma once

#include "worlds/base/vec.h"

namespace handrail::cues {

struct SecondCue {
    double gain = 1.0;   // factor on the loudness
    double pitch = 1.0;  // factor on the pitch
};

// kFlutterDepth is the share of the loudness that flutter removes directly behind the person.
inline constexpr double kFlutter_hz = 9.0, kFlutterDepth = 0.7;
inline constexpr double kGlide_s = 0.9,
                        kGlideOctaves = 0.25;  // duration of one glide, and its range for a sound high above
inline constexpr double kLevelWithin_rad = 0.35,
                        // Elevations of 20 and 50 degrees, above or below the ears. Up to the first angle there is no
                        // glide; from the second on the glide has its full range.
    kHigh_rad = 0.87;

// Returns the cue for a sound at `head_m`, relative to the head: x right, y ahead, z up. `time_s` may start at any
// value.
SecondCue second_cue(const Vec3& head_m, double time_s, bool behind, bool height);

}  // namespace handrail::cues
