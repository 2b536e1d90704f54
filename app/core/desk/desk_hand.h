// Interprets the hand at the desk: which control it has reached, that it pressed one, and how far it slid or turned
// one. Turns what the servo reports about sixty times a second into events in order. Plain state; app thread.
#pragma once

#include <vector>

#include "app/core/desk/desk_panel.h"
#include "haptic/servo/servo_tick.h"

namespace handrail::core {

struct DeskNews {
    enum class Kind {
        Met,      // the hand reached this control
        Pressed,  // pressed as a button
        Put,      // slid to position `number`
        Stepped,  // turned by `number` positions
    } kind = Kind::Met;
    PlacedControl on;
    int number = 0;
};

class DeskHand {
public:
    static constexpr double kSettle_s = 0.04;  // a hand that only passes hears no name
    static constexpr double kForget_s = 0.25;  // after this long away, the name is announced again
    // In positions; at this distance from the middle of one, the next begins.
    static constexpr double kHysteresis = 0.6;

    void begin(const servo::DeskTouch& touch);
    std::vector<DeskNews> follow(const servo::DeskTouch& touch, const DeskPanel& panel, double now_s);

private:
    void press(const PlacedControl& control, const servo::DeskTouch& touch, std::vector<DeskNews>& news);
    void drag(const PlacedControl& control, const servo::DeskTouch& touch, std::vector<DeskNews>& news);

    std::uint32_t presses_ = 0;
    FeatureId met_ = kNoFeature;     // already announced
    FeatureId coming_ = kNoFeature;  // touched since coming_s_
    double coming_s_ = 0.0, away_s_ = 0.0;
    std::size_t page_ = 0;
    double at_ = 0.0;  // last reported position of the slider, or detent of the knob
};

}  // namespace handrail::core
