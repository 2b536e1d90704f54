// Determines in which room of the present world the walker is and where the exits lead, and stores the person's names
// for rooms. This class does not know whether a route is followed. RoomsOfWorld searches for the rooms in a background
// task. Use this class on the app thread only.
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

    // Begins the search for the rooms of another world. `scene` is the world as in its file. RoomsOfWorld explains
    // `keeper`. Returns the rooms of the previous world. A background task should destroy these rooms, because that may
    // wait for a thread and a disk.
    std::shared_ptr<RoomsOfWorld> enter_world(std::shared_ptr<const Scene> scene, RoutesKeeper keeper = {});
    // Carries out the commands for exits, for unvisited exits and for naming a room. Returns false for other commands.
    bool act(Command command, double now_s);
    void tick(double now_s);

    // Returns true if rooms and routes are available.
    bool known();
    // Does the same as known(), and also determines the present room. If the rooms are not known, announces the reason.
    bool have(double now_s);
    // Returns true if have() was called while the rooms were not known, since the last call of this function.
    bool take_refused() { return std::exchange(refused_, false); }
    // Returns true if the rooms have been found, even if the positions of the world's door leaves are not known yet.
    bool found() const { return looked_for_ && of_world_->found(); }
    // Returns true if the search had ended by the last tick, with or without a result.
    bool looked_for() const { return looked_for_; }
    bool awaited() const { return of_world_ && !looked_for_; }
    const std::string& problem() const { return of_world_->problem(); }
    // The results of these functions are valid only if found() is true.
    navigation::RoomGraph& graph() const { return of_world_->graph(); }
    navigation::Navigation& navigation() const { return of_world_->navigation(); }
    const navigation::WalkSpace& space() const { return navigation().space(); }
    // Returns the world as in its file.
    const std::shared_ptr<const Scene>& file_scene() const { return of_world_->scene(); }
    std::shared_ptr<const navigation::Navigation> navigation_kept() const { return of_world_->navigation_kept(); }

    // Returns the room in which the walker was last, or kNothing.
    std::uint32_t here() const { return here_; }
    // Determines the present room, and announces it unless `quietly` is true.
    void notice(double now_s, bool quietly);
    // Announces the name of the present room once more, because the line with the name was cut off. If the person wants
    // no names of rooms, announces nothing. Returns false if there is no room.
    bool announce_here_anew(double now_s);

    // Asks for a name for a room, stores it and then calls `then`.
    void request_name(std::uint32_t room, std::function<void(double now_s)> then, double now_s);
    // Reads the names again. Call it when another session has changed them in the side file.
    void take_names_again();

    // Returns the rooms for the plan in the window; null: not known yet. Computes them in the first call, and again
    // after a name or the language has changed.
    const std::shared_ptr<const std::vector<DrawnRoom>>& drawing();
    // For each room: true if the walker has been there since the world was entered.
    const std::vector<bool>& visited() const { return visited_; }

    // The session sets these functions, for features that store things by room. `on_renamed` is called when a room was
    // renamed, with names as in files. An empty name means that the room had or has no stored name.
    std::function<void(double now_s)> on_known;  // called once for each world, when the rooms are known
    std::function<void(const std::string& before, const std::string& name)> on_renamed;

private:
    void know_leaves();
    void announce_that_it_takes_long(double now_s);
    std::string storey_news(bool announced);
    void announce_exits(bool unvisited_only, double now_s);
    void lay_given_names(double now_s);
    void give_name(std::uint32_t room, const std::string& typed, double now_s);

    bool looked_for_ = false, announced_ = false, refused_ = false;
    std::shared_ptr<RoomsOfWorld> of_world_;
    // Set at the first tick in this world. It has no value before the search has begun and after the search has ended.
    std::optional<Patience> patience_;
    std::uint32_t here_ = navigation::kNothing;
    std::optional<std::size_t> storey_;  // the last storey on which the walker was in a room
    std::vector<bool> visited_;          // for each room: true if the walker has been there since the world was entered
    std::vector<RoomNameGiven> names_;
    std::shared_ptr<const std::vector<DrawnRoom>> drawing_;  // rooms for the plan on the display
    std::string drawn_language_;
    std::shared_ptr<const Scene> leaves_of_;  // the scene for which the navigation last got the open leaves
};

}  // namespace handrail::core
