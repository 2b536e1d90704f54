#include "app/core/whereabouts/rooms_of_world.h"

#include <new>

#include "app/core/whereabouts/rooms_kept.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/navigation/reach.h"
#include "worlds/navigation/validate_ways.h"
#include "worlds/stored/stored_navigation.h"

namespace handrail::core {

RoomsOfWorld::RoomsOfWorld(std::shared_ptr<const Scene> scene, const navigation::WalkerMeasures& body,
                           const Executor& executor, RoutesKeeper keeper, RoomsKept* shared, Arrivals* arrivals)
    : scene_(std::move(scene)), body_(body), keeper_(std::move(keeper)), arrivals_(arrivals) {
    contract_pre(scene_ != nullptr);
    contract_pre(body.radius_m > 0.0 && body.height_m > 0.0);
    if (keeper_) shared = nullptr;
    if (shared && take_from(*shared)) return;
    worker_ = executor.run("rooms", [this] { find(stop_.get_token()); });
    if (shared && !worker_.joinable() && navigation_)
        shared->keep({scene_, body_, spoken_language(), navigation_->space(), graph_, out_of_reach_});
}

RoomsOfWorld::~RoomsOfWorld() {
    give_up();
    if (worker_.joinable()) worker_.join();
}

// Uses the earlier result for the same scene, if there is one. Returns false if there is none.
bool RoomsOfWorld::take_from(const RoomsKept& shared) {
    const RoomsKept::Found* before = shared.of(scene_, body_);
    if (!before) return false;
    auto made = navigation::Navigation::over(*scene_, before->space);
    if (!made) return false;
    navigation_ = std::move(*made);
    graph_ = before->graph;
    out_of_reach_ = before->out_of_reach;
    done_ = true;
    return true;
}

void RoomsOfWorld::find_or_take(const std::string& key, const std::stop_token& stop) {
    std::optional<stored::FoundNavigation> kept;
    if (keeper_) kept = stored::navigation_from(keeper_.take(key, stop), body_, *scene_);
    Result<std::shared_ptr<navigation::Navigation>> made =
        kept ? navigation::Navigation::over(*scene_, std::move(kept->space), stop)
             : navigation::Navigation::make(*scene_, body_, stop);
    if (!made) {
        problem_ = made.error().message;
        return;
    }
    graph_ = kept ? std::move(kept->graph) : navigation::make_rooms(*scene_, (*made)->space(), stop);
    contract_valid(validate((*made)->space()));
    contract_valid(validate(graph_, (*made)->space()));
    out_of_reach_ = navigation::unreachable_rooms(*scene_, (*made)->space(), graph_);
    (*made)->let_walls_go();
    navigation_ = std::move(*made);
    kept_ = kept.has_value();
}

void RoomsOfWorld::find(const std::stop_token& stop) {
    std::string key;
    std::shared_ptr<const navigation::Navigation> to_keep;
    navigation::RoomGraph graph;  // a copy of the graph from before the person's names were added
    try {
        if (keeper_) key = keeper_.key_of(*scene_, body_);
        find_or_take(key, stop);
        if (navigation_ && !kept_ && keeper_ && !stop.stop_requested() &&
            stored::worth_keeping(navigation_->space(), *scene_)) {
            graph = graph_;
            to_keep = navigation_;
        }
    } catch (const std::bad_alloc&) {
        // The search failed, so the session continues without rooms and routes.
        navigation_.reset();
        graph_ = {};
        out_of_reach_.clear();
        problem_ = phrase("navigation.no_memory");
    }
    done_ = true;
    done_.notify_all();
    if (!to_keep) return;
    try {
        if (const std::string packed = stored::stored_navigation(to_keep->space(), graph, stop); !packed.empty())
            keeper_.keep(key, packed);
    } catch (const std::bad_alloc&) {  // Memory is short, so nothing is stored, and the next start searches again.
    }
}

bool RoomsOfWorld::ready() {
    if (!known_)
        known_ = Arrivals::there(
            arrivals_, [this] { return done_.load(); }, [this] { done_.wait(false); });
    return known_;
}

}  // namespace handrail::core
