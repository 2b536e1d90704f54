#include "haptic/dynamics/dynamics_loop.h"

#include <cmath>

#include "worlds/base/contract.h"

namespace handrail {

DynamicsLoop::DynamicsLoop(std::shared_ptr<const DynamicsScene> scene, double begin_s) : dynamics_(std::move(scene)) {
    dynamics_.skip(begin_s);
}

DynamicsLoop::~DynamicsLoop() { stop(); }

void DynamicsLoop::start(Clock& clock) {
    if (thread_.joinable()) return;
    stop_.store(false, std::memory_order_release);
    thread_ = std::thread([this, &clock] {
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

// Everything handed over until now.
void DynamicsLoop::take() {
    Order order;
    while (orders_.pop(order)) switch (order.kind) {
            case Order::Kind::Restart:
                dynamics_.restart();
                break;
            case Order::Kind::Lead:
                dynamics_.lead(order.body, order.at_m, order.most_n, order.turn);
                break;
            case Order::Kind::LetGo:
                dynamics_.lead(kNoBody, Vec3(0.0), 0.0);
                break;
            case Order::Kind::Shove:
                dynamics_.shove(order.body, order.speed_m_per_s, order.most_n, order.for_s);
                break;
            case Order::Kind::Walker:
                dynamics_.walker(order.at_m, order.radius_m, order.height_m);
                break;
        }
    if (driven_.refresh() && driven_.read()) {
        const std::vector<BodyPose>& poses = *driven_.read();
        const std::size_t count = std::min(poses.size(), dynamics_.scene().driven.size());
        for (std::size_t i = 0; i < count; ++i)
            dynamics_.drive(static_cast<std::uint32_t>(i), poses[i].at, poses[i].present);
    }
    for (unsigned hand = 0; hand < 2; ++hand) {
        HandChannel& channel = *hands_[hand];
        if (channel.place.refresh()) dynamics_.place_hand(hand, channel.place.read());
        HandPush push;
        while (channel.pushes.pop(push)) dynamics_.push(hand, push);
    }
}

void DynamicsLoop::one_step() {
    heard_.clear();
    dynamics_.step(now_, heard_);
    for (const BodyEvent& event : heard_)
        if (!events_.push(event)) break;
}

bool DynamicsLoop::step_until(double now_s) {
    // Rounding must not make a step at the very moment one tick late.
    const double due = std::floor((now_s - dynamics_.time_s()) / Dynamics::kStep_s + 1e-6);
    if (!(due >= 1.0)) return false;
    int steps = kMostBehind;
    if (due > kMostBehind) {
        const double lost = (due - kMostBehind) * Dynamics::kStep_s;
        dynamics_.skip(lost);
        lost_s_.store(lost_s_.load(std::memory_order_relaxed) + lost, std::memory_order_relaxed);
    } else {
        steps = static_cast<int>(due);
    }
    for (int i = 0; i < steps; ++i) {
        take();
        one_step();
    }
    late_steps_.fetch_add(static_cast<std::uint64_t>(steps - 1), std::memory_order_relaxed);
    for (const auto& hand : hands_) hand->frame.publish(now_);
    for_app_.publish(now_);
    return true;
}

}  // namespace handrail
