#include "app/core/hand/forces.h"

#include <cmath>

#include "app/core/dialogue/words.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kSamePress_s = 0.25;
constexpr double kBreakEvery_s = 15.0 * 60.0;

}  // namespace

bool Forces::act(Command command, double now_s) {
    if (command != Command::ToggleForces) return false;
    toggle(now_s);
    return true;
}

void Forces::toggle(double now_s) {
    const bool stopped = hands_.tuning.panic || stops_known_ != hands_.tuning.stops_let_go;
    if (offered_ && !stopped) {
        offered_ = false;
        context_.requests.offered_hand = true;
        return;
    }
    if (!hands_.right.present && !stopped) return context_.answer(phrase("session.no_hand"), now_s);
    const bool wake = stopped || hands_.tool.fault != servo::Fault::None ||
                      hands_.left_tool.fault != servo::Fault::None || !hands_.tuning.forces_on;
    hands_.tuning.panic = false;
    hands_.tuning.stops_let_go = stops_known_;
    hands_.tuning.forces_on = wake;
    if (wake) ++hands_.tuning.confirm;
    if (wake && hands_.tool.fault_lasts) return context_.answer(why_none_yet(), now_s);
    if (!hands_.right.present) return context_.answer(phrase("session.sounds_again"), now_s);
    context_.play(wake ? cues::SoundKind::ForcesOn : cues::SoundKind::ForcesOff, now_s);
    context_.answer(phrase(wake ? "session.forces_on" : "session.forces_off"), now_s);
}

// Returns the announcement for a press of the force key while the cause that switched off the force persists.
std::string Forces::why_none_yet() const {
    switch (hands_.tool.fault) {
        case servo::Fault::Unplugged:
            return phrase("session.unplugged");
        case servo::Fault::TooHot:
            return phrase("session.too_warm");
        default:
            return servo::fault_sentence(hands_.tool.fault);
    }
}

bool Forces::stop(double now_s) {
    if (hands_.tuning.panic && now_s - stopped_s_ < kSamePress_s) return false;
    stopped_s_ = now_s;
    hands_.tuning.panic = true;
    hands_.tuning.workspace.grab_key = false;
    cues::CueRequest silence;
    silence.kind = cues::CueRequestKind::SilenceAll;
    silence.time_s = now_s;
    context_.cues.cue(std::move(silence));
    context_.say(phrase(hands_.right.present ? "session.stopped" : "session.stopped_sounds",
                        {{"key", context_.keys.keys_of(Command::ToggleForces)}}),
                 cues::SpeechClass::Alarm, now_s);
    return true;
}

bool Forces::know_stops(std::uint32_t stops) {
    return std::exchange(stops_known_, stops) != stops && !hands_.tuning.panic;
}

void Forces::take(const HandFacts& hand) {
    contact_before_s_ += hands_.tool.contact_s;
    hands_.tool = servo::ToolState{};
    fault_lasted_ = false;
    hands_.right = hand;
}

void Forces::offer(const std::string& spoken_name, double now_s) {
    offered_ = true;
    context_.say(found_words(spoken_name) + " " +
                     phrase("session.press_to_use", {{"key", context_.keys.keys_of(Command::ToggleForces)}}),
                 cues::SpeechClass::Answer, now_s);
}

void Forces::tick(double now_s) {
    const bool was_waiting = std::exchange(fault_lasted_, hands_.tool.fault_lasts);
    if (!was_waiting || hands_.tool.fault_lasts || !hands_.tool.fault_latched) return;
    const std::string key = context_.keys.keys_of(Command::ToggleForces);
    if (servo::is_lost(hands_.tool.fault))
        context_.say(phrase("session.plugged_in_again", {{"key", key}}), cues::SpeechClass::Alarm, now_s);
    if (hands_.tool.fault == servo::Fault::TooHot)
        context_.say(phrase("session.cooled", {{"key", key}}), cues::SpeechClass::Alarm, now_s);
}

void Forces::announce_break(double now_s) {
    const double contact_s = contact_before_s_ + hands_.tool.contact_s;
    if (contact_s < (breaks_announced_ + 1.0) * kBreakEvery_s) return;
    breaks_announced_ = std::floor(contact_s / kBreakEvery_s);
    context_.say(phrase("session.take_a_break", {{"time", minutes_words(contact_s)}}), cues::SpeechClass::Ambient,
                 now_s);
}

}  // namespace handrail::core
