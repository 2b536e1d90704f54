// Where a person may want to go: things and marks, and places as stops of a route. Functions of what the context
// contains. Functions about stops require that the rooms are found. Metres, world. App thread only.
#pragma once

#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/kept/saved_routes.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// Something to find or to go to.
struct Goal {
    std::string name;
    Aabb box_m;  // a point for marks, and for places on walls
    FeatureId feature = kNoFeature;
};

inline Aabb point_box(const Vec3& place_m) { return {place_m, place_m}; }

// Everything with a name, including the person's marks, nearest first.
std::vector<Goal> goals(const SessionContext& context);

// Where a goal is announced to be: for a door the doorway, as in the list of exits, if rooms are found; otherwise its
// box.
Aabb told_box(const Rooms& rooms, const Goal& goal);

inline constexpr double kAtStop_m = 1.5;  // within this distance of a stop no guidance to it is needed

// True within this level distance, on this storey.
bool near_stop(const Stop& stop, const Vec3& place_m, double near_m);
// A stop named after the room there, as the map or the person calls it; otherwise after what is near; otherwise
// `otherwise`.
Stop stop_at_place(const Rooms& rooms, const Vec3& place_m, const std::string& otherwise);
Stop stop_in_room(const Rooms& rooms, std::uint32_t room);
// Where the person stands before the goal when coming from that place.
Stop stop_at_goal(const SessionContext& context, const Rooms& rooms, const Goal& goal, const Vec3& from_m);
// The present place of the thing at a stop; otherwise the stop's place.
Goal goal_of(const SessionContext& context, const Stop& stop);

// The person's successive goals, each reached from the previous one: together one route.
class PlannedStops : SessionPart {
public:
    PlannedStops(const SessionContext& context, const Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    void clear() { stops_.clear(), chosen_.clear(); }
    // Notes that the person wants to go there from that place.
    void note(const Stop& stop, const Vec3& from_m);
    const std::vector<Stop>& stops() const { return stops_; }
    // Also includes goals that were chosen one after the other without going there, as an instructor does to prepare a
    // route.
    const std::vector<Stop>& chosen() const { return chosen_; }

private:
    const Rooms& rooms_;
    std::vector<Stop> stops_, chosen_;
    Vec3 chosen_at_m_{0.0};  // where the last one was chosen
};

}  // namespace handrail::core
