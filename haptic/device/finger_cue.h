// What fingers on a game pad are told of the world: a cue, not a wall. Made by audio-cues/plan, rendered by the pads of
// haptic/drivers. Plain data.
#pragma once

namespace handrail {

// All 0 to 1 but the frequency. A pad with triggers resists on the right one by nearness and hardness, clicks it at a
// doorway and lets it tremble by material; the left one resists a slope. Coils give knocks and grain; a pad without
// triggers has these alone.
struct FingerCue {
    double nearness = 0.0;  // 0 far, 1 touching
    double hardness = 1.0;  // 0 soft, 1 hard
    bool doorway = false;
    double material_hz = 0.0;  // 0: smooth
    double slope = 0.0;        // 0 level, 1 as steep as stairs
    double knock = 0.0;
    double grain = 0.0;  // of a material that is walked on or slid along
    bool operator==(const FingerCue&) const = default;
};

}  // namespace handrail
