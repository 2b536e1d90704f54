// Defines a cue about the world for fingers on a game pad. The cue indicates a wall but cannot render one.
// FingerPlanner in audio-cues/plan makes the cue, and the pads of haptic/drivers render it. Plain data.
#pragma once

namespace handrail::device {

// All values are 0 to 1 except the frequency. On a pad with resisting triggers, the right trigger shows nearness and
// hardness by resistance, a doorway by a click and the material by trembling. The left trigger resists on a slope. The
// coils give knocks and grain. A pad without such triggers has only the coils.
struct FingerCue {
    double nearness = 0.0;  // 0: far from a wall; 1: touching it
    double hardness = 1.0;  // 0: a soft surface; 1: a hard one
    bool doorway = false;
    double material_hz = 0.0;  // frequency at which the trigger trembles; 0: a smooth material
    double slope = 0.0;        // 0: level; 1: as steep as stairs
    double knock = 0.0;
    double grain = 0.0;  // strength of the roughness of a material that the person walks on or slides along
    bool operator==(const FingerCue&) const = default;
};

}  // namespace handrail::device
