// Moving bodies at servo rate: the app says at its frame rate where they are, the hand meets them a thousand times a second. Frames are played back
// at the same moment as the workspace's poses (see PosePlayback) and interpolated between, so that a moving thing is one smooth push and not a
// staircase. Plain state, servo thread only; real-time safe.
#pragma once

#include <array>
#include <cstdint>

#include "haptic/render/touch.h"

namespace handrail {

// All bodies of a scene at one moment. Published by the app; about 9 kB.
struct BodyFrame {
    std::uint32_t scene = 0;   // HapticScene::generation that the poses belong to; 0: none
    std::uint64_t number = 0;  // rises whenever anything in it changed
    double time_s = 0.0;       // when the bodies were there, the clock of WorkspacePose::time_s
    std::uint32_t count = 0;
    std::array<BodyPose, HapticScene::kMostBodies> poses{};
};

class BodyPlayback {
public:
    // Takes the newest frame the servo knows; one that was given before changes nothing. Frames of one scene come in rising time. jump: nothing of
    // what was felt before holds, so the frame counts at once.
    void give(const BodyFrame& newest, bool jump) noexcept;
    // The bodies at the moment now being played. Valid until the next call.
    BodyPoses at(const HapticScene& scene, double play_s) noexcept;

private:
    static constexpr std::size_t kFrames = 8;  // 130 ms at 60 frames a second

    const BodyFrame& frame(std::size_t i) const noexcept { return frames_[(first_ + i) % kFrames]; }

    std::array<BodyFrame, kFrames> frames_{};
    std::size_t first_ = 0, count_ = 0;
    std::array<BodyPose, HapticScene::kMostBodies> now_{};
    std::uint64_t played_ = 0;   // number given to the renderer
    std::uint64_t settled_ = 0;  // BodyFrame::number that now_ is exactly; 0: between two
    std::uint32_t scene_ = 0;    // that now_ belongs to
};

}  // namespace handrail
