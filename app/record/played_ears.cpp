#include "app/record/played_ears.h"

#include <bit>
#include <utility>

#include "app/record/json_fields.h"

namespace handrail::record {

PlayedEars::PlayedEars(const settings::Settings& settings, double begun_s)
    : begun_s_(begun_s), planner_(settings), last_s_(begun_s) {}

void PlayedEars::Voice::begin(std::uint64_t speaking) {
    answers = speaking;
    answers_left = speaking == 0 ? 0 : std::bit_width(speaking) - 1;
}

bool PlayedEars::Voice::answer() {
    if (answers_left > 0) last = (answers >> --answers_left & 1U) != 0;
    return last;
}

void PlayedEars::Voice::end() {
    while (answers_left > 0) answer();
}

std::optional<std::string> PlayedEars::Voice::news() {
    return reported.empty() ? std::nullopt : std::optional(std::exchange(reported, {}));
}

std::optional<std::string> PlayedEars::Silence::news() {
    return reported.empty() ? std::nullopt : std::optional(std::exchange(reported, {}));
}

void PlayedEars::Voice::keep(const cues::Utterance& utterance, bool voiced) {
    said.push_back({now_s, utterance.text, kClassWords.at(static_cast<std::size_t>(utterance.speech_class)), voiced});
}

void PlayedEars::post(cues::CueRequest request) {
    Post post;
    post.request = std::move(request);
    posts_.push_back(std::move(post));
}
void PlayedEars::set_settings(const settings::Settings& settings) {
    Post post;
    post.kind = Kind::Settings;
    post.settings = settings;
    posts_.push_back(std::move(post));
}
void PlayedEars::set_two_hands(bool two) {
    Post post;
    post.kind = Kind::TwoHands;
    post.yes = two;
    posts_.push_back(std::move(post));
}
void PlayedEars::set_hand_stands_in(bool stands_in) {
    Post post;
    post.kind = Kind::StandsIn;
    post.yes = stands_in;
    posts_.push_back(std::move(post));
}
void PlayedEars::enter_world(std::shared_ptr<const Scene> scene) {
    Post post;
    post.kind = Kind::World;
    post.scene = std::move(scene);
    posts_.push_back(std::move(post));
}
void PlayedEars::follow_edit(std::shared_ptr<const Scene> scene) {
    Post post;
    post.kind = Kind::Edit;
    post.scene = std::move(scene);
    posts_.push_back(std::move(post));
}

void PlayedEars::hear_of(std::uint64_t step, bool from_voice, std::string text) {
    auto& reported = news_[step];
    (from_voice ? reported.first : reported.second) = std::move(text);
}

// Applies the posted items in the same way as AudioThread::step applies the items of its inbox. Then computes one step.
void PlayedEars::step(const CueRow& row, std::vector<servo::ContactEvent> contacts) {
    std::vector<cues::CueRequest> requests;
    std::shared_ptr<const Scene> entered, edited;
    for (std::uint32_t i = 0; i < row.posts; ++i) {
        Post post = std::move(posts_.front());
        posts_.pop_front();
        switch (post.kind) {
            case Kind::Request:
                requests.push_back(std::move(post.request));
                break;
            case Kind::Settings:
                planner_.set_settings(post.settings);
                break;
            case Kind::TwoHands:
                planner_.set_two_hands(post.yes);
                break;
            case Kind::StandsIn:
                planner_.set_hand_stands_in(post.yes);
                break;
            case Kind::World:
                entered = std::move(post.scene);
                edited.reset();
                break;
            case Kind::Edit:
                (entered ? entered : edited) = std::move(post.scene);
                break;
        }
    }
    if (entered) planner_.enter_world(std::move(entered));
    if (edited) planner_.follow_edit(std::move(edited));
    if (const auto news = news_.find(steps_); news != news_.end())
        voice_.reported = news->second.first, sound_.reported = news->second.second;
    ++steps_;
    last_s_ = row.now_s;
    voice_.now_s = row.now_s - begun_s_;
    voice_.begin(row.speaking);
    planner_.tick({.now_s = row.now_s, .contacts = contacts, .requests = requests, .listener = listener_}, sound_,
                  voice_);
    // AudioThread::step makes this call, too. Make it here as well, so that speaking() of `voice_` is called equally
    // often. Discard the result, because the recording contains it.
    (void)planner_.take_owed(row.now_s, voice_);
    voice_.end();
}

void PlayedEars::finish() { planner_.flush(last_s_, voice_); }

}  // namespace handrail::record
