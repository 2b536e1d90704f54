// Where a person may want to go: things and marks, and places as stops of a way. Functions of what the context holds;
// whoever asks for a stop knows that the rooms are found. Metres, world. App thread only.
#pragma once

#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/kept/ways.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail {

// Something to be found or gone to.
struct Goal {
    std::string name;
    Aabb box_m;  // a point for marks and places on walls
    FeatureId feature = kNoFeature;
};

inline Aabb point_box(const Vec3& place_m) { return {place_m, place_m}; }

// Everything with a name, the person's marks too, the nearest first.
std::vector<Goal> goals(const SessionContext& context);

// Where a goal is told to be: of a door the doorway, as exits tell it, where rooms are found; else its box.
Aabb told_box(const Rooms& rooms, const Goal& goal);

inline constexpr double kAtStop_m = 1.5;  // who is so near a stop need not be led to it

// So near on the level, and on this storey.
bool near_stop(const Stop& stop, const Vec3& place_m, double near_m);
// The room there, as the map or the person calls it; else what it is near to; else `otherwise`.
Stop stop_at_place(const Rooms& rooms, const Vec3& place_m, const std::string& otherwise);
Stop stop_in_room(const Rooms& rooms, std::uint32_t room);
// Where one stands before it, coming from that place.
Stop stop_at_goal(const SessionContext& context, const Rooms& rooms, const Goal& goal, const Vec3& from_m);
// The thing of a stop, where it is by now; else its place.
Goal goal_of(const SessionContext& context, const Stop& stop);

// Where the person has wanted to go, one after the other, each from where the one before ended: one way.
class PlannedStops : SessionPart {
public:
    PlannedStops(const SessionContext& context, const Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    void clear() { stops_.clear(), chosen_.clear(); }
    // The person wants to go there, from that place.
    void note(const Stop& stop, const Vec3& from_m);
    const std::vector<Stop>& stops() const { return stops_; }
    // Also those that were chosen one after the other without going there, as an instructor puts a route together.
    const std::vector<Stop>& chosen() const { return chosen_; }

private:
    const Rooms& rooms_;
    std::vector<Stop> stops_, chosen_;
    Vec3 chosen_at_m_{0.0};  // where the last one was chosen
};

}  // namespace handrail
