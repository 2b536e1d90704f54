#include "app/core/context/cues.h"

namespace handrail {

CueRequest sound_at(SoundKind kind, const Vec3& place_m, double now_s) {
    CueRequest sound;
    sound.kind = CueRequestKind::Play;
    sound.sound = kind;
    sound.time_s = now_s;
    sound.position_m = place_m;
    return sound;
}

void Cues::say(std::string text, SpeechClass speech_class, double now_s) {
    CueRequest request;
    request.kind = CueRequestKind::Say;
    request.time_s = now_s;
    request.text = std::move(text);
    request.speech_class = speech_class;
    request.repeatable = speech_class == SpeechClass::Answer;
    cue(std::move(request));
}

void Cues::tell(SpeechTopic topic, std::string text, double now_s, const Telling& how) {
    const bool guidance = !how.answers && (topic == SpeechTopic::Place || topic == SpeechTopic::Leg);
    CueRequest request;
    request.kind = CueRequestKind::Say;
    request.time_s = now_s;
    request.text = std::move(text);
    request.topic = topic;
    request.speech_class = guidance                      ? SpeechClass::Guidance
                           : topic == SpeechTopic::Steps ? SpeechClass::Contact
                                                         : SpeechClass::Answer;
    // Of places alone it matters that they were named a moment ago: who stands between two rooms is in both by turns.
    request.repeatable = how.anew || how.answers || topic != SpeechTopic::Place;
    request.placed = how.place_m.has_value();
    request.position_m = how.place_m.value_or(Vec3(0.0));
    cue(std::move(request));
}

void Cues::quiet(double now_s) {
    CueRequest request;
    request.kind = CueRequestKind::Interrupt;
    request.time_s = now_s;
    cue(std::move(request));
}

}  // namespace handrail
