#include "app/core/whereabouts/far_places.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/context/kinds_first.h"
#include "app/core/dialogue/brief_words.h"
#include "app/core/whereabouts/over_under.h"
#include "app/core/whereabouts/room_words.h"
#include "app/core/whereabouts/storeys.h"
#include "app/core/world/nearest_wall.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kWallReach_m = 30.0;
constexpr double kElsewhere_m = 2.0;  // a known place within this distance is taken for the present place
// When the walker's room changes, the person has passed a doorway within this distance.
constexpr double kDoorNextTo_m = 2.0;
constexpr std::size_t kMostKnown = 32;

}  // namespace

FarPlaces::FarPlaces(const SessionContext& context, WalkerState& avatar, Rooms& rooms)
    : SessionPart(context), avatar_(avatar), rooms_(rooms) {}

void FarPlaces::enter_world() {
    known_.clear();
    room_ = navigation::kNothing;
}

bool FarPlaces::act(Command command, double now_s) {
    if (command == Command::Lost) find_bearings(now_s);
    else if (command == Command::Describe) choose_room(now_s);
    else if (command == Command::Overview) announce_building(now_s);
    else if (command == Command::AboveBelow) announce_above_and_below(now_s);
    else return false;
    return true;
}

void FarPlaces::announce_building(double now_s) {
    if (rooms_.have(now_s)) context_.answer(building_words(context_, rooms_), now_s);
}

void FarPlaces::announce_above_and_below(double now_s) {
    if (!rooms_.have(now_s)) return;
    context_.answer(over_person_words(context_, rooms_, 1) + " " + over_person_words(context_, rooms_, -1), now_s);
}

void FarPlaces::know(Known place) {
    if (!known_.empty() && glm::length(known_.back().feet_m - place.feet_m) < 0.5) known_.pop_back();
    if (known_.size() == kMostKnown) known_.pop_front();
    known_.push_back(place);
}

void FarPlaces::note(Command command) {
    switch (command) {
        case Command::WhereAmI:
        case Command::Exits:
        case Command::UnvisitedExits:
        case Command::Coordinates:
            know({context_.avatar.feet_m(), kNoFeature, rooms_.here(), rooms_.here()});
            break;
        default:
            break;
    }
}

void FarPlaces::tick() {
    if (!rooms_.found() || rooms_.here() == room_) return;
    const std::uint32_t before = std::exchange(room_, rooms_.here());
    if (before == navigation::kNothing || room_ == navigation::kNothing) return;
    const Vec3& feet_m = context_.avatar.feet_m();
    for (const navigation::Portal& portal : rooms_.graph().portals) {
        const bool joins = (portal.rooms[0] == before && portal.rooms[1] == room_) ||
                           (portal.rooms[1] == before && portal.rooms[0] == room_);
        if (joins && glm::length(portal.place_m - feet_m) < kDoorNextTo_m)
            return know(
                {feet_m, portal.kind == navigation::PassageKind::Door ? portal.feature : kNoFeature, before, room_});
    }
}

// Returns "Kitchen door", "between hall and kitchen", "where you asked last, in the kitchen" or "the base".
std::string FarPlaces::name_of_place(const Known& place) const {
    if (const Feature* door = context_.world.scene->find(place.door)) return spoken_name(*door);
    const auto known = [&](std::uint32_t room) { return rooms_.found() && room < rooms_.graph().rooms.size(); };
    if (place.from != place.to && known(place.from) && known(place.to))
        return phrase("lost.between",
                      {{"one", rooms_.graph().rooms[place.from].name}, {"other", rooms_.graph().rooms[place.to].name}});
    return known(place.to) ? phrase("lost.asked_in", {{"room", rooms_.graph().rooms[place.to].name}})
                           : phrase("lost.asked");
}

std::string FarPlaces::route_back() const {
    const Vec3& feet_m = context_.avatar.feet_m();
    Vec3 goal_m = context_.world.home_feet_m;
    std::string name = phrase("lost.base");
    const auto last = std::find_if(known_.rbegin(), known_.rend(), [&](const Known& place) {
        return glm::length(place.feet_m - feet_m) >= kElsewhere_m;
    });
    if (last != known_.rend()) {
        goal_m = last->feet_m;
        name = name_of_place(*last);
    } else if (glm::length(goal_m - feet_m) < kElsewhere_m) {
        return phrase("lost.at_base");
    }
    Vec3 first_m = goal_m;
    double length_m = glm::length(goal_m - feet_m);
    if (rooms_.found()) {
        const navigation::Route route = rooms_.navigation().plan(feet_m, goal_m);
        if (route.points_m.size() >= 2 && route.reaches) {
            length_m = route.length_m;
            first_m = route.points_m[1];
        }
    }
    const std::string direction = brief_direction_words(std::atan2(first_m.x - feet_m.x, first_m.y - feet_m.y),
                                                        avatar_.heading_goal_rad, context_.settings.speech.directions);
    return phrase("lost.last_known", {{"place", name},
                                      {"distance", distance_words(length_m, distances(context_))},
                                      {"direction", direction},
                                      {"key", context_.keys.keys_of(Command::Retrace)}});
}

void FarPlaces::find_bearings(double now_s) {
    const bool known = rooms_.known();
    if (known) rooms_.notice(now_s, true);
    const auto wall = nearest_wall(*context_.world.solids, context_.avatar.feet_m(), kWallReach_m);
    if (wall) avatar_.heading_goal_rad = wrap_angle(wall->bearing_rad);
    const bool in_room = known && rooms_.here() != navigation::kNothing;
    const std::string place = in_room ? rooms_.graph().rooms[rooms_.here()].name : spoken_name(*context_.world.scene);
    std::string text = phrase("questions.place_facing", {{"place", sentence_case(place)},
                                                         {"compass", fine_compass_word(avatar_.heading_goal_rad)}});
    text += " " + (wall ? phrase("lost.turned", {{"wall", name_of(context_, wall->feature)},
                                                 {"distance", distance_words(wall->distance_m, distances(context_))}})
                        : phrase("lost.no_wall"));
    context_.play(cues::SoundKind::TurnTick, now_s);
    context_.answer(text + " " + route_back(), now_s);
}

// Opens a list of rooms to describe: the present room first, then the others, the nearest first.
void FarPlaces::choose_room(double now_s) {
    if (!rooms_.have(now_s)) return;
    const navigation::RoomGraph& graph = rooms_.graph();
    std::vector<std::uint32_t> rooms;
    for (std::uint32_t room = 0; room < graph.rooms.size(); ++room)
        if (graph.rooms[room].kind != navigation::RoomKind::Niche) rooms.push_back(room);
    const auto far_m = [&](std::uint32_t room) {
        return room == rooms_.here() ? -1.0 : glm::length(graph.rooms[room].middle_m - context_.avatar.feet_m());
    };
    std::stable_sort(rooms.begin(), rooms.end(), [&](std::uint32_t a, std::uint32_t b) { return far_m(a) < far_m(b); });
    ListSpec list;
    list.title = phrase("describe.which");
    std::vector<std::vector<std::string>> kinds = kinds_of_rooms(*context_.world.scene, graph), kinds_of_items;
    for (const std::uint32_t room : rooms)
        kinds_of_items.push_back(room == rooms_.here() ? std::vector<std::string>() : std::move(kinds[room]));
    for (const std::uint32_t room : rooms)
        list.items.push_back({sentence_case(graph.rooms[room].name),
                              room == rooms_.here() ? phrase("describe.here") : std::string(), false});
    list.chosen = [this, rooms](std::size_t at) {
        if (rooms_.found() && rooms[at] < rooms_.graph().rooms.size())
            context_.answer(room_words(context_, rooms_, rooms[at]), context_.tick_s);
    };
    open_kinds_first(context_, std::move(list), kinds_of_items, now_s);
}

}  // namespace handrail::core
