#include "app/core/rooms_of_world.h"

namespace handrail {

RoomsOfWorld::RoomsOfWorld(std::shared_ptr<const Scene> scene, const WalkBody& body, bool at_once) : scene_(std::move(scene)), body_(body), at_once_(at_once) {
    if (!at_once_) worker_ = std::thread([this] { find(); });
}

RoomsOfWorld::~RoomsOfWorld() {
    stop_ = true;
    if (worker_.joinable()) worker_.join();
}

void RoomsOfWorld::find() {
    Result<std::shared_ptr<Navigation>> made = Navigation::make(*scene_, body_, [this] { return stop_.load(); });
    if (made) {
        graph_ = make_rooms(*scene_, (*made)->space());
        navigation_ = std::move(*made);
    } else {
        problem_ = made.error().message;
    }
    done_ = true;
}

bool RoomsOfWorld::ready() {
    if (at_once_ && !done_) find();
    return done_;
}

}  // namespace handrail
