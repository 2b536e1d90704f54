#include "app/core/learning/place_learning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/dialogue/words.h"
#include "app/core/learning/time_words.h"
#include "app/core/world/trail.h"
#include "worlds/base/language.h"
#include "worlds/base/spoken_time.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace {

constexpr double kLookEvery_s = 1.0, kKeepEvery_s = 60.0;
constexpr double kAtBase_m = 1.0;
constexpr double kVisit_s = 5.0;  // a shorter stay in a room is no visit
constexpr std::array kQuarters{Quarter::Ahead, Quarter::Right, Quarter::Behind, Quarter::Left};

long percent(double share) { return static_cast<long>(std::floor(100.0 * share + 0.5)); }

}  // namespace

bool PlaceLearning::act(Command command, double now_s) {
    if (command == Command::Unexplored) announce_unexplored(now_s);
    else if (command == Command::ProgressReport) context_.answer(progress_words(now_s), now_s);
    else if (command == Command::LearnPlace) toggle(now_s);
    else if (command == Command::LearntRooms) list_rooms(now_s);
    else if (command == Command::Diary) list_diary(now_s);
    else return false;
    return true;
}

void PlaceLearning::enter_world(double now_s) {
    state_ = {};
    state_.last_s = state_.kept_s = state_.began_s = now_s;
    take_kept();
}

void PlaceLearning::take_kept() {
    if (!remembers(context_.additions)) return;
    auto kept = read_learnt(context_.additions);
    state_.keeps = kept.has_value();
    state_.diary_before = read_diary(context_.additions);
    if (!kept) {
        state_.fault = std::move(kept.error());
        return;
    }
    for (const TouchNote& note : kept->touches) state_.notes.touched(note.point_m, note.normal, note.reach_m);
    for (const Vec3& step : kept->steps_m) state_.notes.walked(step);
    state_.kept_notes = state_.notes.count();
    state_.kept = std::move(*kept);
}

void PlaceLearning::announce_kept(double now_s) {
    if (state_.fault)
        return context_.say(phrase("learning.unreadable", {{"fault", state_.fault->sentence()}}),
                            cues::SpeechClass::Answer, now_s);
    if (!state_.keeps || state_.kept.sessions == 0) return;
    context_.say(phrase("learning.remembered", {{"sessions", state_.kept.sessions},
                                                {"time", time_words(state_.kept.spent_s)},
                                                {"unexplored", context_.keys.keys_of(Command::Unexplored)},
                                                {"rooms", context_.keys.keys_of(Command::LearntRooms)}}),
                 cues::SpeechClass::Answer, now_s);
}

void PlaceLearning::take_again() {
    if (!state_.keeps || !remembers(context_.additions)) return;
    const auto kept = read_learnt(context_.additions);
    if (!kept) return;
    for (const TouchNote& note : kept->touches) state_.notes.touched(note.point_m, note.normal, note.reach_m);
    for (const Vec3& step : kept->steps_m) state_.notes.walked(step);
}

void PlaceLearning::keep(double now_s) {
    if (!state_.keeps || state_.notes.count() == state_.kept_notes || !remembers(context_.additions)) return;
    state_.kept_notes = state_.notes.count();
    state_.kept_s = now_s;
    KeptLearning kept;
    kept.sessions = state_.kept.sessions + 1;
    kept.spent_s = state_.kept.spent_s + now_s - state_.began_s;
    thin_out(state_.notes, kept);
    for (const auto& [number, learning] : state_.rooms)
        if (rooms_.found() && number < rooms_.graph().rooms.size())
            kept.rooms.push_back({rooms_.graph().rooms[number].name, learning.spent_s, learning.base_m,
                                  learning.walls_done, static_cast<int>(learning.lanes_announced)});
    write_learnt(context_.additions, kept);
    write_diary(context_.additions, diary());
    context_.session_requests.save_additions(now_s);
}

// Returns the progress in a room, including the progress that an earlier session stored.
RoomLearning& PlaceLearning::room(std::uint32_t number) {
    const auto [found, fresh] = state_.rooms.try_emplace(number);
    RoomLearning& learning = found->second;
    if (!fresh || state_.kept.rooms.empty()) return learning;
    const std::string& name = rooms_.graph().rooms[number].name;
    for (const KeptRoom& kept : state_.kept.rooms) {
        if (kept.name != name) continue;
        learning.spent_s = learning.spent_before_s = kept.spent_s;
        learning.base_m = kept.base_m;
        learning.walls_done = kept.walls_done;
        learning.lanes_announced = static_cast<std::size_t>(kept.lanes_announced);
        learning.remembered = true;
    }
    return learning;
}

void PlaceLearning::note(const std::optional<Vec3>& bumped, const std::optional<Vec3>& trailed, double now_s) {
    const Vec3& feet_m = context_.avatar.feet_m();
    const double radius = context_.avatar.walker->size().radius_m;
    if (bumped) state_.notes.touched(feet_m - *bumped * radius, *bumped, radius);
    state_.unplaced_s += now_s - std::exchange(state_.last_s, now_s);
    spend_time();
    if (context_.avatar.walker->state().on_ground) state_.notes.walked(feet_m);
    if (trailed) state_.notes.touched(feet_m - *trailed * (radius + Trail::kGap_m), *trailed, radius);
    for (const servo::ToolState* tool : {&context_.hands.tool, &context_.hands.left_tool})
        for (std::size_t i = 0; i < tool->contacts.count; ++i) {
            const render::Contact& contact = tool->contacts.contacts[i];
            const Vec3 point = tool->proxy_m - contact.normal * tool->proxy_radius_m;
            // A hand moves fast. If it stayed on the same wall, it also touched everything between its places in two
            // frames.
            double reach = tool->proxy_radius_m;
            if (contact.feature == state_.hand_feature) reach += std::min(0.5, glm::length(point - state_.hand_m));
            state_.notes.touched(point, contact.normal, reach);
            if (tool == &context_.hands.tool && i == tool->contacts.strongest) {
                state_.hand_m = point;
                state_.hand_feature = contact.feature;
            }
        }
    corner_of_hand(now_s);
}

// Once a second, if there are new notes, checks which walls and lanes are complete.
void PlaceLearning::tick(double now_s) {
    if (now_s - state_.kept_s >= kKeepEvery_s) {
        keep(now_s);
        state_.kept_s = now_s;
    }
    back_at_base(now_s);
    if (!state_.on || now_s - state_.looked_s < kLookEvery_s || state_.notes.count() == state_.seen_notes) return;
    state_.looked_s = now_s;
    state_.seen_notes = state_.notes.count();
    guide(now_s);
}

// If the hand touches two walls at the same time, it is in a corner.
void PlaceLearning::corner_of_hand(double now_s) {
    const render::ContactSet& set = context_.hands.tool.contacts;
    bool corner = false;
    for (std::size_t a = 0; a < set.count; ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const render::Contact &one = set.contacts[a], &other = set.contacts[b];
            const auto wall = [&](const render::Contact& c) {
                const Feature* feature = context_.world.scene->find(c.feature);
                return feature && feature->kind == FeatureKind::Wall && std::abs(c.normal.z) < 0.5;
            };
            corner |= wall(one) && wall(other) && glm::dot(one.normal, other.normal) < 0.87;
        }
    if (corner && now_s - state_.corner_s > 0.5)
        context_.play_at(cues::SoundKind::Corner, context_.hands.tool.proxy_m, now_s);
    if (corner) state_.corner_s = now_s;
}

void PlaceLearning::spend_time() {
    if (rooms_.here() != navigation::kNothing) room(rooms_.here()).spent_s += std::exchange(state_.unplaced_s, 0.0);
}

// Returns what is known of a room, updated with all notes until now.
const Learnt& PlaceLearning::learnt_of(std::uint32_t number) {
    std::optional<Learnt>& learnt = room(number).learnt;
    if (!learnt)
        learnt.emplace(place_of_room(*context_.world.solids, rooms_.navigation().space(), rooms_.graph(), number));
    learnt->lay(state_.notes);
    return *learnt;
}

// Determines the present room. Returns false if rooms are unknown or the person is in none.
bool PlaceLearning::in_known_room(double now_s) {
    if (!rooms_.known()) return false;
    rooms_.notice(now_s, true);
    spend_time();
    return rooms_.here() != navigation::kNothing;
}

// Returns the reason why there is no information about the present room.
std::string PlaceLearning::no_room_words() const {
    if (!rooms_.looked_for()) return phrase("rooms.not_known");
    return rooms_.found() ? phrase("rooms.nowhere") : rooms_.problem();
}

std::string PlaceLearning::progress_words(double now_s) {
    if (!in_known_room(now_s)) return no_room_words();
    const Progress progress = progress_of(learnt_of(rooms_.here()));
    std::string named;
    for (const WallProgress& wall : progress.walls)
        if (wall.touched_m > 0.0) named = joined(named, name_of(context_, wall.feature));
    const std::string time = time_words(room(rooms_.here()).spent_s);
    const TextValue of_walls{"walls", percent(progress.perimeter_share())},
        of_floor{"floor", percent(progress.floor_share())}, took{"time", time};
    const std::string text =
        progress.exits > 0
            ? phrase(progress.doors_only ? "learning.progress_and_doors" : "learning.progress_and_exits",
                     {of_walls, of_floor, {"found", progress.exits_found}, {"exits", progress.exits}, took})
            : phrase("learning.progress", {of_walls, of_floor, took});
    return named.empty() ? text : text + " " + phrase("learning.touched", {{"names", named}});
}

void PlaceLearning::announce_unexplored(double now_s) {
    if (!in_known_room(now_s)) return context_.answer(no_room_words(), now_s);
    const auto left = nearest_unexplored(learnt_of(rooms_.here()), context_.avatar.feet_m());
    if (!left) return context_.answer(phrase("learning.all_explored"), now_s);
    const double dx = left->point_m.x - context_.avatar.feet_m().x, dy = left->point_m.y - context_.avatar.feet_m().y;
    const std::string where = where_words(context_, std::hypot(dx, dy), std::atan2(dx, dy));
    context_.answer(
        left->wall ? phrase("learning.unexplored_wall", {{"wall", name_of(context_, left->feature)}, {"where", where}})
                   : phrase("learning.unexplored_floor", {{"where", where}}),
        now_s);
}

// Returns "Walls 40 percent, floor 10 percent".
std::string PlaceLearning::share_words(const Progress& progress) const {
    return phrase("learning.share",
                  {{"walls", percent(progress.perimeter_share())}, {"floor", percent(progress.floor_share())}});
}

// Opens a list of all rooms with the progress in each. The present room comes first, then the best known rooms.
// Choosing a room gives the route to it.
void PlaceLearning::list_rooms(double now_s) {
    if (!rooms_.have(now_s)) return;
    const navigation::RoomGraph& graph = rooms_.graph();
    struct Row {
        std::uint32_t room = 0;
        bool begun = false;
        Progress progress;
    };
    std::vector<Row> rows(graph.rooms.size());
    std::size_t done = 0;
    for (std::uint32_t r = 0; r < rows.size(); ++r) {
        // Skip the expensive examination of rooms without any notes nearby.
        Aabb box = graph.rooms[r].bounds_m;
        box.min_m -= Vec3(0.5, 0.5, 0.5);
        box.max_m += Vec3(0.5, 0.5, 2.5);
        rows[r].room = r;
        if (!state_.notes.any_in(box)) continue;
        rows[r].progress = progress_of(learnt_of(r));
        rows[r].begun = rows[r].progress.touched_m > 0.0 || rows[r].progress.walked_m2 > 0.0;
        done += rows[r].begun && rows[r].progress.done();
    }
    const auto known = [](const Row& row) {
        return row.begun ? row.progress.perimeter_share() + row.progress.floor_share() : -1.0;
    };
    std::stable_sort(rows.begin(), rows.end(), [&](const Row& a, const Row& b) {
        return std::pair(a.room == rooms_.here(), known(a)) > std::pair(b.room == rooms_.here(), known(b));
    });
    ListSpec list;
    list.title = phrase("learning.rooms", {{"done", done}, {"rooms", rows.size()}});
    std::vector<std::uint32_t> rooms;
    for (const Row& row : rows) {
        list.items.push_back({sentence_case(graph.rooms[row.room].name),
                              row.begun ? share_words(row.progress) : phrase("learning.nothing_yet"), false});
        rooms.push_back(row.room);
    }
    list.chosen = [this, rooms](std::size_t at) { on_go_to_room(rooms[at], context_.tick_s); };
    context_.open_list(std::move(list), now_s);
}

// Returns the diary with the visits of this session.
std::vector<DiaryEntry> PlaceLearning::diary() {
    std::vector<DiaryEntry> all = state_.diary_before;
    if (!rooms_.found()) return all;
    for (const auto& [number, learning] : state_.rooms) {
        const double spent_s = learning.spent_s - learning.spent_before_s;
        if (spent_s < kVisit_s || number >= rooms_.graph().rooms.size()) continue;
        const Progress progress = progress_of(learnt_of(number));
        add_visit(all, {day_,
                        rooms_.graph().rooms[number].name,
                        spent_s,
                        static_cast<int>(percent(progress.perimeter_share())),
                        static_cast<int>(percent(progress.floor_share())),
                        {}});
    }
    return all;
}

// Opens the diary, the latest visit first. Choosing a visit gives the route to its room.
void PlaceLearning::list_diary(double now_s) {
    if (!state_.keeps || !remembers(context_.additions)) return context_.answer(phrase("diary.off"), now_s);
    if (!rooms_.have(now_s)) return;
    rooms_.notice(now_s, true);
    spend_time();
    std::vector<DiaryEntry> visits = diary();
    if (visits.empty()) return context_.answer(phrase("diary.empty"), now_s);
    std::reverse(visits.begin(), visits.end());
    ListSpec list;
    list.title = phrase("diary.title", {{"count", visits.size()}});
    std::vector<std::string> names;
    for (const DiaryEntry& visit : visits) {
        const bool now = visit.day == day_;
        list.items.push_back({phrase("diary.visit", {{"today", now ? "yes" : "no"},
                                                     {"day", day_words(visit.day + "T12:00:00Z")},
                                                     {"room", sentence_case(visit.room)}}),
                              phrase("diary.learnt", {{"time", time_words(visit.spent_s)},
                                                      {"walls", visit.walls_percent},
                                                      {"floor", visit.floor_percent}})});
        names.push_back(visit.room);
    }
    list.chosen = [this, names](std::size_t at) {
        const auto& rooms = rooms_.graph().rooms;
        const auto room =
            std::find_if(rooms.begin(), rooms.end(), [&](const auto& one) { return one.name == names[at]; });
        if (room == rooms.end()) return context_.answer(phrase("diary.gone", {{"room", names[at]}}), context_.tick_s);
        on_go_to_room(static_cast<std::uint32_t>(room - rooms.begin()), context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

// Starts or ends the guided mode in the present room. Progress is kept.
void PlaceLearning::toggle(double now_s) {
    if (state_.on && pose_relation_questions(now_s)) return;
    state_.on = !state_.on;
    state_.seen_notes = 0;
    state_.room = navigation::kNothing;
    if (!state_.on) return context_.answer(phrase("learning.ended") + " " + progress_words(now_s), now_s);
    const bool known = in_known_room(now_s);
    if (known) {
        state_.room = rooms_.here();
        RoomLearning& here = room(rooms_.here());
        if (here.remembered && here.base_m) {  // the guided mode continues from the same base
            context_.answer(
                phrase("learning.goes_on_here", {{"room", sentence_case(rooms_.graph().rooms[rooms_.here()].name)},
                                                 {"share", share_words(progress_of(learnt_of(rooms_.here())))},
                                                 {"base", to_base_words(here)},
                                                 {"unexplored", context_.keys.keys_of(Command::Unexplored)}}),
                now_s);
            return;
        }
        here.base_m = context_.avatar.feet_m();
    }
    context_.answer(phrase("learning.begun", {{"room", known ? sentence_case(rooms_.graph().rooms[rooms_.here()].name)
                                                             : phrase("learning.this_place")},
                                              {"trail", context_.keys.keys_of(Command::TrailLeft)},
                                              {"progress", context_.keys.keys_of(Command::ProgressReport)},
                                              {"unexplored", context_.keys.keys_of(Command::Unexplored)}}),
                    now_s);
}

bool PlaceLearning::at_base(const RoomLearning& room) const {
    return room.base_m && glm::length(*room.base_m - context_.avatar.feet_m()) <= kAtBase_m;
}

std::string PlaceLearning::to_base_words(const RoomLearning& room) const {
    const Vec3 base = *room.base_m - context_.avatar.feet_m();
    const double distance_m = std::hypot(base.x, base.y);
    if (distance_m <= kAtBase_m) return phrase("learning.at_base");
    return phrase("learning.to_base", {{"where", where_words(context_, distance_m, std::atan2(base.x, base.y))}});
}

// In the guided mode, the person returns to the base after each wall. When the person is there, this function announces
// the next stretch of wall.
void PlaceLearning::back_at_base(double now_s) {
    if (!state_.on || state_.room == navigation::kNothing || rooms_.here() != state_.room) return;
    RoomLearning& here = room(state_.room);
    if (!here.to_base || !at_base(here)) return;
    here.to_base = false;
    context_.play(cues::SoundKind::Arrived, now_s);
    std::string text = phrase("learning.base_again");
    const Vec3 feet_m = context_.avatar.feet_m();
    const Learnt& learnt = learnt_of(state_.room);
    const WallSample* next = nullptr;
    for (std::size_t i = 0; i < learnt.place().walls.size(); ++i) {
        const WallSample& wall = learnt.place().walls[i];
        if (!learnt.knows_wall(i) &&
            (!next || glm::length(wall.point_m - feet_m) < glm::length(next->point_m - feet_m)))
            next = &wall;
    }
    if (next) {
        const Vec3 to = next->point_m - feet_m;
        text += " " + phrase("learning.unexplored_wall",
                             {{"wall", name_of(context_, next->feature)},
                              {"where", where_words(context_, std::hypot(to.x, to.y), std::atan2(to.x, to.y))}});
    }
    context_.answer(std::move(text), now_s);
}

// Once all lanes are walked, asks the person where things are relative to each other. Returns false if it is too early
// or if this room offers no questions.
bool PlaceLearning::pose_relation_questions(double now_s) {
    if (state_.room == navigation::kNothing || rooms_.here() != state_.room) return false;
    RoomLearning& here = room(state_.room);
    if (!here.base_m || !std::exchange(here.lanes_done, false)) return false;
    std::vector<RelationQuestion> questions = relation_questions(context_, rooms_, state_.room, *here.base_m);
    if (questions.empty()) return false;
    pose_relation_question(std::move(questions), 0, 0, now_s);
    return true;
}

void PlaceLearning::pose_relation_question(std::vector<RelationQuestion> questions, std::size_t at, int right,
                                           double now_s) {
    ListSpec list;
    list.title =
        phrase("learning.relation", {{"thing", questions[at].thing}, {"number", at + 1}, {"count", questions.size()}});
    for (const Quarter side : kQuarters) list.items.push_back({side_words(side), {}, false});
    list.chosen = [this, questions = std::move(questions), at, right](std::size_t chosen) {
        const double then_s = context_.tick_s;
        const RelationQuestion& question = questions[at];
        const bool is_right = kQuarters[chosen] == question.right;
        context_.events.report(
            Answered{phrase("learning.relation",
                            {{"thing", question.thing}, {"number", at + 1}, {"count", questions.size()}}),
                     side_words(kQuarters[chosen])},
            then_s);
        const std::string distance = distance_words(question.distance_m, distances(context_)),
                          side = side_words(question.right);
        context_.answer(phrase(is_right ? "learning.relation_right" : "learning.relation_other",
                               {{"thing", question.thing}, {"side", side}, {"distance", distance}}),
                        then_s);
        const int all_right = right + (is_right ? 1 : 0);
        if (at + 1 < questions.size()) return pose_relation_question(questions, at + 1, all_right, then_s);
        context_.answer(phrase("learning.relations_done", {{"right", all_right}, {"count", questions.size()}}), then_s);
    };
    context_.open_list(std::move(list), now_s);
}

// In the guided mode, announces each finished wall, then each finished lane. No order is enforced: if the person goes
// elsewhere, the parts completed there are announced.
void PlaceLearning::guide(double now_s) {
    if (!in_known_room(now_s)) return;
    const Learnt& learnt = learnt_of(rooms_.here());
    const Progress progress = progress_of(learnt);
    RoomLearning& room = this->room(rooms_.here());
    if (std::exchange(room.remembered, false))  // An earlier session has already announced these walls.
        for (const WallProgress& wall : progress.walls)
            if (wall.done()) room.done.push_back(wall.feature);
    if (rooms_.here() != std::exchange(state_.room, rooms_.here())) {
        const std::string name = sentence_case(rooms_.graph().rooms[rooms_.here()].name);
        // The base is the place where the person first entered the room.
        context_.answer(room.base_m ? phrase("learning.goes_on", {{"room", name}, {"share", share_words(progress)}})
                                    : phrase("learning.next_room", {{"room", name}}),
                        now_s);
        if (!room.base_m) room.base_m = context_.avatar.feet_m();
    }
    int done = 0;
    for (const WallProgress& wall : progress.walls) done += wall.done();
    for (const WallProgress& wall : progress.walls) {
        if (!wall.done() || wall.length_m < 0.5 ||
            std::find(room.done.begin(), room.done.end(), wall.feature) != room.done.end())
            continue;
        room.done.push_back(wall.feature);
        context_.events.report(WallDone{wall.feature, state_.room}, now_s);
        std::string text = phrase("learning.wall_done", {{"wall", sentence_case(name_of(context_, wall.feature))},
                                                         {"done", done},
                                                         {"walls", progress.walls.size()}});
        if (room.base_m && static_cast<std::size_t>(done) < progress.walls.size() && !at_base(room)) {
            room.to_base = true;  // The person has to return to the base after each wall.
            text += " " + to_base_words(room);
        }
        context_.answer(std::move(text), now_s);
    }
    if (!room.walls_done && progress.perimeter_share() >= 0.95) {
        room.walls_done = true;
        context_.play(cues::SoundKind::Arrived, now_s);
        room.to_base = false;
        const Vec3 base = *room.base_m - context_.avatar.feet_m();
        const std::string where = where_words(context_, glm::length(base), std::atan2(base.x, base.y));
        context_.answer(phrase("learning.walls_done", {{"left", static_cast<int>(progress.walls.size()) - done},
                                                       {"time", time_words(room.spent_s)},
                                                       {"where", where}}),
                        now_s);
    }
    const std::vector<Lane> lanes = lanes_of(learnt);
    std::size_t walked = 0;
    for (const Lane& lane : lanes) walked += lane.done();
    if (walked > room.lanes_announced && room.walls_done) {
        room.lanes_done = walked == lanes.size();
        std::string next =
            phrase("learning.lanes_done",
                   {{"key", context_.keys.keys_of(Command::LearnPlace)},
                    {"questions", relation_questions(context_, rooms_, rooms_.here(), *room.base_m).size()}});
        for (const Lane& lane : lanes)
            if (!lane.done()) {
                const double off = lane.at_m - (lane.north ? context_.avatar.feet_m().x : context_.avatar.feet_m().y);
                const char* key = lane.north ? (off > 0.0 ? "learning.lane_to_east" : "learning.lane_to_west")
                                             : (off > 0.0 ? "learning.lane_to_north" : "learning.lane_to_south");
                next = phrase(key, {{"distance", distance_words(std::abs(off), distances(context_))}});
                break;
            }
        context_.answer(phrase("learning.lane_done", {{"done", walked}, {"lanes", lanes.size()}}) + " " + next, now_s);
    }
    room.lanes_announced = walked;
}

}  // namespace handrail::core
