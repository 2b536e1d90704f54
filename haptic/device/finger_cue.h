// A cue about the world for fingers on a game pad; it is not a wall. Made by audio-cues/plan, rendered by the pads of
// haptic/drivers. Plain data.
#pragma once

namespace handrail::device {

// All values are 0 to 1 except the frequency. On a pad with triggers, the right one resists by nearness and hardness,
// clicks at a doorway and trembles by material; the left one resists on a slope. Coils give knocks and grain; a pad
// without triggers has only these.
struct FingerCue {
    double nearness = 0.0;  // 0 far, 1 touching
    double hardness = 1.0;  // 0 soft, 1 hard
    bool doorway = false;
    double material_hz = 0.0;  // 0: smooth
    double slope = 0.0;        // 0 level, 1 as steep as stairs
    double knock = 0.0;
    double grain = 0.0;  // of a material that the person walks on or slides along
    bool operator==(const FingerCue&) const = default;
};

}  // namespace handrail::device
