#include "app/core/movers/triggers.h"

#include <algorithm>
#include <utility>

#include "app/core/context/context_words.h"
#include "worlds/base/language.h"
#include "worlds/scene/surfaces.h"

namespace handrail::core {

void Triggers::enter_world() {
    inside_.clear();
    announced_.clear();
}

void Triggers::tick(double now_s) {
    std::vector<FeatureId> now = context_.world.solids->volumes_at(
        context_.avatar.feet_m(), context_.avatar.walker->size().height_m, SolidRole::Trigger);
    for (const FeatureId liquid : context_.world.solids->volumes_at(
             context_.avatar.feet_m(), context_.avatar.walker->size().height_m, SolidRole::Liquid))
        now.push_back(liquid);
    for (const FeatureId id : now) {
        const Feature* feature = context_.world.scene->find(id);
        if (feature && std::find(inside_.begin(), inside_.end(), id) == inside_.end()) meet_switch(id, now_s);
        if (!feature || std::find(inside_.begin(), inside_.end(), id) != inside_.end()) continue;
        if (feature->kind == FeatureKind::Liquid) {
            cues::CueRequest splash;
            splash.kind = cues::CueRequestKind::Play;
            splash.sound = cues::SoundKind::Splash;
            splash.material = SoundClass::Water;
            splash.time_s = now_s;
            splash.position_m = context_.avatar.feet_m();
            context_.cues.cue(std::move(splash));
            context_.say(sentence_case(name_of(context_, id)), cues::SpeechClass::Contact, now_s);
        } else if (!feature->message.empty() &&
                   std::find(announced_.begin(), announced_.end(), id) == announced_.end()) {
            announced_.push_back(id);
            context_.say(spoken_message(*feature), cues::SpeechClass::Answer, now_s);
        }
    }
    inside_ = std::move(now);
}

void Triggers::meet_switch(FeatureId volume, double now_s) {
    for (const Switch& act : context_.world.scene->switches) {
        if (act.volume != volume || std::find(used_.begin(), used_.end(), volume) != used_.end()) continue;
        if (act.once) used_.push_back(volume);
        for (const std::uint32_t mover : act.sets_going) world_.movers.call(mover);
        if (!act.leads_elsewhere) continue;
        if (on_leads_elsewhere) on_leads_elsewhere(act.feet_m, act.heading_rad, now_s);
        return;
    }
}

}  // namespace handrail::core
