#include "app/core/desk/desk_hand.h"

#include <cmath>

namespace handrail::core {
namespace {

// Returns the position of the hand on the knob in detents, clockwise from the top. Between two detents, it is a
// fraction.
double detent_at(const PlacedControl& knob, const Vec3& at_m) {
    const double turns = std::atan2(at_m.x - knob.x_m, at_m.z - knob.z_m) / (2.0 * kPi);
    return (turns - std::floor(turns)) * kKnobDetents;
}

}  // namespace

void DeskHand::begin(const servo::DeskTouch& touch) {
    presses_ = touch.presses;
    met_ = coming_ = kNoFeature;
}

void DeskHand::press(const PlacedControl& control, const servo::DeskTouch& touch, std::vector<DeskNews>& news) {
    switch (control.kind) {
        case DeskKind::Slider:
            at_ = std::round(control.position_at(touch.proxy_m.x));
            news.push_back({DeskNews::Kind::Put, control, static_cast<int>(at_)});
            break;
        case DeskKind::Knob:
            at_ = std::round(detent_at(control, touch.proxy_m));
            news.push_back({DeskNews::Kind::Pressed, control, 0});
            break;
        case DeskKind::List:
            news.push_back({DeskNews::Kind::Stepped, control, touch.proxy_m.z > control.z_m ? -1 : 1});
            break;
        default:
            news.push_back({DeskNews::Kind::Pressed, control, 0});
    }
}

void DeskHand::drag(const PlacedControl& control, const servo::DeskTouch& touch, std::vector<DeskNews>& news) {
    if (control.kind == DeskKind::Slider) {
        const double position = control.position_at(touch.proxy_m.x);
        if (std::abs(position - at_) <= kHysteresis) return;
        at_ = std::round(position);
        news.push_back({DeskNews::Kind::Put, control, static_cast<int>(at_)});
    } else if (control.kind == DeskKind::Knob) {
        double way = detent_at(control, touch.proxy_m) - at_;
        way -= kKnobDetents * std::floor(way / kKnobDetents + 0.5);  // Chooses the shorter direction of rotation.
        if (std::abs(way) <= kHysteresis) return;
        const double steps = std::round(way);
        at_ += steps;
        news.push_back({DeskNews::Kind::Stepped, control, static_cast<int>(steps)});
    }
}

std::vector<DeskNews> DeskHand::follow(const servo::DeskTouch& touch, const DeskPanel& panel, double now_s) {
    std::vector<DeskNews> news;
    const PlacedControl* touched = panel.find(touch.touched);
    if (page_ != panel.page) {
        // The panel has just changed pages, and the hand is still on the button that turns the pages.
        page_ = panel.page;
        met_ = coming_ = touched ? touched->feature : kNoFeature;
    }
    const auto meet = [&](const PlacedControl& control) {
        if (met_ != control.feature) news.push_back({DeskNews::Kind::Met, control, 0});
        met_ = coming_ = control.feature;
    };
    if (touched) {
        away_s_ = now_s;
        if (touched->feature != coming_) {
            coming_ = touched->feature;
            coming_s_ = now_s;
        }
        // While a control is pressed, the hand operates only that one, even if it slides over others.
        if (coming_ != met_ && !touch.held && now_s - coming_s_ >= kSettle_s) meet(*touched);
    } else {
        coming_ = kNoFeature;
        if (now_s - away_s_ >= kForget_s) met_ = kNoFeature;
    }
    const PlacedControl* held = panel.find(touch.held);
    if (touch.presses != presses_) {
        presses_ = touch.presses;
        // If the press is already over, it presses the control that the hand still touches. If the hand touches none,
        // it presses the control announced last.
        const PlacedControl* pressed = held ? held : touched ? touched : panel.find(met_);
        if (pressed) {
            met_ = coming_ = pressed->feature;
            press(*pressed, touch, news);
        }
    } else if (held) {
        drag(*held, touch, news);
    }
    return news;
}

}  // namespace handrail::core
