#include "app/companions/companion_session.h"

#include <algorithm>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::companions {

CompanionSession::CompanionSession(Clock& clock, bool run_thread) : devices_(clock) {
    if (run_thread) devices_.start();
}

std::vector<std::string> CompanionSession::guide(core::Session& app, double now_s, bool busy_elsewhere) {
    core::Steering steering = busy_elsewhere ? core::Steering{} : devices_.steering();
    if (!app.avatar().cane_out) steering.cane_right_rad_per_s = 0.0;  // a pad moves in the hand all the time
    if (steering != steering_) app.apply(core::Steered{steering}, now_s);
    steering_ = steering;
    for (const core::Command command : devices_.take_commands()) {
        if (busy_elsewhere) continue;  // discards the command, so that the session does not carry it out later
        app.apply(core::CommandDown{command}, now_s);
        app.apply(core::CommandUp{command}, now_s);
    }
    return devices_.take_news();
}

void CompanionSession::follow(const core::Session& app, std::span<const cues::CueRequest> requests,
                              const servo::ToolState* tool, double now_s) {
    if (!devices_.any() || !app.scene()) return;
    if (app.world().entered != worlds_entered_) {
        worlds_entered_ = app.world().entered;
        planner_.enter_world(app.scene());
    } else if (app.scene() != scene_) {
        planner_.follow_edit(app.scene());
    }
    scene_ = app.scene();
    planner_.set_settings(app.settings().pads);
    devices_.give(
        planner_.tick({.now_s = now_s, .requests = requests, .tool = tool, .passage_width_m = app.passage_width_m()}));
}

bool is_companion(std::string_view name) {
    const std::vector<std::string> names = drivers::companion_names();
    return std::find(names.begin(), names.end(), lower_ascii(name)) != names.end();
}

std::string cues_and_walking_sentence(std::string_view model) {
    return phrase("companion.cues_and_walking", {{"device", model}});
}

std::string no_companion_sentence(std::string_view name) {
    return phrase("companion.none", {{"device", drivers::companion_model(lower_ascii(name))}});
}

}  // namespace handrail::companions
