#include "app/main/guided_set_up.h"

#include <utility>

#include "worlds/base/language.h"

namespace handrail::program {

void GuidedSetUp::begin(std::span<const wizard::WizardPart> wanted) {
    session_ = std::make_unique<wizard::WizardSession>(parts_.settings.values(), wanted);
    stops_ = parts_.switches.stops;
    let_go_ = parts_.app.hand().tuning.stops_let_go;
    parts_.driver.begin_set_up();
    cues::CueRequest no_tone;
    no_tone.kind = cues::CueRequestKind::WallTone;
    no_tone.loudness = 0.0;
    parts_.ears.sound().post(std::move(no_tone));
}

void GuidedSetUp::begin_if_requested() {
    if (!parts_.app.requests().take_set_up() || session_) return;
    std::vector<wizard::WizardPart> wanted;
    const bool first = parts_.app.requests().take_first_set_up();
    for (const wizard::WizardPartInfo& part : wizard::wizard_parts())
        if (!first || (part.part != wizard::WizardPart::Reach && part.part != wizard::WizardPart::Step))
            wanted.push_back(part.part);
    begin(wanted);
}

void GuidedSetUp::look_for_hand() {
    if (!searched_ && session_->wizard().wants_search()) {
        searched_ = true;
        parts_.hand.begin_for_set_up();
    }
    parts_.hand.look_for_set_up(news_);
}

wizard::WizardSearch GuidedSetUp::search() const {
    if (parts_.hand.looking()) return wizard::WizardSearch::Looking;
    if (parts_.hand.can_be_set_up()) return wizard::WizardSearch::Ready;
    return parts_.alone && !searched_ ? wizard::WizardSearch::NotBegun : wizard::WizardSearch::Nothing;
}

void GuidedSetUp::sense(double now_s) {
    const std::uint32_t stops = parts_.switches.stops;
    if (std::exchange(stops_, stops) != stops) session_->press("F12", now_s);
    parts_.hand.read();
    wizard::WizardSense sense;
    sense.now_s = now_s;
    sense.audible = parts_.ears.has_sound();
    sense.speaking = parts_.ears.sound().speaking();
    if (parts_.app.scene()) sense.listener = parts_.app.listener();
    sense.search = search();
    sense.news = std::exchange(news_, {});
    sense.hand = parts_.hand.facts();
    sense.tool = parts_.hand.tool();
    session_->tick(sense);
}

void GuidedSetUp::hand_over() {
    wizard::Wizard& wizard = session_->wizard();
    if (parts_.kept.take(wizard.take_setting_changes())) parts_.ears.sound().set_settings(parts_.settings.values());
    for (cues::CueRequest& cue : session_->take_cues()) parts_.ears.sound().post(std::move(cue));
    if (!parts_.hand.driven()) return;
    servo::ServoTuning tuning = wizard.tuning();
    if (!tuning.panic) let_go_ = stops_;
    tuning.stops_let_go = let_go_;
    tuning.focused = parts_.app.hand().tuning.focused;
    parts_.driver.feel_set_up({wizard.haptic_scene(), tuning, wizard.pose(), session_->simulated_hand()});
}

void GuidedSetUp::end_if_finished(double now_s) {
    if (!session_->finished()) return;
    core::Session& app = parts_.app;
    const bool stopped = session_->wizard().tuning().panic;
    parts_.driver.end_set_up(session_->wizard().tuning().confirm);
    session_.reset();
    app.apply(core::SetUpOver{}, now_s);
    if (!app.scene()) return;
    app.apply(core::SettingsChanged{parts_.settings.values()}, now_s);
    app.apply(core::Stopped{stops_}, now_s);
    // The session still has its forces switched off, because the person used the stop key during the set-up. The person
    // has since switched them on again in the wizard, so switch them on in the session, too.
    if (app.hand().tuning.panic && !stopped) {
        app.apply(core::CommandDown{core::Command::ToggleForces}, now_s);
        app.apply(core::CommandUp{core::Command::ToggleForces}, now_s);
    }
    parts_.say(phrase("program.back_in", {{"world", app.scene()->name}}));
}

}  // namespace handrail::program
