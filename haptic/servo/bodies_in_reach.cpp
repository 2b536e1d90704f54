#include "haptic/servo/bodies_in_reach.h"

#include <algorithm>
#include <cmath>

#include "haptic/render/tick_assert.h"
#include "haptic/servo/vectors.h"

namespace handrail::servo {
namespace {

constexpr double kStrain_n = 1.2, kStrainShare = 0.9, kStrain_s = 0.6, kStrainMoves_hand_m = 1e-3;
constexpr double kSame_hand_m = 0.05e-3;
// Rate at which a held body turns back to the orientation that it had when the hand gripped it.
constexpr double kWrist_per_s = 30.0;
// Least inertial mass of a body in a contact with a hand. Two hands can still move a body of this mass stably.
constexpr double kLeastFelt_kg = 0.2;

}  // namespace

void BodiesInReach::enter(const render::DynamicsScene* scene) {
    scene_ = scene;
    const std::size_t count = scene ? scene->bodies.size() : 0;
    if (shown_.size() < count) {
        for (Played& played : frames_) played.things.resize(count);
        shown_.resize(count);
        moved_at_.resize(count);
    }
    lively_.reserve(count);
    forget();
}

void BodiesInReach::forget() noexcept {
    game_ = 0;
    newest_ = known_ = reported_count_ = 0;
    for (Slot& slot : slots_) slot = {};
    shown_all_ = holding_ = letting_go_ = has_hand_ = false;
    carried_m_ = grip_force_n_ = hand_m_per_s_ = Vec3(0.0);
    heavy_ = render::kNoBody;
}

// Notes that the body moved since the last frame. lively_ never has more entries than there are bodies, and has room
// for all of them.
void BodiesInReach::moved(std::uint32_t body) noexcept {
    if (moved_at_[body] == 0) lively_.push_back(body);
    moved_at_[body] = heard_;
}

void BodiesInReach::hear(const render::DynamicsFrame& frame) noexcept {
    if (!scene_ || frame.number == 0 || frame.things.size() < scene_->bodies.size()) return;
    if (frame.game != game_) {
        const std::uint32_t heavy = heavy_;
        forget();
        heavy_ = heavy;
        game_ = frame.game;
    }
    if (known_ > 0 && !(frame.time_s > frames_[newest_].time_s)) return;
    const std::size_t count = scene_->bodies.size(), before = newest_;
    const bool first = known_ == 0, follows = !first && frame.number == number_ + 1;
    number_ = frame.number;
    ++heard_;
    newest_ = (newest_ + 1) % frames_.size();
    known_ = std::min(known_ + 1, frames_.size());
    frames_[newest_].time_s = frame.time_s;
    if (first) {
        for (Played& played : frames_) std::copy_n(frame.things.begin(), count, played.things.begin());
        lively_.clear();
        std::fill(moved_at_.begin(), moved_at_.end(), 0);
    } else if (follows) {
        for (const std::uint32_t body : frame.moved)
            if (body < count) moved(body);
    } else {  // frames are missing, because the engine published some that this hand did not read
        for (std::uint32_t body = 0; body < count; ++body)
            if (!(frame.things[body] == frames_[before].things[body])) moved(body);
    }
    for (const std::uint32_t body : lively_) frames_[newest_].things[body] = frame.things[body];
    reported_count_ = std::min<std::size_t>(frame.near_count[hand_], kMost);
    for (std::size_t i = 0; i < reported_count_; ++i) {
        reported_[i] = frame.near[hand_][i];
        if (Slot* slot = slot_of(reported_[i].body)) slot->model.hear(reported_[i]);
    }
}

BodiesInReach::Slot* BodiesInReach::slot_of(std::uint32_t body) noexcept {
    for (Slot& slot : slots_)
        if (slot.used && slot.model.body() == body) return &slot;
    return nullptr;
}

const BodyModel* BodiesInReach::model_of(std::uint32_t body) const noexcept {
    for (const Slot& slot : slots_)
        if (slot.used && slot.model.body() == body) return &slot.model;
    return nullptr;
}

// Returns the state of a body at the time `play_s`, interpolated between the received frames. Requires known_ > 0.
BodyModel::State BodiesInReach::played(std::size_t body, double play_s) const noexcept {
    std::size_t later = newest_, earlier = newest_;
    for (std::size_t back = 1; back < known_; ++back) {
        later = earlier;
        earlier = (newest_ + frames_.size() - back) % frames_.size();
        if (frames_[earlier].time_s <= play_s) break;
    }
    const render::DynamicsBody& is = scene_->bodies[body];
    const Placement a = render::middle_of(is, frames_[earlier].things[body]),
                    b = render::middle_of(is, frames_[later].things[body]);
    const double span = frames_[later].time_s - frames_[earlier].time_s;
    if (!(span > 0.0) || a == b) return {play_s, b, Vec3(0.0), Vec3(0.0)};
    const double part = std::clamp((play_s - frames_[earlier].time_s) / span, 0.0, 1.0);
    const bool goes = play_s <= frames_[later].time_s;
    return {play_s, between(a, b, part), goes ? (b.position_m - a.position_m) / span : Vec3(0.0),
            goes ? turn_between(a.rotation, b.rotation) / span : Vec3(0.0)};
}

void BodiesInReach::open(const render::RigidBodyState& reported, double now_s) noexcept {
    Slot* free = nullptr;
    for (Slot& slot : slots_)
        if (!slot.used) {
            free = &slot;
            break;
        }
    if (!free) return;
    BodyModel::State seen = played(reported.body, now_s - kPlayedLate_s);
    seen.time_s = now_s;
    *free = {};
    free->used = true;
    free->touched_s = now_s;
    free->model.begin(reported, seen);
}

bool BodiesInReach::place(double now_s, const Vec3& hand_m, const BodyFeel& feel,
                          std::span<render::BodyPose> bodies) noexcept {
    carried_m_ = Vec3(0.0);
    if (!scene_ || known_ == 0) return false;
    for (std::size_t i = 0; i < reported_count_; ++i)
        if (reported_[i].gap_m < 2.0 * feel.proxy_radius_m + glm::length(reported_[i].speed_m_per_s) * kPlayedLate_s &&
            now_s - reported_[i].time_s < kSilent_s) {
            if (Slot* slot = slot_of(reported_[i].body)) slot->touched_s = std::max(slot->touched_s, now_s);
            else open(reported_[i], now_s);
        }
    // The used slots in the order of the scene, so that carried_m_ adds up in a fixed order. They are sorted by
    // insertion, because GCC 14 wrongly warns that std::sort would go out of bounds on so short an array.
    std::array<Slot*, kMost> used{};
    std::size_t used_count = 0;
    for (Slot& slot : slots_) {
        if (!slot.used) continue;
        std::size_t at = used_count++;
        for (; at > 0 && slot.model.body() < used[at - 1]->model.body(); --at) used[at] = used[at - 1];
        used[at] = &slot;
    }
    const bool all = !std::exchange(shown_all_, true);
    bool any = all;
    if (all) {
        for (std::uint32_t body = 0; body < scene_->bodies.size(); ++body)
            if (!slot_of(body)) any = show(body, nullptr, now_s, feel, bodies) || any;
    } else {
        for (const std::uint32_t body : lively_)
            if (!slot_of(body)) any = show(body, nullptr, now_s, feel, bodies) || any;
    }
    for (std::size_t i = 0; i < used_count; ++i) any = show(used[i]->model.body(), used[i], now_s, feel, bodies) || any;
    // If a body rests in all frames of the ring, and its pose has been written, it is not examined until it moves.
    std::erase_if(lively_, [this](std::uint32_t body) {
        if (heard_ - moved_at_[body] < frames_.size() || slot_of(body)) return false;
        moved_at_[body] = 0;
        return true;
    });
    if (!has_hand_) last_hand_m_ = hand_m;
    has_hand_ = true;
    return any;
}

// Writes the pose of one body. Returns true if the body has moved since the last tick. `slot` is the slot of this body,
// or null. Frees a slot that is no longer needed.
bool BodiesInReach::show(std::uint32_t body, Slot* slot, double now_s, const BodyFeel& feel,
                         std::span<render::BodyPose> bodies) noexcept {
    const double play_s = now_s - kPlayedLate_s, same_m = kSame_hand_m * feel.world_m_per_hand_m;
    const render::DynamicsBody& is = scene_->bodies[body];
    Placement middle;
    if (!slot) {
        middle = played(body, play_s).at;
    } else {
        middle = slot->model.state().at;
        const bool mine = holding_ && &slots_[held_] == slot;
        if (!mine && now_s - slot->touched_s > kLeaves_s) {
            const BodyModel::State other = played(body, play_s);
            if (glm::length(other.at.position_m - middle.position_m) < same_m &&
                glm::length(turn_between(other.at.rotation, middle.rotation)) * is.reach_m < same_m) {
                *slot = {};
                slot = nullptr;
                middle = other.at;
            }
        }
    }
    const bool gripped = slot && holding_ && &slots_[held_] == slot;
    if (slot) {
        if (slot->contact) {
            const PlacedFrame before(slot->shown), after(middle);
            carried_m_ += after.to_world(before.to_own(slot->contact_m)) - slot->contact_m;
        }
        slot->contact = false;
        slot->shown = middle;
    }
    const Placement thing = render::thing_of(is, middle);
    bool elsewhere = !(shown_[body] == thing);
    if (is.haptic < bodies.size()) {
        const render::BodyPose pose{thing, !gripped};
        elsewhere = elsewhere || !(bodies[is.haptic] == pose);
        bodies[is.haptic] = pose;
    }
    shown_[body] = thing;
    return elsewhere;
}

std::uint32_t BodiesInReach::take(double now_s, const Vec3& hand_m, const BodyFeel& feel) noexcept {
    if (holding_) return holds();
    std::size_t best = kMost;
    double rank = 1e300;
    for (std::size_t i = 0; i < kMost; ++i) {
        const Slot& slot = slots_[i];
        if (!slot.used) continue;
        double gap = 1e300;
        const Vec3 own = PlacedFrame(slot.model.state().at).to_own(hand_m);
        for (const render::DynamicsPiece& piece : scene_->bodies[slot.model.body()].pieces)
            gap = std::min(gap, render::gap_m(piece, own));
        const bool touched =
            glm::length(slot.contact_m) > 0.0 && now_s - slot.touched_s < 0.2 && gap < 1.5 * feel.proxy_radius_m;
        if (!touched && gap > 2.0 * feel.proxy_radius_m) continue;
        if (gap < rank) {
            rank = gap;
            best = i;
        }
    }
    if (best == kMost) return render::kNoBody;
    holding_ = true;
    letting_go_ = false;
    held_ = best;
    Slot& slot = slots_[best];
    const BodyModel::State& s = slot.model.state();
    const bool ball = scene_->bodies[slot.model.body()].ball;
    grip_own_m_ = ball ? Vec3(0.0) : PlacedFrame(s.at).to_own(hand_m);
    grip_offset_m_ = ball ? hand_m - s.at.position_m : Vec3(0.0);
    grip_turn_ = s.at.rotation;
    grip_force_n_ = Vec3(0.0);
    slot.strained_s = 0.0;
    slot.said = false;
    return slot.model.body();
}

void BodiesInReach::let_go(const BodyFeel& feel) noexcept {
    if (!holding_) return;
    holding_ = false;
    letting_go_ = true;
    most_speed_m_per_s_ = kHandSpeed_m_per_s * feel.world_m_per_hand_m;
    slots_[held_].model.limit_speed(most_speed_m_per_s_);
    grip_force_n_ = Vec3(0.0);
}

void BodiesInReach::turn_held(const Rotation& by) noexcept {
    if (holding_) grip_turn_ = normalized(by * grip_turn_);
}

Vec3 BodiesInReach::grip_point_m() const noexcept {
    return PlacedFrame(slots_[held_].model.state().at).to_world(grip_own_m_);
}

Vec3 BodiesInReach::grip_force_n(const Vec3& hand_m, double dt_s, const BodyFeel& feel) noexcept {
    tick_assert(dt_s > 0.0 && feel.world_m_per_hand_m > 0.0 && feel.ceiling_n >= 0.0);
    // The velocity of the hand, filtered with one pole at 50 Hz like the other hand velocities.
    const double u = 2.0 * kPi * 50.0 * dt_s;
    if (has_hand_) hand_m_per_s_ += ((hand_m - last_hand_m_) / dt_s - hand_m_per_s_) * (u / (1.0 + u));
    last_hand_m_ = hand_m;
    grip_force_n_ = Vec3(0.0);
    if (!holding_) return grip_force_n_;
    const double scale = feel.world_m_per_hand_m;
    const Vec3 at = grip_point_m();
    const Vec3 away = at + grip_offset_m_ - hand_m, speeds = slots_[held_].model.speed_at(at) - hand_m_per_s_;
    grip_force_n_ = away * (feel.grip_n_per_m / scale) + speeds * (feel.grip_ns_per_m / scale);
    const Vec3 most = at_most(grip_force_n_, feel.ceiling_n);
    if (!(most == grip_force_n_)) {
        // The grip slips in the direction of the force, which only removes energy.
        grip_offset_m_ += (most - grip_force_n_) * (scale / feel.grip_n_per_m);
        grip_force_n_ = most;
        // The grip has slipped off if the offset is much greater than the body's size and the hand's range.
        const render::DynamicsBody& is = scene_->bodies[slots_[held_].model.body()];
        if (glm::length(grip_offset_m_) > 2.0 * is.reach_m + 0.02 * scale) {
            heavy_ = slots_[held_].model.body();
            let_go(feel);
        }
    }
    return grip_force_n_;
}

// Returns the moment that turns the body back to the orientation that it had when the hand gripped it, like a
// critically damped spring. A device with three axes cannot turn the body itself.
Vec3 BodiesInReach::wrist_nm() const noexcept {
    const BodyModel& model = slots_[held_].model;
    if (scene_->bodies[model.body()].ball) return Vec3(0.0);
    const BodyModel::State& s = model.state();
    const PlacedFrame frame(s.at);
    const Vec3 turn = turn_between(s.at.rotation, grip_turn_) * (kWrist_per_s * kWrist_per_s) -
                      s.turn_rad_per_s * (2.0 * kWrist_per_s);
    return frame.turned(frame.turned_back(turn) * model.reported().inertia_kg_m2);
}

void BodiesInReach::strain(Slot& slot, double force_n, double dt_s, const BodyFeel& feel) noexcept {
    const Vec3& at = slot.model.state().at.position_m;
    const bool hard = force_n >= std::min(kStrain_n, kStrainShare * feel.ceiling_n);
    const bool moved = glm::length(at - slot.strained_from_m) > kStrainMoves_hand_m * feel.world_m_per_hand_m;
    if (!hard || moved || slot.strained_s == 0.0) slot.strained_from_m = at;
    slot.strained_s = hard && !moved ? slot.strained_s + dt_s : 0.0;
    if (force_n == 0.0) slot.said = false;
    if (slot.strained_s < kStrain_s || slot.said) return;
    slot.said = true;
    heavy_ = slot.model.body();
}

void BodiesInReach::send(Slot& slot, render::HandPush push, render::HandPushRing& pushes) noexcept {
    push.force_n += slot.unsent_ns / push.dt_s;
    push.moment_nm += slot.unsent_nms / push.dt_s;
    slot.unsent_ns = slot.unsent_nms = Vec3(0.0);
    if (pushes.push(push)) return;
    refused_ |= 1U << (&slot - slots_.data());
    keep(slot, push);
}

void BodiesInReach::keep(Slot& slot, const render::HandPush& push) noexcept {
    slot.unsent_ns = push.force_n * push.dt_s;
    slot.unsent_nms = push.moment_nm * push.dt_s;
}

bool BodiesInReach::take_back(std::uint32_t refused, const render::HandPush& push) noexcept {
    Slot* const slot = slot_of(push.body);
    if (!slot || !(refused >> (slot - slots_.data()) & 1U)) return false;
    keep(*slot, push);
    return true;
}

void BodiesInReach::react(const render::TouchResult& touch, double share, double now_s, double dt_s,
                          const BodyFeel& feel, render::HandPushRing& pushes) noexcept {
    if (!scene_) return;
    tick_assert(share >= 0.0 && share <= 1.0 + 1e-9 && feel.felt_gain > 0.0);
    const render::ContactSet& set = touch.contacts;
    Vec3 sum(0.0);
    for (std::size_t k = 0; k < set.count; ++k) sum += set.contacts[k].normal * set.contacts[k].share;
    const double whole = glm::length(sum) > 1e-12 ? glm::length(touch.contact_force_n) / glm::length(sum) : 0.0;
    for (std::size_t i = 0; i < kMost; ++i) {
        Slot& slot = slots_[i];
        if (!slot.used) continue;
        const render::DynamicsBody& is = scene_->bodies[slot.model.body()];
        const bool held = holding_ && held_ == i, leaves = letting_go_ && held_ == i;
        Vec3 force(0.0), moment(0.0);
        const auto act = [&](const Vec3& on_hand_n, const Vec3& at_m) {
            const Vec3 f = on_hand_n * (-share / feel.felt_gain);
            force += f;
            moment += glm::cross(at_m - slot.model.state().at.position_m, f);
        };
        for (std::size_t k = 0; k < set.count && !held; ++k) {
            const render::Contact& c = set.contacts[k];
            if (c.feature != is.feature) continue;
            slot.contact_m = touch.proxy_m - c.normal * touch.radius_m;
            slot.contact = true;
            act(set.count == 1 ? touch.contact_force_n : c.normal * (c.share * whole), slot.contact_m);
        }
        if (held) {
            act(grip_force_n_, grip_point_m());
            moment += wrist_nm();
        }
        if (slot.contact || held) slot.touched_s = now_s;
        // A held body needs no such check: if it is too heavy, it slips out of the grip at the ceiling.
        if (!held) strain(slot, glm::length(force) * feel.felt_gain, dt_s, feel);
        if (slot.contact || held || leaves || slot.unsent_ns != Vec3(0.0)) {
            render::HandPush push;
            push.time_s = now_s;
            push.dt_s = dt_s;
            push.body = slot.model.body();
            push.game = game_;
            push.force_n = force;
            push.moment_nm = moment;
            push.least_kg = kLeastFelt_kg / (feel.world_m_per_hand_m * feel.felt_gain);
            push.most_speed_m_per_s = leaves ? most_speed_m_per_s_ : 0.0;
            push.held = held;
            send(slot, push, pushes);
            if (leaves) letting_go_ = false;
        }
        if (now_s - slot.model.reported_s() > kSilent_s) slot.model.rest();
        else slot.model.tick(force, moment, dt_s);
    }
}

std::uint32_t BodiesInReach::heavy() noexcept {
    const std::uint32_t said = heavy_;
    heavy_ = render::kNoBody;
    return said;
}

}  // namespace handrail::servo
