// Interprets the movements of the hand at the desk. It turns about sixty reports of the servo a second into events in
// order: the hand reached a control, pressed it, slid it or turned it. Plain state for the app thread.
#pragma once

#include <vector>

#include "app/core/desk/desk_panel.h"
#include "haptic/servo/servo_tick.h"

namespace handrail::core {

struct DeskNews {
    enum class Kind {
        Met,      // the hand reached this control
        Pressed,  // the hand pressed this control as a button
        Put,      // the hand slid this control to position `number`
        Stepped,  // the hand turned this control by `number` positions
    } kind = Kind::Met;
    PlacedControl on;
    int number = 0;
};

class DeskHand {
public:
    // The hand must touch a control for this long before its name is announced, so passing over it is silent.
    static constexpr double kSettle_s = 0.04;
    // Once the hand has been away from the controls for this long, a name may be announced again.
    static constexpr double kForget_s = 0.25;
    // The hand must move this many positions away from the present position before the value changes.
    static constexpr double kHysteresis = 0.6;

    void begin(const servo::DeskTouch& touch);
    std::vector<DeskNews> follow(const servo::DeskTouch& touch, const DeskPanel& panel, double now_s);

private:
    void press(const PlacedControl& control, const servo::DeskTouch& touch, std::vector<DeskNews>& news);
    void drag(const PlacedControl& control, const servo::DeskTouch& touch, std::vector<DeskNews>& news);

    std::uint32_t presses_ = 0;
    FeatureId met_ = kNoFeature;     // control whose name has been announced
    FeatureId coming_ = kNoFeature;  // control that the hand has touched since coming_s_
    double coming_s_ = 0.0, away_s_ = 0.0;
    std::size_t page_ = 0;
    double at_ = 0.0;  // last reported position of the slider or detent of the knob
};

}  // namespace handrail::core
