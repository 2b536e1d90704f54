// Computes the ears of a recording again, step by step, with what the app hands over, the contacts of the hands, and a
// voice that answers as the recorded one did. One thread.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "app/record/recording.h"
#include "audio-cues/plan/cue_planner.h"
#include "audio-cues/plan/ears_inbox.h"

namespace handrail::record {

class PlayedEars final : public cues::EarsInbox {
public:
    PlayedEars(const settings::Settings& settings, double begun_s);

    // What the app hands over; each item is counted.
    void post(cues::CueRequest request) override;
    void set_settings(const settings::Settings& settings) override;
    void set_two_hands(bool two) override;
    void set_hand_stands_in(bool stands_in) override;
    void enter_world(std::shared_ptr<const Scene> scene) override;
    void follow_edit(std::shared_ptr<const Scene> scene) override;
    void set_listener(const cues::Listener& listener) override { listener_ = listener; }
    std::size_t posted() const { return posts_.size(); }
    // Notes what a sink reported about itself, and in which step.
    void hear_of(std::uint64_t step, bool from_voice, std::string text);

    // Requires row.posts <= posted().
    void step(const CueRow& row, std::vector<servo::ContactEvent> contacts);
    // Call at the end: writes the lines that are still waiting.
    void finish();
    const std::vector<SaidLine>& said() const { return voice_.said; }

private:
    struct Voice final : cues::SpeechSink {
        double now_s = 0.0;  // since the recording began
        std::uint64_t answers = 0;
        int answers_left = 0;
        bool last = false;
        std::vector<SaidLine> said;
        std::string told;  // what the voice reported about itself in this step

        void begin(std::uint64_t speaking);
        void end();
        bool answer();
        void say(const cues::Utterance& utterance) override { keep(utterance, true); }
        void write(const cues::Utterance& utterance) override { keep(utterance, false); }
        void stop() override {}
        // The recorded voice answered in a fixed order, so each call returns the next recorded answer.
        bool speaking() const override { return const_cast<Voice*>(this)->answer(); }
        std::optional<std::string> news() override;
        void keep(const cues::Utterance& utterance, bool voiced);
    };
    struct Silence final : cues::AudioSink {
        std::string told;
        void play(const cues::SoundCue&) override {}
        void set_loop(const cues::SoundCue&) override {}
        void set_listener(const cues::Listener&) override {}
        void stop_all() override {}
        void tick(double) override {}
        std::optional<std::string> news() override;
    };
    enum class Kind { Request, Settings, TwoHands, StandsIn, World, Edit };
    struct Post {
        Kind kind = Kind::Request;
        cues::CueRequest request;
        settings::Settings settings;
        std::shared_ptr<const Scene> scene;
        bool yes = false;
    };

    double begun_s_;
    cues::CuePlanner planner_;
    Voice voice_;
    Silence sound_;
    std::deque<Post> posts_;
    // By step: news of the voice, and of the sounds.
    std::map<std::uint64_t, std::pair<std::string, std::string>> news_;
    cues::Listener listener_;
    std::uint64_t steps_ = 0;
    double last_s_ = 0.0;
};

}  // namespace handrail::record
