// Moving bodies at servo rate. The app reports their poses at its frame rate, while the hand touches them a thousand
// times a second. Frames are played back at the same moment as the poses of the workspace (see PosePlayback) and
// interpolated. A moving body is therefore felt as one smooth push and not as a staircase. The pose tables belong to
// the app and are never copied in a tick. A pose between two moments is computed only for the bodies that are queried.
// Plain state; real-time safe.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "haptic/render/touch.h"

namespace handrail::servo {

// The poses of all bodies of a scene at the last moments at which something moved. The app makes and publishes it, and
// is the only one that allocates and frees; the servo only reads.
class BodyFrame {
public:
    static constexpr std::size_t kMoments = 8;  // 130 ms at 60 frames a second

    struct Moment {
        std::uint64_t number = 0;
        double time_s = 0.0;
        std::shared_ptr<const std::vector<render::BodyPose>> poses;
        // Bodies that moved since the moment before, in rising order.
        std::shared_ptr<const std::vector<render::MovingBody>> moved;
    };

    // Adds the poses that all bodies of a scene (HapticScene::generation) have from this moment on. The times of one
    // scene must rise. Another scene, or a time that does not rise, clears the earlier moments.
    void push(std::uint32_t scene, double time_s, std::vector<render::BodyPose> poses);

    std::uint32_t scene() const noexcept { return scene_; }  // 0: none
    // Rises with every push and is unique in this process, so two frames with the same number hold the same tables. 0:
    // no push yet.
    std::uint64_t number() const noexcept { return number_; }
    std::size_t size() const noexcept { return count_; }
    const Moment& moment(std::size_t i) const noexcept { return moments_[(first_ + i) % kMoments]; }  // 0: the oldest
    // Poses at the last moment.
    std::span<const render::BodyPose> poses() const noexcept {
        return count_ > 0 ? std::span<const render::BodyPose>(*moment(count_ - 1).poses)
                          : std::span<const render::BodyPose>{};
    }

private:
    std::uint32_t scene_ = 0;
    std::uint64_t number_ = 0;
    std::array<Moment, kMoments> moments_{};
    std::size_t first_ = 0, count_ = 0;
};

// Used by the servo thread only.
class BodyPlayback {
public:
    // Returns the bodies at the moment being played. The result is valid until the next call and while the frame
    // exists. Pass the newest known frame; passing the same frame again is fine. jump: what was felt before is no
    // longer valid, so playback starts at the newest moment.
    render::BodyPoses at(const BodyFrame& frame, const render::HapticScene& scene, double play_s,
                         bool jump = false) noexcept {
        // Fast path for most ticks: still between the same two moments as in the tick before, or at rest at the last
        // one.
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
    render::BodyPoses find(const BodyFrame& frame, const render::HapticScene& scene, double play_s, bool jump) noexcept;

    std::uint64_t first_number_ = 0;  // moments before this one are no longer played
    std::uint64_t played_ = 0;        // the number that the renderer got last
    std::uint64_t settled_ = 0;       // the Moment::number that was returned last; 0: between two moments
    std::uint32_t scene_ = 0;         // the scene that was returned last
    // Number of the frame whose tables poses_ and ways_ refer to, valid while from_s_ < play_s < until_s_. 0: none.
    std::uint64_t frame_ = 0;
    double from_s_ = 0.0, until_s_ = 0.0, long_s_ = 0.0;  // long_s_: until_s_ - from_s_
    std::span<const render::BodyPose> poses_{};
    render::BodyPaths ways_;
};

}  // namespace handrail::servo
