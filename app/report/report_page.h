// Reports on a session, for the learner and the instructor: a self-contained page, and tables for other programs. Made
// of plain values; pure functions; any thread. Lengths in metres, times in seconds, world axes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/plan/storey.h"

namespace handrail::report {

// A measure: its key in files, its unit (UCUM), and how many decimals are shown.
struct ReportMeasureInfo {
    std::string_view key, unit;
    int decimals = 0;
};
// All measures in the order of the table: "path_ratio", "time", "pauses" and so on. Their words are the texts
// `report.measure_KEY` and `report.means_KEY`.
std::span<const ReportMeasureInfo> report_measures();

struct ReportMeasure {
    std::string key;  // of report_measures(); other keys are left out of the page but kept in the tables
    double value = 0.0;
};

enum class ReportTaskKind : std::uint8_t { Go, Learn, Free, Point, Distance, Order, Ask };
struct ReportTask {
    ReportTaskKind kind = ReportTaskKind::Go;
    std::string name;             // the goal, the room learnt, or a question with its answer; may be empty
    std::optional<bool> reached;  // only for Go
    std::vector<ReportMeasure> measures;
};

// A strategy of exploration: "perimeter", "grid", "object", "base", "mixed", "none".
struct ReportStrategy {
    std::string key;
    double seconds = 0.0;
};

struct ReportEvent {
    double at_s = 0.0;
    std::string text;  // a sentence, as it was announced
};

struct ReportContact {
    Vec2 place_m{0.0};
    std::string name;
    int count = 1;
};

struct SessionReport {
    std::string learner;     // chosen name
    std::string learner_id;  // the learner's number, used in files
    std::string lesson, session;
    std::string started_utc;  // ISO 8601: "2026-11-22T17:30:00Z"
    std::string world;
    double seconds = 0.0;
    std::vector<ReportTask> tasks;
    std::vector<ReportStrategy> strategies;
    std::vector<ReportEvent> course;
    std::vector<ReportContact> contacts;  // the most frequent first
    std::vector<ReportEvent> notes;       // what the instructor noted and did
    double walked_m = 0.0;
    std::vector<std::string> rooms;  // rooms walked through, in order
    // Where the walker went on the storey of the plan. A new piece begins after the walker returned to the storey or
    // was put somewhere.
    std::vector<std::vector<Vec2>> ways_m;
    std::optional<plan::Storey> storey;  // nothing: no plan is drawn
};

// What went well and what did not, addressed to the learner, in short sentences without technical words.
std::vector<std::string> report_words(const SessionReport& report);
// The route through the rooms in sentences, as the plan shows it.
std::vector<std::string> plan_words(const SessionReport& report);
// One HTML file in the language spoken: words, tables, plan, course of events. It has no scripts, fonts, picture files
// or network requests.
std::string report_page(const SessionReport& report);

// Reports on several sessions of one learner, the first session first: how each route developed, in words and tables,
// and each session.
std::vector<std::string> learner_words(std::span<const SessionReport> reports);
std::string learner_page(std::span<const SessionReport> reports);
// Such as "12 minutes" or "40 seconds".
std::string duration_words(double seconds);

// A row of the tables: one value for one task.
struct ResultRow {
    std::string learner, lesson, session, started_utc, task, measure;
    double value = 0.0;
    std::string unit;  // UCUM; "1" if there is no unit
    bool operator==(const ResultRow&) const = default;
};
// `learner` is the number, never the name. `task` is its place in the session, its kind and its name: "1 go Library".
std::vector<ResultRow> result_rows(std::span<const SessionReport> reports);

// RFC 4180 with a header line, UTF-8. Numbers are the shortest text that reads back unchanged.
std::string results_csv(std::span<const ResultRow> rows);
std::string results_json(std::span<const ResultRow> rows);
// Describes the columns of results.csv by CSV on the Web (W3C, Metadata Vocabulary for Tabular Data, 2015). `csv_name`
// is the file that it describes.
std::string results_metadata(const std::string& csv_name);
// Read the tables back. They fail with the line of the first mistake.
Result<std::vector<ResultRow>> read_results_csv(std::string_view text, const std::string& file);
Result<std::vector<ResultRow>> read_results_json(std::string_view text, const std::string& file);

}  // namespace handrail::report
