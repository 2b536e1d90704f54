// The order in which lines are spoken, and which of them are dropped: decided here alone, for every voice, screen
// reader and braille display. It has plain values and no sinks; CuePlanner reports what happens and does what it
// decides. On the thread of CuePlanner. A few lines at most wait, so each call costs little.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "audio-cues/plan/sinks.h"
#include "worlds/base/feature_id.h"

namespace handrail::cues {

struct SpeechLine {
    Utterance utterance;
    double asked_s = 0.0;    // time of the request or event
    double due_s = 0.0;      // not said before
    double expires_s = 0.0;  // of Contact: kept until then, a name also as long as the hand touches the thing
    bool repeatable = false;
    bool again = false;
    bool cuts = false;               // an alarm that does not wait for another one
    FeatureId touched = kNoFeature;  // a name: of this
    std::uint8_t hand = 0;           // a name: touched by this hand
    std::uint64_t key = 0;           // set by SpeechOrder: how many keys had been pressed
};

class SpeechOrder {
public:
    static constexpr double kPause_s = 1.0;  // what was cut is made anew once nothing was said or pressed for so long
    static constexpr std::size_t kMostDanger = 4;   // alarms that wait, and warnings
    static constexpr std::size_t kMostWaiting = 8;  // answers that wait, and lines of guidance

    // It waits for its turn. Of names, step counts and topics that replace each other the newest stays.
    void add(SpeechLine line);
    // A key was pressed. True: what is being spoken ends. What waits to be said is dropped, but for alarms and
    // warnings.
    bool key(double now_s, bool speaking);
    // A stop key was pressed: everything that waits is dropped, and nothing is made anew.
    void silence(double now_s);
    // What is known outside of a line that waits.
    struct Knows {
        std::function<bool(const SpeechLine& name)> touches;  // its thing is still touched
        std::function<bool(const SpeechLine& line)> said;     // the same was said so lately that it is not said again
    };
    // The next line to be said at once, if there is one; call again until there is none. `speaking`: as the sink says
    // now.
    std::optional<SpeechLine> next(double now_s, bool speaking, const Knows& knows);
    // Lines that will not be spoken, oldest first, for sinks that keep text.
    std::vector<SpeechLine> take_unspoken();
    // The topics of lines that were cut or dropped, once nothing has been said or pressed for kPause_s; the session
    // makes those lines anew that are still true. Each is given once.
    SpeechTopics take_owed(double now_s, bool speaking);

    bool waiting() const { return !alarms_.empty() || !warnings_.empty() || !answers_.empty() || !guidance_.empty(); }
    bool answers_wait() const { return !answers_.empty(); }
    void forget_names();
    // The name that waits to be said of what this hand touches.
    const std::optional<SpeechLine>& name_of(std::size_t hand) const { return names_.at(hand); }

private:
    void note(double now_s, bool speaking);
    bool busy(SpeechClass least) const;
    SpeechLine begin(std::deque<SpeechLine>& queue, double now_s);
    SpeechLine begin(SpeechLine line, double now_s);
    void drop(SpeechLine line);
    void drop_all(std::deque<SpeechLine>& queue);
    void queue(std::deque<SpeechLine>& lines, SpeechLine line, std::size_t most);
    std::optional<SpeechLine> next_of_importance(double now_s);
    std::optional<SpeechLine> next_name(double now_s, const Knows& knows);
    void leave_out_what_was_said(double now_s, const Knows& knows);
    std::optional<SpeechLine> next_of_the_rest(double now_s);

    std::deque<SpeechLine> alarms_, warnings_, answers_, guidance_, hints_;
    std::array<std::optional<SpeechLine>, 2> names_;  // by hand
    std::optional<SpeechLine> steps_;
    std::optional<SpeechLine> current_;  // being spoken
    std::vector<SpeechLine> unspoken_;
    SpeechTopics owed_;
    std::uint64_t keys_ = 0;
    double sounded_s_ = -1e9;  // when something was last spoken, or a key pressed
};

}  // namespace handrail::cues
