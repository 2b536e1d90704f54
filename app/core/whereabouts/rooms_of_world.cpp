#include "app/core/whereabouts/rooms_of_world.h"

#include <new>

#include "app/core/whereabouts/rooms_kept.h"
#include "app/core/world/arrivals.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/navigation/reach.h"
#include "worlds/navigation/validate_ways.h"

namespace handrail {

RoomsOfWorld::RoomsOfWorld(std::shared_ptr<const Scene> scene, const WalkBody& body, bool at_once)
    : scene_(std::move(scene)), body_(body), at_once_(at_once) {
    contract_pre(scene_ != nullptr);
    contract_pre(body.radius_m > 0.0 && body.height_m > 0.0);
    if (!at_once_) worker_ = std::jthread([this](const std::stop_token& stop) { find(stop); });
}

void RoomsOfWorld::find(const std::stop_token& stop) {
    try {
        Result<std::shared_ptr<Navigation>> made = Navigation::make(*scene_, body_, stop);
        if (made) {
            graph_ = make_rooms(*scene_, (*made)->space(), stop);
            contract_valid(validate((*made)->space()));
            contract_valid(validate(graph_, (*made)->space()));
            out_of_reach_ = unreachable_rooms(*scene_, (*made)->space(), graph_);
            (*made)->let_walls_go();
            navigation_ = std::move(*made);
        } else {
            problem_ = made.error().message;
        }
    } catch (const std::bad_alloc&) {
        // The session goes on without rooms and ways.
        navigation_.reset();
        graph_ = {};
        out_of_reach_.clear();
        problem_ = phrase("navigation.too_large");
    }
    done_ = true;
    done_.notify_all();
}

// What was found of the same scene before, where somebody keeps it.
void RoomsOfWorld::find_once() {
    RoomsKept* const kept = RoomsKept::here();
    if (const RoomsKept::Found* before = kept ? kept->of(scene_, body_) : nullptr)
        if (auto made = Navigation::make_over(*scene_, before->space)) {
            navigation_ = std::move(*made);
            graph_ = before->graph;
            out_of_reach_ = before->out_of_reach;
            done_ = true;
            return;
        }
    find({});
    if (kept && navigation_)
        kept->keep({scene_, body_, spoken_language(), navigation_->space(), graph_, out_of_reach_});
}

bool RoomsOfWorld::ready() {
    if (at_once_ && !done_) find_once();
    if (!known_ && !at_once_) known_ = Arrivals::there([this] { return done_.load(); }, [this] { done_.wait(false); });
    return at_once_ ? done_.load() : known_;
}

}  // namespace handrail
