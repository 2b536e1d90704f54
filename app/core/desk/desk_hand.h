// What a hand at the desk means: which control it has come to, that it pressed one, and to where it slid or turned it.
// From what the servo tells of the hand about sixty times a second to news in order. Plain state; app thread.
#pragma once

#include <vector>

#include "app/core/desk/desk_panel.h"
#include "haptic/servo/servo_tick.h"

namespace handrail {

struct DeskNews {
    enum class Kind {
        Met,      // the hand has come to this control
        Pressed,  // as a button
        Put,      // to position `number`
        Stepped,  // by `number`
    } kind = Kind::Met;
    PlacedControl on;
    int number = 0;
};

class DeskHand {
public:
    static constexpr double kSettle_s = 0.04;   // a hand that goes past on its way elsewhere hears no name
    static constexpr double kForget_s = 0.25;   // away for so long, the name is told again
    static constexpr double kHysteresis = 0.6;  // of a position: so far from its middle the next one begins

    void begin(const DeskTouch& touch);
    std::vector<DeskNews> follow(const DeskTouch& touch, const DeskPanel& panel, double now_s);

private:
    void press(const PlacedControl& control, const DeskTouch& touch, std::vector<DeskNews>& news);
    void drag(const PlacedControl& control, const DeskTouch& touch, std::vector<DeskNews>& news);

    std::uint32_t presses_ = 0;
    FeatureId met_ = kNoFeature;     // told
    FeatureId coming_ = kNoFeature;  // touched since coming_s_
    double coming_s_ = 0.0, away_s_ = 0.0;
    std::size_t page_ = 0;
    double at_ = 0.0;  // position of the slider, or detent of the knob, that was told last
};

}  // namespace handrail
