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

Sounding::Sounding() : sink_(open_mix(heard_)) {
    auto voice = EspeakSpeech::open(made_, Settings::Speech{});
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

}  // namespace handrail::test
