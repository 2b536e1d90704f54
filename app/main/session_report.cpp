#include "app/main/session_report.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "app/core/whereabouts/rooms_of_world.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/walker.h"
#include "app/core/world/wall_at_side.h"
#include "app/results/measures.h"
#include "app/results/strategy.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::program {
namespace {

constexpr double kSample_s = 0.1, kLeap_m = 1.0;
// For this long after a touch, the person is still assumed to be at the touched wall.
constexpr double kTouchCounts_s = 0.5;
constexpr std::size_t kMostContacts = 20, kMostLines = 400;

// ---- the walked path ----

std::vector<results::WalkedPoint> way_of(const record::Recording& recording, const record::RecordedEvents& events) {
    std::vector<results::WalkedPoint> walk;
    Vec3 before(0.0);
    bool leap = false, first = true;
    std::size_t leaps = 0;
    for (const record::FrameRow& frame : recording.frames) {
        const double t_s = frame.now_s - recording.head.begun_s;
        if (t_s < events.from_s || t_s > events.to_s) continue;
        // `leaps_s` contains times during a tick, but a frame contains the state at the end of a tick. So assign each
        // leap to the next frame.
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

std::span<const results::WalkedPoint> between_times(std::span<const results::WalkedPoint> walk, double from_s,
                                                    double to_s) {
    const auto at = [&](double t_s) {
        return std::partition_point(walk.begin(), walk.end(),
                                    [&](const results::WalkedPoint& p) { return p.t_s < t_s; });
    };
    return {at(from_s), at(to_s + 1e-9)};
}

bool any_near(std::span<const double> times_s, double t_s) {
    return std::any_of(times_s.begin(), times_s.end(),
                       [&](double one_s) { return std::abs(one_s - t_s) <= 0.5 * kSample_s; });
}

std::vector<results::WalkSample> samples_of(std::span<const results::WalkedPoint> walk,
                                            const record::RecordedEvents& events,
                                            const std::shared_ptr<const Scene>& scene) {
    const core::WalkerWorld solids(scene);
    std::vector<results::WalkSample> samples;
    std::size_t contact = 0, visit = 0;
    for (const results::WalkedPoint& point : walk) {
        results::WalkSample sample{.t_s = point.t_s, .place_m = point.place_m};
        sample.wall_m = core::wall_at_side_m(solids, point.place_m);
        for (; contact < events.contacts.size() && events.contacts[contact].t_s <= point.t_s; ++contact) {
            const record::RecordedContact& met = events.contacts[contact];
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

std::vector<report::ReportStrategy> strategies_of(std::span<const results::WalkSample> samples, const Vec3& base_m,
                                                  double to_s) {
    constexpr std::array<std::pair<results::Strategy, const char*>, results::kStrategies> kKeys{
        {{results::Strategy::Perimeter, "perimeter"},
         {results::Strategy::Grid, "grid"},
         {results::Strategy::ObjectToObject, "object"},
         {results::Strategy::BackToBase, "base"},
         {results::Strategy::Mixed, "mixed"},
         {results::Strategy::None, "none"}}};
    const std::vector<results::StrategyWindow> windows = results::strategy_windows(samples, base_m);
    std::array<double, results::kStrategies> seconds{};
    // Windows overlap. Add to each strategy only the time from the end of the previous window to the end of this one.
    for (std::size_t i = 0; i < windows.size(); ++i) {
        const double begin_s = i == 0 ? windows[i].from_s : windows[i].to_s;
        const double end_s = i + 1 < windows.size() ? windows[i + 1].to_s : to_s;
        seconds[static_cast<std::size_t>(windows[i].kind)] += std::max(0.0, end_s - begin_s);
    }
    std::vector<report::ReportStrategy> listed;
    for (const auto& [kind, key] : kKeys)
        if (const double s = seconds[static_cast<std::size_t>(kind)]; s > 0.0) listed.push_back({key, s});
    return listed;
}

std::vector<report::ReportContact> contacts_of(const record::RecordedEvents& events, const Scene& scene) {
    std::map<std::uint32_t, std::pair<report::ReportContact, std::vector<results::Touch>>> by_thing;
    for (const record::RecordedContact& met : events.contacts) {
        if (!scene.find(FeatureId{met.feature})) continue;
        auto& [listed, touches] = by_thing[met.feature];
        listed.place_m = {met.at_m.x, met.at_m.y};
        listed.name = core::sentence_case(spoken_name(scene.features[met.feature]));
        touches.push_back({met.t_s, met.feature});
    }
    std::vector<report::ReportContact> contacts;
    for (auto& [feature, one] : by_thing) {
        one.first.count = results::contact_episodes(one.second);
        if (!one.first.name.empty()) contacts.push_back(std::move(one.first));
    }
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const report::ReportContact& a, const report::ReportContact& b) { return a.count > b.count; });
    if (contacts.size() > kMostContacts) contacts.resize(kMostContacts);
    return contacts;
}

int count_between(std::span<const double> times_s, double from_s, double to_s) {
    return static_cast<int>(
        std::count_if(times_s.begin(), times_s.end(), [&](double t_s) { return t_s >= from_s && t_s <= to_s; }));
}

void add_pauses(report::ReportTask& task, std::span<const results::WalkedPoint> walk,
                const record::RecordedEvents& events) {
    std::vector<results::Span> busy;
    for (const record::RecordedSpan& span : events.busy) busy.push_back({span.from_s, span.to_s});
    const results::Hesitations pauses = results::hesitations(walk, busy);
    task.measures.push_back({"pauses", static_cast<double>(pauses.count)});
    task.measures.push_back({"pause_time", pauses.sum_s});
}

report::ReportTask task_of(const record::RecordedRoute& way, double to_s, std::span<const results::WalkedPoint> all,
                           const record::RecordedEvents& events, navigation::Navigation& navigation) {
    report::ReportTask task{
        .kind = report::ReportTaskKind::Go, .name = way.goal, .reached = way.arrived_s.has_value(), .measures = {}};
    const double end_s = way.arrived_s.value_or(to_s);
    const auto walk = between_times(all, way.from_s, end_s);
    task.measures.push_back({"time", end_s - way.from_s});
    if (!walk.empty() && task.reached == true) {
        const navigation::Route shortest = navigation.plan(walk.front().place_m, walk.back().place_m);
        if (shortest.reaches) {
            if (const auto ratio = results::path_ratio(results::walked_length_m(walk),
                                                       results::level_length_m(shortest.points_m), true))
                task.measures.push_back({"path_ratio", *ratio});
            const results::TurnsMet turns = results::turns_met(shortest.points_m, walk);
            task.measures.push_back({"turns_missed", static_cast<double>(turns.missed)});
            task.measures.push_back({"turns_early", static_cast<double>(turns.early)});
        }
    }
    add_pauses(task, walk, events);
    task.measures.push_back({"help_asked", static_cast<double>(count_between(events.help_s, way.from_s, end_s))});
    return task;
}

report::ReportTask task_of(const record::RecordedTask& done) {
    constexpr std::array<std::pair<const char*, report::ReportTaskKind>, 7> kKinds{
        {{"learn", report::ReportTaskKind::Learn},
         {"go", report::ReportTaskKind::Go},
         {"free", report::ReportTaskKind::Free},
         {"point", report::ReportTaskKind::Point},
         {"distance", report::ReportTaskKind::Distance},
         {"order", report::ReportTaskKind::Order},
         {"ask", report::ReportTaskKind::Question}}};
    report::ReportTask task{.kind = report::ReportTaskKind::Free, .name = done.name, .reached = {}, .measures = {}};
    for (const auto& [word, kind] : kKinds)
        if (done.kind == word) task.kind = kind;
    for (const auto& [key, value] : done.measures)
        if (key == "reached") task.reached = value > 0.5;
        else task.measures.push_back({key, value});
    return task;
}

// Adds the rooms through which the person walked, and the walked path on `storey`.
void add_rooms(report::SessionReport& report, std::span<const results::WalkedPoint> walk,
               const navigation::RoomGraph& graph, const navigation::WalkSpace& space, int storey) {
    bool on_plan = false;
    for (const results::WalkedPoint& point : walk) {
        const std::uint32_t room = navigation::room_at(graph, space, point.place_m);
        const bool was = on_plan;
        if (room != navigation::kNothing) {
            on_plan = graph.rooms[room].level + 1 == storey;
            const std::string name = capitalised(graph.rooms[room].name);
            if (report.rooms.empty() || report.rooms.back() != name) report.rooms.push_back(name);
        }
        if (!on_plan) continue;
        const Vec2 at(point.place_m.x, point.place_m.y);
        if (!was || point.leap) report.ways_m.emplace_back();
        std::vector<Vec2>& way = report.ways_m.back();
        if (way.empty() || glm::length(at - way.back()) >= results::kPointSpacing_m) way.push_back(at);
    }
}

// Returns what was said. If the person stepped through a list, includes only the first answer, not the items of the
// list.
std::vector<report::ReportEvent> course_of(const record::Recording& recording, const record::RecordedEvents& events) {
    std::vector<report::ReportEvent> course;
    std::size_t list = 0;
    bool first = true;
    for (const record::SaidLine& line : record::said_lines(recording)) {
        if (!line.voiced || line.t_s < events.from_s || line.t_s > events.to_s) continue;
        for (; list < events.lists.size() && events.lists[list].to_s <= line.t_s; ++list) first = true;
        const bool in_list = list < events.lists.size() && line.t_s >= events.lists[list].from_s;
        if (in_list && line.speech_class == "answer" && !std::exchange(first, false)) continue;
        if (course.size() < kMostLines) course.push_back({line.t_s - events.from_s, line.text});
    }
    return course;
}

report::ReportTask whole(const record::RecordedEvents& events, std::span<const results::WalkedPoint> walk) {
    report::ReportTask task{.kind = report::ReportTaskKind::Free, .name = {}, .reached = {}, .measures = {}};
    std::vector<results::Touch> touches;
    for (const record::RecordedContact& met : events.contacts) touches.push_back({met.t_s, met.feature});
    task.measures.push_back({"time", events.to_s - events.from_s});
    add_pauses(task, walk, events);
    task.measures.push_back({"contacts_hand", static_cast<double>(results::contact_episodes(touches))});
    task.measures.push_back({"help_asked", static_cast<double>(events.help_s.size())});
    return task;
}

}  // namespace

Result<report::SessionReport> report_of(const record::Recording& recording, const record::RecordedEvents& events,
                                        const std::shared_ptr<const Scene>& scene, core::RoomsKept* rooms_kept) {
    const core::WalkerSize size = core::walker_size(*scene, settings::Settings{}.walk.body_radius_m);
    core::RoomsOfWorld rooms(scene, navigation::walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m),
                             at_once(), core::RoutesKeeper{}, rooms_kept);
    if (!rooms.ready() || !rooms.found())
        return fail(rooms.problem().empty() ? phrase("export.no_rooms") : rooms.problem(), scene->source_file);
    report::SessionReport report;
    report.started_utc = recording.head.begun_utc;
    report.world = spoken_name(*scene);
    report.seconds = events.to_s - events.from_s;
    const std::vector<results::WalkedPoint> walk = way_of(recording, events);
    report.tasks.push_back(whole(events, walk));
    report.lesson = events.lesson;
    for (const record::RecordedTask& task : events.tasks) report.tasks.push_back(task_of(task));
    // In a session without a lesson, each route on which the person was guided becomes a task of the report.
    for (std::size_t i = 0; i < (events.lesson.empty() ? events.ways.size() : 0); ++i)
        report.tasks.push_back(task_of(events.ways[i],
                                       i + 1 < events.ways.size() ? events.ways[i + 1].from_s : events.to_s, walk,
                                       events, rooms.navigation()));
    if (!walk.empty())
        report.strategies =
            strategies_of(samples_of(walk, events, rooms.scene()), walk.front().place_m, walk.back().t_s);
    report.course = course_of(recording, events);
    report.contacts = contacts_of(events, *scene);
    for (const record::RecordedNote& note : events.notes)
        if (note.t_s >= events.from_s && note.t_s <= events.to_s)
            report.notes.push_back({note.t_s - events.from_s, note.text});
    report.walked_m = results::walked_length_m(walk);
    const navigation::WalkSpace& space = rooms.navigation().space();
    const int storey = plan::storey_of_start(*scene, rooms.graph(), space);
    add_rooms(report, walk, rooms.graph(), space, storey);
    if (auto plan = plan::storey_of(*scene, rooms.graph(), space, storey)) report.storey = std::move(*plan);
    return report;
}

report::SessionReport report_of(const learners::KeptResults& results) {
    report::SessionReport report;
    report.started_utc = results.begun_utc;
    report.lesson = results.lesson;
    report.world = results.world;
    report.seconds = results.seconds;
    for (const record::RecordedTask& task : results.tasks) report.tasks.push_back(task_of(task));
    return report;
}

}  // namespace handrail::program
