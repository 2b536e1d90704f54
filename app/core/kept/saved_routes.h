// Stores the routes that a person has saved in a world under a name. A route is an ordered list of stops. The functions
// define how the side file stores the route, and how each stop is found again after the world was edited. Navigation
// plans the route between two stops. Pure functions over plain values, for the app thread. Finding the stops of a saved
// route plans nothing. Each leg costs one call of Navigation::plan.
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
    std::string name;      // name as it is announced; empty: the stop is not announced
    Vec3 place_m{0.0};     // a point on the floor, in world coordinates
    std::string thing;     // scene name of the thing at the stop; empty: none
    double thing_m = 0.0;  // distance from the stop to the bounding box of that thing
    // Name of the room that contains the stop, given by the map or a person; empty: the room has no such name.
    std::string room;
    SideEntry kept;  // keys of the side file that this version does not know
};

struct SavedRoute {
    std::string name;
    std::vector<Stop> stops;  // at least two stops; the first and the last have names
    std::string world;        // checksum of the world's file when the route was saved; empty: not known
    SideEntry kept;
};

inline constexpr std::size_t kMostStops = 200;
inline constexpr double kStopMoved_m = 0.5;  // how much the distance from a stop to its thing may have changed
// There must be a standing place for the walker within this distance of a stop.
inline constexpr double kStopFloor_m = 0.6;
inline constexpr double kTrailBend_m = 0.4;  // largest distance of a simplified trail from the original one

// Returns the routes in the order of the side file. Entries that are not routes stay in the file but are not returned.
// For each of these entries, `faults` receives the file, the line, what is wrong and what to do.
std::vector<SavedRoute> read_saved_routes(const SideFile& file, std::vector<Error>& faults);
void write_saved_routes(SideFile& file, const std::vector<SavedRoute>& ways);

// A reason why a saved route does not fit the present world.
struct StopFault {
    enum class Kind : std::uint8_t {
        ThingMissing,
        ThingMoved,  // the thing is at another place
        RoomMissing,
        RoomMoved,  // the room is at another place
        NoPlace,    // the walker cannot stand there
        NoRoute,    // there is no route on foot from the previous stop
    } kind = Kind::ThingMissing;
    std::size_t stop = 0;
    double moved_m = 0.0;
};
// The present places of the stops, and the faults. If the world's file is unchanged, look_up() does not search for
// things and rooms again. It recognises a room by the name that the person or the map gave it.
struct FoundRoute {
    std::vector<Stop> stops;
    std::vector<StopFault> faults;
};
FoundRoute look_up(const SavedRoute& way, const Scene& scene, const SideFile& file,
                   const navigation::Navigation& navigation, const navigation::RoomGraph& graph);
// Returns "Desk is gone; no way on foot from Hall to Kitchen", or an empty text if every stop fits the world.
std::string fault_words(const FoundRoute& found, const std::function<std::string(double)>& distance);

// Joins two routes. `then` must begin where `first` ends.
navigation::Route joined(navigation::Route first, const navigation::Route& then);

// Plans a route on foot through several places. The route ends before the first place that cannot be reached. `at_m`
// receives the distance of each place along the route, unless it is null.
navigation::Route plan_through(navigation::Navigation& navigation, const Vec3& from_m, std::span<const Vec3> places_m,
                               std::vector<double>* at_m = nullptr);

// Reduces a trail to a few points, including the first and the last. Every point of the trail is within `off_m` of the
// straight lines between them.
std::vector<Vec3> corners_of(std::span<const Vec3> trail_m, double off_m);
// Returns the part of the trail since the person was last at `place_m`. The part is empty if the trail never came
// within `near_m` of that place.
std::span<const Vec3> trail_since(std::span<const Vec3> trail_m, const Vec3& place_m, double near_m);
double length_of(std::span<const Vec3> points_m);

// A saved route that the person is following, stop by stop.
struct RouteRun {
    std::vector<Stop> stops;   // in walking order
    std::size_t next = 0;      // index of the first stop that has not been passed
    bool by_hand = false;      // true: the hand is guided along the route; false: announcements guide the walker
    std::vector<double> at_m;  // distance along the present route to each stop, beginning with the stop `planned`
    std::size_t planned = 0;

    // Returns the index of the next stop whose arrival is announced.
    std::size_t goal() const {
        std::size_t named = next;
        while (named + 1 < stops.size() && stops[named].name.empty()) ++named;
        return named;
    }
    std::vector<Vec3> places() const;  // returns the places of the stops from `next` to goal()
};

}  // namespace handrail::core
