// Decides in which order lines are spoken, and which of them are dropped. Only SpeechOrder decides this, for every
// voice, screen reader and braille display. It has plain values and no sinks: CuePlanner reports all events to it and
// speaks the lines that it returns. It runs on CuePlanner's thread. Only a few lines are ever waiting, so each call
// costs little.
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
    double requested_s = 0.0;  // time of the request or event
    double due_s = 0.0;        // earliest time at which the line may be spoken
    // For Contact: until this time the line waits in any case, and after it only while the hand touches the thing.
    double expires_s = 0.0;
    bool repeatable = false;
    bool again = false;
    bool cuts = false;               // an alarm that interrupts another alarm
    FeatureId touched = kNoFeature;  // for a name: the touched feature
    std::uint8_t hand = 0;           // for a name: the hand that touches it
    std::uint64_t key = 0;           // number of keys pressed before the line was added; set by SpeechOrder
};

class SpeechOrder {
public:
    // After this time without speech or a key, a line that was cut off is composed again.
    static constexpr double kPause_s = 1.0;
    static constexpr std::size_t kMostDanger = 4;  // greatest number of waiting alarms, and of waiting warnings
    // Greatest number of waiting answers, and greatest number of waiting lines of guidance.
    static constexpr std::size_t kMostWaiting = 8;

    // Adds a line, which waits for its turn. Of several names, step counts or lines of a topic that replaces itself,
    // only the newest stays.
    void add(SpeechLine line);
    // Call it when a key was pressed. Returns true if the current utterance must end. All waiting lines are dropped,
    // except alarms and warnings.
    bool key(double now_s, bool speaking);
    // Call it when a stop key was pressed. All waiting lines are dropped, and the session composes none of them again.
    void silence(double now_s);
    // What the caller knows about a waiting line.
    struct Knows {
        // Returns true if the hand still touches the thing that `name` names.
        std::function<bool(const SpeechLine& name)> touches;
        // Returns true if the same text was spoken so recently that it is not spoken again.
        std::function<bool(const SpeechLine& line)> said;
    };
    // Returns the next line to be spoken at once, if there is one. Call it again until it returns none. `speaking` is
    // the present state of the sink.
    std::optional<SpeechLine> next(double now_s, bool speaking, const Knows& knows);
    // Returns the lines that will not be spoken, oldest first, for sinks that store text.
    std::vector<SpeechLine> take_unspoken();
    // Returns the topics of lines that were cut off or dropped, once nothing has been spoken and no key pressed for
    // kPause_s. The session composes a line again if its content is still true. Each topic is returned once.
    SpeechTopics take_owed(double now_s, bool speaking);

    bool waiting() const { return !alarms_.empty() || !warnings_.empty() || !answers_.empty() || !guidance_.empty(); }
    bool answers_wait() const { return !answers_.empty(); }
    void forget_names();
    // Returns the waiting name of the thing that hand number `hand` touches.
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
    std::array<std::optional<SpeechLine>, 2> names_;  // the waiting name for each hand
    std::optional<SpeechLine> steps_;
    std::optional<SpeechLine> current_;  // the line that is being spoken
    std::vector<SpeechLine> unspoken_;
    SpeechTopics owed_;
    std::uint64_t keys_ = 0;
    double sounded_s_ = -1e9;  // time at which the person last heard speech or pressed a key
};

}  // namespace handrail::cues
