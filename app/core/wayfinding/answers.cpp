#include "app/core/wayfinding/answers.h"

#include <algorithm>
#include <limits>

#include "app/core/context/context_words.h"
#include "app/core/whereabouts/extents.h"
#include "app/core/whereabouts/over_under.h"
#include "app/core/whereabouts/room_things.h"
#include "app/core/whereabouts/room_words.h"
#include "app/core/whereabouts/storeys.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/navigation/foot_distances.h"
#include "worlds/scene/stated_building.h"

namespace handrail::core {
namespace {

constexpr std::size_t kMostRoomsInAnswer = 12;  // a sentence names no more rooms than this

// Returns "hall, kitchen and 3 more".
std::string names_of(const navigation::RoomGraph& graph, const std::vector<std::uint32_t>& rooms) {
    std::string names;
    const std::size_t first = std::min(kMostRoomsInAnswer, rooms.size());
    for (std::size_t i = 0; i < first; ++i) names = joined(names, graph.rooms[rooms[i]].name);
    if (rooms.size() == first) return names;
    return phrase("overview.and_more", {{"names", names}, {"more", rooms.size() - first}});
}

// Returns true if the answer does not depend on the rooms.
bool needs_no_rooms(QuestionKind kind) {
    return kind == QuestionKind::Behind || kind == QuestionKind::Left || kind == QuestionKind::Right ||
           kind >= QuestionKind::EndRoute;
}

template <class Named>
std::vector<NameInWorld> names_alone(const std::vector<Named>& named) {
    std::vector<NameInWorld> names;
    for (const Named& each : named) names.push_back(each.is);
    return names;
}

}  // namespace

std::vector<Answers::Named> Answers::named() const {
    std::vector<Named> all;
    if (rooms_.found()) {
        const std::vector<navigation::Room>& rooms = rooms_.graph().rooms;
        for (std::uint32_t r = 0; r < rooms.size(); ++r)
            if (!rooms[r].name.empty()) all.push_back({{rooms[r].name, NamedKind::Room}, r, {}});
    } else {
        for (const RoomName& room : context_.world.scene->room_names)
            all.push_back({{in_spoken_language(room.name, room.name_in), NamedKind::Room}, navigation::kNothing, {}});
    }
    for (Goal& goal : goals(context_)) {
        const Feature* feature = context_.world.scene->find(goal.feature);
        const bool door = feature && feature->kind == FeatureKind::Door;
        all.push_back({{goal.name, door ? NamedKind::Door : NamedKind::Thing}, navigation::kNothing, std::move(goal)});
    }
    return all;
}

bool Answers::knows(std::string_view line) const { return question_in(line, names_alone(named())).has_value(); }

std::string Answers::hint(std::string_view line) const {
    const std::vector<Named> all = named();
    const auto name = name_in(line, names_alone(all));
    return name ? phrase("answer.hint", {{"name", all[*name].is.name}}) : std::string();
}

void Answers::answer(std::string_view line, double now_s) {
    const auto asked = question_in(line, names_alone(named()));
    contract_pre(asked.has_value());
    if (asked->kind == QuestionKind::Home || asked->kind == QuestionKind::Here)
        return context_.session_requests.perform(asked->kind == QuestionKind::Home ? Command::Home : Command::WhereAmI,
                                                 now_s);
    if (!needs_no_rooms(asked->kind) && !rooms_.have(now_s)) return;
    // With the rooms known, the line may contain other names, and the names have other indices.
    const std::vector<Named> all = named();
    const auto question = question_in(line, names_alone(all));
    if (!question) return context_.answer(phrase("terminal.no_sentence", {{"line", line}}), now_s);
    const Named* named = question->name ? &all[*question->name] : nullptr;
    if (auto text = words(*question, named, now_s)) context_.answer(std::move(*text), now_s);
}

// Returns the answer, or no value if the answer is announced otherwise, as that of a route is.
std::optional<std::string> Answers::words(const Question& question, const Named* named, double now_s) {
    const std::uint32_t here = rooms_.here();
    switch (question.kind) {
        case QuestionKind::WhereIs:
        case QuestionKind::HowFar:
            return named ? place_of(*named) : nearest(question.noun);
        case QuestionKind::WayTo:
            if (named) go_to(*named, now_s);
            return std::nullopt;
        case QuestionKind::WhatIsIn:
            return room_words(context_, rooms_, named->room);
        case QuestionKind::RoomOf:
            return room_of_thing(*named);
        case QuestionKind::SizeOf:
            return size_of(named ? named->room : here);
        case QuestionKind::IsOpen:
            return named ? state_of_door(named->goal->feature) : state_of_door(nearest_door().value_or(kNoFeature));
        case QuestionKind::WhichDoor:
            return door_nearby(named);
        case QuestionKind::Nearest:
            return nearest(question.noun);
        case QuestionKind::HowMany:
            return how_many(question.noun);
        case QuestionKind::Rooms:
            return all_rooms();
        case QuestionKind::StoreyAbove:
            return storey_beside(1);
        case QuestionKind::StoreyBelow:
            return storey_beside(-1);
        case QuestionKind::Above:
            return over(named, 1);
        case QuestionKind::Below:
            return over(named, -1);
        case QuestionKind::GoUp:
            return go_storey(1, now_s);
        case QuestionKind::GoDown:
            return go_storey(-1, now_s);
        case QuestionKind::OwnStorey:
            return own_storey();
        case QuestionKind::OwnPart:
            return own_part();
        case QuestionKind::Behind:
            return queries_.side_sentence(2);
        case QuestionKind::Left:
            return queries_.side_sentence(3);
        case QuestionKind::Right:
            return queries_.side_sentence(1);
        case QuestionKind::EndRoute:
            return guide_.end(Guidance::Route);
        case QuestionKind::EndBeacon:
            return guide_.end(Guidance::Beacon);
        case QuestionKind::EndWarmer:
            return guide_.end(Guidance::Warmer);
        case QuestionKind::EndLines:
            return guide_.end(Guidance::Lines);
        case QuestionKind::EndLearning:
            return end_learning(now_s);
        case QuestionKind::OwnRoute:
            return guide_.state_words(Guidance::Route, now_s);
        case QuestionKind::OwnBeacon:
            return guide_.state_words(Guidance::Beacon, now_s);
        case QuestionKind::Home:
        case QuestionKind::Here:
            break;
    }
    return std::nullopt;
}

// Ends the learning of a room. Returns a sentence if there is none, because the command would begin it.
std::optional<std::string> Answers::end_learning(double now_s) {
    if (!learns || !learns()) return phrase("answer.not_learning");
    context_.session_requests.perform(Command::LearnPlace, now_s);
    return std::nullopt;
}

// ---- places ----

std::string Answers::place_of_room(std::uint32_t room) const {
    const navigation::RoomGraph& graph = rooms_.graph();
    const navigation::Room& is = graph.rooms[room];
    const Vec3& feet_m = context_.avatar.feet_m();
    const auto on_foot_m = navigation::FootDistances(graph, rooms_.here(), feet_m).to(room, is.middle_m);
    return on_foot_m ? where_words_on_foot(context_, point_box(is.middle_m), *on_foot_m)
                     : phrase("answer.no_route", {{"where", where_words(context_, point_box(is.middle_m))}});
}

std::string Answers::place_of(const Named& named) const {
    const std::string name = sentence_case(named.is.name);
    if (!named.goal) {
        if (named.room == rooms_.here()) return phrase("answer.in_room", {{"room", named.is.name}});
        return phrase("answer.place", {{"name", name}, {"where", place_of_room(named.room)}});
    }
    for (const FindGroup& group : find_groups(context_, rooms_, FindKind::Everything))
        if (group.name == named.goal->name)
            return phrase("answer.place",
                          {{"name", name}, {"where", find_words(context_, rooms_, group.found.front())}});
    return phrase("answer.place", {{"name", name}, {"where", where_words(context_, named.goal->box_m)}});
}

std::string Answers::room_of_thing(const Named& named) const {
    const std::uint32_t room = room_of(rooms_, named.goal->box_m);
    if (room == navigation::kNothing) return phrase("answer.room_unknown", {{"name", sentence_case(named.is.name)}});
    return phrase("answer.room_of",
                  {{"name", sentence_case(named.is.name)}, {"room", sentence_case(rooms_.graph().rooms[room].name)}});
}

std::string Answers::size_of(std::uint32_t room) const {
    if (room == navigation::kNothing) return phrase("answer.no_room");
    const std::string runs = extent_words(context_, rooms_, room);
    return room_size_words(context_, rooms_, room) + (runs.empty() ? runs : " " + runs);
}

// ---- doors ----

// Returns the door of the present room that is nearest, or else the nearest door.
std::optional<FeatureId> Answers::nearest_door() const {
    const Vec3& feet_m = context_.avatar.feet_m();
    std::optional<FeatureId> nearest;
    double nearest_m = 0.0;
    for (const navigation::Portal& portal : rooms_.graph().portals) {
        const bool here = portal.rooms[0] == rooms_.here() || portal.rooms[1] == rooms_.here();
        const double far_m = glm::length(portal.place_m - feet_m);
        if (portal.kind != navigation::PassageKind::Door || !portal.feature || !here || (nearest && far_m >= nearest_m))
            continue;
        nearest = portal.feature;
        nearest_m = far_m;
    }
    if (nearest) return nearest;
    const std::vector<FindGroup> groups = find_groups(context_, rooms_, FindKind::Doors);
    return groups.empty() ? std::nullopt : std::optional(groups.front().found.front().goal.feature);
}

std::string Answers::state_of_door(FeatureId door) const {
    const Feature* feature = context_.world.scene->find(door);
    if (!feature) return phrase("answer.no_door");
    const std::string state = queries_.state_of(door), name = sentence_case(spoken_name(*feature));
    return state.empty() ? phrase("answer.door_fixed", {{"door", name}})
                         : phrase("answer.door_is", {{"door", name}, {"state", state}});
}

std::string Answers::door_nearby(const Named* named) const {
    const FeatureId door = named ? named->goal->feature : nearest_door().value_or(kNoFeature);
    if (door == kNoFeature) return phrase("answer.no_door");
    const navigation::RoomGraph& graph = rooms_.graph();
    const std::string name = sentence_case(spoken_name(*context_.world.scene->find(door)));
    for (const navigation::Portal& portal : graph.portals) {
        if (portal.feature != door || portal.kind != navigation::PassageKind::Door) continue;
        const std::string where = where_words(context_, point_box(portal.place_m));
        for (const int side : {0, 1})
            if (portal.rooms[static_cast<std::size_t>(side)] == rooms_.here())
                return phrase("answer.door_leads",
                              {{"door", name},
                               {"where", where},
                               {"room", graph.rooms[portal.rooms[static_cast<std::size_t>(1 - side)]].name}});
        return phrase("answer.door_joins", {{"door", name},
                                            {"where", where},
                                            {"one", graph.rooms[portal.rooms[0]].name},
                                            {"other", graph.rooms[portal.rooms[1]].name}});
    }
    return state_of_door(door);
}

// ---- nouns ----

std::string Answers::nearest(CommonNoun noun) const {
    if (noun == CommonNoun::Stairs) {
        const navigation::RoomGraph& graph = rooms_.graph();
        const navigation::FootDistances on_foot(graph, rooms_.here(), context_.avatar.feet_m());
        std::uint32_t nearest = navigation::kNothing;
        double nearest_m = 0.0;
        for (std::uint32_t r = 0; r < graph.rooms.size(); ++r) {
            if (graph.rooms[r].kind != navigation::RoomKind::Stairs) continue;
            const auto far_m = on_foot.to(r, graph.rooms[r].middle_m);
            if (!far_m || (nearest != navigation::kNothing && *far_m >= nearest_m)) continue;
            nearest = r;
            nearest_m = *far_m;
        }
        if (nearest != navigation::kNothing && nearest != rooms_.here())
            return phrase("answer.place",
                          {{"name", sentence_case(graph.rooms[nearest].name)}, {"where", place_of_room(nearest)}});
    }
    const FindKind kind = noun == CommonNoun::Door ? FindKind::Doors : FindKind::Everything;
    for (const FindGroup& group : find_groups(context_, rooms_, kind))
        if (kind == FindKind::Doors || has_noun(group.name, noun))
            return phrase("answer.place", {{"name", sentence_case(group.name)},
                                           {"where", find_words(context_, rooms_, group.found.front())}});
    return phrase("answer.none_near", {{"noun", noun_key(noun)}});
}

std::string Answers::how_many(CommonNoun noun) const {
    const Scene& scene = *context_.world.scene;
    const navigation::RoomGraph& graph = rooms_.graph();
    const std::vector<StoreyOfRooms> storeys = storeys_of(scene, graph);
    const auto count_things = [&](auto is) {
        return static_cast<std::size_t>(std::count_if(scene.features.begin(), scene.features.end(), is));
    };
    std::size_t count = 0;
    switch (noun) {
        case CommonNoun::Room:
            for (const StoreyOfRooms& storey : storeys) count += storey.rooms.size();
            break;
        case CommonNoun::Storey:
            count = storeys.size();
            break;
        case CommonNoun::Door:
            count = count_things([](const Feature& feature) { return feature.kind == FeatureKind::Door; });
            break;
        case CommonNoun::Window:
            count = scene.stated ? scene.stated->windows.size() : count_things([](const Feature& feature) {
                return has_noun(spoken_name(feature), CommonNoun::Window);
            });
            break;
        case CommonNoun::Stairs:
            count = static_cast<std::size_t>(
                std::count_if(graph.rooms.begin(), graph.rooms.end(),
                              [](const navigation::Room& room) { return room.kind == navigation::RoomKind::Stairs; }));
            break;
        case CommonNoun::None:
            break;
    }
    return phrase("answer.count", {{"noun", noun_key(noun)}, {"count", count}});
}

std::string Answers::all_rooms() const {
    std::vector<std::uint32_t> all;
    for (const StoreyOfRooms& storey : storeys_of(*context_.world.scene, rooms_.graph()))
        all.insert(all.end(), storey.rooms.begin(), storey.rooms.end());
    return phrase("answer.rooms", {{"count", all.size()}, {"names", names_of(rooms_.graph(), all)}});
}

// ---- storeys ----

// Describes the storey above if `by` is 1, and below if `by` is -1.
std::string Answers::storey_beside(int by) const {
    const std::vector<StoreyOfRooms> storeys = storeys_of(*context_.world.scene, rooms_.graph());
    const std::size_t own = storey_of_room(storeys, rooms_.graph(), rooms_.here());
    if (own >= storeys.size()) return phrase("answer.between_storeys");
    if ((by > 0 && own + 1 == storeys.size()) || (by < 0 && own == 0))
        return phrase("answer.no_storey", {{"above", by > 0 ? "yes" : "no"}});
    const std::size_t other = by > 0 ? own + 1 : own - 1;
    return phrase("answer.storey", {{"storey", storey_name(storeys, other)},
                                    {"count", storeys[other].rooms.size()},
                                    {"names", names_of(rooms_.graph(), storeys[other].rooms)}});
}

// Names the rooms above or below the named room, or else above or below the person.
std::string Answers::over(const Named* named, int by) const {
    return named ? over_room_words(rooms_, named->room, by) : over_person_words(context_, rooms_, by);
}

std::string Answers::own_storey() const {
    const std::vector<StoreyOfRooms> storeys = storeys_of(*context_.world.scene, rooms_.graph());
    const std::size_t own = storey_of_room(storeys, rooms_.graph(), rooms_.here());
    if (own >= storeys.size()) return phrase("answer.between_storeys");
    return phrase("answer.own_storey", {{"named", storeys[own].file_name.empty() ? "no" : "yes"},
                                        {"storey", storey_name(storeys, own)},
                                        {"number", own + 1},
                                        {"count", storeys.size()}});
}

std::string Answers::own_part() const {
    const Scene& scene = *context_.world.scene;
    const std::uint32_t here = rooms_.here();
    const std::string part =
        here == navigation::kNothing ? std::string() : part_of_building(scene, rooms_.graph(), here);
    if (!part.empty())
        return phrase("answer.own_part",
                      {{"known", "yes"}, {"room", sentence_case(rooms_.graph().rooms[here].name)}, {"part", part}});
    const bool any = scene.stated && std::any_of(scene.stated->rooms.begin(), scene.stated->rooms.end(),
                                                 [](const StatedRoom& room) { return !room.part.empty(); });
    return phrase("answer.own_part", {{"known", any ? "none" : "no"}, {"room", ""}, {"part", ""}});
}

// ---- routes ----

void Answers::go_to(const Named& named, double now_s) {
    if (!named.goal) return guide_.go_to_room(named.room, now_s);
    guide_.go_to_thing(*named.goal, now_s);
}

// Returns the room among these whose doorway is nearest on foot. Nobody wants to go to the cabin of a lift, so another
// room is preferred.
std::uint32_t Answers::first_room_of(const std::vector<std::uint32_t>& among) const {
    const navigation::RoomGraph& graph = rooms_.graph();
    const navigation::FootDistances on_foot(graph, rooms_.here(), context_.avatar.feet_m());
    std::uint32_t first = among.front();
    double first_m = std::numeric_limits<double>::infinity();
    std::vector<bool> has_lift(graph.rooms.size(), false);
    for (const navigation::Portal& portal : graph.portals)
        for (const std::uint32_t room : portal.rooms)
            if (portal.kind == navigation::PassageKind::Lift && room < has_lift.size()) has_lift[room] = true;
    const bool all_have = std::all_of(among.begin(), among.end(), [&](std::uint32_t room) { return has_lift[room]; });
    const auto may_be_goal = [&](std::uint32_t room) {
        return std::find(among.begin(), among.end(), room) != among.end() && (all_have || !has_lift[room]);
    };
    for (std::uint32_t p = 0; p < graph.portals.size(); ++p)
        for (const std::uint32_t room : graph.portals[p].rooms) {
            const double far_m = on_foot.to_portal(p).value_or(std::numeric_limits<double>::infinity());
            if (far_m >= first_m || !may_be_goal(room)) continue;
            first = room;
            first_m = far_m;
        }
    return first;
}

// Leads to the first room of the next storey. Returns the reason if there is none.
std::optional<std::string> Answers::go_storey(int by, double now_s) {
    const navigation::RoomGraph& graph = rooms_.graph();
    const std::vector<StoreyOfRooms> storeys = storeys_of(*context_.world.scene, graph);
    const std::size_t own = storey_of_room(storeys, graph, rooms_.here());
    if (own >= storeys.size()) return phrase("answer.between_storeys");
    if ((by > 0 && own + 1 == storeys.size()) || (by < 0 && own == 0))
        return phrase("answer.no_storey", {{"above", by > 0 ? "yes" : "no"}});
    guide_.go_to_room(first_room_of(storeys[by > 0 ? own + 1 : own - 1].rooms), now_s);
    return std::nullopt;
}

}  // namespace handrail::core
