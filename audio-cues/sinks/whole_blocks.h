// Delivers any number of frames from a renderer that may only be called for whole blocks of 64 frames. Frames rendered
// beyond a request are delivered first at the next request. Reason: OpenAL Soft 1.19.1 writes past its buffer if its
// reverb fades between two rooms within a request that is not a multiple of four frames. OpenAL's own devices request
// whole periods, so this affects only code that requests samples itself. One owner. Cost: a copy of at most 63 frames
// each way.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace handrail::sinks {

class WholeBlocks {
public:
    static constexpr int kFrames = 64;

    // Returns the largest multiple of kFrames that is at most `frames`.
    static constexpr int whole(int frames) { return frames - frames % kFrames; }

    // Fills `stereo` with the next `frames` frames, with left and right alternating. Calls render(to, count) for new
    // frames; count is always a multiple of kFrames.
    template <class Render>
    void take(float* stereo, int frames, Render render) {
        const int kept = std::min(frames, kFrames - at_);
        give(stereo, kept);
        stereo += 2 * static_cast<std::ptrdiff_t>(kept);
        const int direct = whole(frames - kept), rest = frames - kept - direct;
        if (direct > 0) render(stereo, direct);
        if (rest == 0) return;
        render(block_.data(), kFrames);
        at_ = 0;
        give(stereo + 2 * static_cast<std::ptrdiff_t>(direct), rest);
    }

private:
    void give(float* stereo, int frames) {
        std::copy_n(block_.data() + 2 * static_cast<std::ptrdiff_t>(at_), 2 * static_cast<std::ptrdiff_t>(frames),
                    stereo);
        at_ += frames;
    }

    std::array<float, 2 * kFrames> block_{};
    int at_ = kFrames;  // index of the first frame of block_ that has not been delivered yet
};

}  // namespace handrail::sinks
