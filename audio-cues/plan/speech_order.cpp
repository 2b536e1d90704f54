#include "audio-cues/plan/speech_order.h"

#include <algorithm>
#include <utility>

namespace handrail::cues {
namespace {

// A count of steps waits at most this long. After that, the person is probably on another walk.
constexpr double kKeepSteps_s = 2.0;

bool replaces(SpeechTopic topic) {
    return topic == SpeechTopic::Place || topic == SpeechTopic::Arrival || topic == SpeechTopic::Leg ||
           topic == SpeechTopic::Heading;
}

bool made_anew(SpeechTopic topic) {
    return topic == SpeechTopic::Place || topic == SpeechTopic::Arrival || topic == SpeechTopic::Summary ||
           topic == SpeechTopic::Leg || topic == SpeechTopic::Lesson || topic == SpeechTopic::Praise;
}

}  // namespace

// ---- adding lines ----

void SpeechOrder::queue(std::deque<SpeechLine>& lines, SpeechLine line, std::size_t most) {
    if (replaces(line.utterance.topic)) {
        const auto older = std::stable_partition(lines.begin(), lines.end(), [&](const SpeechLine& waits) {
            return waits.utterance.topic != line.utterance.topic;
        });
        for (auto it = older; it != lines.end(); ++it) unspoken_.push_back(std::move(*it));
        lines.erase(older, lines.end());
    }
    lines.push_back(std::move(line));
    if (lines.size() <= most) return;
    drop(std::move(lines.front()));
    lines.pop_front();
}

void SpeechOrder::add(SpeechLine line) {
    line.key = keys_;
    if (line.utterance.topic == SpeechTopic::Steps) {
        line.expires_s = line.requested_s + kKeepSteps_s;
        if (steps_) drop(std::move(*steps_));
        steps_ = std::move(line);
        return;
    }
    switch (line.utterance.speech_class) {
        case SpeechClass::Alarm:
            return queue(alarms_, std::move(line), kMostDanger);
        case SpeechClass::Warning:
            return queue(warnings_, std::move(line), kMostDanger);
        case SpeechClass::Answer:
            return queue(answers_, std::move(line), kMostWaiting);
        case SpeechClass::Guidance:
            return queue(guidance_, std::move(line), kMostWaiting);
        case SpeechClass::Contact:
            names_.at(line.hand) = std::move(line);
            return;
        case SpeechClass::Ambient:
            return queue(hints_, std::move(line), kMostWaiting);
    }
}

// Drops a line. If the session will compose the line's topic again, the line is not written as text now.
void SpeechOrder::drop(SpeechLine line) {
    if (made_anew(line.utterance.topic)) owed_.add(line.utterance.topic);
    else unspoken_.push_back(std::move(line));
}

void SpeechOrder::drop_all(std::deque<SpeechLine>& queue) {
    for (SpeechLine& line : std::exchange(queue, {})) drop(std::move(line));
}

void SpeechOrder::forget_names() {
    for (auto& name : names_) name.reset();
}

bool SpeechOrder::key(double now_s, bool speaking) {
    note(now_s, speaking);
    ++keys_;
    sounded_s_ = now_s;
    drop_all(answers_);
    drop_all(guidance_);
    drop_all(hints_);
    if (steps_) drop(*std::exchange(steps_, std::nullopt));
    forget_names();
    if (!current_ || current_->utterance.speech_class <= SpeechClass::Warning) return false;
    if (made_anew(current_->utterance.topic)) owed_.add(current_->utterance.topic);
    current_.reset();
    return true;
}

void SpeechOrder::silence(double now_s) {
    ++keys_;
    sounded_s_ = now_s;
    for (auto* lines : {&alarms_, &warnings_, &answers_, &guidance_, &hints_})
        for (SpeechLine& line : std::exchange(*lines, {})) unspoken_.push_back(std::move(line));
    if (steps_) unspoken_.push_back(*std::exchange(steps_, std::nullopt));
    forget_names();
    current_.reset();
    owed_ = {};
}

// ---- choosing the next line ----

void SpeechOrder::note(double now_s, bool speaking) {
    if (speaking) sounded_s_ = now_s;
    else current_.reset();
}

// Returns true if a line of this class, or of a more important one, is being spoken.
bool SpeechOrder::busy(SpeechClass least) const { return current_ && current_->utterance.speech_class <= least; }

SpeechLine SpeechOrder::begin(SpeechLine line, double now_s) {
    if (current_ && made_anew(current_->utterance.topic) && current_->utterance.topic != line.utterance.topic)
        owed_.add(current_->utterance.topic);
    owed_.remove(line.utterance.topic);
    sounded_s_ = now_s;
    current_ = line;
    return line;
}

SpeechLine SpeechOrder::begin(std::deque<SpeechLine>& queue, double now_s) {
    SpeechLine line = std::move(queue.front());
    queue.pop_front();
    return begin(std::move(line), now_s);
}

void SpeechOrder::leave_out_what_was_said(double now_s, const Knows& knows) {
    const auto said = [&](const SpeechLine& line) { return !line.repeatable && knows.said(line); };
    for (auto* lines : {&alarms_, &warnings_, &answers_, &guidance_, &hints_}) std::erase_if(*lines, said);
    for (auto& name : names_)
        if (name && name->due_s <= now_s && said(*name)) name.reset();
}

std::optional<SpeechLine> SpeechOrder::next(double now_s, bool speaking, const Knows& knows) {
    note(now_s, speaking);
    leave_out_what_was_said(now_s, knows);
    if (auto line = next_of_importance(now_s)) return line;
    if (auto line = next_name(now_s, knows)) return line;
    return next_of_the_rest(now_s);
}

std::optional<SpeechLine> SpeechOrder::next_of_importance(double now_s) {
    // An alarm with `cuts` says that a device may still push. It interrupts other alarms, because earlier alarms about
    // the device were composed before this was known.
    const bool cuts = std::any_of(alarms_.begin(), alarms_.end(), [](const SpeechLine& alarm) { return alarm.cuts; });
    if (!alarms_.empty() && (cuts || !busy(SpeechClass::Alarm))) return begin(alarms_, now_s);
    if (busy(SpeechClass::Warning)) return std::nullopt;
    if (!warnings_.empty()) return begin(warnings_, now_s);
    // The newest line of a topic that replaces itself need not wait for an older line of the same topic.
    const auto same_topic = [&](const SpeechLine& line) {
        return replaces(line.utterance.topic) && current_->utterance.topic == line.utterance.topic;
    };
    if (!answers_.empty()) {
        // Until another key is pressed, an answer is interrupted only by a newer answer of the same topic.
        const SpeechLine& front = answers_.front();
        if (!busy(SpeechClass::Answer) || current_->key != front.key || same_topic(front))
            return begin(answers_, now_s);
        return std::nullopt;
    }
    if (guidance_.empty() || busy(SpeechClass::Answer)) return std::nullopt;
    if (busy(SpeechClass::Guidance) && !same_topic(guidance_.front())) return std::nullopt;
    return begin(guidance_, now_s);
}

std::optional<SpeechLine> SpeechOrder::next_name(double now_s, const Knows& knows) {
    for (auto& name : names_) {
        if (!name || name->due_s > now_s) continue;
        if (now_s > name->expires_s && !knows.touches(*name)) {
            name.reset();
            continue;
        }
        // The name of the thing at one hand does not interrupt the name for the other hand, but waits for its end.
        const bool others = busy(SpeechClass::Contact) && current_->utterance.speech_class == SpeechClass::Contact &&
                            current_->hand != name->hand;
        if (waiting() || busy(SpeechClass::Guidance) || others) continue;
        return begin(*std::exchange(name, std::nullopt), now_s);
    }
    return std::nullopt;
}

std::optional<SpeechLine> SpeechOrder::next_of_the_rest(double now_s) {
    const bool named = std::any_of(names_.begin(), names_.end(), [](const auto& name) { return name.has_value(); });
    const bool free = !waiting() && !named && !current_;
    if (steps_ && free) return begin(*std::exchange(steps_, std::nullopt), now_s);
    if (steps_ && now_s > steps_->expires_s) drop(*std::exchange(steps_, std::nullopt));
    if (!hints_.empty() && free) return begin(hints_, now_s);
    // A hint is never kept for later, because by then it may be out of date. Only a hint that was requested at the same
    // time as the current one waits for its end.
    if (hints_.empty() || (current_ && current_->utterance.speech_class == SpeechClass::Ambient &&
                           current_->requested_s == hints_.front().requested_s))
        return std::nullopt;
    drop_all(hints_);
    return std::nullopt;
}

std::vector<SpeechLine> SpeechOrder::take_unspoken() { return std::exchange(unspoken_, {}); }

SpeechTopics SpeechOrder::take_owed(double now_s, bool speaking) {
    note(now_s, speaking);
    if (!owed_.any() || current_ || waiting() || now_s - sounded_s_ < kPause_s) return {};
    return std::exchange(owed_, {});
}

}  // namespace handrail::cues
