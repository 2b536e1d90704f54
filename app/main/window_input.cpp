#include "app/main/window_input.h"

#include <utility>
#include <variant>

namespace handrail::program {

WindowInput::WindowInput(std::unique_ptr<window::Window> window, core::Session& app, WorldVisits& worlds, Ears& ears,
                         servo::ServoSwitches& switches, Clock& clock)
    : app_(app), ears_(ears), clock_(clock), acts_(app, worlds), window_(std::move(window)) {
    ears.braille()->window = window_->number();
    const auto stops = [keys = app.keys()](const std::string& key) {
        return keys.find(key) == core::Command::StopEverything;
    };
    window_->offer_keys({[&ears](const window::KeyStroke& stroke) { return ears.accessible()->offer(stroke); },
                         [&ears](std::uint64_t ticket) { return ears.accessible()->verdict(ticket); }},
                        stops);
    window_->watch_keys(
        {stops, [&switches] { switches.stop(); }, [&switches](bool focused) { switches.focused = focused; }});
}

void WindowInput::take(wizard::WizardSession* wizard) {
    const double now_s = clock_.now_s();
    // If a routing key of the braille display was pressed, request more about the current object.
    if (ears_.braille()->more_requested.exchange(0) > 0 && !wizard && app_.scene()) {
        app_.apply(core::CommandDown{core::Command::WhatIsThis}, now_s);
        app_.apply(core::CommandUp{core::Command::WhatIsThis}, now_s);
    }
    for (const core::ItemAct& act : ears_.accessible()->take_acts())
        if (!wizard) app_.apply(core::ItemActed{act}, now_s);
    for (const window::WindowEvent& event : window_->poll()) {
        if (const auto* key = std::get_if<window::KeyEvent>(&event)) {
            acts_.take(*key, wizard, now_s);
        } else if (const auto* text = std::get_if<window::TextEvent>(&event)) {
            acts_.take_text(text->utf8, wizard, now_s);
        } else if (const auto* motion = std::get_if<window::HandDragged>(&event)) {
            app_.apply(core::HandMoved{motion->by_m}, now_s);
        } else if (const auto* focus = std::get_if<window::FocusChange>(&event)) {
            app_.apply(core::FocusChanged{focus->focused}, now_s);
            ears_.accessible()->set_focus(focus->focused);
        } else if (std::holds_alternative<window::CloseRequest>(event)) {
            closed_ = true;
        }
    }
}

}  // namespace handrail::program
