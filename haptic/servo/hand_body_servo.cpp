#include "haptic/servo/hand_body_servo.h"

#include <algorithm>

namespace handrail::servo {
namespace {

// Sine and cosine of 45 degrees, for a quaternion of a quarter turn.
constexpr double kHalfRoot = 0.70710678118654752440;

}  // namespace

HandBodyServo::HandBodyServo(std::shared_ptr<const render::DynamicsScene> scene,
                             std::shared_ptr<render::HandChannel> channel, unsigned hand, std::size_t bodies)
    : scene_(std::move(scene)),
      channel_(std::move(channel)),
      bodies_(hand),
      poses_(bodies + kMoreBodies),
      free_(bodies + kMoreBodies, 0) {
    for (const render::DynamicsBody& body : scene_->bodies)
        if (body.haptic < free_.size()) free_[body.haptic] = 1;
    bodies_.enter(scene_.get());
}

bool HandBodyServo::grip(const BodyTuning& tuning, std::uint32_t buttons, double now_s, const Vec3& hand_m) noexcept {
    const std::uint32_t pressed = buttons & tuning.grip_buttons;
    if (here_) {
        if (held_by_button_ && pressed == 0) {
            held_by_button_ = false;
            if (!held_by_key_) bodies_.let_go(feel_);
        } else if (!held_by_button_ && pressed != 0 && buttons_ == 0) {
            held_by_button_ = bodies_.take(now_s, hand_m, feel_) != render::kNoBody;
        }
        if (held_by_key_ && !tuning.hold) {
            held_by_key_ = false;
            if (!held_by_button_) bodies_.let_go(feel_);
        } else if (!held_by_key_ && tuning.hold) {
            held_by_key_ = bodies_.take(now_s, hand_m, feel_) != render::kNoBody;
        }
    }
    buttons_ = pressed;
    if (quarters_known_ && quarters_ != tuning.quarters) {
        // Makes at most four quarter turns, even if the counter has risen by more.
        for (int i = 0; i < 4 && quarters_ != tuning.quarters; ++i) {
            const bool left = tuning.quarters > quarters_;
            bodies_.turn_held({kHalfRoot, 0.0, 0.0, left ? kHalfRoot : -kHalfRoot});
            quarters_ += left ? 1 : -1;
        }
    }
    quarters_ = tuning.quarters;
    quarters_known_ = true;
    return held_by_button_;
}

render::BodyPoses HandBodyServo::place(const render::BodyPoses& given, const render::HapticScene& scene, double now_s,
                                       const Vec3& hand_m, const BodyFeel& feel) noexcept {
    if (channel_->frame.refresh()) bodies_.hear(channel_->frame.read());
    if (bodies_.idle()) feel_ = feel;
    here_ = true;
    const std::size_t count = std::min(scene.bodies.size(), poses_.size());
    const auto take = [&](std::size_t b) {
        if (free_[b]) return;
        poses_[b] = given.know(b) ? given.at(b) : render::BodyPose{scene.bodies[b].start, scene.bodies[b].present};
    };
    bool moved = false;
    if (generation_ != scene.generation) {
        generation_ = scene.generation;
        for (std::size_t b = 0; b < count; ++b) {
            take(b);
            if (free_[b]) poses_[b] = {scene.bodies[b].start, scene.bodies[b].present};
        }
        bodies_.show_all();
        moved = true;
    } else if (given_ != given.number) {
        moved = true;
        // If the movement is the same as in the last tick, only the bodies that move in it have changed.
        if (given.ways && given.ways_number() == given_ways_ && given.ways->number_before != 0) {
            for (const render::MovingBody& moving : given.ways->moving)
                if (moving.body < count) take(moving.body);
        } else {
            for (std::size_t b = 0; b < count; ++b) take(b);
        }
    }
    given_ = given.number;
    given_ways_ = given.ways_number();
    moved = bodies_.place(now_s, hand_m, feel_, std::span(poses_).first(count)) || moved;
    if (moved) ++number_;
    channel_->place.publish({hand_m, feel_.proxy_radius_m, now_s});
    return {std::span(poses_).first(count), number_};
}

void HandBodyServo::leave() noexcept {
    if (!here_) return;
    here_ = held_by_key_ = held_by_button_ = false;
    bodies_.forget();
    channel_->place.publish({});
}

}  // namespace handrail::servo
