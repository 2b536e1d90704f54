#include "worlds/check/faults.h"

#include <algorithm>
#include <array>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/check/examined.h"

namespace handrail::check {
namespace {

constexpr std::array kRows{
    FaultRow{FaultKind::NowhereToStand, "nowhere_to_stand", true},
    FaultRow{FaultKind::StartLost, "start_lost", true},
    FaultRow{FaultKind::RoomOutOfReach, "room_out_of_reach", true},
    FaultRow{FaultKind::ImpassableDoor, "impassable_door", true},
    FaultRow{FaultKind::MissingPart, "missing_part", true},
    FaultRow{FaultKind::DoorOnNoWall, "door_on_no_wall", true},
    FaultRow{FaultKind::DoorOverLevels, "door_over_levels", true},
    FaultRow{FaultKind::FloorEnds, "floor_ends", true},
    FaultRow{FaultKind::UnguardedDrop, "unguarded_drop", false},
    FaultRow{FaultKind::CrossingOutline, "crossing_outline", true},
    FaultRow{FaultKind::OverlappingRooms, "overlapping_rooms", true},
    FaultRow{FaultKind::OpenToOutside, "open_to_outside", false},
    FaultRow{FaultKind::OpenRoof, "open_roof", false},
    FaultRow{FaultKind::Crack, "crack", false},
    FaultRow{FaultKind::DoorToNoRoom, "door_to_no_room", false},
    FaultRow{FaultKind::UnlikeFile, "unlike_file", false},
    FaultRow{FaultKind::StairsInOneGo, "stairs_in_one_go", false},
    FaultRow{FaultKind::OddName, "odd_name", false},
    FaultRow{FaultKind::DoorCutFree, "door_cut_free", false},
    FaultRow{FaultKind::AlikeMaterials, "alike_materials", false},
    FaultRow{FaultKind::ThingOutside, "thing_outside", false},
    FaultRow{FaultKind::ThingTwice, "thing_twice", false},
    FaultRow{FaultKind::ThingBuried, "thing_buried", false},
    FaultRow{FaultKind::ThingInTheAir, "thing_in_the_air", false},
    FaultRow{FaultKind::DamagedInFile, "damaged_in_file", false},
    FaultRow{FaultKind::UnnamedRoom, "unnamed_room", false},
    FaultRow{FaultKind::NoLandmark, "no_landmark", false},
};

std::string candidate_words(const Scene& scene, const WorldFault& fault) {
    std::string list;
    for (const FeatureId id : fault.candidates) {
        const std::string name = one_line(spoken_name(scene.features[id.value]));
        list = list.empty() ? name : phrase("words.joined", {{"one", list}, {"other", name}});
    }
    return list;
}

// A door at least this wide is never reported as impassable because of its width. The advice to the person names the
// same width.
constexpr double kWideDoorway_m = 0.8;

std::string say(const Scene& scene, const WorldFault& fault, std::string_view key) {
    const std::string name = capitalised(one_line(fault.name)), other = one_line(fault.other),
                      candidates = candidate_words(scene, fault);
    return phrase(key, {{"name", name},
                        {"named", name.empty() ? "no" : "yes"},
                        {"other", other},
                        {"with", other.empty() ? "no" : "yes"},
                        {"metres", fault.amount},
                        {"centimetres", fault.amount * 100.0},
                        {"needed", fault.needed_m},
                        {"lack", std::string(word_of(fault.lack))},
                        {"known", fault.amount > 0.0 ? "yes" : "no"},
                        {"why", fault.why},
                        {"doorway", !fault.why.empty()               ? "told"
                                    : fault.amount >= kWideDoorway_m ? "wide"
                                    : fault.amount > 0.0             ? "narrow"
                                                                     : "no"},
                        {"candidates", candidates},
                        {"any", candidates.empty() ? "no" : "yes"}});
}

}  // namespace

const FaultRow& row_of(FaultKind kind) {
    const FaultRow& row = kRows[static_cast<std::size_t>(kind)];
    contract_pre(row.kind == kind);
    return row;
}

std::vector<WorldFault> find_faults(const Scene& scene, const navigation::WalkSpace* space,
                                    const navigation::RoomGraph* graph) {
    contract_pre((space == nullptr) == (graph == nullptr));
    const Examined world(scene, space, graph);
    std::vector<WorldFault> faults;
    if (space) find_room_faults(world, faults);
    else faults.push_back({FaultKind::NowhereToStand, scene.starts.empty() ? Vec3(0.0) : scene.starts.front().feet_m});
    find_outline_faults(world, faults);
    find_door_faults(world, faults);
    find_unlike_faults(world, faults);
    find_shell_faults(world, faults);
    find_thing_faults(world, faults);
    for (const Diagnostic& warning : scene.report.warnings) {
        const bool reported =
            warning.line > 0 && std::any_of(faults.begin(), faults.end(), [&](const WorldFault& fault) {
                return fault.source.line == warning.line && fault.kind != FaultKind::NoLandmark;
            });
        if (reported) continue;
        WorldFault fault{FaultKind::DamagedInFile, Vec3(0.0), {warning.line, 0}};
        fault.name = warning.message;
        fault.other = warning.action;
        faults.push_back(std::move(fault));
    }
    std::stable_sort(faults.begin(), faults.end(),
                     [](const WorldFault& a, const WorldFault& b) { return a.kind < b.kind; });
    return faults;
}

std::string fault_words(const Scene& scene, const WorldFault& fault) {
    if (fault.kind == FaultKind::AlikeMaterials) return fault.name;  // the name is a whole sentence already
    if (fault.kind == FaultKind::DamagedInFile)
        return fault.other.empty() ? fault.name : fault.name + " " + fault.other;
    return say(scene, fault, "world_fault." + std::string(row_of(fault.kind).word));
}

std::string fault_advice(const Scene& scene, const WorldFault& fault) {
    return say(scene, fault, "world_fault_do." + std::string(row_of(fault.kind).word));
}

}  // namespace handrail::check
