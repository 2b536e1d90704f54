#include "audio-cues/sinks/openal_speech.h"

#include <AL/alext.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "audio-cues/sinks/openal_voices.h"

namespace handrail::sinks {

void OpenALSpeech::make() {
    const ALint best_resampler = alGetInteger(AL_NUM_RESAMPLERS_SOFT) - 1;
    for (Speaker& s : speakers_) {
        s = Speaker{};
        alGenSources(1, &s.source);
        alSource3f(s.source, AL_POSITION, 0.0F, 0.0F, -1.0F);
        if (best_resampler >= 0) alSourcei(s.source, AL_SOURCE_RESAMPLER_SOFT, best_resampler);
    }
}

void OpenALSpeech::stop() {
    for (Speaker& s : speakers_) drop_speech(s);
}

void OpenALSpeech::drop() {
    for (Speaker& s : speakers_) alDeleteSources(1, &s.source);
}

void OpenALSpeech::give_up(VoiceChannel::Ticket spoken) {
    channel_->finished(spoken);
    speakers_[speaker_].ticket = spoken;
}

void OpenALSpeech::delete_played(const Speaker& s) {
    ALint played = 0;
    alGetSourcei(s.source, AL_BUFFERS_PROCESSED, &played);
    std::vector<ALuint> done(static_cast<std::size_t>(std::max(played, 0)));
    if (done.empty()) return;
    alSourceUnqueueBuffers(s.source, played, done.data());
    alDeleteBuffers(played, done.data());
}

void OpenALSpeech::drop_speech(Speaker& s) {
    alSourceStop(s.source);  // stops the source, after which OpenAL reports all of its buffers as played
    delete_played(s);
    alSourcei(s.source, AL_BUFFER, 0);
    s.active = s.ended = s.ending = false;
}

void OpenALSpeech::place(const Speaker& s, std::optional<double> right_rad, const settings::Settings::Sound& sound) {
    double right = 0.0, ahead = 1.0;
    if (right_rad && !sound.mono) right = std::sin(*right_rad), ahead = std::cos(*right_rad);
    if (sound.swap_sides) right = -right;
    alSource3f(s.source, AL_POSITION, static_cast<float>(right), 0.0F, static_cast<float>(-ahead));
}

void OpenALSpeech::update(double now_s, const settings::Settings::Sound& sound) {
    const VoiceChannel::Update update = channel_->take();
    if (update.ticket != speakers_[speaker_].ticket) {
        Speaker& cut = speakers_[speaker_];
        if (cut.active) {
            cut.ending = true;
            cut.stop_at_s = now_s + kFadeOut_s;
            alSourcef(cut.source, AL_GAIN, 0.0F);
        }
        speaker_ = 1 - speaker_;
        drop_speech(speakers_[speaker_]);
        speakers_[speaker_].ticket = update.ticket;
        speakers_[speaker_].gain = update.gain;
        place(speakers_[speaker_], update.right_rad, sound);
    }
    Speaker& s = speakers_[speaker_];
    s.ended = update.ended;
    if (!update.samples.empty()) {
        delete_played(s);  // otherwise a source that ran out of samples would play these buffers again
        ALuint buffer = 0;
        alGenBuffers(1, &buffer);
        alBufferData(buffer, AL_FORMAT_MONO16, update.samples.data(),
                     static_cast<ALsizei>(update.samples.size() * sizeof(std::int16_t)), update.rate_hz);
        alSourceQueueBuffers(s.source, 1, &buffer);
        alSourcef(s.source, AL_GAIN, static_cast<float>(s.gain));
        ALint state = 0;
        alGetSourcei(s.source, AL_SOURCE_STATE, &state);
        // The source is not playing before the first piece, or if the synthesis was slower than the speech.
        if (state != AL_PLAYING) alSourcePlay(s.source);
        s.active = true;
    }
    if (s.ended) {
        ALint state = 0;
        if (s.active) alGetSourcei(s.source, AL_SOURCE_STATE, &state);
        if (state != AL_PLAYING) {
            if (s.active) drop_speech(s);
            s.ended = true;
            channel_->finished(s.ticket);
        }
    }
    Speaker& other = speakers_[1 - speaker_];
    if (other.ending && now_s >= other.stop_at_s) drop_speech(other);
}

}  // namespace handrail::sinks
