#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report/report_page.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;
constexpr std::array kColumns{"learner", "lesson", "session", "started", "task", "measure", "value", "unit"};

std::string kind_word(ReportTaskKind kind) {
    constexpr std::array kWords{"go", "learn", "free", "point", "distance", "order", "ask"};
    return kWords[static_cast<std::size_t>(kind)];
}

// Returns the shortest text that reads back as exactly `value`.
std::string number_text(double value) {
    std::array<char, 40> text{};
    const auto done = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), done.ptr};
}

std::string cell_of(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}

// Returns the cells of the record that begins at `at`. Moves `at` behind that record, and adds the record's number of
// lines to `line`. Returns nothing if a quote is not closed.
std::optional<std::vector<std::string>> record_of(std::string_view text, std::size_t& at, int& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    while (at < text.size()) {
        const char c = text[at++];
        if (c == '\n') ++line;
        if (quoted) {
            if (c != '"') cells.back() += c;
            else if (at < text.size() && text[at] == '"') cells.back() += text[at++];
            else quoted = false;
        } else if (c == '"' && cells.back().empty()) quoted = true;
        else if (c == ',') cells.emplace_back();
        else if (c == '\r' && at < text.size() && text[at] == '\n') continue;
        else if (c == '\n') return cells;
        else cells.back() += c;
    }
    if (quoted) return std::nullopt;
    return cells;
}

}  // namespace

std::vector<ResultRow> result_rows(std::span<const SessionReport> reports) {
    std::vector<ResultRow> rows;
    for (const SessionReport& report : reports) {
        const auto add = [&](const std::string& task, std::string_view measure, double value, std::string_view unit) {
            if (std::isfinite(value))
                rows.push_back({report.learner_id, report.lesson, report.session, report.started_utc, task,
                                std::string(measure), value, std::string(unit)});
        };
        int number = 0;
        for (const ReportTask& task : report.tasks) {
            const std::string name =
                std::to_string(++number) + " " + kind_word(task.kind) + (task.name.empty() ? "" : " " + task.name);
            if (task.reached) add(name, "reached", *task.reached ? 1.0 : 0.0, "1");
            for (const ReportMeasure& measure : task.measures) {
                std::string_view unit = "1";
                for (const ReportMeasureInfo& info : report_measures())
                    if (info.key == measure.key) unit = info.unit;
                add(name, measure.key, measure.value, unit);
            }
        }
        for (const ReportStrategy& strategy : report.strategies)
            add("session", "strategy_" + strategy.key, strategy.seconds, "s");
    }
    return rows;
}

std::string results_csv(std::span<const ResultRow> rows) {
    std::string csv = fmt::format("{}\r\n", fmt::join(kColumns, ","));
    for (const ResultRow& row : rows) {
        for (const std::string* text :
             {&row.learner, &row.lesson, &row.session, &row.started_utc, &row.task, &row.measure})
            csv += cell_of(*text) + ",";
        csv += number_text(row.value) + "," + cell_of(row.unit) + "\r\n";
    }
    return csv;
}

std::string results_json(std::span<const ResultRow> rows) {
    Json all = Json::array();
    for (const ResultRow& row : rows)
        all.push_back({{"learner", row.learner},
                       {"lesson", row.lesson},
                       {"session", row.session},
                       {"started", row.started_utc},
                       {"task", row.task},
                       {"measure", row.measure},
                       {"value", row.value},
                       {"unit", row.unit}});
    return Json{{"schema", kSchema}, {"results", std::move(all)}}.dump(2, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

std::string results_metadata(const std::string& csv_name) {
    Json columns = Json::array();
    for (const char* name : kColumns) {
        const std::string column = name;
        Json one{{"name", column}, {"titles", column}, {"dc:description", phrase("report.csv_" + column)}};
        one["datatype"] = column == "value" ? "double" : column == "started" ? "dateTime" : "string";
        columns.push_back(std::move(one));
    }
    const Json all{{"@context", Json::array({"http://www.w3.org/ns/csvw", {{"@language", spoken_language()}}})},
                   {"url", csv_name},
                   {"dialect", {{"encoding", "utf-8"}, {"header", true}, {"delimiter", ","}}},
                   {"tableSchema", {{"columns", std::move(columns)}}}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<std::vector<ResultRow>> read_results_csv(std::string_view text, const std::string& file) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::vector<ResultRow> rows;
    int line = 1;
    std::size_t at = 0;
    for (bool head = true; at < text.size(); head = false) {
        const int began = line;
        const auto cells = record_of(text, at, line);
        if (!cells) return fail(phrase("report.csv_quote"), file, began);
        if (head) {
            if (!std::equal(cells->begin(), cells->end(), kColumns.begin(), kColumns.end()))
                return fail(phrase("report.csv_head"), file, began);
            continue;
        }
        if (cells->size() != kColumns.size())
            return fail(phrase("report.csv_cells", {{"count", cells->size()}}), file, began);
        ResultRow row{(*cells)[0], (*cells)[1], (*cells)[2], (*cells)[3], (*cells)[4], (*cells)[5], 0.0, (*cells)[7]};
        if (!parse_finite((*cells)[6], row.value))
            return fail(phrase("report.csv_number", {{"text", (*cells)[6]}}), file, began);
        rows.push_back(std::move(row));
    }
    if (text.empty()) return fail(phrase("report.csv_head"), file, 1);
    return rows;
}

Result<std::vector<ResultRow>> read_results_json(std::string_view text, const std::string& file) {
    const Json all = Json::parse(text, nullptr, false);
    if (!all.is_object() || all.value("schema", Json()) != kSchema || !all.contains("results") ||
        !all["results"].is_array())
        return fail(phrase("report.json_damaged"), file);
    std::vector<ResultRow> rows;
    for (const Json& one : all["results"]) {
        for (const char* name : kColumns) {
            const bool number = std::string_view(name) == "value";
            if (!one.is_object() || !one.contains(name) || (number ? !one[name].is_number() : !one[name].is_string()))
                return fail(phrase("report.json_row", {{"number", rows.size() + 1}, {"name", name}}), file);
        }
        rows.push_back({one["learner"], one["lesson"], one["session"], one["started"], one["task"], one["measure"],
                        one["value"], one["unit"]});
    }
    return rows;
}

}  // namespace handrail::report
