// The rooms of the present world: which one the walker is in, where they lead, and the person's names for them. It
// knows nothing of followed routes. App thread only; RoomsOfWorld finds them in a background task.
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

namespace handrail::core {

class Rooms : SessionPart {
public:
    explicit Rooms(const SessionContext& context) : SessionPart(context) {}

    // scene: as in its file. keeper: see RoomsOfWorld. Returns the rooms of the previous world, to be freed in a
    // background task, because that may wait for a thread and for a disk.
    std::shared_ptr<RoomsOfWorld> enter_world(std::shared_ptr<const Scene> scene, RoutesKeeper keeper = {});
    // Handles exits, unvisited exits, and naming a room. Returns false for other commands.
    bool act(Command command, double now_s);
    void tick(double now_s);

    // True if there are rooms and routes to use.
    bool known();
    // The same, and determines the present room; if false, announces why.
    bool have(double now_s);
    // True if have() was called before the rooms were known, since the last call.
    bool take_refused() { return std::exchange(refused_, false); }
    // The same before the world's doors are in place: leaves are not considered.
    bool found() const { return looked_for_ && of_world_->found(); }
    // True once the search is over, with or without a result, as of the last tick.
    bool looked_for() const { return looked_for_; }
    bool awaited() const { return of_world_ && !looked_for_; }
    const std::string& problem() const { return of_world_->problem(); }
    // Valid only if they are found.
    navigation::RoomGraph& graph() const { return of_world_->graph(); }
    navigation::Navigation& navigation() const { return of_world_->navigation(); }
    const navigation::WalkSpace& space() const { return navigation().space(); }
    // The world as in its file.
    const std::shared_ptr<const Scene>& file_scene() const { return of_world_->scene(); }
    std::shared_ptr<const navigation::Navigation> navigation_kept() const { return of_world_->navigation_kept(); }

    // The last room that the walker was in; kNothing: none.
    std::uint32_t here() const { return here_; }
    // Determines the present room; quietly: without announcing it.
    void notice(double now_s, bool quietly);
    // Its name once more, since the line with it was cut, unless the person wants no names of rooms. False: there is
    // none.
    bool tell_here_anew(double now_s);

    // Asks for a name for a room, stores it and then calls `then`.
    void ask_name(std::uint32_t room, std::function<void(double now_s)> then, double now_s);
    // The person's names have changed in their file.
    void take_names_again();

    // For the plan while it is shown.
    void show_plan(bool shown) { drawn_ = shown; }
    const std::shared_ptr<const std::vector<DrawnRoom>>& drawing() const { return drawing_; }

    // Set by the session, for features that store things by room.
    std::function<void(double now_s)> on_known;  // once for each world
    std::function<void(const std::string& before, const std::string& name)>
        on_renamed;  // names as in files; empty: it has none

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
    std::uint32_t here_ = navigation::kNothing;
    std::optional<std::size_t> storey_;  // the last storey on which the walker was in a room
    std::vector<bool> visited_;          // since this world was entered
    std::vector<RoomNameGiven> names_;
    std::shared_ptr<const std::vector<DrawnRoom>> drawing_;  // for the plan
    std::string drawn_language_;
    std::shared_ptr<const Scene> leaves_of_;  // the scene in which the navigation last learnt of open leaves
};

}  // namespace handrail::core
