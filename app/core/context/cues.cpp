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

void Cues::quiet(double now_s) {
    CueRequest request;
    request.kind = CueRequestKind::Interrupt;
    request.time_s = now_s;
    cue(std::move(request));
}

}  // namespace handrail
