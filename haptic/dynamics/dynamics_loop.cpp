#include "haptic/dynamics/dynamics_loop.h"

#include <cmath>

#include "worlds/base/contract.h"
#include "worlds/base/executor.h"

namespace handrail::dynamics {

DynamicsLoop::DynamicsLoop(std::shared_ptr<const render::DynamicsScene> scene, double begin_s,
                           EngineRecording* recording)
    : recording_(recording), dynamics_(std::move(scene)) {
    dynamics_.skip(begin_s);
    if (recording_) row_.engine = ++recording_->engines;
    for (const auto& hand : hands_) hand->engine = row_.engine;
}

DynamicsLoop::~DynamicsLoop() { stop(); }

void DynamicsLoop::start(Clock& clock) {
    if (thread_.joinable()) return;
    stop_.store(false, std::memory_order_release);
    thread_ = std::thread([this, &clock] {
        name_this_thread("bodies");
        while (!stop_.load(std::memory_order_acquire)) {
            step_until(clock.now_s());
            clock.sleep_until_s(dynamics_.time_s() + Dynamics::kStep_s);
        }
    });
}

void DynamicsLoop::stop() {
    stop_.store(true, std::memory_order_release);
    if (thread_.joinable()) thread_.join();
}

bool DynamicsLoop::order(const Order& order) {
    const bool has_room = orders_.push(order);
    if (!recording_) return has_room;
    ++recording_->orders;
    if (!has_room) recording_->refused.push_back(recording_->orders);
    return has_room;
}

void carry_out(Dynamics& dynamics, const BodyEngine::Order& order) {
    using Kind = BodyEngine::Order::Kind;
    switch (order.kind) {
        case Kind::Restart:
            return dynamics.restart();
        case Kind::Lead:
            return dynamics.lead(order.body, order.at_m, order.most_n, order.turn);
        case Kind::LetGo:
            return dynamics.lead(render::kNoBody, Vec3(0.0), 0.0);
        case Kind::Shove:
            return dynamics.shove(order.body, order.speed_m_per_s, order.most_n, order.for_s);
        case Kind::Walker:
            return dynamics.walker(order.at_m, order.radius_m, order.height_m);
    }
}

void carry_out(Dynamics& dynamics, const std::vector<render::BodyPose>& driven) {
    const std::size_t count = std::min(driven.size(), dynamics.scene().driven.size());
    for (std::size_t i = 0; i < count; ++i)
        dynamics.drive(static_cast<std::uint32_t>(i), driven[i].at, driven[i].present);
}

// Applies all requests, pushes, places and poses that have arrived.
void DynamicsLoop::take() {
    row_.orders = 0;
    for (Order order; orders_.pop(order); ++row_.orders) carry_out(dynamics_, order);
    if (driven_.refresh() && driven_.read().poses) {
        carry_out(dynamics_, *driven_.read().poses);
        row_.driven = driven_.read().number;
    }
    for (unsigned hand = 0; hand < 2; ++hand) {
        render::HandChannel& channel = *hands_[hand];
        if (channel.place.refresh()) {
            const render::HandPlace& place = channel.place.read();
            dynamics_.place_hand(hand, place);
            row_.places_s[hand] = place.present() ? place.time_s : EngineRow::kNoHand_s;
        }
        row_.pushes[hand] = 0;
        for (render::HandPush push; channel.pushes.pop(push); ++row_.pushes[hand]) dynamics_.push(hand, push);
    }
}

void DynamicsLoop::one_step() {
    heard_.clear();
    dynamics_.step(now_, heard_);
    row_.events = 0;
    for (const render::BodyEvent& event : heard_) {
        if (!events_.push(event)) break;
        ++row_.events;
    }
}

bool DynamicsLoop::step_until(double now_s) {
    // The small addend prevents a rounding error from delaying a step by one tick.
    const double due = std::floor((now_s - dynamics_.time_s()) / Dynamics::kStep_s + 1e-6);
    if (!(due >= 1.0)) return false;
    int steps = kMostBehind;
    row_.skipped = 0;
    if (due > kMostBehind) {
        const double lost = (due - kMostBehind) * Dynamics::kStep_s;
        dynamics_.skip(lost);
        row_.skipped = static_cast<std::uint64_t>(due - kMostBehind);
        lost_s_.store(lost_s_.load(std::memory_order_relaxed) + lost, std::memory_order_relaxed);
    } else {
        steps = static_cast<int>(due);
    }
    for (int i = 0; i < steps; ++i) {
        take();
        one_step();
        if (!recording_) continue;
        row_.step = now_.number;
        row_.time_s = now_.time_s;
        row_.published = i + 1 == steps;
        recording_->push(row_);
        row_.skipped = 0;
    }
    late_steps_.fetch_add(static_cast<std::uint64_t>(steps - 1), std::memory_order_relaxed);
    for (const auto& hand : hands_) hand->frame.publish(now_);
    for_app_.publish(now_);
    return true;
}

}  // namespace handrail::dynamics
