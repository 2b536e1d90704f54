#include "app/core/world/placed_things.h"

#include <algorithm>
#include <utility>

#include "worlds/base/contract.h"

namespace handrail::core {

void PlacedThings::enter(const Scene& scene, const render::HapticScene& haptic, const compile::Simplification& plan,
                         double now_s) {
    contract_pre(std::isfinite(now_s));
    things_.clear();
    for (std::size_t i = 0; i < haptic.bodies.size() && i < scene.placed.size(); ++i)
        things_.push_back({scene.placed[i].at, {}, {}, 1.0, 0.0, -1});
    feel_as(scene, haptic, plan, now_s);
}

void PlacedThings::feel_as(const Scene& scene, const render::HapticScene& haptic, const compile::Simplification& plan,
                           double now_s) {
    doorways_.clear();
    for (std::size_t i = 0; i < things_.size(); ++i) {
        things_[i].doorway = -1;
        if (const compile::NarrowOpening* opening = plan.of_door(scene.placed[i].feature)) {
            things_[i].doorway = static_cast<int>(doorways_.size());
            doorways_.push_back(*opening);
        }
    }
    generation_ = haptic.generation;
    publish(now_s);
}

void PlacedThings::publish(double now_s) {
    std::vector<render::BodyPose> poses(things_.size());
    for (std::size_t i = 0; i < things_.size(); ++i) {
        poses[i] = {things_[i].at, true};
        Vec3& place_m = poses[i].at.position_m;
        if (things_[i].doorway >= 0)
            place_m = doorways_[static_cast<std::size_t>(things_[i].doorway)].drawn_apart(place_m);
    }
    frame_.push(generation_, now_s, std::move(poses));
}

void PlacedThings::send(std::size_t thing, const Placement& to, double speed_m_per_s) {
    contract_pre(thing < things_.size());
    contract_pre(speed_m_per_s > 0.0);
    Thing& t = things_[thing];
    t.from = t.at;
    t.to = to;
    t.part = 0.0;
    const double way = glm::length(to.position_m - t.at.position_m);
    t.parts_per_s = way > 0.0 ? speed_m_per_s / way : 1.0;
}

void PlacedThings::put(std::size_t thing, const Placement& at) {
    contract_pre(thing < things_.size());
    contract_pre(is_finite(at.position_m) && at.scale > 0.0);
    Thing& t = things_[thing];
    put_ = put_ || !(t.at == at);
    t.at = at;
    t.part = 1.0;
}

bool PlacedThings::tick(double now_s, double dt_s) {
    contract_pre(dt_s >= 0.0);
    bool moved = std::exchange(put_, false), arrived = false;
    for (Thing& t : things_) {
        if (t.part >= 1.0) continue;
        t.part = std::min(1.0, t.part + t.parts_per_s * dt_s);
        t.at = t.part == 1.0 ? t.to : between(t.from, t.to, t.part);
        moved = true;
        arrived = arrived || t.part == 1.0;
    }
    if (moved) publish(now_s);
    return arrived;
}

std::vector<Placement> PlacedThings::all() const {
    std::vector<Placement> all;
    for (const Thing& t : things_) all.push_back(t.at);
    return all;
}

bool PlacedThings::moving() const {
    return std::any_of(things_.begin(), things_.end(), [](const Thing& t) { return t.part < 1.0; });
}

}  // namespace handrail::core
