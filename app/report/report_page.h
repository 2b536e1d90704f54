// Makes reports on a session for the learner and the instructor: a self-contained page, and tables for other programs.
// Pure functions over plain values; any thread. Lengths in metres, times in seconds, world axes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/plan/storey.h"

namespace handrail::report {

// A measure: its key in files, its unit (UCUM), and the number of decimals in the report.
struct ReportMeasureInfo {
    std::string_view key, unit;
    int decimals = 0;
};
// Returns all measures in the order of the table: "path_ratio", "time", "pauses" and so on. The texts
// `report.measure_KEY` and `report.means_KEY` name and explain the measure with this key.
std::span<const ReportMeasureInfo> report_measures();

struct ReportMeasure {
    std::string key;  // a key of report_measures(); the tables also contain measures with other keys, the page does not
    double value = 0.0;
};

enum class ReportTaskKind : std::uint8_t { Go, Learn, Free, Point, Distance, Order, Question };
struct ReportTask {
    ReportTaskKind kind = ReportTaskKind::Go;
    std::string name;             // the goal, the room to learn, or a question with its answer; may be empty
    std::optional<bool> reached;  // whether the goal was reached; only for tasks of the kind Go
    std::vector<ReportMeasure> measures;
};

// A strategy of exploration, with the key "perimeter", "grid", "object", "base", "mixed" or "none".
struct ReportStrategy {
    std::string key;
    double seconds = 0.0;
};

struct ReportEvent {
    double at_s = 0.0;
    std::string text;  // a sentence as it was announced, or a note
};

struct ReportContact {
    Vec2 place_m{0.0};
    std::string name;
    int count = 1;
};

struct SessionReport {
    std::string learner;     // the chosen name
    std::string learner_id;  // the learner's number, which files contain instead of the name
    std::string lesson, session;
    std::string started_utc;  // ISO 8601, such as "2026-11-22T17:30:00Z"
    std::string world;
    double seconds = 0.0;
    std::vector<ReportTask> tasks;
    std::vector<ReportStrategy> strategies;
    std::vector<ReportEvent> course;
    std::vector<ReportContact> contacts;  // the objects that were touched, the most frequent first
    std::vector<ReportEvent> notes;       // notes and actions of the instructor
    double walked_m = 0.0;
    std::vector<std::string> rooms;  // rooms through which the learner walked, in order
    // Where the walker went on the storey of the plan. A new piece begins whenever the walker returned to the storey,
    // or was moved to another place without walking.
    std::vector<std::vector<Vec2>> ways_m;
    std::optional<plan::Storey> storey;  // the storey of the plan; nothing: no plan is drawn
};

// Returns what went well and what did not, addressed to the learner, in short sentences without technical words.
std::vector<std::string> report_words(const SessionReport& report);
// Returns sentences that describe the learner's route through the rooms, as the plan shows it.
std::vector<std::string> plan_words(const SessionReport& report);
// Returns one HTML file in the spoken language, with words, tables, the plan and the course of events. The file
// contains no scripts, fonts, picture files or network requests.
std::string report_page(const SessionReport& report);

// These functions report on several sessions of one learner, in the order of time. They describe in words and tables
// how the measures of each route developed. The page also contains each session.
std::vector<std::string> learner_words(std::span<const SessionReport> reports);
std::string learner_page(std::span<const SessionReport> reports);
// Returns a duration in words, such as "12 minutes" or "40 seconds".
std::string duration_words(double seconds);

// A row of the tables: one value for one task.
struct ResultRow {
    std::string learner, lesson, session, started_utc, task, measure;
    double value = 0.0;
    std::string unit;  // unit (UCUM); "1" if the measure has no unit
    bool operator==(const ResultRow&) const = default;
};
// Returns the rows of the tables. `learner` in a row is the learner's number, never the name. `task` is the position in
// the session, the kind and the name, such as "1 go Library".
std::vector<ResultRow> result_rows(std::span<const SessionReport> reports);

// Return the tables as text. The CSV follows RFC 4180, with a header line, in UTF-8. Numbers are the shortest text that
// reads back unchanged.
std::string results_csv(std::span<const ResultRow> rows);
std::string results_json(std::span<const ResultRow> rows);
// Returns a description of the columns of results.csv in the format CSV on the Web (W3C, Metadata Vocabulary for
// Tabular Data, 2015). `csv_name` is the name of the described file.
std::string results_metadata(const std::string& csv_name);
// Read tables that results_csv and results_json wrote. They fail with the line of the first mistake.
Result<std::vector<ResultRow>> read_results_csv(std::string_view text, const std::string& file);
Result<std::vector<ResultRow>> read_results_json(std::string_view text, const std::string& file);

}  // namespace handrail::report
