#include "app/core/kept/saved_routes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/geometry/closest_point.h"
#include "worlds/navigation/route_place.h"

namespace handrail::core {
namespace {

constexpr const char* kRouteTable = "way";
constexpr const char* kStops = "stop";
constexpr double kSamePoint_m = 1e-6;

Result<Stop> stop_from(const SideEntry& entry, std::size_t number) {
    Stop stop;
    if (entry.contains("name")) {
        const auto name = good_name(text_of(entry, "name"));
        if (!name) return fail(phrase("ways.stop_name", {{"number", number}}));
        stop.name = *name;
    }
    const auto place = place_of(entry);
    if (!place) return fail(phrase("ways.stop_place", {{"number", number}}));
    stop.place_m = *place;
    stop.thing = text_of(entry, "thing");
    if (!stop.thing.empty()) stop.thing_m = std::max(0.0, number_of(entry, "thing_m", 0.0));
    stop.room = text_of(entry, "room");
    stop.kept = without(entry, {"name", "place_m", "thing", "thing_m", "room"});
    return stop;
}

Result<SavedRoute> route_from(const SideEntry& entry) {
    SavedRoute way;
    const auto name = good_name(text_of(entry, "name"));
    if (!name) return fail(phrase("ways.entry_name"));
    way.name = *name;
    way.world = text_of(entry, "world");
    const auto found = entry.find(kStops);
    const auto* stops = found == entry.end() ? nullptr : std::get_if<std::vector<SideTable>>(&found->second);
    if (!stops || stops->size() < 2 || stops->size() > kMostStops)
        return fail(phrase("ways.entry_stops", {{"name", way.name}, {"most", kMostStops}}));
    for (const SideTable& table : *stops) {
        auto stop = stop_from(table.entry, way.stops.size() + 1);
        if (!stop) return fail(phrase("ways.entry_stop", {{"name", way.name}, {"fault", stop.error().message}}));
        way.stops.push_back(std::move(*stop));
    }
    if (way.stops.front().name.empty() || way.stops.back().name.empty())
        return fail(phrase("ways.entry_ends", {{"name", way.name}}));
    way.kept = without(entry, {"name", "world", kStops});
    return way;
}

SideEntry route_entry(const SavedRoute& way) {
    SideEntry entry = way.kept;
    entry["name"] = way.name;
    if (!way.world.empty()) entry["world"] = way.world;
    std::vector<SideTable> stops;
    for (const Stop& stop : way.stops) {
        SideEntry one = stop.kept;
        if (!stop.name.empty()) one["name"] = stop.name;
        put_place(one, stop.place_m);
        if (!stop.thing.empty()) one["thing"] = stop.thing;
        if (!stop.thing.empty()) one["thing_m"] = stop.thing_m;
        if (!stop.room.empty()) one["room"] = stop.room;
        stops.push_back({std::move(one)});
    }
    entry[kStops] = std::move(stops);
    return entry;
}

// Returns the name of the stop `at`, or of the last stop before it that has a name.
std::string name_up_to(const std::vector<Stop>& stops, std::size_t at) {
    while (at > 0 && stops[at].name.empty()) --at;
    return stops[at].name;
}

// Returns the name of the stop `at`, or of the next stop after it that has a name.
std::string name_from(const std::vector<Stop>& stops, std::size_t at) {
    while (at + 1 < stops.size() && stops[at].name.empty()) ++at;
    return stops[at].name;
}

void look_for_thing(FoundRoute& found, std::size_t i, const Scene& scene, const navigation::Navigation& navigation) {
    Stop& stop = found.stops[i];
    const Feature* nearest = nullptr;
    double near_m = std::numeric_limits<double>::infinity();
    for (const Feature& feature : scene.features) {
        if (feature.name != stop.thing || feature.bounds_m.empty()) continue;
        if (const double away_m = std::sqrt(distance_squared(feature.bounds_m, stop.place_m)); away_m < near_m) {
            near_m = away_m;
            nearest = &feature;
        }
    }
    if (!nearest) return found.faults.push_back({StopFault::Kind::ThingMissing, i, 0.0});
    if (std::abs(near_m - stop.thing_m) <= kStopMoved_m) return;
    found.faults.push_back({StopFault::Kind::ThingMoved, i, near_m});
    const Vec3 beside = glm::clamp(stop.place_m, nearest->bounds_m.min_m, nearest->bounds_m.max_m);
    if (const auto stand = navigation.nearest_place(beside)) stop.place_m = *stand;
}

void look_for_room(FoundRoute& found, std::size_t i, const navigation::Navigation& navigation,
                   const navigation::RoomGraph& graph) {
    Stop& stop = found.stops[i];
    const std::string wanted = lower_ascii(stop.room);
    const auto is_called = [&](std::uint32_t room) {
        return lower_ascii(navigation::known_as(graph.rooms[room])) == wanted ||
               lower_ascii(graph.rooms[room].map_name) == wanted;
    };
    const std::uint32_t here = navigation::room_at(graph, navigation.space(), stop.place_m);
    if (here != navigation::kNothing && is_called(here)) return;
    for (std::uint32_t room = 0; room < graph.rooms.size(); ++room)
        if (is_called(room)) {
            found.faults.push_back(
                {StopFault::Kind::RoomMoved, i, glm::length(graph.rooms[room].middle_m - stop.place_m)});
            stop.place_m = graph.rooms[room].middle_m;
            return;
        }
    found.faults.push_back({StopFault::Kind::RoomMissing, i, 0.0});
}

}  // namespace

std::vector<SavedRoute> read_saved_routes(const SideFile& file, std::vector<Error>& faults) {
    return read_list(file, kRouteTable, route_from, faults);
}

void write_saved_routes(SideFile& file, const std::vector<SavedRoute>& ways) {
    write_list(file, kRouteTable, ways, route_entry, route_from);
}

FoundRoute look_up(const SavedRoute& way, const Scene& scene, const SideFile& file,
                   const navigation::Navigation& navigation, const navigation::RoomGraph& graph) {
    FoundRoute found{way.stops, {}};
    const bool same_world = !way.world.empty() && way.world == file.world_checksum();
    for (std::size_t i = 0; i < found.stops.size(); ++i) {
        const Stop& stop = found.stops[i];
        if (!same_world) {
            if (!stop.thing.empty()) look_for_thing(found, i, scene, navigation);
            else if (!stop.room.empty()) look_for_room(found, i, navigation, graph);
        }
        const auto stand = navigation.nearest_place(stop.place_m);
        if (!stand || glm::length(*stand - stop.place_m) > kStopFloor_m)
            found.faults.push_back({StopFault::Kind::NoPlace, i, 0.0});
        else if (i > 0 && navigation.nearest_place(found.stops[i - 1].place_m) &&
                 !navigation.reachable(found.stops[i - 1].place_m, stop.place_m))
            found.faults.push_back({StopFault::Kind::NoRoute, i, 0.0});
    }
    return found;
}

namespace {

std::string one_fault(const FoundRoute& found, const StopFault& fault,
                      const std::function<std::string(double)>& distance) {
    using Kind = StopFault::Kind;
    const std::string stop = name_from(found.stops, fault.stop);
    if (fault.kind == Kind::NoRoute)
        return phrase("ways.no_way", {{"from", name_up_to(found.stops, fault.stop - 1)}, {"to", stop}});
    if (fault.kind == Kind::NoPlace)
        return phrase(found.stops[fault.stop].name.empty() ? "ways.no_place_before" : "ways.no_place",
                      {{"stop", stop}});
    const bool of_room = fault.kind == Kind::RoomMissing || fault.kind == Kind::RoomMoved;
    const std::string what = of_room ? found.stops[fault.stop].room : stop;
    if (fault.kind == Kind::ThingMissing || fault.kind == Kind::RoomMissing)
        return phrase("ways.gone", {{"stop", what}});
    return phrase("ways.moved", {{"stop", what}, {"distance", distance(fault.moved_m)}});
}

}  // namespace

std::string fault_words(const FoundRoute& found, const std::function<std::string(double)>& distance) {
    std::vector<std::string> words;
    for (const StopFault& fault : found.faults) {
        std::string one = one_fault(found, fault, distance);
        if (std::find(words.begin(), words.end(), one) == words.end()) words.push_back(std::move(one));
    }
    return fmt::format("{}", fmt::join(words, "; "));
}

navigation::Route joined(navigation::Route first, const navigation::Route& then) {
    for (navigation::RoutePassage passage : then.passages) {
        passage.at_m += first.length_m;
        first.passages.push_back(passage);
    }
    for (const Vec3& point : then.points_m)
        if (first.points_m.empty() || glm::length(point - first.points_m.back()) > kSamePoint_m)
            first.points_m.push_back(point);
    first.length_m += then.length_m;
    first.drops = first.drops || then.drops;
    first.reaches = then.reaches;
    first.short_of_m = then.short_of_m;
    return first;
}

navigation::Route plan_through(navigation::Navigation& navigation, const Vec3& from_m, std::span<const Vec3> places_m,
                               std::vector<double>* at_m) {
    contract_pre(is_finite(from_m));
    navigation::Route all;
    if (at_m) at_m->clear();
    Vec3 at = from_m;
    for (const Vec3& place : places_m) {
        navigation::Route leg = navigation.plan(at, place);
        if (leg.points_m.empty() && all.points_m.empty()) return leg;
        all = joined(std::move(all), leg);
        if (at_m) at_m->push_back(all.length_m);
        if (!leg.reaches) break;
        at = place;
    }
    return all;
}

std::vector<Vec3> corners_of(std::span<const Vec3> trail_m, double off_m) {
    contract_pre(off_m >= 0.0);
    std::vector<bool> kept(trail_m.size(), false);
    if (!kept.empty()) kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open;
    if (trail_m.size() > 2) open.emplace_back(0, trail_m.size() - 1);
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        std::size_t farthest = first;
        double most_m = off_m;
        for (std::size_t i = first + 1; i < last; ++i)
            if (const double away_m =
                    navigation::nearest_on_path(std::array{trail_m[first], trail_m[last]}, trail_m[i]).distance_m;
                away_m > most_m) {
                most_m = away_m;
                farthest = i;
            }
        if (farthest == first) continue;
        kept[farthest] = true;
        open.emplace_back(first, farthest);
        open.emplace_back(farthest, last);
    }
    std::vector<Vec3> corners;
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (kept[i]) corners.push_back(trail_m[i]);
    return corners;
}

std::span<const Vec3> trail_since(std::span<const Vec3> trail_m, const Vec3& place_m, double near_m) {
    contract_pre(near_m >= 0.0);
    // Search backwards for the last visit to the place, then for the nearest point of that visit.
    std::size_t best = trail_m.size();
    double nearest_m = near_m;
    for (std::size_t i = trail_m.size(); i-- > 0;) {
        const double away_m = glm::length(trail_m[i] - place_m);
        if (away_m <= nearest_m) {
            nearest_m = away_m;
            best = i;
        } else if (best != trail_m.size() && away_m > near_m) {
            break;
        }
    }
    return trail_m.subspan(best);
}

double length_of(std::span<const Vec3> points_m) {
    double sum = 0.0;
    for (std::size_t i = 1; i < points_m.size(); ++i) sum += glm::length(points_m[i] - points_m[i - 1]);
    return sum;
}

std::vector<Vec3> RouteRun::places() const {
    std::vector<Vec3> places;
    for (std::size_t i = next; i <= goal() && i < stops.size(); ++i) places.push_back(stops[i].place_m);
    return places;
}

}  // namespace handrail::core
