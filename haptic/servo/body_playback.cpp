#include "haptic/servo/body_playback.h"

#include <algorithm>

namespace handrail {
namespace {

constexpr double kLongestFrameS = 0.1;  // bodies that were still for longer start to move from where they stood, one usual frame before
constexpr double kUsualFrameS = 1.0 / 60.0;

}  // namespace

void BodyPlayback::give(const BodyFrame& newest, bool jump) noexcept {
    if (count_ > 0 && !jump && newest.number == frame(count_ - 1).number && newest.scene == frame(count_ - 1).scene) return;
    if (count_ > 0 && (jump || newest.scene != frame(count_ - 1).scene || !(newest.time_s > frame(count_ - 1).time_s))) count_ = 0;
    if (count_ > 0 && newest.time_s - frame(count_ - 1).time_s > kLongestFrameS) {
        const std::size_t last = (first_ + count_ - 1) % kFrames;
        first_ = last;
        count_ = 1;
        frames_[last].time_s = newest.time_s - kUsualFrameS;
    }
    if (count_ == kFrames) {
        first_ = (first_ + 1) % kFrames;
        --count_;
    }
    frames_[(first_ + count_) % kFrames] = newest;
    ++count_;
}

BodyPoses BodyPlayback::at(const HapticScene& scene, double play_s) noexcept {
    if (count_ == 0 || frame(0).scene != scene.generation) {
        if (scene_ != 0) ++played_;
        scene_ = 0;
        settled_ = 0;
        return {{}, played_};
    }
    while (count_ > 1 && frame(1).time_s <= play_s) {
        first_ = (first_ + 1) % kFrames;
        --count_;
    }
    const BodyFrame& a = frame(0);
    const bool still = count_ == 1 || play_s <= a.time_s;
    if (still && scene_ == a.scene && settled_ == a.number) return {std::span(now_).first(a.count), played_};
    scene_ = a.scene;
    settled_ = still ? a.number : 0;
    ++played_;
    if (still) {
        std::copy_n(a.poses.begin(), a.count, now_.begin());
    } else {
        const BodyFrame& b = frame(1);
        const double part = (play_s - a.time_s) / (b.time_s - a.time_s);
        for (std::size_t i = 0; i < a.count; ++i) {
            const bool moves = a.poses[i].present && b.poses[i].present && !(a.poses[i].at == b.poses[i].at);
            now_[i] = moves ? BodyPose{between(a.poses[i].at, b.poses[i].at, part), true} : a.poses[i];
        }
    }
    return {std::span(now_).first(a.count), played_};
}

}  // namespace handrail
