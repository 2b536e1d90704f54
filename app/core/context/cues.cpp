#include "app/core/context/cues.h"

namespace handrail::core {

cues::CueRequest sound_at(cues::SoundKind kind, const Vec3& place_m, double now_s) {
    cues::CueRequest sound;
    sound.kind = cues::CueRequestKind::Play;
    sound.sound = kind;
    sound.time_s = now_s;
    sound.position_m = place_m;
    return sound;
}

void Cues::say(std::string text, cues::SpeechClass speech_class, double now_s) {
    cues::CueRequest request;
    request.kind = cues::CueRequestKind::Say;
    request.time_s = now_s;
    request.text = std::move(text);
    request.speech_class = speech_class;
    request.repeatable = speech_class == cues::SpeechClass::Answer;
    cue(std::move(request));
}

void Cues::announce(cues::SpeechTopic topic, std::string text, double now_s, const AnnounceOptions& how) {
    const bool guidance = !how.answers && (topic == cues::SpeechTopic::Place || topic == cues::SpeechTopic::Arrival ||
                                           topic == cues::SpeechTopic::Leg);
    // The summary of another route replaces a leg of the route before it.
    if (topic == cues::SpeechTopic::Leg || topic == cues::SpeechTopic::Summary) last_leg_ = text;
    cues::CueRequest request;
    request.kind = cues::CueRequestKind::Say;
    request.time_s = now_s;
    request.text = std::move(text);
    request.topic = topic;
    request.speech_class = guidance                            ? cues::SpeechClass::Guidance
                           : topic == cues::SpeechTopic::Steps ? cues::SpeechClass::Contact
                                                               : cues::SpeechClass::Answer;
    // Only the name of a place must not be repeated soon, because a person who stands between two rooms alternates
    // between them.
    request.repeatable = how.anew || how.answers || topic != cues::SpeechTopic::Place;
    request.placed = how.place_m.has_value();
    request.position_m = how.place_m.value_or(Vec3(0.0));
    cue(std::move(request));
}

void Cues::quiet(double now_s) {
    cues::CueRequest request;
    request.kind = cues::CueRequestKind::Interrupt;
    request.time_s = now_s;
    cue(std::move(request));
}

}  // namespace handrail::core
