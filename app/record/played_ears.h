// Computes the ears (the audio thread) of a recorded session again, step by step. The inputs are the items that the app
// hands over, and the contacts of the hands. A simulated voice answers as the recorded one did. One thread.
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

    // Functions by which the app hands over items. Each call counts as one item of posted().
    void post(cues::CueRequest request) override;
    void set_settings(const settings::Settings& settings) override;
    void set_two_hands(bool two) override;
    void set_hand_stands_in(bool stands_in) override;
    void enter_world(std::shared_ptr<const Scene> scene) override;
    void follow_edit(std::shared_ptr<const Scene> scene) override;
    void set_listener(const cues::Listener& listener) override { listener_ = listener; }
    std::size_t posted() const { return posts_.size(); }
    // Stores what a sink reported about itself, and the step in which it reported that.
    void hear_of(std::uint64_t step, bool from_voice, std::string text);

    // Computes one step, which reads row.posts items. Requires row.posts <= posted().
    void step(const CueRow& row, std::vector<servo::ContactEvent> contacts);
    // Writes the lines that still wait. Call it at the end.
    void finish();
    const std::vector<SaidLine>& said() const { return voice_.said; }

private:
    struct Voice final : cues::SpeechSink {
        double now_s = 0.0;  // time since the recording began
        std::uint64_t answers = 0;
        int answers_left = 0;
        bool last = false;
        std::vector<SaidLine> said;
        std::string reported;  // what the voice reported about itself in this step

        void begin(std::uint64_t speaking);
        void end();
        bool answer();
        void say(const cues::Utterance& utterance) override { keep(utterance, true); }
        void write(const cues::Utterance& utterance) override { keep(utterance, false); }
        void stop() override {}
        // Returns the next recorded answer. The computed ears call speaking() in the same order as the recorded ones,
        // so the answers match.
        bool speaking() const override { return const_cast<Voice*>(this)->answer(); }
        std::optional<std::string> news() override;
        void keep(const cues::Utterance& utterance, bool voiced);
    };
    struct Silence final : cues::AudioSink {
        std::string reported;
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
    // For each step: what the voice and the sounds reported about themselves.
    std::map<std::uint64_t, std::pair<std::string, std::string>> news_;
    cues::Listener listener_;
    std::uint64_t steps_ = 0;
    double last_s_ = 0.0;
};

}  // namespace handrail::record
