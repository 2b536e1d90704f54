// Finds the places where a person may want to go: things and marks, and stops of a route. Functions of the context.
// Functions about stops require that the rooms have been found. Lengths are in world metres. Use them on the app thread
// only.
#pragma once

#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/kept/saved_routes.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// A thing or a place that the person wants to find or go to.
struct Goal {
    std::string name;
    Aabb box_m;  // a single point for marks and for places on walls
    FeatureId feature = kNoFeature;
};

inline Aabb point_box(const Vec3& place_m) { return {place_m, place_m}; }

// Returns everything with a name, including the person's marks, the nearest first.
std::vector<Goal> goals(const SessionContext& context);

// Returns the box whose place is announced for a goal. For a door, it is the doorway, as in the list of exits, if the
// rooms are found. Otherwise it is the goal's own box.
Aabb announced_box(const Rooms& rooms, const Goal& goal);

inline constexpr double kAtStop_m = 1.5;  // within this distance of a stop no guidance to it is needed

// Returns true if `place_m` is within the horizontal distance `near_m` of the stop, on the same storey.
bool near_stop(const Stop& stop, const Vec3& place_m, double near_m);
// Makes a stop at `place_m`. The stop gets the name that the map or the person gave the room. Without such a name, it
// is named after what is near, or else `otherwise`.
Stop stop_at_place(const Rooms& rooms, const Vec3& place_m, const std::string& otherwise);
Stop stop_in_room(const Rooms& rooms, std::uint32_t room);
// Makes a stop where a person who comes from `from_m` stands in front of the goal.
Stop stop_at_goal(const SessionContext& context, const Rooms& rooms, const Goal& goal, const Vec3& from_m);
// Returns the thing at a stop, at its present place. If there is no thing, returns the stop itself.
Goal goal_of(const SessionContext& context, const Stop& stop);

// Remembers the goals that the person has chosen one after the other, each reached from the previous one. Together they
// form a route.
class PlannedStops : SessionPart {
public:
    PlannedStops(const SessionContext& context, const Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    void clear() { stops_.clear(), chosen_.clear(); }
    // Notes that the person wants to go from `from_m` to this stop.
    void note(const Stop& stop, const Vec3& from_m);
    const std::vector<Stop>& stops() const { return stops_; }
    // Returns the chosen stops. They also include goals that were chosen one after the other without walking to them,
    // as an instructor does to prepare a route.
    const std::vector<Stop>& chosen() const { return chosen_; }

private:
    const Rooms& rooms_;
    std::vector<Stop> stops_, chosen_;
    Vec3 chosen_at_m_{0.0};  // the person's place when the last goal was chosen
};

}  // namespace handrail::core
