#include "audio-cues/plan/cue_planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audio-cues/plan/speakable.h"

namespace handrail {
namespace {

constexpr double kSayAgain_s = 5.0;              // decisions: nothing spoken twice in 5 s
constexpr double kSettle_s = 0.040;              // a corner's second surface arrives within a few ticks; the first word is due after 120 ms
constexpr double kChatter_s = 0.050;             // the same feature again within this is one contact to the ear
constexpr double kKeepName_s = 0.5;              // a tap is still named when the voice is free this soon
constexpr double kKeepBump_s = 2.0;              // longer for a bump: the body does not leave by itself
constexpr double kSlideSilent_s = 0.15;          // no slide event for this long: the hand rests
constexpr double kSlideOwner_s = 0.05;           // events come every 10 ms while a surface is slid along
constexpr double kSlideSlowest_m_per_s = 0.004;  // of hand travel; slower is inaudible
constexpr double kFastTouch_m_per_s = 0.3;       // of hand travel; a brisk tap, full loudness
constexpr double kAlarmFloor = 0.2;              // settings: everything but alarms may fall below
constexpr std::size_t kMostAlarmsWaiting = 4;

std::string metres(double length_m) {
    const double rounded = std::round(length_m * 10.0) / 10.0;
    return fmt::format("{:g} {}", rounded, rounded == 1.0 ? "metre" : "metres");
}

std::string size_sentence(const Feature& feature) {
    const Vec3 size = feature.bounds_m.max_m - feature.bounds_m.min_m;
    const auto area = [](double a_m, double b_m) { return fmt::format("{:g} by {}", std::round(a_m * 10.0) / 10.0, metres(b_m)); };
    if (feature.kind == FeatureKind::Floor || feature.kind == FeatureKind::Ceiling) return area(size.x, size.y) + ".";
    if (feature.kind == FeatureKind::Object) return fmt::format("{}, {} high.", area(std::max(size.x, size.y), std::min(size.x, size.y)), metres(size.z));
    return fmt::format("{} wide, {} high.", metres(std::max(size.x, size.y)), metres(size.z));
}

}  // namespace

std::string describe_feature(const Scene& scene, FeatureId id, int verbosity) {
    const Feature* feature = scene.find(id);
    if (feature == nullptr || verbosity <= 0) return {};
    std::string text = verbosity == 1 ? feature->name : spoken_name(scene, id);
    if (text.empty() || verbosity == 1) return sentence_case(text);
    if (!feature->handle.empty()) text += fmt::format(", handle on the {} side", feature->handle);
    if (verbosity >= 3 && !feature->hinge.empty()) text += fmt::format(", hinged on the {} side", feature->hinge);
    if (verbosity >= 4) text += ". " + size_sentence(*feature);
    if (verbosity >= 3 && !feature->message.empty()) text += (text.back() == '.' ? " " : ". ") + feature->message;
    return sentence_case(text);
}

CuePlanner::CuePlanner(Settings settings) : settings_(std::move(settings)) {}

void CuePlanner::set_settings(const Settings& settings) { settings_ = settings; }

void CuePlanner::enter_world(std::shared_ptr<const Scene> scene) {
    scene_ = std::move(scene);
    touched_.clear();
    recent_.clear();
    name_.reset();
}

void CuePlanner::follow_edit(std::shared_ptr<const Scene> scene) { scene_ = std::move(scene); }

void CuePlanner::tick(const CueInputs& inputs, AudioSink& audio, SpeechSink& speech) {
    // 1. The sinks take the time first, so that what is played below carries it.
    audio.set_listener(inputs.listener);
    audio.tick(inputs.now_s);
    speech.tick(inputs.now_s);
    if (const auto news = audio.news()) ask(*news, SpeechClass::Alarm, inputs.now_s, false);
    if (const auto news = speech.news()) ask(*news, SpeechClass::Alarm, inputs.now_s, false);
    // 2. What happened, then what is asked for.
    for (const ContactEvent& event : inputs.contacts) on_contact(event, audio);
    for (const CueRequest& request : inputs.requests) on_request(request, inputs.now_s, audio, speech);
    // 3. Loops whose cause is gone.
    if (sliding_ && inputs.now_s - slide_s_ > kSlideSilent_s) stop_slide(audio);
    if (wall_tone_on_ && !settings_.sound.wall_tone) {
        audio.set_loop({.kind = SoundKind::WallTone, .loudness = 0.0});
        wall_tone_on_ = false;
    }
    // 4. One voice.
    speak_waiting(inputs.now_s, speech);
}

void CuePlanner::flush(double now_s, SpeechSink& speech) {
    write_waiting(alarms_, now_s, speech);
    write_waiting(answers_, now_s, speech);
}

SoundClass CuePlanner::sound_of(MaterialId material) const {
    return scene_ && !scene_->materials.empty() ? scene_->material(material).sound : SoundClass::Generic;
}

double CuePlanner::volume_of(SoundKind kind) const {
    const Settings::Sound& sound = settings_.sound;
    switch (kind) {
        case SoundKind::Contact:
        case SoundKind::Slide:
        case SoundKind::Splash:
            return sound.volume * sound.contact_volume;
        case SoundKind::Footstep:
        case SoundKind::Bump:
            return sound.volume * sound.footstep_volume;
        case SoundKind::WallTone:
            return sound.volume * sound.wall_tone_volume;
        case SoundKind::Alarm:
            return std::max(sound.volume, kAlarmFloor);
        default:
            return sound.volume;
    }
}

void CuePlanner::play(SoundCue cue, AudioSink& audio) const {
    cue.loudness = std::clamp(cue.loudness, 0.0, 1.0) * volume_of(cue.kind);
    if (cue.kind == SoundKind::Alarm) cue.loudness = std::max(cue.loudness, kAlarmFloor);
    if (cue.loudness > 0.0) audio.play(cue);
}

void CuePlanner::touch(FeatureId feature) {
    if (feature && !is_touched(feature)) touched_.push_back(feature);
}

bool CuePlanner::is_touched(FeatureId feature) const { return std::find(touched_.begin(), touched_.end(), feature) != touched_.end(); }

void CuePlanner::stop_slide(AudioSink& audio) {
    if (sliding_) audio.set_loop({.kind = SoundKind::Slide, .loudness = 0.0});
    sliding_ = false;
}

void CuePlanner::name_touched(FeatureId feature, double time_s, double settle_s, double keep_s) {
    if (!scene_) return;
    const std::string text = describe_feature(*scene_, feature, settings_.speech.verbosity);
    if (text.empty()) return;
    // A hand that trembles between two surfaces must not put the name off for ever: the first touch sets the time, the last one the name.
    const double due_s = name_ ? std::min(name_->due_s, time_s + settle_s) : time_s + settle_s;
    name_ = Waiting{.utterance = {.text = text, .speech_class = SpeechClass::Contact},
                    .due_s = due_s,
                    .asked_s = time_s,
                    .touched = feature,
                    .expires_s = time_s + settle_s + keep_s};
}

void CuePlanner::on_contact(const ContactEvent& event, AudioSink& audio) {
    switch (event.kind) {
        case ContactEventKind::Begin: {
            hushed_ = false;
            std::erase_if(recent_, [&](const RecentContact& r) { return event.time_s - r.time_s >= kChatter_s; });
            const bool chatter = std::any_of(recent_.begin(), recent_.end(), [&](const RecentContact& r) { return r.feature == event.feature; });
            if (!chatter) {
                recent_.push_back({event.feature, event.time_s});
                // Loudness follows the square root of speed: a slow touch of 1 cm/s is still heard over the room.
                const double force_of_blow = std::sqrt(std::min(1.0, std::max(0.0, event.speed_m_per_s) / kFastTouch_m_per_s));
                play({.kind = SoundKind::Contact,
                      .material = sound_of(event.material),
                      .position_m = event.position_m,
                      .loudness = 0.25 + 0.75 * force_of_blow,
                      .event_time_s = event.time_s},
                     audio);
            }
            touch(event.feature);
            name_touched(event.feature, event.time_s, kSettle_s, kKeepName_s);
            return;
        }
        case ContactEventKind::Slide: {
            if (event.feature && !is_touched(event.feature)) {  // slid onto something else without leaving the surface
                touch(event.feature);
                name_touched(event.feature, event.time_s, kSettle_s, kKeepName_s);
            }
            // In a corner two surfaces are slid along at once; one of them is heard until it stops, not both in turn.
            if (sliding_ && event.feature != slide_feature_ && event.time_s - slide_s_ < kSlideOwner_s) return;
            slide_s_ = event.time_s;
            slide_feature_ = event.feature;
            if (hushed_ || event.speed_m_per_s < kSlideSlowest_m_per_s) return stop_slide(audio);
            const double pace = std::min(1.0, event.speed_m_per_s / kFastTouch_m_per_s);
            sliding_ = true;
            audio.set_loop({.kind = SoundKind::Slide,
                            .material = sound_of(event.material),
                            .position_m = event.position_m,
                            .loudness = std::sqrt(pace) * volume_of(SoundKind::Slide),
                            .pitch = 0.75 + 0.5 * pace,
                            .event_time_s = event.time_s});
            return;
        }
        case ContactEventKind::End:
            std::erase(touched_, event.feature);
            if (touched_.empty() || slide_feature_ == event.feature) stop_slide(audio);
            return;
        case ContactEventKind::EnterLiquid:
        case ContactEventKind::LeaveLiquid: {
            const bool entering = event.kind == ContactEventKind::EnterLiquid;
            if (entering) hushed_ = false;
            play({.kind = SoundKind::Splash,
                  .material = SoundClass::Water,
                  .position_m = event.position_m,
                  .loudness = entering ? 1.0 : 0.4,
                  .event_time_s = event.time_s},
                 audio);
            if (entering) {
                touch(event.feature);
                name_touched(event.feature, event.time_s, kSettle_s, kKeepName_s);
            } else {
                std::erase(touched_, event.feature);
            }
            return;
        }
        case ContactEventKind::FaultRaised:
            stop_slide(audio);
            play({.kind = SoundKind::Alarm, .event_time_s = event.time_s}, audio);
            ask(fault_sentence(event.fault), SpeechClass::Alarm, event.time_s, false);
            return;
        case ContactEventKind::FaultCleared:
            play({.kind = SoundKind::ForcesOn, .event_time_s = event.time_s}, audio);
            return;
    }
}

void CuePlanner::on_request(const CueRequest& request, double now_s, AudioSink& audio, SpeechSink& speech) {
    const double asked_s = request.time_s > 0.0 ? request.time_s : now_s;
    SoundCue cue{.material = request.material, .position_m = request.position_m, .loudness = request.loudness, .event_time_s = asked_s};
    switch (request.kind) {
        case CueRequestKind::Say:
            if (request.speech_class == SpeechClass::Answer)
                answer({.utterance = {.text = request.text}, .asked_s = asked_s, .repeatable = request.repeatable}, now_s, speech);
            else ask(request.text, request.speech_class, asked_s, request.repeatable);
            return;
        case CueRequestKind::Footstep:
            hushed_ = false;
            left_foot_ = !left_foot_;
            cue.kind = SoundKind::Footstep;
            cue.pitch = left_foot_ ? 0.97 : 1.03;  // two feet are never quite alike; equal steps sound like a machine
            play(cue, audio);
            return;
        case CueRequestKind::Bump: {
            hushed_ = false;
            cue.kind = SoundKind::Bump;
            const Feature* feature = scene_ ? scene_->find(request.feature) : nullptr;
            if (cue.material == SoundClass::Generic && feature != nullptr) cue.material = sound_of(feature->material);
            play(cue, audio);
            name_touched(request.feature, asked_s, 0.0, kKeepBump_s);
            return;
        }
        case CueRequestKind::WallTone: {
            cue.kind = SoundKind::WallTone;
            cue.loudness = hushed_ || !settings_.sound.wall_tone ? 0.0 : std::clamp(request.loudness, 0.0, 1.0) * volume_of(SoundKind::WallTone);
            const bool on = cue.loudness > 0.0;
            if (on || wall_tone_on_) audio.set_loop(cue);
            wall_tone_on_ = on;
            return;
        }
        case CueRequestKind::StopSpeech:
        case CueRequestKind::SilenceAll:
            speech.stop();
            flush(now_s, speech);
            name_.reset();
            hint_.reset();
            if (request.kind == CueRequestKind::StopSpeech) return;
            audio.stop_all();
            sliding_ = wall_tone_on_ = false;
            hushed_ = true;
            return;
        case CueRequestKind::Play:
            cue.kind = request.sound;
            play(cue, audio);
            return;
        case CueRequestKind::Repeat: {
            const std::string text = spoken_.empty() ? "Nothing has been said yet." : spoken_.back().text;
            answer({.utterance = {.text = text}, .asked_s = asked_s, .repeatable = true}, now_s, speech);
            return;
        }
    }
}

void CuePlanner::ask(const std::string& text, SpeechClass speech_class, double asked_s, bool repeatable) {
    Waiting waiting{.utterance = {.text = speakable(text), .speech_class = speech_class}, .asked_s = asked_s, .repeatable = repeatable};
    if (waiting.utterance.text.empty()) return;
    if (speech_class == SpeechClass::Alarm) {
        if (alarms_.size() == kMostAlarmsWaiting) alarms_.pop_front();
        alarms_.push_back(std::move(waiting));
    } else if (settings_.speech.verbosity > 0) {
        waiting.expires_s = asked_s + kKeepName_s;
        (speech_class == SpeechClass::Contact ? name_ : hint_) = std::move(waiting);
    }
}

void CuePlanner::answer(Waiting waiting, double now_s, SpeechSink& speech) {
    waiting.utterance.text = speakable(waiting.utterance.text);
    if (waiting.utterance.text.empty()) return;
    if (!answers_.empty() && answers_.front().asked_s != waiting.asked_s) write_waiting(answers_, now_s, speech);
    answers_.push_back(std::move(waiting));
}

void CuePlanner::write_waiting(std::deque<Waiting>& queue, double now_s, SpeechSink& speech) {
    for (const Waiting& waiting : queue)
        if (keep_line(waiting, now_s)) speech.write(waiting.utterance);
    queue.clear();
}

void CuePlanner::speak_waiting(double now_s, SpeechSink& speech) {
    // The class that is speaking now, if any; a sink without duration is never busy, so everything is said in this very tick.
    const auto busy_with = [&](SpeechClass c) { return speech.speaking() && speaking_class_ == c; };
    while (!alarms_.empty() && !busy_with(SpeechClass::Alarm)) {
        say_now(alarms_.front(), now_s, speech);
        alarms_.pop_front();
    }
    while (!answers_.empty() && !busy_with(SpeechClass::Alarm)) {
        const bool same_reply = answers_.front().asked_s == speaking_asked_s_;
        if (busy_with(SpeechClass::Answer) && same_reply) break;
        say_now(answers_.front(), now_s, speech);
        answers_.pop_front();
    }
    const bool engaged = waiting() || busy_with(SpeechClass::Alarm) || busy_with(SpeechClass::Answer);
    if (name_ && name_->due_s <= now_s) {
        const bool stale = now_s > name_->expires_s && !is_touched(name_->touched);
        if (!stale && !engaged) say_now(*name_, now_s, speech);
        if (stale || !engaged) name_.reset();
    }
    // A hint is never kept for later: by then it is about something else.
    if (hint_ && !waiting() && !name_ && !speech.speaking()) say_now(*hint_, now_s, speech);
    hint_.reset();
}

bool CuePlanner::keep_line(const Waiting& waiting, double now_s) {
    std::erase_if(said_at_s_, [&](const auto& said) { return now_s - said.second >= kSayAgain_s; });
    const auto [said, is_new] = said_at_s_.try_emplace(waiting.utterance.text, now_s);
    if (!is_new && !waiting.repeatable) return false;
    said->second = now_s;
    if (spoken_.size() == kMaxSpoken) spoken_.erase(spoken_.begin());
    spoken_.push_back({now_s, waiting.utterance.text, waiting.utterance.speech_class});
    ++spoken_in_all_;
    return true;
}

void CuePlanner::say_now(const Waiting& waiting, double now_s, SpeechSink& speech) {
    if (!keep_line(waiting, now_s)) return;
    Utterance utterance = waiting.utterance;
    utterance.loudness = std::clamp(settings_.sound.volume * settings_.sound.speech_volume, 0.0, 1.0);
    if (utterance.speech_class == SpeechClass::Alarm) utterance.loudness = std::max(utterance.loudness, kAlarmFloor);
    speech.say(utterance);
    speaking_class_ = utterance.speech_class;
    speaking_asked_s_ = waiting.asked_s;
}

}  // namespace handrail
