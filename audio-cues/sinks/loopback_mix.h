// Renders samples without a sound card. It requests them from OpenAL's loopback device in whole blocks. If nobody hears
// the samples, it discards them as fast as a sound card would play them. Audio thread only.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "audio-cues/sinks/openal_device.h"
#include "audio-cues/sinks/whole_blocks.h"

namespace handrail::sinks {

class LoopbackMix {
public:
    // `on_render` receives the number of frames of each request to the device; it may be empty. The device must outlive
    // this object.
    LoopbackMix(const OpenALDevice& device, std::function<void(int)> on_render)
        : device_(device), on_render_(std::move(on_render)) {}

    // Sets the start time; no samples are due from before it.
    void begin_at(double now_s) { rendered_until_s_ = now_s; }
    // Call it after the device has been opened again.
    void restart(double now_s);
    // Renders and discards the samples for the time that has passed. A rest of less than a whole block is left for the
    // next call.
    void discard_elapsed(double now_s);
    // Returns the next frames, with left and right samples alternating. Valid until the next call.
    std::span<const float> render(int frames);

private:
    void render_whole(float* stereo, int frames) const;

    const OpenALDevice& device_;
    std::function<void(int)> on_render_;
    double rendered_until_s_ = 0.0;
    std::vector<float> mix_;
    WholeBlocks ahead_;  // samples that were rendered beyond the last request of render()
};

}  // namespace handrail::sinks
