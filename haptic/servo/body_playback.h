// Moving bodies at servo rate: the app says at its frame rate where they are, the hand meets them a thousand times a
// second. Frames are played back at the same moment as the workspace's poses (see PosePlayback) and interpolated
// between, so that a moving thing is one smooth push and not a staircase. The poses are the app's own tables, never
// copied on a tick, and a pose between two is worked out only for who is asked for. Plain state; real-time safe.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "haptic/render/touch.h"

namespace handrail {

// All bodies of a scene at the last moments at which something moved. Made and published by the app, which allocates
// and frees; the servo only reads.
class BodyFrame {
public:
    static constexpr std::size_t kMoments = 8;  // 130 ms at 60 frames a second

    struct Moment {
        std::uint64_t number = 0;
        double time_s = 0.0;
        std::shared_ptr<const std::vector<BodyPose>> poses;
        std::shared_ptr<const std::vector<MovingBody>> moved;  // since the moment before, in rising order
    };

    // Where all bodies of a scene (HapticScene::generation) are from this moment on. Times of one scene rise; another
    // scene, or a time that does not, begins anew.
    void push(std::uint32_t scene, double time_s, std::vector<BodyPose> poses);

    std::uint32_t scene() const noexcept { return scene_; }  // 0: none
    // Rises with every push and differs for every push in this process, so that frames of one number hold the same
    // tables; 0: none yet.
    std::uint64_t number() const noexcept { return number_; }
    std::size_t size() const noexcept { return count_; }
    const Moment& moment(std::size_t i) const noexcept {
        return moments_[(first_ + i) % kMoments];
    }  // the oldest first
    // At the last moment.
    std::span<const BodyPose> poses() const noexcept {
        return count_ > 0 ? std::span<const BodyPose>(*moment(count_ - 1).poses) : std::span<const BodyPose>{};
    }

private:
    std::uint32_t scene_ = 0;
    std::uint64_t number_ = 0;
    std::array<Moment, kMoments> moments_{};
    std::size_t first_ = 0, count_ = 0;
};

// Servo thread only.
class BodyPlayback {
public:
    // The bodies at the moment now being played; valid until the next call and as long as the frame is. The frame is
    // the newest that is known; one that was given before is fine. jump: nothing of what was felt before holds, so the
    // newest counts at once.
    BodyPoses at(const BodyFrame& frame, const HapticScene& scene, double play_s, bool jump = false) noexcept {
        // Between the same two moments as on the tick before, or at rest at the last: what most ticks meet.
        if (frame.number() != frame_ || scene.generation != scene_ || !(play_s > from_s_ && play_s < until_s_) || jump)
            [[unlikely]]
            return find(frame, scene, play_s, jump);
        if (settled_ == 0) {
            ++played_;
            ways_.part = (play_s - from_s_) / long_s_;
        }
        return {poses_, played_, &ways_};
    }

private:
    BodyPoses find(const BodyFrame& frame, const HapticScene& scene, double play_s, bool jump) noexcept;

    std::uint64_t first_number_ = 0;  // moments before this one are over
    std::uint64_t played_ = 0;        // number given to the renderer
    std::uint64_t settled_ = 0;       // Moment::number that was given last; 0: between two
    std::uint32_t scene_ = 0;         // that was given last
    // Whose tables poses_ and ways_ look into, which hold while from_s_ < play_s < until_s_; 0: none.
    std::uint64_t frame_ = 0;
    double from_s_ = 0.0, until_s_ = 0.0, long_s_ = 0.0;  // long_s_: from the one to the other
    std::span<const BodyPose> poses_{};
    BodyWays ways_;
};

}  // namespace handrail
