#include "audio-cues/plan/second_cue.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/contract.h"

namespace handrail::cues {

SecondCue second_cue(const Vec3& head_m, double time_s, bool behind, bool height) {
    contract_pre(is_finite(head_m) && std::isfinite(time_s));
    const double level_m = std::hypot(head_m.x, head_m.y), distance_m = glm::length(head_m);
    SecondCue cue;
    if (distance_m < 1e-6) return cue;
    if (behind && level_m > 1e-6) {
        // The flutter begins only slightly behind the ears, so that sounds at the side stay steady.
        const double how_far = std::clamp(-1.5 * head_m.y / distance_m - 0.3, 0.0, 1.0);
        cue.gain = 1.0 - kFlutterDepth * how_far * (0.5 - 0.5 * std::cos(2.0 * kPi * kFlutter_hz * time_s));
    }
    if (height) {
        const double elevation_rad = std::atan2(head_m.z, level_m);
        const double how_high = std::copysign(
            std::clamp((std::abs(elevation_rad) - kLevelWithin_rad) / (kHigh_rad - kLevelWithin_rad), 0.0, 1.0),
            elevation_rad);
        // The pitch glides for nine tenths of the time and swings back in the last tenth.
        const double phase = time_s / kGlide_s - std::floor(time_s / kGlide_s);
        const double glide = phase < 0.9 ? phase / 0.9 : (1.0 - phase) / 0.1;
        cue.pitch = std::exp2(kGlideOctaves * how_high * glide);
    }
    return cue;
}

}  // namespace handrail::cues
