// Samples without a sound card: asked of the loopback device in whole blocks, and thrown away at the pace of time where
// nobody hears them. The audio thread.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "audio-cues/sinks/openal_device.h"
#include "audio-cues/sinks/whole_blocks.h"

namespace handrail {

class LoopbackMix {
public:
    // `on_render`: told of each count of frames that is asked for; may be empty. The device outlives this object.
    LoopbackMix(const OpenALDevice& device, std::function<void(int)> on_render)
        : device_(device), on_render_(std::move(on_render)) {}

    // Nothing is owed from before this time.
    void begin_at(double now_s) { rendered_until_s_ = now_s; }
    // Of a device that was opened anew.
    void restart(double now_s);
    // What time has passed since is rendered and thrown away. Less than a whole block waits for the next call.
    void discard_elapsed(double now_s);
    // The next frames, left and right in turn. Valid until the next call.
    std::span<const float> render(int frames);

private:
    void render_whole(float* stereo, int frames) const;

    const OpenALDevice& device_;
    std::function<void(int)> on_render_;
    double rendered_until_s_ = 0.0;
    std::vector<float> mix_;
    WholeBlocks ahead_;  // what render() has been given beyond what it was asked for
};

}  // namespace handrail
