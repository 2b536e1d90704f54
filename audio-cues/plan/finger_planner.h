// Decides the cues for fingers on a game pad, as CuePlanner decides the sounds. FingerPlanner is pure logic over what
// the hand touches, the app's requests and a time, so tests replay it exactly. App thread; a few comparisons per frame.
// The app calls it only if there is a pad.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "audio-cues/plan/cue_planner.h"
#include "haptic/device/finger_cue.h"

namespace handrail::cues {

struct FingerInputs {
    double now_s = 0.0;
    std::span<const CueRequest> requests;    // the app's requests of this frame: bumps, steps, the wall tone
    const servo::ToolState* tool = nullptr;  // state of the hand; nullptr: there is no hand
    double passage_width_m = 0.0;            // free width across the walking direction; 0: open on at least one side
};

// Converts inputs to cues as follows:
// - Hardness is the stiffness of the touched surface.
// - A bump gives a knock, and the right trigger stays stiff until the walker is away from the wall.
// - The nearness of a wall ahead follows the loudness of the wall tone. The nearness of a touched surface follows the
//   force of that surface on the hand.
// - A door ahead gives a click. So does a passage no wider than a door, if the walker enters it from a wider place.
// - Steps and slides give the grain of their material. Stairs and slopes make the left trigger resist.
class FingerPlanner {
public:
    static constexpr double kKnock_s = 0.12, kBumpHolds_s = 0.6, kClick_s = 0.4, kStepGrain_s = 0.06,
                            kSlopeHolds_s = 2.0;
    static constexpr double kDoorWidth_m = 1.4, kWide_m = 1.8;

    void set_settings(const settings::Settings::Pads& settings) { settings_ = settings; }
    void enter_world(std::shared_ptr<const Scene> scene);  // forgets all contacts and steps in the old world
    void follow_edit(std::shared_ptr<const Scene> scene) { scene_ = std::move(scene); }
    // Returns the cue of this frame. `inputs.now_s` must never decrease.
    device::FingerCue tick(const FingerInputs& inputs);

private:
    struct Surface {
        double hardness = 1.0;
        double period_hand_m = 0.0;  // period of the material's texture; 0: no texture
        SoundClass sound = SoundClass::Generic;
    };
    Surface surface_of(MaterialId material) const;
    void on_request(const CueRequest& request);
    void on_passage(double width_m, double now_s);
    void on_hand(const FingerInputs& inputs, device::FingerCue& cue);

    settings::Settings::Pads settings_;
    std::shared_ptr<const Scene> scene_;
    double wall_nearness_ = 0.0;
    double bumped_s_ = -1e9, clicked_s_ = -1e9, stepped_s_ = -1e9;
    Surface bumped_, stepped_on_;
    double slope_ = 0.0;
    std::optional<Vec3> last_step_m_, last_hand_m_;
    double last_hand_s_ = 0.0;
    bool was_wide_ = true;
    FeatureId touched_door_ = kNoFeature;
};

// Returns the grains per second of a material under a foot or a slow hand; 0: a smooth material.
double grain_hz(SoundClass sound) noexcept;

}  // namespace handrail::cues
