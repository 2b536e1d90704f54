// Ways that a person has kept in a world under a name: an ordered list of stops, how it is kept in the side file, and
// how each stop is looked up again in a world that was edited since. Between two stops one walks as the ways of the
// world lead. Pure functions over plain values; app thread. Looking up plans nothing; planning costs a way of
// Navigation for each leg.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/scene/scene.h"

namespace handrail {

struct Stop {
    std::string name;      // as it is told; empty: one passes here without a word
    Vec3 place_m{0.0};     // world, where soles stand
    std::string thing;     // name in the scene of the thing one goes to; empty: none
    double thing_m = 0.0;  // from the place to its bounds
    std::string room;      // it is in, as the map or a person calls it; empty: that room has no such name
    SideEntry kept;        // keys of the file that this version does not know
};

struct SavedWay {
    std::string name;
    std::vector<Stop> stops;  // at least two; the first and the last have names
    std::string world;        // checksum of the world's file then; empty: unknown
    SideEntry kept;
};

inline constexpr std::size_t kMostStops = 200;
inline constexpr double kStopMoved_m = 0.5;  // how much nearer or farther its thing may be than it was
inline constexpr double kStopFloor_m = 0.6;  // as far off there must be a place to stand
inline constexpr double kTrailBend_m = 0.4;  // what a kept trail may leave out beside it

// In the order of the file. Entries that are no way are left out and stay in the file; of each `faults` gets file,
// line, what is wrong and what to do.
std::vector<SavedWay> read_ways(const SideFile& file, std::vector<Error>& faults);
void write_ways(SideFile& file, const std::vector<SavedWay>& ways);

// What is wrong with a way in the world as it is.
struct StopFault {
    enum class Kind : std::uint8_t {
        ThingGone,
        ThingMoved,  // found again elsewhere
        RoomGone,
        RoomMoved,  // likewise
        NoPlace,    // nobody can stand there
        NoWay,      // from the stop before, on foot
    } kind = Kind::ThingGone;
    std::size_t stop = 0;
    double moved_m = 0.0;
};
// The stops where they are by now, and what does not fit. In the very world it was kept in things and rooms are where
// they were. A room goes by the person's name and by the map's.
struct FoundWay {
    std::vector<Stop> stops;
    std::vector<StopFault> faults;
};
FoundWay look_up(const SavedWay& way, const Scene& scene, const SideFile& file, const Navigation& navigation,
                 const RoomGraph& graph);
// "Desk is gone; no way on foot from Hall to Kitchen". Empty when all fits.
std::string fault_words(const FoundWay& found, const std::function<std::string(double)>& distance);

// One route and then the other, which begins where it ends.
Route joined(Route first, const Route& then);

// The way on foot through one place after the other. It ends before the first that cannot be reached. at_m, if given,
// gets where along it each place is.
Route plan_through(Navigation& navigation, const Vec3& from_m, std::span<const Vec3> places_m,
                   std::vector<double>* at_m = nullptr);

// So few of the points of a trail, first and last among them, that no point of it is farther than `off_m` from the
// straight lines between them.
std::vector<Vec3> corners_of(std::span<const Vec3> trail_m, double off_m);
// The part of a trail since one last was at a place; empty where the trail never came within `near_m` of it.
std::span<const Vec3> trail_since(std::span<const Vec3> trail_m, const Vec3& place_m, double near_m);
double length_of(std::span<const Vec3> points_m);

// A way that is being gone along, stop after stop.
struct WayRun {
    std::vector<Stop> stops;   // in the order of going
    std::size_t next = 0;      // the first that has not been passed
    bool by_hand = false;      // the hand is led; else the body is told
    std::vector<double> at_m;  // along the route that is followed: the stops from `planned` on
    std::size_t planned = 0;

    // The stop whose reaching is told.
    std::size_t goal() const {
        std::size_t named = next;
        while (named + 1 < stops.size() && stops[named].name.empty()) ++named;
        return named;
    }
    std::vector<Vec3> places() const;  // from `next` to goal()
};

}  // namespace handrail
