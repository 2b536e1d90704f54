#include "audio-cues/plan/audio_thread.h"

#include <algorithm>
#include <utility>

#include "haptic/servo/hand_recording.h"
#include "worlds/base/executor.h"

namespace handrail::cues {

AudioThread::AudioThread(std::shared_ptr<AudioSink> audio, std::shared_ptr<SpeechSink> speech, Clock& clock,
                         ContactRing* contacts, const settings::Settings& settings, ContactRing* left_contacts)
    : clock_(clock),
      contacts_{contacts, left_contacts},
      audio_(std::move(audio)),
      speech_(std::move(speech)),
      planner_(settings) {}

AudioThread::~AudioThread() { stop(); }

void AudioThread::start() {
    if (!thread_.joinable() && !stopped_)
        thread_ = std::thread([this] {
            name_this_thread("ears");
            run();
        });
}

void AudioThread::stop(double finish_speech_s) {
    if (std::exchange(stopped_, true)) return;
    finish_speech_s_ = finish_speech_s;
    stop_requested_.store(true, std::memory_order_release);
    if (thread_.joinable()) thread_.join();
    // The thread was never started, or the owner steps the loop. run() then speaks the last lines on this thread.
    else run();
}

void AudioThread::post(CueRequest request) {
    const std::lock_guard lock(mutex_);
    ++inbox_.posts;
    inbox_.requests.push_back(std::move(request));
}

void AudioThread::set_settings(const settings::Settings& settings) {
    const std::lock_guard lock(mutex_);
    ++inbox_.posts;
    inbox_.settings = settings;
}

void AudioThread::enter_world(std::shared_ptr<const Scene> scene) {
    const std::lock_guard lock(mutex_);
    ++inbox_.posts;
    inbox_.scene = std::move(scene);
    inbox_.edited.reset();
}

void AudioThread::follow_edit(std::shared_ptr<const Scene> scene) {
    const std::lock_guard lock(mutex_);
    ++inbox_.posts;
    // If no step has processed the world that the app entered last, the edited scene replaces that world's scene.
    if (inbox_.scene) inbox_.scene = std::move(scene);
    else inbox_.edited = std::move(scene);
}

void AudioThread::set_two_hands(bool two) {
    const std::lock_guard lock(mutex_);
    ++inbox_.posts;
    inbox_.two_hands = two;
}

void AudioThread::set_hand_stands_in(bool stands_in) {
    const std::lock_guard lock(mutex_);
    ++inbox_.posts;
    inbox_.hand_stands_in = stands_in;
}

std::string AudioThread::who_speaks() {
    const std::lock_guard lock(mutex_);
    return who_;
}

std::vector<SpokenLine> AudioThread::take_spoken() {
    const std::lock_guard lock(mutex_);
    return std::exchange(outbox_, {});
}

void AudioThread::step() {
    Inbox inbox;
    {
        const std::lock_guard lock(mutex_);
        std::swap(inbox, inbox_);
    }
    const double now_s = step_listener_.ends ? servo::in_whole_microseconds(clock_.now_s()) : clock_.now_s();
    if (step_listener_.begins) step_listener_.begins(now_s);
    if (inbox.settings) {
        planner_.set_settings(*inbox.settings);
        speech_->set_speech(inbox.settings->speech);
        audio_->set_sound(inbox.settings->sound);
    }
    if (inbox.two_hands) planner_.set_two_hands(*inbox.two_hands);
    if (inbox.hand_stands_in) planner_.set_hand_stands_in(*inbox.hand_stands_in);
    if (inbox.scene) planner_.enter_world(std::move(*inbox.scene));
    if (inbox.edited) planner_.follow_edit(std::move(*inbox.edited));
    drops_out_.store(audio_->drops_out(), std::memory_order_relaxed);
    events_.clear();
    for (std::size_t hand = 0; hand < contacts_.size(); ++hand) {
        if (contacts_[hand] == nullptr) continue;
        contacts_[hand]->consume_all([&](const servo::ContactEvent& event) {
            events_.push_back(event);
            events_.back().hand = static_cast<std::uint8_t>(hand);
        });
    }
    listener_.refresh();
    planner_.tick({.now_s = now_s, .contacts = events_, .requests = inbox.requests, .listener = listener_.read()},
                  *audio_, *speech_);
    owed_.fetch_or(planner_.take_owed(now_s, *speech_).bits, std::memory_order_relaxed);
    if (step_listener_.ends) {
        const auto left = static_cast<std::uint32_t>(std::count_if(
            events_.begin(), events_.end(), [](const servo::ContactEvent& event) { return event.hand == 1; }));
        step_listener_.ends({now_s, static_cast<std::uint32_t>(events_.size()) - left, left, inbox.posts});
    }
    speaking_.store(speech_->speaking() || planner_.waiting(), std::memory_order_relaxed);
    publish();
}

void AudioThread::publish() {
    const std::vector<SpokenLine>& spoken = planner_.spoken();
    const auto fresh =
        static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(planner_.spoken_in_all() - published_, spoken.size()));
    published_ = planner_.spoken_in_all();
    const std::string who = speech_->who();
    if (fresh == 0 && who == reported_who_) return;
    const std::lock_guard lock(mutex_);
    reported_who_ = who_ = who;
    outbox_.insert(outbox_.end(), spoken.end() - fresh, spoken.end());
}

void AudioThread::run() {
    double next_s = clock_.now_s();
    const auto step_and_sleep = [&] {
        step();
        // If a stall made the loop miss ticks, it does not repeat them.
        next_s = std::max(next_s + kPeriod_s, clock_.now_s());
        clock_.sleep_until_s(next_s);
    };
    while (!stop_requested_.load(std::memory_order_acquire)) step_and_sleep();
    step();  // handles the requests that were posted before stop()
    const double patience_s = clock_.now_s() + finish_speech_s_;
    while ((speech_->speaking() || planner_.waiting()) && clock_.now_s() < patience_s) step_and_sleep();
    planner_.flush(clock_.now_s(), *speech_);
    publish();
    speech_->stop();
    audio_->stop_all();
    for (const double end_s = clock_.now_s() + kFade_s; clock_.now_s() < end_s;) {
        audio_->tick(clock_.now_s());
        speech_->tick(clock_.now_s());
        next_s = std::max(next_s + kPeriod_s, clock_.now_s());
        clock_.sleep_until_s(next_s);
    }
}

}  // namespace handrail::cues
