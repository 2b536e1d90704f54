#include "tests/unit/heard/sounding.h"
#include "tests/support/names.h"

#include <algorithm>
#include <stdexcept>
#include <thread>

namespace handrail::test {
namespace {

constexpr int kVoice_hz = 22050;  // sample rate of espeak-ng
constexpr int kFramesPerMs = 48;

std::unique_ptr<OpenALSink> open_mix(const std::shared_ptr<VoiceChannel>& channel) {
    auto sink = OpenALSink::open(channel, {.output = OpenALSink::Output::OnDemand});
    if (!sink) throw std::runtime_error(sink.error().sentence());
    return std::move(*sink);
}

void bring(VoiceChannel& channel, const Utterance& utterance, const std::vector<std::int16_t>& samples) {
    const VoiceChannel::Ticket ticket = channel.begin(kVoice_hz, utterance.loudness, utterance.right_rad);
    channel.append(ticket, samples);
    channel.end(ticket);
}

}  // namespace

Sounding::Sounding(const Settings& settings) : sink_(open_mix(heard_)) {
    auto voice = EspeakSpeech::open(made_, settings.speech);
    if (!voice) throw std::runtime_error(voice.error().sentence());
    voice_ = std::move(*voice);
}

std::vector<std::int16_t> Sounding::synthesised(const Utterance& utterance) {
    voice_->say(utterance);
    std::vector<std::int16_t> samples;
    for (;;) {
        const VoiceChannel::Update update = made_->take();
        if (update.rate_hz != kVoice_hz) throw std::runtime_error("the voice has another rate");
        samples.insert(samples.end(), update.samples.begin(), update.samples.end());
        if (update.ended) return samples;
        std::this_thread::yield();
    }
}

void Sounding::say(const Utterance& utterance) {
    PrintedLine line{.utterance = utterance, .begin_frame = mix_.size() / 2, .samples = synthesised(utterance)};
    bring(*heard_, utterance, line.samples);
    lines_.push_back(std::move(line));
}

void Sounding::stop() {
    if (speaking()) {
        const auto spoken = std::find_if(lines_.rbegin(), lines_.rend(), [](const auto& line) { return line.voiced; });
        if (spoken != lines_.rend()) spoken->stopped = true;
    }
    heard_->stop();
}

void Sounding::write(const Utterance& utterance) {
    lines_.push_back({.utterance = utterance, .voiced = false, .begin_frame = mix_.size() / 2});
}

void Sounding::mix_ms() {
    const auto frames = sink_->render(kFramesPerMs);
    mix_.insert(mix_.end(), frames.begin(), frames.end());
    speaks_.push_back(speaking());
}

bool Sounding::voice_silent(std::size_t from_frame, std::size_t until_frame) const {
    for (std::size_t ms = from_frame / kFramesPerMs; ms <= until_frame / kFramesPerMs && ms < speaks_.size(); ++ms)
        if (speaks_[ms]) return false;
    return true;
}

void Sounding::Ears::play(const SoundCue& cue) {
    sounds.push_back({cue, listener_, mix_.mix_.size() / 2});
    mix_.sink_->play(cue);
}

void Sounding::Ears::set_listener(const Listener& listener) {
    listener_ = listener;
    mix_.sink_->set_listener(listener);
}

std::vector<float> Sounding::alone(const PrintedLine& line) {
    auto channel = std::make_shared<VoiceChannel>();
    const auto sink = open_mix(channel);
    bring(*channel, line.utterance, line.samples);
    std::vector<float> both;
    double now_s = 0.0;
    do {
        now_s += 0.005;
        sink->tick(now_s);
        const auto frames = sink->render(5 * kFramesPerMs);
        both.insert(both.end(), frames.begin(), frames.end());
    } while (channel->playing());
    return both;
}

SoundAlone::SoundAlone() : sink_(open_mix(std::make_shared<VoiceChannel>())) {}

std::vector<float> SoundAlone::render(const PlayedSound& sound) {
    constexpr int kTick_ms = 5, kTicks = 20;
    std::vector<float> both;
    const auto run = [&] {
        both.clear();
        for (int i = 0; i < kTicks; ++i) {
            sink_->tick(now_s_ += 0.001 * kTick_ms);
            const auto frames = sink_->render(kTick_ms * kFramesPerMs);
            both.insert(both.end(), frames.begin(), frames.end());
        }
    };
    // The last sound and its direction must have faded.
    sink_->stop_all();
    sink_->set_listener(sound.listener);
    run();
    sink_->play(sound.cue);
    run();
    return both;
}

}  // namespace handrail::test
