#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/report/page_parts.h"
#include "worlds/base/language.h"
#include "worlds/base/markup.h"
#include "worlds/base/spoken_time.h"

namespace handrail::report {
namespace {

// One attempt to walk to a goal.
struct Went {
    std::size_t session = 0;  // number of the session, counted from 1
    const ReportTask* task = nullptr;
};
struct Goal {
    std::string name;
    std::vector<Went> times;
};

std::vector<Goal> goals_of(std::span<const SessionReport> reports) {
    std::vector<Goal> goals;
    for (std::size_t i = 0; i < reports.size(); ++i)
        for (const ReportTask& task : reports[i].tasks) {
            if (task.kind != ReportTaskKind::Go || task.name.empty()) continue;
            auto own =
                std::find_if(goals.begin(), goals.end(), [&](const Goal& goal) { return goal.name == task.name; });
            if (own == goals.end()) own = goals.insert(own, Goal{task.name, {}});
            own->times.push_back({i + 1, &task});
        }
    return goals;
}

std::optional<double> measured(const ReportTask& task, std::string_view key) {
    for (const ReportMeasure& measure : task.measures)
        if (measure.key == key && std::isfinite(measure.value)) return measure.value;
    return std::nullopt;
}

std::optional<double> wrong_turns(const ReportTask& task) {
    const auto missed = measured(task, "turns_missed"), early = measured(task, "turns_early");
    if (!missed && !early) return std::nullopt;
    return missed.value_or(0.0) + early.value_or(0.0);
}

// Returns the first and the last measured value of a goal; nothing if there are fewer than two values.
template <class Of>
std::optional<std::pair<double, double>> first_and_last(const Goal& goal, Of of) {
    std::vector<double> values;
    for (const Went& went : goal.times)
        if (const auto value = of(*went.task)) values.push_back(*value);
    if (values.size() < 2) return std::nullopt;
    return std::pair(values.front(), values.back());
}

void say_of_goal(const Goal& goal, std::vector<std::string>& said) {
    said.push_back(phrase("report.goal_times", {{"name", goal.name}, {"count", goal.times.size()}}));
    if (const auto way = first_and_last(goal, [](const ReportTask& task) { return measured(task, "path_ratio"); }))
        said.push_back(phrase(way->second < 0.95 * way->first   ? "report.goal_shorter"
                              : way->second > 1.05 * way->first ? "report.goal_longer"
                                                                : "report.goal_same"));
    const auto say = [&](const char* key, const std::optional<std::pair<double, double>>& values) {
        if (values && (values->first > 0.5 || values->second > 0.5))
            said.push_back(phrase(key, {{"first", std::lround(values->first)}, {"last", std::lround(values->second)}}));
    };
    say("report.goal_turns", first_and_last(goal, wrong_turns));
    say("report.goal_help", first_and_last(goal, [](const ReportTask& task) { return measured(task, "help_asked"); }));
}

std::string session_words(const SessionReport& report, std::size_t number) {
    return phrase("report.session_number", {{"number", number}, {"day", day_words(report.started_utc)}});
}

std::string cell(const ReportTask& task, const std::string& key) {
    const auto value = measured(task, key);
    const ReportMeasureInfo* info = info_of(key);
    return value && info ? value_words(*info, *value) : phrase("report.none");
}

std::string goals_html(std::span<const SessionReport> reports) {
    std::string html;
    for (const Goal& goal : goals_of(reports)) {
        html += table_head(phrase("report.task_go", {{"name", goal.name}}),
                           {phrase("report.column_session"), phrase("report.measure_time"),
                            phrase("report.measure_path_ratio"), phrase("report.measure_turns_missed"),
                            phrase("report.measure_turns_early"), phrase("report.measure_help_asked")});
        for (const Went& went : goal.times)
            html += row_of(session_words(reports[went.session - 1], went.session),
                           {cell(*went.task, "time"), cell(*went.task, "path_ratio"), cell(*went.task, "turns_missed"),
                            cell(*went.task, "turns_early"), cell(*went.task, "help_asked")});
        html += std::string(kTableEnd);
    }
    return html.empty() ? html : heading("progress", phrase("report.progress")) + html;
}

std::string sessions_html(std::span<const SessionReport> reports) {
    std::string html = heading("sessions", phrase("report.sessions"));
    html += table_head(phrase("report.sessions_caption"),
                       {phrase("report.column_session"), phrase("report.column_place"), phrase("report.column_time")});
    for (std::size_t i = 0; i < reports.size(); ++i)
        html += row_of(session_words(reports[i], i + 1), {reports[i].world, duration_words(reports[i].seconds)});
    return html + std::string(kTableEnd);
}

}  // namespace

std::vector<std::string> learner_words(std::span<const SessionReport> reports) {
    double all_s = 0.0;
    for (const SessionReport& report : reports) all_s += report.seconds;
    std::vector<std::string> said = {
        phrase("report.sessions_in_all", {{"count", reports.size()}, {"time", duration_words(all_s)}})};
    for (const Goal& goal : goals_of(reports)) say_of_goal(goal, said);
    return said;
}

std::string learner_page(std::span<const SessionReport> reports) {
    const std::string title =
        phrase("report.title", {{"session", reports.empty() ? std::string() : reports.front().learner}});
    std::string html = page_begin(title) + heading("words", phrase("report.words"));
    const auto list = [&html](const std::vector<std::string>& sentences) {
        html += "<ul>\n";
        for (const std::string& sentence : sentences) html += "<li>" + markup_text(sentence) + "</li>\n";
        html += "</ul>\n";
    };
    list(learner_words(reports));
    html += goals_html(reports);
    std::map<std::string, double> seconds;
    for (const SessionReport& report : reports)
        for (const ReportStrategy& strategy : report.strategies) seconds[strategy.key] += strategy.seconds;
    std::vector<ReportStrategy> strategies;
    for (const auto& [key, spent_s] : seconds) strategies.push_back({key, spent_s});
    std::stable_sort(strategies.begin(), strategies.end(),
                     [](const ReportStrategy& a, const ReportStrategy& b) { return a.seconds > b.seconds; });
    html += strategies_html(strategies);
    if (!reports.empty()) html += sessions_html(reports);
    for (std::size_t i = 0; i < reports.size(); ++i) {
        html += heading(fmt::format("session-{}", i + 1), session_words(reports[i], i + 1));
        list(report_words(reports[i]));
        html += plan_html(reports[i], fmt::format("plan-{}", i + 1));
    }
    return html + std::string(kPageEnd);
}

}  // namespace handrail::report
