// AppCore's part on learning a place and on the hunt. App thread only.
#include <algorithm>
#include <cmath>

#include "app/core/app_core.h"
#include "app/core/side_file.h"
#include "audio-cues/plan/sound_table.h"
#include "worlds/base/language.h"

namespace handrail {
namespace {

constexpr double kLookEvery_s = 1.0;
constexpr double kHide_m = 6.0;       // on foot from where one is
constexpr double kHandFinds_m = 0.4;  // of world

long percent(double share) { return static_cast<long>(std::floor(100.0 * share + 0.5)); }

std::string time_words(double seconds) {
    const long all = std::lround(seconds);
    if (all < 60) return phrase("learning.seconds", {{"seconds", all}});
    return all % 60 == 0 ? minutes_words(seconds) : phrase("learning.minutes_and_seconds", {{"minutes", all / 60}, {"seconds", all % 60}});
}

}  // namespace

bool AppCore::act_learning(Command command, double now_s) {
    switch (command) {
        case Command::Unexplored:
            tell_unexplored(now_s);
            return true;
        case Command::ProgressReport:
            answer(progress_words(now_s), now_s);
            return true;
        case Command::LearnPlace:
            learn_place(now_s);
            return true;
        case Command::LearntRooms:
            list_learnt_rooms(now_s);
            return true;
        case Command::Hunt:
            hunt_key(now_s);
            return true;
        default:
            return false;
    }
}

void AppCore::enter_learning(double now_s) {
    learning_ = {};
    learning_.last_s = now_s;
    hunt_.reset();
    soundscape_.add({});
}

// What hand and body touch, and where the body goes; and in the mode, what is done by now.
void AppCore::note_learning(double now_s) {
    learning_.unplaced_s += now_s - std::exchange(learning_.last_s, now_s);
    spend_time();
    if (walker_->state().on_ground) learning_.notes.walked(feet_m());
    const double radius = walker_->size().radius_m;
    if (walking_.trail.touching() && led())
        learning_.notes.touched(feet_m() - walking_.trail.wall_normal() * (radius + Trail::kGap_m), walking_.trail.wall_normal(), radius);
    for (const ToolState* tool : {&tool_, &left_tool_})
        for (std::size_t i = 0; i < tool->contacts.count; ++i) {
            const Contact& contact = tool->contacts.contacts[i];
            const Vec3 point = tool->proxy_m - contact.normal * tool->ball_radius_m;
            // A hand is quick: what lies between two frames was touched too, where it stayed on the same wall.
            double reach = tool->ball_radius_m;
            if (contact.feature == learning_.hand_feature) reach += std::min(0.5, glm::length(point - learning_.hand_m));
            learning_.notes.touched(point, contact.normal, reach);
            if (tool == &tool_ && i == tool->contacts.strongest) {
                learning_.hand_m = point;
                learning_.hand_feature = contact.feature;
            }
        }
    corner_of_hand(now_s);
    seek_clock(now_s);
    if (!learning_.on || now_s - learning_.looked_s < kLookEvery_s || learning_.notes.count() == learning_.seen_notes) return;
    learning_.looked_s = now_s;
    learning_.seen_notes = learning_.notes.count();
    guide_learning(now_s);
}

// Two walls that the hand touches at once are a corner.
void AppCore::corner_of_hand(double now_s) {
    const ContactSet& set = tool_.contacts;
    bool corner = false;
    for (std::size_t a = 0; a < set.count; ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const Contact &one = set.contacts[a], &other = set.contacts[b];
            const auto wall = [&](const Contact& c) {
                const Feature* feature = scene_->find(c.feature);
                return feature && feature->kind == FeatureKind::Wall && std::abs(c.normal.z) < 0.5;
            };
            corner |= wall(one) && wall(other) && glm::dot(one.normal, other.normal) < 0.87;
        }
    if (corner && now_s - learning_.corner_s > 0.5) cue(sound_at(SoundKind::Corner, tool_.proxy_m, now_s));
    if (corner) learning_.corner_s = now_s;
}

void AppCore::spend_time() {
    if (room_ != kNothing) learning_.rooms[room_].spent_s += std::exchange(learning_.unplaced_s, 0.0);
}

// Of a room, as much as is known of it by now.
const Learnt& AppCore::learnt_of(std::uint32_t room) {
    std::optional<Learnt>& learnt = learning_.rooms[room].learnt;
    if (!learnt) learnt.emplace(place_of_room(*body_world_, rooms_->navigation().space(), rooms_->graph(), room));
    learnt->lay(learning_.notes);
    return *learnt;
}

// The room one stands in is known, and known to be one; notices which it is.
bool AppCore::in_known_room(double now_s) {
    if (!rooms_known()) return false;
    notice_room(now_s, true);
    spend_time();
    return room_ != kNothing;
}

// Why there is nothing to be told of the room one stands in.
std::string AppCore::no_room_words() const {
    if (!rooms_ || !rooms_->done()) return phrase("rooms.not_yet");
    return rooms_->found() ? phrase("rooms.nowhere") : rooms_->problem();
}

std::string AppCore::progress_words(double now_s) {
    if (!in_known_room(now_s)) return no_room_words();
    const Progress progress = progress_of(learnt_of(room_));
    std::string named;
    for (const WallProgress& wall : progress.walls)
        if (wall.touched_m > 0.0) named = joined(named, name_of(wall.feature));
    const std::string time = time_words(learning_.rooms[room_].spent_s);
    const TextValue of_walls{"walls", percent(progress.perimeter_share())}, of_floor{"floor", percent(progress.floor_share())}, took{"time", time};
    const std::string text = progress.exits > 0 ? phrase(progress.doors_only ? "learning.progress_and_doors" : "learning.progress_and_exits",
                                                         {of_walls, of_floor, {"found", progress.exits_found}, {"exits", progress.exits}, took})
                                                : phrase("learning.progress", {of_walls, of_floor, took});
    return named.empty() ? text : text + " " + phrase("learning.touched", {{"names", named}});
}

void AppCore::tell_unexplored(double now_s) {
    if (!in_known_room(now_s)) return answer(no_room_words(), now_s);
    const auto left = nearest_unexplored(learnt_of(room_), feet_m());
    if (!left) return answer(phrase("learning.all_explored"), now_s);
    const double dx = left->point_m.x - feet_m().x, dy = left->point_m.y - feet_m().y;
    const std::string where = where_words(std::hypot(dx, dy), std::atan2(dx, dy));
    answer(left->wall ? phrase("learning.unexplored_wall", {{"wall", name_of(left->feature)}, {"where", where}})
                      : phrase("learning.unexplored_floor", {{"where", where}}),
           now_s);
}

// "Walls 40 percent, floor 10 percent".
std::string AppCore::share_words(const Progress& progress) const {
    return phrase("learning.share", {{"walls", percent(progress.perimeter_share())}, {"floor", percent(progress.floor_share())}});
}

// Every room with what is learnt of it, the one that one is in first, then those known best; the way to the chosen one.
void AppCore::list_learnt_rooms(double now_s) {
    if (!have_rooms(now_s)) return;
    const RoomGraph& graph = rooms_->graph();
    struct Row {
        std::uint32_t room = 0;
        bool begun = false;
        Progress progress;
    };
    std::vector<Row> rows(graph.rooms.size());
    std::size_t done = 0;
    for (std::uint32_t r = 0; r < rows.size(); ++r) {
        // A room nobody was in and nobody touched from elsewhere is not even looked at.
        Aabb box = graph.rooms[r].bounds_m;
        box.min_m -= Vec3(0.5, 0.5, 0.5);
        box.max_m += Vec3(0.5, 0.5, 2.5);
        rows[r].room = r;
        if (!learning_.notes.any_in(box)) continue;
        rows[r].progress = progress_of(learnt_of(r));
        rows[r].begun = rows[r].progress.touched_m > 0.0 || rows[r].progress.walked_m2 > 0.0;
        done += rows[r].begun && rows[r].progress.done();
    }
    const auto known = [](const Row& row) { return row.begun ? row.progress.perimeter_share() + row.progress.floor_share() : -1.0; };
    std::stable_sort(rows.begin(), rows.end(), [&](const Row& a, const Row& b) {
        return std::pair(a.room == room_, known(a)) > std::pair(b.room == room_, known(b));
    });
    ListSpec list;
    list.title = phrase("learning.rooms", {{"done", done}, {"rooms", rows.size()}});
    std::vector<std::uint32_t> rooms;
    for (const Row& row : rows) {
        list.items.push_back({sentence_case(graph.rooms[row.room].name), row.begun ? share_words(row.progress) : phrase("learning.nothing_yet"), false});
        rooms.push_back(row.room);
    }
    list.chosen = [this, rooms](std::size_t at) { way_to_room(rooms[at], last_tick_s_); };
    open_list(std::move(list), now_s);
}

// The mode begins in the room one is in, or ends. What is known already stays known.
void AppCore::learn_place(double now_s) {
    learning_.on = !learning_.on;
    learning_.seen_notes = 0;
    learning_.room = kNothing;
    if (!learning_.on) return answer(phrase("learning.ended") + " " + progress_words(now_s), now_s);
    const bool known = in_known_room(now_s);
    if (known) {
        learning_.room = room_;
        learning_.rooms[room_].base_m = feet_m();
    }
    answer(phrase("learning.begun", {{"room", known ? sentence_case(rooms_->graph().rooms[room_].name) : phrase("learning.this_place")},
                                     {"trail", keys_.keys_of(Command::TrailLeft)},
                                     {"progress", keys_.keys_of(Command::ProgressReport)},
                                     {"unexplored", keys_.keys_of(Command::Unexplored)}}),
           now_s);
}

// In the mode: each wall that is done, then each lane. Nothing is forced, and whoever goes another way is told what that has done.
void AppCore::guide_learning(double now_s) {
    if (!in_known_room(now_s)) return;
    const Learnt& learnt = learnt_of(room_);
    const Progress progress = progress_of(learnt);
    RoomLearning& room = learning_.rooms[room_];
    if (room_ != std::exchange(learning_.room, room_)) {
        const std::string name = sentence_case(rooms_->graph().rooms[room_].name);
        // The base is where one came in first.
        answer(room.base_m ? phrase("learning.goes_on", {{"room", name}, {"share", share_words(progress)}}) : phrase("learning.next_room", {{"room", name}}), now_s);
        if (!room.base_m) room.base_m = feet_m();
    }
    int done = 0;
    for (const WallProgress& wall : progress.walls) done += wall.done();
    for (const WallProgress& wall : progress.walls) {
        if (!wall.done() || wall.length_m < 0.5 || std::find(room.done.begin(), room.done.end(), wall.feature) != room.done.end()) continue;
        room.done.push_back(wall.feature);
        answer(phrase("learning.wall_done", {{"wall", sentence_case(name_of(wall.feature))}, {"done", done}, {"walls", progress.walls.size()}}), now_s);
    }
    if (!room.walls_done && progress.perimeter_share() >= 0.95) {
        room.walls_done = true;
        play(SoundKind::Arrived, now_s);
        const Vec3 base = *room.base_m - feet_m();
        const std::string where = where_words(glm::length(base), std::atan2(base.x, base.y));
        answer(phrase("learning.walls_done", {{"time", time_words(room.spent_s)}, {"where", where}}), now_s);
    }
    const std::vector<Lane> lanes = lanes_of(learnt);
    std::size_t walked = 0;
    for (const Lane& lane : lanes) walked += lane.done();
    if (walked > room.lanes_told && room.walls_done) {
        std::string next = phrase("learning.lanes_done");
        for (const Lane& lane : lanes)
            if (!lane.done()) {
                const double off = lane.at_m - (lane.north ? feet_m().x : feet_m().y);
                const char* key = lane.north ? (off > 0.0 ? "learning.lane_to_east" : "learning.lane_to_west")
                                             : (off > 0.0 ? "learning.lane_to_north" : "learning.lane_to_south");
                next = phrase(key, {{"distance", distance_words(std::abs(off), distances())}});
                break;
            }
        answer(phrase("learning.lane_done", {{"done", walked}, {"lanes", lanes.size()}}) + " " + next, now_s);
    }
    room.lanes_told = walked;
}

// Hides the clock, or says where to go next.
void AppCore::hunt_key(double now_s) {
    if (hunt_) {
        ++hunt_->hints;
        return answer(hunt_words(), now_s);
    }
    // Doors count as open: whoever hunts opens them.
    Scene open = *scene_;
    std::erase_if(open.placed, [&](const PlacedModel& thing) {
        const Feature* feature = scene_->find(thing.feature);
        return feature && feature->kind == FeatureKind::Door;
    });
    auto world = std::make_unique<BodyWorld>(std::make_shared<const Scene>(std::move(open)));
    HuntGround ground(*world, feet_m(), walker_->size());
    if (ground.size() < 30) return answer(phrase("hunt.no_space"), now_s);
    const Vec3 clock = ground.hiding_place(static_cast<std::uint64_t>(now_s * 1e3) + 7919U * ++hunts_, kHide_m);
    ground.aim(clock);
    hunt_.emplace(ClockHunt{std::move(ground), std::move(world), clock, now_s, 0});
    soundscape_.add({SoundSource{clock + Vec3(0.0, 0.0, 1.0), {}, std::string(info(SoundKind::HiddenClock).name), 1.0}});
    play(SoundKind::Arrived, now_s);
    answer(phrase("hunt.begun", {{"key", keys_.keys_of(Command::Hunt)}}), now_s);
}

std::string AppCore::hunt_words() const {
    // By the ways of this world where they are known; they begin anywhere. The ground's own squares else.
    std::optional<double> way;
    std::optional<Vec3> next;
    if (rooms_ && rooms_->done() && rooms_->found())
        if (const auto leg = next_leg(rooms_->navigation().plan(feet_m(), hunt_->clock_m)); leg && leg->route.reaches)
            way = leg->route.length_m, next = leg->to_m;
    if (!way) way = hunt_->ground.way_m(feet_m()), next = hunt_->ground.next_m(*hunt_->open_world, feet_m(), walker_->size());
    if (!way || !next) {
        const Vec3 to = hunt_->clock_m - feet_m();
        return phrase("hunt.straight", {{"where", where_words(std::hypot(to.x, to.y), std::atan2(to.x, to.y))}});
    }
    const Vec3 to = *next - feet_m();
    const double bearing = std::atan2(to.x, to.y), straight_m = std::hypot(to.x, to.y);
    std::string text = phrase("hunt.go", {{"where", where_words(straight_m, bearing)}, {"distance", distance_words(*way, distances())}});
    const Vec3 up(0.0, 0.0, 1.0);
    const TraceHit hit = body_world_->trace(feet_m() + up, *next + Vec3(0.0, 0.0, 1.0), walker_->shape().height_m > 0.0 ? BodyShape{} : BodyShape{}, true);
    if (hit.hit)
        if (const Feature* feature = scene_->find(hit.feature); feature && feature->kind == FeatureKind::Door)
            text = phrase("hunt.open", {{"door", spoken_name(*feature)}}) + " " + text;
    return text;
}

void AppCore::seek_clock(double now_s) {
    if (!hunt_) return;
    const bool reached = tool_.ticks > 0 && hand_.present && glm::length(tool_.proxy_m - (hunt_->clock_m + Vec3(0.0, 0.0, 1.0))) < kHandFinds_m;
    if (!reached && !finds(*body_world_, feet_m(), hunt_->clock_m)) return;
    const double took_s = now_s - hunt_->began_s;
    const int hints = hunt_->hints;
    hunt_.reset();
    soundscape_.add({});
    play(SoundKind::Arrived, now_s);
    std::string text = phrase("hunt.found", {{"time", time_words(took_s)}, {"hints", hints}});
    // The best time for each world lies in the person's own data folder.
    SideFile times = records_folder_.empty() ? SideFile() : SideFile::of_world(records_folder_ / "hunt", records_folder_);
    SideEntry best = times.table("best_seconds");
    for (const std::string& news : times.news()) text += " " + news;
    const double before_s = records_folder_.empty() ? (best_hunt_s_ > 0.0 ? best_hunt_s_ : -1.0) : number_of(best, scene_->name, -1.0);
    if (before_s < 0.0 || took_s < before_s) {
        text += " " + (before_s < 0.0 ? phrase("hunt.first_time") : phrase("hunt.better", {{"time", time_words(before_s)}}));
        best[scene_->name] = took_s;
        best_hunt_s_ = took_s;
        times.set_table("best_seconds", best);
        if (const auto saved = times.save(); !saved) text += " " + saved.error().sentence();
    } else {
        text += " " + phrase("hunt.best", {{"time", time_words(before_s)}});
    }
    answer(text, now_s);
}

}  // namespace handrail
