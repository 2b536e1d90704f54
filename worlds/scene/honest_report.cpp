#include "worlds/scene/honest_report.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

// Returns the key of the sentence about this kind of finding.
std::string_view key_of(ToCheck what) {
    switch (what) {
        case ToCheck::MissingPart:
            return "honest.missing_part";
        case ToCheck::ImpassableDoor:
            return "honest.impassable_door";
        case ToCheck::DoorToNoRoom:
            return "honest.door_to_no_room";
        case ToCheck::OddName:
            return "honest.odd_name";
        case ToCheck::RoomWithoutName:
            return "honest.room_without_name";
        case ToCheck::DoorCutFree:
            return "honest.door_cut_free";
        case ToCheck::RoomWithoutRoute:
            return "honest.room_without_way";
    }
    return "honest.odd_name";
}

// Returns "Bedroom 1 A203", or only the number if the room has no name.
std::string room_words(const StatedRoom& room) {
    if (room.name == room.number || room.number.empty()) return one_line(room.name);
    return one_line(room.name.empty() ? room.number : room.name + " " + room.number);
}

void note_doors(const StatedBuilding& stated, HonestReport& report) {
    for (std::uint32_t p = 0; p < stated.portals.size(); ++p) {
        const StatedPortal& portal = stated.portals[p];
        const auto check = [&](ToCheck what) { report.check.push_back({what, p, portal.place_m, portal.source}); };
        if (!portal.passable) check(ToCheck::ImpassableDoor);
        if (portal.opened_by_box) check(ToCheck::DoorCutFree);
        report.doors_impassable += portal.passable ? 0 : 1;
        report.doors_cut_free += portal.opened_by_box ? 1 : 0;
        if (portal.kind != StatedPortalKind::Door) continue;
        ++report.doors;
        if (portal.rooms.size() > 1) ++report.doors_of_two_rooms;
        else if (portal.rooms.size() == 1) ++report.doors_of_one_room;
        else {
            ++report.doors_of_no_room;
            check(ToCheck::DoorToNoRoom);
        }
    }
}

void note_rooms(const StatedBuilding& stated, HonestReport& report) {
    std::vector<bool> led_to(stated.rooms.size(), false);
    for (const StatedPortal& portal : stated.portals)
        for (const std::uint32_t room : portal.rooms) led_to[room] = true;
    for (std::uint32_t r = 0; r < stated.rooms.size(); ++r) {
        const StatedRoom& room = stated.rooms[r];
        const auto check = [&](ToCheck what) { report.check.push_back({what, r, room.at_m, room.source}); };
        if (!led_to[r]) check(ToCheck::RoomWithoutRoute);
        if (is_oddly_named(room)) check(ToCheck::OddName);
        if (room.name.empty()) check(ToCheck::RoomWithoutName);
    }
}

}  // namespace

bool is_of_a_room(ToCheck what) {
    return what == ToCheck::RoomWithoutRoute || what == ToCheck::OddName || what == ToCheck::RoomWithoutName;
}

std::string_view word_of(ToCheck what) { return key_of(what).substr(std::string_view("honest.").size()); }

HonestReport honest_report(const Scene& scene) {
    contract_pre(scene.stated != nullptr);
    const StatedBuilding& stated = *scene.stated;
    HonestReport report;
    report.storeys = static_cast<int>(stated.storeys.size());
    report.storeys_with_rooms = static_cast<int>(std::count_if(
        stated.storeys.begin(), stated.storeys.end(), [](const StatedStorey& storey) { return storey.rooms > 0; }));
    report.rooms = static_cast<int>(stated.rooms.size());
    report.windows = static_cast<int>(stated.windows.size());
    report.openings = stated.openings;
    report.openings_uncut = stated.openings - stated.openings_cut;
    report.stairs = stated.stairs;
    report.ramps = stated.ramps;
    report.lifts = stated.lifts;
    report.escalators = stated.escalators;
    report.walkways = stated.walkways;
    report.furnishings = static_cast<int>(stated.furnishings.size());
    report.largest_connected = largest_connected(stated);
    report.landmarks = static_cast<int>(std::count_if(scene.features.begin(), scene.features.end(),
                                                      [](const Feature& feature) { return feature.landmark; }));
    report.guessed = static_cast<int>(scene.report.guessed.size());
    report.simplified = static_cast<int>(scene.report.simplified.size());
    report.left_out = static_cast<int>(scene.report.left_out.size());
    report.problems = scene.report.warnings_in_all;
    report.parts_missing = static_cast<int>(stated.missing.size());
    for (std::uint32_t m = 0; m < stated.missing.size(); ++m)
        report.check.push_back({ToCheck::MissingPart, m, stated.missing[m].at_m, stated.missing[m].source});
    note_doors(stated, report);
    note_rooms(stated, report);
    std::stable_sort(report.check.begin(), report.check.end(),
                     [](const CheckPoint& a, const CheckPoint& b) { return a.what < b.what; });
    return report;
}

std::string missing_words(const MissingPart& part) {
    const std::string name = one_line(part.name.empty() ? part.guid : part.name);
    return phrase("honest.missing_part",
                  {{"name", name},
                   {"guid", one_line(part.guid)},
                   {"storey", one_line(part.storey)},
                   {"on", part.storey.empty() ? "no" : "yes"},
                   {"reason", phrase(part.reason, {{"detail", one_line(part.detail)},
                                                   {"percent", std::round(part.share * 100.0)}})}});
}

std::string door_trial_words(const StatedPortal& portal) {
    if (portal.why.empty()) return {};
    return phrase(portal.why, {{"names", one_line(portal.in_the_way)},
                               {"named", portal.in_the_way.empty() ? "no" : "yes"},
                               {"width", portal.width_m},
                               {"height", portal.height_m},
                               {"metres", portal.step_m}});
}

std::string check_words(const Scene& scene, const CheckPoint& point) {
    const std::string key(key_of(point.what));
    if (point.what == ToCheck::MissingPart) return missing_words(scene.stated->missing[point.index]);
    if (is_of_a_room(point.what)) return phrase(key, {{"room", room_words(scene.stated->rooms[point.index])}});
    const StatedPortal& portal = scene.stated->portals[point.index];
    const std::string reason = door_trial_words(portal);
    return phrase(key, {{"door", one_line(portal.name)},
                        {"named", portal.name.empty() ? "no" : "yes"},
                        {"why", point.what == ToCheck::ImpassableDoor && !reason.empty() ? "yes" : "no"},
                        {"reason", reason}});
}

std::string honest_sentence(const Scene& scene, const HonestReport& report) {
    std::string text = phrase("honest.sentence", {{"rooms", report.rooms},
                                                  {"storeys", report.storeys},
                                                  {"with_rooms", report.storeys_with_rooms},
                                                  {"all", report.storeys == report.storeys_with_rooms ? "yes" : "no"},
                                                  {"doors", report.doors},
                                                  {"windows", report.windows},
                                                  {"stairs", report.stairs},
                                                  {"ramps", report.ramps},
                                                  {"lifts", report.lifts},
                                                  {"escalators", report.escalators},
                                                  {"walkways", report.walkways},
                                                  {"furnishings", report.furnishings},
                                                  {"landmarks", report.landmarks}});
    if (!report.check.empty())
        text += " " + phrase("honest.check_first",
                             {{"what", check_words(scene, report.check.front())}, {"more", report.check.size() - 1}});
    return text;
}

std::string honest_counts(const ReadReport& report) {
    return phrase("honest.counts", {{"guessed", report.guessed.size()},
                                    {"simplified", report.simplified.size()},
                                    {"left_out", report.left_out.size()},
                                    {"problems", report.warnings_in_all}});
}

std::vector<std::string> honest_details(const Scene& scene, const HonestReport& report) {
    const StatedBuilding& stated = *scene.stated;
    std::vector<std::string> sentences{
        phrase("honest.file", {{"schema", one_line(stated.schema)}}),
        phrase("honest.doors", {{"two", report.doors_of_two_rooms},
                                {"one", report.doors_of_one_room},
                                {"none", report.doors_of_no_room},
                                {"freed", report.doors_cut_free},
                                {"shut", report.doors_impassable}}),
        phrase("honest.openings", {{"openings", report.openings}, {"cut", report.openings - report.openings_uncut}})};
    if (report.rooms > 0)
        sentences.push_back(
            phrase("honest.connected", {{"rooms", report.rooms}, {"connected", report.largest_connected}}));
    for (const StatedStorey& storey : stated.storeys)
        sentences.push_back(phrase(
            "honest.storey", {{"storey", one_line(storey.name)}, {"height", storey.floor_m}, {"rooms", storey.rooms}}));
    return sentences;
}

}  // namespace handrail
