// Samples by any number of frames from a renderer that is only ever asked for whole blocks of 64: what was made beyond
// a request begins the next one. OpenAL Soft 1.19.1 writes past its buffer when its reverb fades between two rooms
// within a request that is no multiple of four frames; its own devices ask for whole periods, so only what asks for
// samples itself comes upon it. One owner. Cost: a copy of at most 63 frames each way.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace handrail {

class WholeBlocks {
public:
    static constexpr int kFrames = 64;

    // As many of `frames` as make whole blocks.
    static constexpr int whole(int frames) { return frames - frames % kFrames; }

    // Fills `stereo` with the next `frames` frames, left and right in turn. render(to, count) makes the next `count`,
    // always a multiple of kFrames.
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
    int at_ = kFrames;  // the first frame of block_ that nobody has had
};

}  // namespace handrail
