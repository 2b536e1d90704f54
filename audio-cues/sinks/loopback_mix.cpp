#include "audio-cues/sinks/loopback_mix.h"

#include <algorithm>

#include "audio-cues/sinks/synth.h"
#include "worlds/base/contract.h"

namespace handrail::sinks {
namespace {

constexpr int kMostPacedFrames = kSampleRate_hz / 4;
constexpr int kPacedBlock = 1024;
static_assert(kPacedBlock % WholeBlocks::kFrames == 0);

}  // namespace

// Only render_whole() requests samples from the loopback device.
void LoopbackMix::render_whole(float* stereo, int frames) const {
    contract_pre(frames % WholeBlocks::kFrames == 0);
    if (on_render_) on_render_(frames);
    device_.render(stereo, frames);
}

void LoopbackMix::restart(double now_s) {
    rendered_until_s_ = now_s;
    ahead_ = {};
}

std::span<const float> LoopbackMix::render(int frames) {
    mix_.resize(2 * static_cast<std::size_t>(frames));
    ahead_.take(mix_.data(), frames, [this](float* to, int count) { render_whole(to, count); });
    return mix_;
}

void LoopbackMix::discard_elapsed(double now_s) {
    double due = (now_s - rendered_until_s_) * kSampleRate_hz;
    // If the thread was delayed, the missing samples are not rendered later, because nobody hears them.
    if (due > kMostPacedFrames) {
        rendered_until_s_ = now_s - static_cast<double>(kMostPacedFrames) / kSampleRate_hz;
        due = kMostPacedFrames;
    }
    mix_.resize(2 * kPacedBlock);
    for (int left = WholeBlocks::whole(static_cast<int>(due)); left > 0; left -= kPacedBlock) {
        const int frames = std::min(left, kPacedBlock);
        render_whole(mix_.data(), frames);
        rendered_until_s_ += static_cast<double>(frames) / kSampleRate_hz;
    }
}

}  // namespace handrail::sinks
