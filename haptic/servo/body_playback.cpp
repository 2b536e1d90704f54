#include "haptic/servo/body_playback.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

namespace handrail::servo {
namespace {

// Time without movement after which a body's next movement starts one frame before the new pose.
constexpr double kStillS = 0.1;
constexpr double kUsualFrameS = 1.0 / 60.0;
std::atomic<std::uint64_t> frames_pushed{0};

render::MovingBody on_the_way(std::size_t body, const Placement& from, const Placement& to) {
    const Vec3 way = glm::abs(to.position_m - from.position_m);
    return {static_cast<std::uint32_t>(body), 0.5 * (way.x + way.y + way.z), std::max(from.scale, to.scale),
            0.5 * (from.position_m + to.position_m)};
}

}  // namespace

void BodyFrame::push(std::uint32_t scene, double time_s, std::vector<render::BodyPose> poses) {
    const auto last = [this]() -> Moment& { return moments_[(first_ + count_ - 1) % kMoments]; };
    if (count_ > 0 && (scene != scene_ || !(time_s > last().time_s) || poses.size() != last().poses->size())) {
        moments_ = {};
        first_ = count_ = 0;
    }
    if (count_ > 0 && time_s - last().time_s > kStillS) {
        Moment rest = std::move(last());
        rest.time_s = time_s - kUsualFrameS;
        moments_ = {};
        moments_[0] = std::move(rest);
        first_ = 0;
        count_ = 1;
    }
    scene_ = scene;
    std::vector<render::MovingBody> moved;
    for (std::size_t i = 0; count_ > 0 && i < poses.size(); ++i)
        if (const render::BodyPose& before = (*last().poses)[i]; !(poses[i] == before))
            moved.push_back(on_the_way(i, before.at, poses[i].at));
    number_ = ++frames_pushed;
    if (count_ == kMoments) {
        first_ = (first_ + 1) % kMoments;
        --count_;
    }
    moments_[(first_ + count_) % kMoments] = {
        number_, time_s, std::make_shared<const std::vector<render::BodyPose>>(std::move(poses)),
        std::make_shared<const std::vector<render::MovingBody>>(std::move(moved))};
    ++count_;
}

render::BodyPoses BodyPlayback::find(const BodyFrame& frame, const render::HapticScene& scene, double play_s,
                                     bool jump) noexcept {
    if (frame.size() == 0 || frame.scene() != scene.generation) {
        if (scene_ != 0) ++played_;
        scene_ = 0;
        settled_ = frame_ = 0;
        ways_ = {};
        ways_.number = ~std::uint64_t{0};  // no frame has this number
        return {{}, played_, &ways_};
    }
    if (jump) first_number_ = frame.number();
    const std::size_t last = frame.size() - 1;
    std::size_t i = last;
    while (i > 0 && frame.moment(i).time_s > play_s && frame.moment(i).number > first_number_) --i;
    const BodyFrame::Moment& a = frame.moment(i);
    first_number_ = a.number;
    const bool still = i == last || play_s <= a.time_s;
    if (still) {
        if (scene_ != frame.scene() || settled_ != a.number) {
            ++played_;
            ways_ = {};
            ways_.number = a.number;
        }
    } else {
        const BodyFrame::Moment& b = frame.moment(i + 1);
        ++played_;
        ways_ = {b.number, a.number, *b.poses, (play_s - a.time_s) / (b.time_s - a.time_s), *b.moved};
    }
    scene_ = frame.scene();
    settled_ = still ? a.number : 0;
    constexpr double kEver = std::numeric_limits<double>::infinity();
    // The value 0 forces a new search in the next tick. It is set while play_s is before the first moment, because at
    // that moment the bodies begin to move.
    frame_ = still && i < last ? 0 : frame.number();
    from_s_ = still ? -kEver : a.time_s;
    until_s_ = still ? kEver : frame.moment(i + 1).time_s;
    long_s_ = until_s_ - from_s_;
    poses_ = *a.poses;
    return {poses_, played_, &ways_};
}

}  // namespace handrail::servo
