#include "app/core/wayfinding/directions_ground.h"

#include <utility>

namespace handrail::core {

void DirectionsGround::enter_world() {
    floor_.reset();
    making_.give_up();
}

void DirectionsGround::tick() {
    // If the person has changed the step length, the floor must be made again, because its distances are in steps.
    if (floor_ && floor_->step_m != context_.settings.walk.step_length_m) floor_.reset();
    (void)floor();
}

std::shared_ptr<const DirectionsFloor> DirectionsGround::floor() {
    if (floor_ || !rooms_.found() || !context_.world.scene) return floor_;
    if (auto made = making_.take()) return floor_ = std::move(*made);
    if (making_.busy()) return nullptr;
    making_.begin([ways = rooms_.navigation_kept(), rooms = rooms_.graph().room_of_span, scene = context_.world.scene,
                   things = context_.world.thing_of_mover,
                   step_m = context_.settings.walk.step_length_m](const std::stop_token&) {
        return std::shared_ptr<const DirectionsFloor>(
            std::make_shared<const DirectionsFloor>(ways, rooms, navigation::word_doors(*scene, things), step_m));
    });
    return nullptr;
}

navigation::DoorsOpen DirectionsGround::open_now(const DirectionsFloor& floor) const {
    navigation::DoorsOpen open;
    for (const navigation::DirectionsDoor& door : floor.ground.doors())
        // A door that is shutting is treated as shut, because it will be shut when the person arrives.
        open.push_back(context_.world.movers.at_goal(door.mover) == context_.world.scene->movers[door.mover].at(0.0)
                           ? navigation::DoorState::Shut
                           : navigation::DoorState::Open);
    return open;
}

std::optional<double> DirectionsGround::line_up_m(const Vec3& feet_m, double heading_rad) {
    const auto known = floor();
    if (!known) return std::nullopt;
    const navigation::BlindWalker body = known->ground.body_at(feet_m);
    if (body.span == navigation::kNothing) return std::nullopt;
    return known->ground.line_up_m(body, heading_rad, open_now(*known));
}

}  // namespace handrail::core
