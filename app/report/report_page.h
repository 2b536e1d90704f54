// What a session was like, for the one who learns and for whoever teaches: a page that needs nothing but itself, and
// tables that other programs read. Made of plain values; pure functions; any thread. Lengths in metres, times in
// seconds, world axes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/plan/storey.h"

namespace handrail {

// What can be measured: the key that files know it by, its unit (UCUM), and how many decimals a person is told.
struct ReportMeasureInfo {
    std::string_view key, unit;
    int decimals = 0;
};
// "path_ratio", "time", "pauses", ...: all, in the order of the table. Their words are the texts `report.measure_KEY`
// and `report.means_KEY`.
std::span<const ReportMeasureInfo> report_measures();

struct ReportMeasure {
    std::string key;  // of report_measures; others are left out of the page, and kept in the tables
    double value = 0.0;
};

enum class ReportTaskKind : std::uint8_t { Go, Learn, Free, Point, Distance, Order, Ask };
struct ReportTask {
    ReportTaskKind kind = ReportTaskKind::Go;
    std::string name;             // what is gone to or learnt, or a question with its answer; may be empty
    std::optional<bool> reached;  // of Go
    std::vector<ReportMeasure> measures;
};

// How one went about it: "perimeter", "grid", "object", "base", "mixed", "none".
struct ReportStrategy {
    std::string key;
    double seconds = 0.0;
};

struct ReportEvent {
    double at_s = 0.0;
    std::string text;  // a sentence, as it was said
};

struct ReportContact {
    Vec2 place_m{0.0};
    std::string name;
    int count = 1;
};

struct SessionReport {
    std::string learner;     // chosen name
    std::string learner_id;  // the number that files know the learner by
    std::string lesson, session;
    std::string started_utc;  // ISO 8601: "2026-11-22T17:30:00Z"
    std::string world;
    double seconds = 0.0;
    std::vector<ReportTask> tasks;
    std::vector<ReportStrategy> strategies;
    std::vector<ReportEvent> course;
    std::vector<ReportContact> contacts;  // the most frequent first
    std::vector<ReportEvent> notes;       // what whoever taught noted and did
    double walked_m = 0.0;
    std::vector<std::string> rooms;  // walked through, in order
    // Where the body walked on the storey of the plan. A new piece begins where it came back to it or was put.
    std::vector<std::vector<Vec2>> ways_m;
    std::optional<Storey> storey;  // none: no plan is drawn
};

// What went well and what did not, to the learner, in short sentences without a technical word.
std::vector<std::string> report_words(const SessionReport& report);
// The way through the rooms in sentences: what the plan shows.
std::vector<std::string> plan_words(const SessionReport& report);
// One HTML file in the language spoken: words, tables, plan, course. No script, no font, no picture file, no request.
std::string report_page(const SessionReport& report);

// Of one learner over several sessions, the first one first: what became of each way, in words and tables, and what
// each session was like.
std::vector<std::string> learner_words(std::span<const SessionReport> reports);
std::string learner_page(std::span<const SessionReport> reports);
// "12 minutes", "40 seconds".
std::string duration_words(double seconds);

// A row of the tables: one value of one task.
struct ResultRow {
    std::string learner, lesson, session, started_utc, task, measure;
    double value = 0.0;
    std::string unit;  // UCUM; "1" for what has none
    bool operator==(const ResultRow&) const = default;
};
// The learner is the number, never the name. A task is its kind, with its place in the session: "1 go Library".
std::vector<ResultRow> result_rows(std::span<const SessionReport> reports);

// RFC 4180 with a head, UTF-8; numbers as the shortest text that reads back the same.
std::string results_csv(std::span<const ResultRow> rows);
std::string results_json(std::span<const ResultRow> rows);
// What the columns of results.csv mean, by CSV on the Web (W3C, Metadata Vocabulary for Tabular Data, 2015); `csv_name`
// is the file it speaks of.
std::string results_metadata(const std::string& csv_name);
// They read back. Fail with the line of the first thing that is wrong.
Result<std::vector<ResultRow>> read_results_csv(std::string_view text, const std::string& file);
Result<std::vector<ResultRow>> read_results_json(std::string_view text, const std::string& file);

}  // namespace handrail
