// Makes samples without a sound card: takes them from the loopback device in whole blocks and, if nobody hears them,
// discards them at the pace of time. Audio thread only.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "audio-cues/sinks/openal_device.h"
#include "audio-cues/sinks/whole_blocks.h"

namespace handrail::sinks {

class LoopbackMix {
public:
    // `on_render`: gets each requested number of frames; may be empty. The device must outlive this object.
    LoopbackMix(const OpenALDevice& device, std::function<void(int)> on_render)
        : device_(device), on_render_(std::move(on_render)) {}

    // Starts at this time: nothing is due from before it.
    void begin_at(double now_s) { rendered_until_s_ = now_s; }
    // Call it after the device was opened again.
    void restart(double now_s);
    // Renders and discards the samples for the time that has passed. Less than a whole block waits for the next call.
    void discard_elapsed(double now_s);
    // The next frames, left and right alternating. Valid until the next call.
    std::span<const float> render(int frames);

private:
    void render_whole(float* stereo, int frames) const;

    const OpenALDevice& device_;
    std::function<void(int)> on_render_;
    double rendered_until_s_ = 0.0;
    std::vector<float> mix_;
    WholeBlocks ahead_;  // samples rendered beyond the last request of render()
};

}  // namespace handrail::sinks
