// Routes that a person has saved in a world under a name: an ordered list of stops, how the side file stores it, and
// how each stop is found again after the world was edited. Between two stops the route is planned by Navigation. Pure
// functions over plain values; app thread. Looking up a route plans nothing; planning costs one Navigation plan for
// each leg.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

struct Stop {
    std::string name;      // as announced; empty: passed silently
    Vec3 place_m{0.0};     // world; on the floor
    std::string thing;     // scene name of the thing at the stop; empty: none
    double thing_m = 0.0;  // distance from the place to its bounds
    std::string room;      // its room, as the map or a person calls it; empty: that room has no such name
    SideEntry kept;        // keys of the file that this version does not know
};

struct SavedRoute {
    std::string name;
    std::vector<Stop> stops;  // at least two; the first and the last have names
    std::string world;        // checksum of the world's file at that time; empty: unknown
    SideEntry kept;
};

inline constexpr std::size_t kMostStops = 200;
inline constexpr double kStopMoved_m = 0.5;  // how much the distance to its thing may have changed
inline constexpr double kStopFloor_m = 0.6;  // there must be standing room within this distance
inline constexpr double kTrailBend_m = 0.4;  // how far a simplified trail may be from the original

// In the order of the file. Entries that are not routes are left out but stay in the file. For each, `faults` receives
// the file, the line, what is wrong and what to do.
std::vector<SavedRoute> read_ways(const SideFile& file, std::vector<Error>& faults);
void write_ways(SideFile& file, const std::vector<SavedRoute>& ways);

// What is wrong with a saved route in the present world.
struct StopFault {
    enum class Kind : std::uint8_t {
        ThingGone,
        ThingMoved,  // found elsewhere
        RoomGone,
        RoomMoved,  // found elsewhere
        NoPlace,    // nobody can stand there
        NoWay,      // no route on foot from the previous stop
    } kind = Kind::ThingGone;
    std::size_t stop = 0;
    double moved_m = 0.0;
};
// The present places of the stops, and the faults. If the world's file is unchanged, things and rooms are not searched
// for again. A room is recognised by the person's name and by the map's.
struct FoundRoute {
    std::vector<Stop> stops;
    std::vector<StopFault> faults;
};
FoundRoute look_up(const SavedRoute& way, const Scene& scene, const SideFile& file,
                   const navigation::Navigation& navigation, const navigation::RoomGraph& graph);
// "Desk is gone; no way on foot from Hall to Kitchen". Empty if everything fits.
std::string fault_words(const FoundRoute& found, const std::function<std::string(double)>& distance);

// Joins two routes; the second begins where the first ends.
navigation::Route joined(navigation::Route first, const navigation::Route& then);

// Plans a route on foot through several places. It ends before the first place that cannot be reached. at_m, if given,
// receives the distance of each place along the route.
navigation::Route plan_through(navigation::Navigation& navigation, const Vec3& from_m, std::span<const Vec3> places_m,
                               std::vector<double>* at_m = nullptr);

// Reduces a trail to few points, including the first and the last. No point of the trail is farther than `off_m` from
// the straight lines between them.
std::vector<Vec3> corners_of(std::span<const Vec3> trail_m, double off_m);
// The part of a trail since the person was last at a place; empty if the trail never came within `near_m` of it.
std::span<const Vec3> trail_since(std::span<const Vec3> trail_m, const Vec3& place_m, double near_m);
double length_of(std::span<const Vec3> points_m);

// A saved route that is being followed, stop after stop.
struct RouteRun {
    std::vector<Stop> stops;   // in walking order
    std::size_t next = 0;      // first stop that has not been passed
    bool by_hand = false;      // guidance is by the hand; otherwise by announcements to the walker
    std::vector<double> at_m;  // distance along the present route of each stop from `planned` on
    std::size_t planned = 0;

    // The next stop whose arrival is announced.
    std::size_t goal() const {
        std::size_t named = next;
        while (named + 1 < stops.size() && stops[named].name.empty()) ++named;
        return named;
    }
    std::vector<Vec3> places() const;  // from `next` to goal()
};

}  // namespace handrail::core
