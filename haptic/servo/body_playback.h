// Plays back moving bodies at the rate of the servo. The app reports their poses at its frame rate, but the hand
// touches them a thousand times a second. So the poses are played back for the same moment as those of the workspace
// (see PosePlayback), with interpolation. A moving body then feels like one smooth push and not like a staircase. The
// app owns the pose tables, which a tick never copies. Interpolated poses are computed only for the bodies that are
// queried. Plain state; real-time safe.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "haptic/render/touch.h"

namespace handrail::servo {

// The poses of all bodies of a scene at the last moments at which some body moved. The app makes and publishes a
// BodyFrame. Only the app allocates and frees its memory; the servo only reads it.
class BodyFrame {
public:
    static constexpr std::size_t kMoments = 8;  // number of kept moments, which cover 130 ms at 60 frames a second

    struct Moment {
        std::uint64_t number = 0;
        double time_s = 0.0;
        std::shared_ptr<const std::vector<render::BodyPose>> poses;
        // Bodies that moved between the previous moment and this one, in rising order.
        std::shared_ptr<const std::vector<render::MovingBody>> moved;
    };

    // Adds the poses of all bodies of a scene (HapticScene::generation) from the moment `time_s` on. The times of one
    // scene must rise. Another scene, or a time that does not rise, clears the earlier moments.
    void push(std::uint32_t scene, double time_s, std::vector<render::BodyPose> poses);

    std::uint32_t scene() const noexcept { return scene_; }  // HapticScene::generation; 0: none
    // The number of this frame. It rises with every push() and is unique in this process, so two frames with the same
    // number contain the same tables. 0: no push() yet.
    std::uint64_t number() const noexcept { return number_; }
    std::size_t size() const noexcept { return count_; }
    // Returns moment i; 0 is the oldest.
    const Moment& moment(std::size_t i) const noexcept { return moments_[(first_ + i) % kMoments]; }
    // Returns the poses at the newest moment.
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

// Interpolates between the moments of a BodyFrame. Only the servo thread uses it.
class BodyPlayback {
public:
    // Returns the poses at the time `play_s`. The result is valid until the next call and while the frame exists.
    // `frame` is the newest known frame and may be the same as before. If `jump` is true, everything that the hand felt
    // before is invalid, so playback starts at the newest moment.
    render::BodyPoses at(const BodyFrame& frame, const render::HapticScene& scene, double play_s,
                         bool jump = false) noexcept {
        // Fast path for most ticks: the time is between the same two moments as in the last tick, or all bodies rest at
        // the newest moment.
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

    std::uint64_t first_number_ = 0;  // moments with lower numbers are not played any more
    std::uint64_t played_ = 0;        // number of the poses that the renderer got last
    std::uint64_t settled_ = 0;  // Moment::number of the poses returned last; 0: the poses were between two moments
    std::uint32_t scene_ = 0;    // scene of the poses returned last
    // Number of the frame whose tables poses_ and ways_ refer to, valid while from_s_ < play_s < until_s_. 0: none.
    std::uint64_t frame_ = 0;
    double from_s_ = 0.0, until_s_ = 0.0, long_s_ = 0.0;  // long_s_ is until_s_ - from_s_
    std::span<const render::BodyPose> poses_{};
    render::BodyPaths ways_;
};

}  // namespace handrail::servo
