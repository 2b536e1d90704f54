// Wraps the voice and the sounds, so that a recorder receives what they are given and what they answer. AudioThread
// owns the wrappers and calls all their functions on its thread.
#pragma once

#include <memory>
#include <utility>

#include "app/record/recorder.h"
#include "audio-cues/plan/sinks.h"

namespace handrail::record {

// Data of the current step that both sinks of a session share.
struct StepNotes {
    double now_s = 0.0;
    std::uint64_t step = 0;  // number of the step, counted from 0
    bool in_step = false;
    std::uint64_t answers = 1;  // answers of speaking() in this step as binary digits after a leading 1
    bool last_answer = false, changed = false;

    void begin(double at_s);
    // Ends the step and returns CueRow::speaking for it.
    std::uint64_t end();
};

class RecordedVoice final : public cues::SpeechSink {
public:
    // `recorder` must outlive this object.
    RecordedVoice(std::unique_ptr<cues::SpeechSink> voice, Recorder& recorder, std::shared_ptr<StepNotes> notes)
        : voice_(std::move(voice)), recorder_(recorder), notes_(std::move(notes)) {}

    void say(const cues::Utterance& utterance) override;
    void write(const cues::Utterance& utterance) override;
    void stop() override { voice_->stop(); }
    bool speaking() const override;
    void tick(double now_s) override { voice_->tick(now_s); }
    void set_speech(const settings::Settings::Speech& settings) override { voice_->set_speech(settings); }
    std::optional<std::string> news() override;
    std::string who() const override { return voice_->who(); }

private:
    std::unique_ptr<cues::SpeechSink> voice_;
    Recorder& recorder_;
    std::shared_ptr<StepNotes> notes_;
};

class RecordedSound final : public cues::AudioSink {
public:
    RecordedSound(std::unique_ptr<cues::AudioSink> sound, Recorder& recorder, std::shared_ptr<StepNotes> notes)
        : sound_(std::move(sound)), recorder_(recorder), notes_(std::move(notes)) {}

    void play(const cues::SoundCue& cue) override { sound_->play(cue); }
    void set_loop(const cues::SoundCue& cue) override { sound_->set_loop(cue); }
    void set_listener(const cues::Listener& listener) override { sound_->set_listener(listener); }
    void set_sound(const settings::Settings::Sound& settings) override { sound_->set_sound(settings); }
    void set_speaking(bool speaking) override { sound_->set_speaking(speaking); }
    void stop_all() override { sound_->stop_all(); }
    void tick(double now_s) override { sound_->tick(now_s); }
    bool drops_out() const override { return sound_->drops_out(); }
    std::optional<std::string> news() override;

private:
    std::unique_ptr<cues::AudioSink> sound_;
    Recorder& recorder_;
    std::shared_ptr<StepNotes> notes_;
};

}  // namespace handrail::record
