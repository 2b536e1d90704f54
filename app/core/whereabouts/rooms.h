// The rooms of the world one is in: which one the body is in, where they lead, and what the person calls them. Knows
// nothing of ways that are gone. App thread only; RoomsOfWorld finds them in the background.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/context/view.h"
#include "app/core/kept/room_names.h"
#include "app/core/whereabouts/rooms_of_world.h"
#include "worlds/base/patience.h"

namespace handrail {

class Rooms : SessionPart {
public:
    explicit Rooms(const SessionContext& context) : SessionPart(context) {}

    // scene: as its file has it. keeper: see RoomsOfWorld. What is known of the world one leaves comes back, to be let
    // go of beside everything else: that may wait for its thread and for a disk.
    std::shared_ptr<RoomsOfWorld> enter_world(std::shared_ptr<const Scene> scene, WaysKeeper keeper = {});
    // Exits, those not taken yet, and naming a room. False: it is another's.
    bool act(Command command, double now_s);
    void tick(double now_s);

    // There are rooms and routes to be used.
    bool known();
    // The same, noticing which room one is in; else says why not.
    bool have(double now_s);
    // have() was asked before they were known, since this was asked last.
    bool take_refused() { return std::exchange(refused_, false); }
    // The same, before the world's doors are where they will be: no leaf is noticed.
    bool found() const { return looked_for_ && of_world_->found(); }
    // The search is over, with or without a result, as of the last tick.
    bool looked_for() const { return looked_for_; }
    bool awaited() const { return of_world_ && !looked_for_; }
    const std::string& problem() const { return of_world_->problem(); }
    // Only where they are found.
    RoomGraph& graph() const { return of_world_->graph(); }
    Navigation& navigation() const { return of_world_->navigation(); }
    const WalkSpace& space() const { return navigation().space(); }
    // The world as its file has it.
    const std::shared_ptr<const Scene>& file_scene() const { return of_world_->scene(); }
    std::shared_ptr<const Navigation> navigation_kept() const { return of_world_->navigation_kept(); }

    // The last one the body was in; kNothing: none.
    std::uint32_t here() const { return here_; }
    // Which one that is now; quietly: without a word about it.
    void notice(double now_s, bool quietly);

    // Asks what a room is to be called, `then` once it is; names it and keeps that.
    void ask_name(std::uint32_t room, std::function<void(double now_s)> then, double now_s);
    // The names that the person gave have been changed in their file.
    void take_names_again();

    // For the plan, while it is shown.
    void show_plan(bool shown) { drawn_ = shown; }
    const std::shared_ptr<const std::vector<DrawnRoom>>& drawing() const { return drawing_; }

    // Set by the session, for whoever keeps something by the rooms.
    std::function<void(double now_s)> on_known;  // once for each world
    std::function<void(const std::string& before, const std::string& name)>
        on_renamed;  // as files know a room; empty: they do not

private:
    void know_leaves();
    void tell_that_it_takes_long(double now_s);
    void draw();
    std::string storey_news(bool told);
    void tell_exits(bool unvisited_only, double now_s);
    void lay_given_names(double now_s);
    void give_name(std::uint32_t room, const std::string& typed, double now_s);

    bool looked_for_ = false, told_ = false, drawn_ = false, refused_ = false;
    std::shared_ptr<RoomsOfWorld> of_world_;
    std::optional<Patience> patience_;  // since the first tick in this world; none: not begun, or over
    std::uint32_t here_ = kNothing;
    std::optional<std::size_t> storey_;  // the last one that the body was in a room of
    std::vector<bool> visited_;          // since this world was entered
    std::vector<RoomNameGiven> names_;
    std::shared_ptr<const std::vector<DrawnRoom>> drawing_;  // for the plan
    std::string drawn_language_;
    std::shared_ptr<const Scene> leaves_of_;  // the world as it was when ways were told where leaves stand
};

}  // namespace handrail
