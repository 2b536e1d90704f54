#include "app/main/session_report.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "app/core/whereabouts/rooms_of_world.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/walker.h"
#include "app/core/world/wall_beside.h"
#include "app/results/measures.h"
#include "app/results/strategy.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

constexpr double kSample_s = 0.1, kLeap_m = 1.0;
constexpr double kTouchCounts_s = 0.5;  // a touch or a visit counts as "here" for this long
constexpr std::size_t kMostContacts = 20, kMostLines = 400;

// ---- the walked path ----

std::vector<WayPoint> way_of(const Recording& recording, const RecordedEvents& events) {
    std::vector<WayPoint> walk;
    Vec3 before(0.0);
    bool leap = false, first = true;
    std::size_t leaps = 0;
    for (const FrameRow& frame : recording.frames) {
        const double t_s = frame.now_s - recording.head.begun_s;
        if (t_s < events.from_s || t_s > events.to_s) continue;
        // Frames show the state at the end of a tick; leaps are noted during the tick.
        for (; leaps < events.leaps_s.size() && events.leaps_s[leaps] <= t_s + 1e-3; ++leaps) leap = true;
        leap = leap || (!first && glm::length(frame.feet_m - before) > kLeap_m);
        before = frame.feet_m;
        first = false;
        if (!walk.empty() && t_s - walk.back().t_s < kSample_s - 1e-6) continue;
        walk.push_back({t_s, frame.feet_m, leap});
        leap = false;
    }
    return walk;
}

std::span<const WayPoint> between_times(std::span<const WayPoint> walk, double from_s, double to_s) {
    const auto at = [&](double t_s) {
        return std::partition_point(walk.begin(), walk.end(), [&](const WayPoint& p) { return p.t_s < t_s; });
    };
    return {at(from_s), at(to_s + 1e-9)};
}

bool any_near(std::span<const double> times_s, double t_s) {
    return std::any_of(times_s.begin(), times_s.end(),
                       [&](double one_s) { return std::abs(one_s - t_s) <= 0.5 * kSample_s; });
}

std::vector<WalkSample> samples_of(std::span<const WayPoint> walk, const RecordedEvents& events,
                                   const std::shared_ptr<const Scene>& scene) {
    const WalkerWorld solids(scene);
    std::vector<WalkSample> samples;
    std::size_t contact = 0, visit = 0;
    for (const WayPoint& point : walk) {
        WalkSample sample{.t_s = point.t_s, .place_m = point.place_m};
        sample.wall_m = wall_beside_m(solids, point.place_m);
        for (; contact < events.contacts.size() && events.contacts[contact].t_s <= point.t_s; ++contact) {
            const RecordedContact& met = events.contacts[contact];
            const Feature* feature = scene->find(FeatureId{met.feature});
            if (feature && feature->kind == FeatureKind::Wall && point.t_s - met.t_s <= kTouchCounts_s)
                sample.wall_touched = true;
        }
        for (; visit < events.visits.size() && events.visits[visit].t_s <= point.t_s; ++visit)
            sample.thing = static_cast<int>(events.visits[visit].feature);
        sample.home = any_near(events.home_s, point.t_s);
        samples.push_back(sample);
    }
    return samples;
}

// ---- contents of the report ----

std::vector<ReportStrategy> strategies_of(std::span<const WalkSample> samples, const Vec3& base_m, double to_s) {
    constexpr std::array<std::pair<Strategy, const char*>, kStrategies> kKeys{{{Strategy::Perimeter, "perimeter"},
                                                                               {Strategy::Grid, "grid"},
                                                                               {Strategy::ObjectToObject, "object"},
                                                                               {Strategy::BackToBase, "base"},
                                                                               {Strategy::Mixed, "mixed"},
                                                                               {Strategy::None, "none"}}};
    const std::vector<StrategyWindow> windows = strategy_windows(samples, base_m);
    std::array<double, kStrategies> seconds{};
    // The windows overlap: each counts until the next one ends.
    for (std::size_t i = 0; i < windows.size(); ++i) {
        const double begin_s = i == 0 ? windows[i].from_s : windows[i].to_s;
        const double end_s = i + 1 < windows.size() ? windows[i + 1].to_s : to_s;
        seconds[static_cast<std::size_t>(windows[i].kind)] += std::max(0.0, end_s - begin_s);
    }
    std::vector<ReportStrategy> told;
    for (const auto& [kind, key] : kKeys)
        if (const double s = seconds[static_cast<std::size_t>(kind)]; s > 0.0) told.push_back({key, s});
    return told;
}

std::vector<ReportContact> contacts_of(const RecordedEvents& events, const Scene& scene) {
    std::map<std::uint32_t, std::pair<ReportContact, std::vector<Touch>>> by_thing;
    for (const RecordedContact& met : events.contacts) {
        if (!scene.find(FeatureId{met.feature})) continue;
        auto& [told, touches] = by_thing[met.feature];
        told.place_m = {met.at_m.x, met.at_m.y};
        told.name = sentence_case(spoken_name(scene.features[met.feature]));
        touches.push_back({met.t_s, met.feature});
    }
    std::vector<ReportContact> contacts;
    for (auto& [feature, one] : by_thing) {
        one.first.count = contact_episodes(one.second);
        if (!one.first.name.empty()) contacts.push_back(std::move(one.first));
    }
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const ReportContact& a, const ReportContact& b) { return a.count > b.count; });
    if (contacts.size() > kMostContacts) contacts.resize(kMostContacts);
    return contacts;
}

int count_between(std::span<const double> times_s, double from_s, double to_s) {
    return static_cast<int>(
        std::count_if(times_s.begin(), times_s.end(), [&](double t_s) { return t_s >= from_s && t_s <= to_s; }));
}

void add_pauses(ReportTask& task, std::span<const WayPoint> walk, const RecordedEvents& events) {
    std::vector<Span> busy;
    for (const RecordedSpan& span : events.busy) busy.push_back({span.from_s, span.to_s});
    const Hesitations pauses = hesitations(walk, busy);
    task.measures.push_back({"pauses", static_cast<double>(pauses.count)});
    task.measures.push_back({"pause_time", pauses.sum_s});
}

ReportTask task_of(const RecordedRoute& way, double to_s, std::span<const WayPoint> all, const RecordedEvents& events,
                   Navigation& navigation) {
    ReportTask task{.kind = ReportTaskKind::Go, .name = way.goal, .reached = way.arrived_s.has_value(), .measures = {}};
    const double end_s = way.arrived_s.value_or(to_s);
    const auto walk = between_times(all, way.from_s, end_s);
    task.measures.push_back({"time", end_s - way.from_s});
    if (!walk.empty() && task.reached == true) {
        const Route shortest = navigation.plan(walk.front().place_m, walk.back().place_m);
        if (shortest.reaches) {
            if (const auto ratio = path_ratio(way_walked_m(walk), level_way_m(shortest.points_m), true))
                task.measures.push_back({"path_ratio", *ratio});
            const TurnsMet turns = turns_met(shortest.points_m, walk);
            task.measures.push_back({"turns_missed", static_cast<double>(turns.missed)});
            task.measures.push_back({"turns_early", static_cast<double>(turns.early)});
        }
    }
    add_pauses(task, walk, events);
    task.measures.push_back({"help_asked", static_cast<double>(count_between(events.help_s, way.from_s, end_s))});
    return task;
}

ReportTask task_of(const RecordedTask& done) {
    constexpr std::array<std::pair<const char*, ReportTaskKind>, 7> kKinds{{{"learn", ReportTaskKind::Learn},
                                                                            {"go", ReportTaskKind::Go},
                                                                            {"free", ReportTaskKind::Free},
                                                                            {"point", ReportTaskKind::Point},
                                                                            {"distance", ReportTaskKind::Distance},
                                                                            {"order", ReportTaskKind::Order},
                                                                            {"ask", ReportTaskKind::Ask}}};
    ReportTask task{.kind = ReportTaskKind::Free, .name = done.name, .reached = {}, .measures = {}};
    for (const auto& [word, kind] : kKinds)
        if (done.kind == word) task.kind = kind;
    for (const auto& [key, value] : done.measures)
        if (key == "reached") task.reached = value > 0.5;
        else task.measures.push_back({key, value});
    return task;
}

// Adds the rooms that were walked through, and the path if it is on that storey.
void add_rooms(SessionReport& report, std::span<const WayPoint> walk, const RoomGraph& graph, const WalkSpace& space,
               int storey) {
    bool on_plan = false;
    for (const WayPoint& point : walk) {
        const std::uint32_t room = room_at(graph, space, point.place_m);
        const bool was = on_plan;
        if (room != kNothing) {
            on_plan = graph.rooms[room].level + 1 == storey;
            const std::string name = capitalised(graph.rooms[room].name);
            if (report.rooms.empty() || report.rooms.back() != name) report.rooms.push_back(name);
        }
        if (!on_plan) continue;
        const Vec2 at(point.place_m.x, point.place_m.y);
        if (!was || point.leap) report.ways_m.emplace_back();
        std::vector<Vec2>& way = report.ways_m.back();
        if (way.empty() || glm::length(at - way.back()) >= kWaySpacing_m) way.push_back(at);
    }
}

// What was said. When a person looks through a list, only the first answer is kept and its items are left out.
std::vector<ReportEvent> course_of(const Recording& recording, const RecordedEvents& events) {
    std::vector<ReportEvent> course;
    std::size_t list = 0;
    bool first = true;
    for (const SaidLine& line : said_lines(recording)) {
        if (!line.voiced || line.t_s < events.from_s || line.t_s > events.to_s) continue;
        for (; list < events.lists.size() && events.lists[list].to_s <= line.t_s; ++list) first = true;
        const bool in_list = list < events.lists.size() && line.t_s >= events.lists[list].from_s;
        if (in_list && line.speech_class == "answer" && !std::exchange(first, false)) continue;
        if (course.size() < kMostLines) course.push_back({line.t_s - events.from_s, line.text});
    }
    return course;
}

ReportTask whole(const RecordedEvents& events, std::span<const WayPoint> walk) {
    ReportTask task{.kind = ReportTaskKind::Free, .name = {}, .reached = {}, .measures = {}};
    std::vector<Touch> touches;
    for (const RecordedContact& met : events.contacts) touches.push_back({met.t_s, met.feature});
    task.measures.push_back({"time", events.to_s - events.from_s});
    add_pauses(task, walk, events);
    task.measures.push_back({"contacts_hand", static_cast<double>(contact_episodes(touches))});
    task.measures.push_back({"help_asked", static_cast<double>(events.help_s.size())});
    return task;
}

}  // namespace

Result<SessionReport> report_of(const Recording& recording, const RecordedEvents& events,
                                const std::shared_ptr<const Scene>& scene, RoomsKept* rooms_kept) {
    const WalkerSize size = body_size(*scene, Settings{}.walk.body_radius_m);
    RoomsOfWorld rooms(scene, walk_body(*scene, size.radius_m, size.height_m, size.step_up_m), at_once(), RoutesKeeper{},
                       rooms_kept);
    if (!rooms.ready() || !rooms.found())
        return fail(rooms.problem().empty() ? phrase("export.no_rooms") : rooms.problem(), scene->source_file);
    SessionReport report;
    report.started_utc = recording.head.begun_utc;
    report.world = spoken_name(*scene);
    report.seconds = events.to_s - events.from_s;
    const std::vector<WayPoint> walk = way_of(recording, events);
    report.tasks.push_back(whole(events, walk));
    report.lesson = events.lesson;
    for (const RecordedTask& task : events.tasks) report.tasks.push_back(task_of(task));
    // Without a lesson, each route on which the person was led counts as a task.
    for (std::size_t i = 0; i < (events.lesson.empty() ? events.ways.size() : 0); ++i)
        report.tasks.push_back(task_of(events.ways[i],
                                       i + 1 < events.ways.size() ? events.ways[i + 1].from_s : events.to_s, walk,
                                       events, rooms.navigation()));
    if (!walk.empty())
        report.strategies =
            strategies_of(samples_of(walk, events, rooms.scene()), walk.front().place_m, walk.back().t_s);
    report.course = course_of(recording, events);
    report.contacts = contacts_of(events, *scene);
    for (const RecordedNote& note : events.notes)
        if (note.t_s >= events.from_s && note.t_s <= events.to_s)
            report.notes.push_back({note.t_s - events.from_s, note.text});
    report.walked_m = way_walked_m(walk);
    const WalkSpace& space = rooms.navigation().space();
    const int storey = storey_of_start(*scene, rooms.graph(), space);
    add_rooms(report, walk, rooms.graph(), space, storey);
    if (auto plan = storey_of(*scene, rooms.graph(), space, storey)) report.storey = std::move(*plan);
    return report;
}

SessionReport report_of(const KeptResults& results) {
    SessionReport report;
    report.started_utc = results.begun_utc;
    report.lesson = results.lesson;
    report.world = results.world;
    report.seconds = results.seconds;
    for (const RecordedTask& task : results.tasks) report.tasks.push_back(task_of(task));
    return report;
}

}  // namespace handrail
