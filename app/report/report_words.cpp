#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/report/report_page.h"
#include "worlds/base/language.h"

namespace handrail::report {
namespace {

constexpr std::array kMeasures{
    ReportMeasureInfo{"path_ratio", "1", 2},      ReportMeasureInfo{"time", "s", 0},
    ReportMeasureInfo{"turns_missed", "1", 0},    ReportMeasureInfo{"turns_early", "1", 0},
    ReportMeasureInfo{"pauses", "1", 0},          ReportMeasureInfo{"pause_time", "s", 0},
    ReportMeasureInfo{"contacts_hand", "1", 0},   ReportMeasureInfo{"walls_percent", "%", 0},
    ReportMeasureInfo{"exits_percent", "%", 0},   ReportMeasureInfo{"help_asked", "1", 0},
    ReportMeasureInfo{"led_time", "s", 0},        ReportMeasureInfo{"detour_time", "s", 0},
    ReportMeasureInfo{"pointing_off", "deg", 0},  ReportMeasureInfo{"pointing_side", "deg", 0},
    ReportMeasureInfo{"pointing_passed", "%", 0}, ReportMeasureInfo{"distance_judged", "1", 2},
    ReportMeasureInfo{"order_kept", "1", 2},      ReportMeasureInfo{"answer", "1", 0},
};

std::optional<double> value_of(const ReportTask& task, std::string_view key) {
    for (const ReportMeasure& measure : task.measures)
        if (measure.key == key && std::isfinite(measure.value)) return measure.value;
    return std::nullopt;
}

// Makes the sentences about one task. Leaves out values that were not measured.
class TaskWords {
public:
    TaskWords(const ReportTask& task, std::vector<std::string>& said) : task_(task), said_(said) {}

    void go() {
        if (task_.reached) say(*task_.reached ? "report.reached" : "report.not_reached", {{"name", task_.name}});
        if (const auto time = value("time")) say("report.took", {{"time", duration_words(*time)}});
        if (const auto ratio = value("path_ratio"))
            say(*ratio < 1.15  ? "report.way_short"
                : *ratio < 1.5 ? "report.way_longer"
                               : "report.way_times",
                {{"times", *ratio}});
        // True if the learner did not reach the goal. Few missed turns are then no reason for praise.
        const bool given_up = task_.reached == false;
        if (const auto missed = value("turns_missed"); missed && !(given_up && *missed < 0.5))
            say(*missed < 0.5 ? "report.turns_made" : "report.turns_missed", {{"count", std::lround(*missed)}});
        if (const auto early = value("turns_early"); early && *early > 0.5)
            say("report.turns_early", {{"count", std::lround(*early)}});
        if (const auto pauses = value("pauses"); pauses && *pauses > 0.5)
            say("report.pauses", {{"count", std::lround(*pauses)}});
        if (const auto help = value("help_asked"); help && !(given_up && *help < 0.5))
            say(*help < 0.5 ? "report.no_help" : "report.help", {{"count", std::lround(*help)}});
        if (value("detour_time")) say("report.detour", {});
    }

    void learn() {
        say("report.learnt", {{"name", task_.name}});
        if (const auto walls = value("walls_percent")) say("report.walls", {{"percent", std::lround(*walls)}});
        if (const auto exits = value("exits_percent"))
            say(*exits > 99.5 ? "report.exits_all" : "report.exits", {{"percent", std::lround(*exits)}});
    }

    void point() {
        if (const auto off = value("pointing_off"))
            say(*off < 20.0 ? "report.points_well" : "report.points_off", {{"degrees", std::lround(*off)}});
        if (const auto side = value("pointing_side"); side && std::abs(*side) >= 10.0)
            say(*side > 0.0 ? "report.points_right" : "report.points_left", {});
        if (const auto passed = value("pointing_passed"))
            say(*passed > 99.5 ? "report.points_all_count" : "report.points_count",
                {{"percent", std::lround(*passed)}});
    }

    void distance() {
        if (const auto judged = value("distance_judged"))
            say(*judged < 0.8 ? "report.judges_near" : *judged > 1.25 ? "report.judges_far" : "report.judges_well", {});
    }

    void order() {
        if (const auto kept = value("order_kept")) say(*kept > 0.99 ? "report.order_all" : "report.order_some", {});
    }

    void question() {
        if (const auto answer = value("answer"))
            say("report.asked", {{"question", fmt::format("{} {}", task_.name, std::lround(*answer))}});
        else say("report.asked", {{"question", task_.name}});
    }

private:
    std::optional<double> value(std::string_view key) const { return value_of(task_, key); }
    void say(std::string_view key, std::initializer_list<TextValue> values) { said_.push_back(phrase(key, values)); }

    const ReportTask& task_;
    std::vector<std::string>& said_;
};

}  // namespace

std::string duration_words(double seconds) {
    const auto whole = static_cast<long>(std::lround(std::max(0.0, seconds)));
    return whole < 120 ? phrase("report.seconds", {{"count", whole}})
                       : phrase("report.minutes", {{"count", (whole + 30) / 60}});
}

std::span<const ReportMeasureInfo> report_measures() { return kMeasures; }

std::vector<std::string> report_words(const SessionReport& report) {
    std::vector<std::string> said;
    if (report.seconds > 0.0)
        said.push_back(phrase("report.was_in", {{"world", report.world}, {"time", duration_words(report.seconds)}}));
    for (const ReportTask& task : report.tasks) {
        TaskWords words(task, said);
        if (task.kind == ReportTaskKind::Go) words.go();
        else if (task.kind == ReportTaskKind::Learn) words.learn();
        else if (task.kind == ReportTaskKind::Point) words.point();
        else if (task.kind == ReportTaskKind::Distance) words.distance();
        else if (task.kind == ReportTaskKind::Order) words.order();
        else if (task.kind == ReportTaskKind::Question) words.question();
    }
    const auto most =
        std::max_element(report.strategies.begin(), report.strategies.end(),
                         [](const ReportStrategy& a, const ReportStrategy& b) { return a.seconds < b.seconds; });
    if (most != report.strategies.end() && has_phrase("report.mostly_" + most->key))
        said.push_back(phrase("report.mostly_" + most->key));
    if (said.empty()) said.push_back(phrase("report.nothing"));
    return said;
}

std::vector<std::string> plan_words(const SessionReport& report) {
    std::vector<std::string> said;
    if (!report.storey) return said;
    const plan::Storey& storey = *report.storey;
    said.push_back(
        phrase("report.plan_shows", {{"world", storey.world}, {"storey", storey.number}, {"count", storey.count}}));
    if (report.walked_m < 0.5) {
        said.push_back(phrase("report.no_way"));
        return said;
    }
    said.push_back(phrase("report.way", {{"metres", std::lround(report.walked_m)}}));
    if (report.rooms.empty()) return said;
    constexpr std::size_t kMost = 12;
    std::vector<std::string> rooms = report.rooms;
    const std::size_t more = rooms.size() > kMost ? rooms.size() - kMost : 0;
    if (more > 0) rooms.resize(kMost);
    said.push_back(phrase("report.way_rooms", {{"rooms", fmt::format("{}", fmt::join(rooms, "; "))}, {"more", more}}));
    return said;
}

}  // namespace handrail::report
