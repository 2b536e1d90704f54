#include "app/core/places/fault_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/dialogue/words.h"
#include "app/core/kept/kept_unit.h"
#include "app/core/kept/made_doors.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace {

struct UnitOffered {
    const char* word;
    double metres;
};
constexpr UnitOffered kUnitsOffered[] = {{"mm", 0.001}, {"cm", 0.01}, {"m", 1.0}, {"inch", 0.0254}, {"foot", 0.3048}};

// Returns true if the reader reports a file that states no unit, so that the world would be very large or very small.
bool is_of_the_unit(const check::WorldFault& fault) {
    return fault.kind == check::FaultKind::DamagedInFile && fault.source.line == 0 &&
           fault.other == phrase("reader.say_unit");
}

// Removes the full stop, because items of a list have none.
std::string unstopped(std::string sentence) {
    if (sentence.ends_with('.')) sentence.pop_back();
    return sentence;
}

// Returns the world of the file with the present landmarks. The features of both worlds are the same.
std::shared_ptr<const Scene> with_landmarks_of(const std::shared_ptr<const Scene>& file,
                                               const std::vector<bool>& landmarks) {
    std::shared_ptr<Scene> copy;
    for (std::size_t f = 0; f < std::min(landmarks.size(), file->features.size()); ++f) {
        if (file->features[f].landmark == landmarks[f]) continue;
        if (!copy) copy = std::make_shared<Scene>(*file);
        copy->features[f].landmark = landmarks[f];
    }
    return copy ? copy : file;
}

}  // namespace

void FaultList::open(double now_s) {
    // If the world has no rooms and routes, the check runs without them, because what prevents them is the fault to
    // correct.
    const bool known = rooms_.known();
    if (known || rooms_.awaited())
        if (!rooms_.have(now_s)) return;
    std::vector<bool> landmarks;
    for (const Feature& feature : context_.world.scene->features) landmarks.push_back(feature.landmark);
    BackgroundTask<std::shared_ptr<const Found>>::Work work =
        [file = rooms_.file_scene(), navigation = known ? rooms_.navigation_kept() : nullptr,
         graph = known ? rooms_.graph() : navigation::RoomGraph(), landmarks = std::move(landmarks),
         feet_m = context_.avatar.feet_m()](const std::stop_token&) {
            auto found = std::make_shared<Found>();
            found->scene = with_landmarks_of(file, landmarks);
            found->faults = navigation ? check::find_faults(*found->scene, &navigation->space(), &graph)
                                       : check::find_faults(*found->scene, nullptr, nullptr);
            for (const check::WorldFault& fault : found->faults) {
                found->doorways.push_back(check::doorway_cut_free(*found->scene, fault));
                const bool no_route = fault.kind == check::FaultKind::RoomOutOfReach && fault.room < graph.rooms.size();
                found->doors.push_back(
                    no_route ? check::missing_doors(*found->scene, navigation->space(), graph, fault.room, feet_m)
                             : std::vector<check::MissingDoor>{});
            }
            return std::shared_ptr<const Found>(std::move(found));
        };
    context_.answer(phrase("faults.looking"), now_s);
    looking_.begin(std::move(work));
}

void FaultList::tick(double now_s) {
    if (const auto found = looking_.take()) show(*found, now_s);
}

void FaultList::show(const std::shared_ptr<const Found>& found, double now_s) {
    const std::vector<MadeDoor> made = read_made_doors(context_.additions);
    if (found->faults.empty() && made.empty()) return context_.answer(phrase("faults.none"), now_s);
    ListSpec list;
    list.title = phrase("faults.title");
    for (const check::WorldFault& fault : found->faults)
        list.items.push_back({unstopped(check::fault_words(*found->scene, fault)),
                              check::has_place(fault) ? where_words(context_, point_box(fault.at_m)) : std::string()});
    for (const MadeDoor& door : made)
        list.items.push_back({phrase("faults.made_door", {{"between", one_line(door.name)}}),
                              where_words(context_, point_box(door.place_m))});
    list.stays_open = true;  // The list stays open, so that the person can go from one fault to the next.
    list.chosen = [this, found, made](std::size_t i) {
        if (i < found->faults.size()) show_one(found, i, context_.tick_s);
        else show_made_door(made[i - found->faults.size()], context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

void FaultList::show_one(const std::shared_ptr<const Found>& found, std::size_t which, double now_s) {
    const check::WorldFault& fault = found->faults[which];
    const std::string what = check::fault_words(*found->scene, fault),
                      advice = check::fault_advice(*found->scene, fault);
    ListSpec list;
    list.title = unstopped(advice);
    std::vector<std::function<void(double)>> acts;
    const auto add = [&](std::string name, std::function<void(double)> act) {
        list.items.push_back({std::move(name), {}});
        acts.push_back(std::move(act));
    };
    if (is_of_the_unit(fault))
        for (const auto& [word, metres] : kUnitsOffered)
            if (const double now = found->scene->metres_per_unit; std::abs(metres - now) > 1e-9 * metres) {
                const Vec3 size = found->scene->bounds_m.size_m();
                add(phrase("faults.unit", {{"unit", word}, {"wide", std::max(size.x, size.y) / now * metres}}),
                    [this, unit = metres](double then_s) { take_unit(unit, then_s); });
            }
    const navigation::RoomGraph none;
    const navigation::RoomGraph& graph = rooms_.found() ? rooms_.graph() : none;
    if (fault.kind == check::FaultKind::UnnamedRoom || fault.kind == check::FaultKind::OddName)
        if (fault.room < graph.rooms.size())
            add(phrase("faults.name"), [this, room = fault.room](double then_s) {
                rooms_.request_name(
                    room, [this](double named_s) { open(named_s); }, then_s);
            });
    for (const FeatureId id : fault.candidates)
        add(phrase("faults.mark", {{"name", one_line(spoken_name(found->scene->features[id.value]))}}),
            [this, id](double then_s) { on_landmark(id, then_s); });
    for (const check::MissingDoor& missing : found->doors[which]) {
        if (missing.to >= graph.rooms.size() || fault.room >= graph.rooms.size()) continue;
        MadeDoor door = missing.door;
        door.name = joined(graph.rooms[fault.room].name, graph.rooms[missing.to].name);
        add(phrase("faults.make_door", {{"room", graph.rooms[missing.to].name}}),
            [this, door](double then_s) { make_door(door, then_s); });
    }
    if (const auto& doorway = found->doorways[which])
        add(phrase("faults.cut_free", {{"door", one_line(fault.name)}}),
            [this, door = *doorway](double then_s) { make_door(door, then_s); });
    if (check::has_place(fault))
        add(phrase("faults.find"),
            [this, goal = Goal{unstopped(what), point_box(fault.at_m)}](double then_s) { on_find(goal, then_s); });
    if (list.items.empty()) return context_.answer(advice, now_s);
    list.chosen = [this, acts](std::size_t i) { acts[i](context_.tick_s); };
    context_.open_list(std::move(list), now_s);
}

void FaultList::show_made_door(const MadeDoor& door, double now_s) {
    const std::string what = phrase("faults.made_door", {{"between", one_line(door.name)}});
    ListSpec list;
    list.title = what;
    list.items = {{phrase("faults.take_door_away"), {}}, {phrase("faults.find"), {}}};
    list.chosen = [this, door, what](std::size_t i) {
        if (i == 0) take_door_away(door, context_.tick_s);
        else on_find(Goal{what, point_box(door.place_m)}, context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

// Doors are cut into walls when the world is read. So the owner of the session reads the world again, and the person
// continues at the same place.
void FaultList::make_door(const MadeDoor& door, double now_s) {
    keep_made_door(context_.additions, door);
    // If the door is not saved, reading the world again would have no effect.
    if (!context_.session_requests.save_additions(now_s)) return;
    context_.requests.read_again = true;
    context_.answer(phrase("faults.door_made", {{"between", one_line(door.name)}}), now_s);
}

// Another unit changes every position, so the owner must begin a new session in this world.
void FaultList::take_unit(double metres, double now_s) {
    keep_unit(context_.additions, metres);
    if (!context_.session_requests.save_additions(now_s)) return;
    context_.requests.read_again = context_.requests.begin_anew = true;
    context_.answer(phrase("faults.unit_taken"), now_s);
}

void FaultList::take_door_away(const MadeDoor& door, double now_s) {
    drop_made_door(context_.additions, door.place_m);
    if (!context_.session_requests.save_additions(now_s)) return;
    context_.requests.read_again = true;
    context_.answer(phrase("faults.door_gone", {{"between", one_line(door.name)}}), now_s);
}

}  // namespace handrail::core
