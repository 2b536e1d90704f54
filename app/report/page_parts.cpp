#include "app/report/page_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "worlds/base/language.h"
#include "worlds/base/markup.h"

namespace handrail::report {
namespace {

// Light and dark colours of text, links, headings, plan lines and the route. Each colour has a contrast of at least 4.5
// to 1 on its background; the tests compute this contrast.
constexpr std::string_view kStyle =
    R"(:root{color-scheme:light dark;--paper:#fff;--ink:#16181d;--soft:#4a4f59;--line:#6b7280;--way:#9a1f1f}
@media(prefers-color-scheme:dark){:root{--paper:#14161a;--ink:#f1f2f4;--soft:#c3c8d0;--line:#9aa1ad;--way:#ff9b8f}}
body{background:var(--paper);color:var(--ink);font:1.1rem/1.5 sans-serif;max-width:46rem;
margin:0 auto;padding:1rem;overflow-wrap:break-word}
h1{font-size:1.6rem}h2{font-size:1.25rem;margin-top:2rem}
table{border-collapse:collapse;width:100%}caption{text-align:left;color:var(--soft)}
th,td{text-align:left;vertical-align:top;padding:.3rem .5rem;border-bottom:1px solid var(--line)}
.wide{overflow-x:auto}@media(max-width:30rem){table{font-size:.9rem}th,td{padding:.3rem .25rem}}
svg{width:100%;height:auto;max-height:80vh}
.wall{fill:var(--ink)}.way{fill:none;stroke:var(--way)}.spot{fill:var(--paper);stroke:var(--way)}.name{fill:var(--ink)}
@media print{:root{--paper:#fff;--ink:#000;--soft:#333;--line:#555;--way:#7a1414}table,svg{break-inside:avoid}})";

std::string number_words(double value, int decimals) {
    return decimals == 0 ? phrase("report.whole", {{"value", std::lround(value)}})
                         : phrase("report.decimal", {{"value", value}});
}

}  // namespace

const ReportMeasureInfo* info_of(const std::string& key) {
    for (const ReportMeasureInfo& info : report_measures())
        if (info.key == key) return &info;
    return nullptr;
}

std::string value_words(const ReportMeasureInfo& info, double value) {
    if (!std::isfinite(value)) return phrase("report.none");
    std::string number = number_words(value, info.decimals);
    if (info.unit == "s") return phrase("report.in_seconds", {{"value", number}});
    if (info.unit == "%") return phrase("report.in_percent", {{"value", number}});
    if (info.unit == "deg") return phrase("report.in_degrees", {{"value", number}});
    return number;
}

std::string task_words(const ReportTask& task) {
    constexpr std::array kTasks{"report.task_go", "report.task_learn", "report.task_free", "report.task_point",
                                // in the order of ReportTaskKind
                                "report.task_distance", "report.task_order", "report.task_ask"};
    return phrase(kTasks.at(static_cast<std::size_t>(task.kind)), {{"name", task.name}});
}

// Returns the number of seconds in minutes and seconds, such as "3:05".
std::string clock_of(double seconds) {
    const long whole = std::lround(std::clamp(seconds, 0.0, 1e7));
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string heading(std::string_view id, const std::string& text) {
    return fmt::format("<h2 id=\"{}\">{}</h2>\n", id, markup_text(text));
}

std::string table_head(const std::string& caption, std::initializer_list<std::string> columns) {
    std::string html = fmt::format(
        "<div class=\"wide\" role=\"group\" tabindex=\"0\" "
        "aria-label=\"{}\">\n<table>\n<caption>{}</caption>\n<thead><tr>",
        markup_text(caption), markup_text(caption));
    for (const std::string& column : columns) html += fmt::format("<th scope=\"col\">{}</th>", markup_text(column));
    return html + "</tr></thead>\n<tbody>\n";
}

std::string row_of(const std::string& head, std::initializer_list<std::string> cells) {
    std::string html = fmt::format("<tr><th scope=\"row\">{}</th>", markup_text(head));
    for (const std::string& cell : cells) html += fmt::format("<td>{}</td>", markup_text(cell));
    return html + "</tr>\n";
}

std::string strategies_html(std::span<const ReportStrategy> strategies) {
    double all_s = 0.0;
    for (const ReportStrategy& strategy : strategies) all_s += strategy.seconds;
    if (!(all_s > 0.0)) return {};
    std::string html = heading("strategies", phrase("report.strategies"));
    html +=
        table_head(phrase("report.strategies_caption"),
                   {phrase("report.column_strategy"), phrase("report.column_share"), phrase("report.column_means")});
    for (const ReportStrategy& strategy : strategies) {
        if (!has_phrase("report.strategy_" + strategy.key)) continue;
        const long percent = std::lround(100.0 * strategy.seconds / all_s);
        html += row_of(phrase("report.strategy_" + strategy.key),
                       {phrase("report.in_percent", {{"value", number_words(static_cast<double>(percent), 0)}}),
                        phrase("report.strategy_means_" + strategy.key)});
    }
    return html + std::string(kTableEnd);
}

std::string page_begin(const std::string& title) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\">\n<meta http-equiv=\"Content-Security-Policy\" "
        "content=\"default-src 'none'; style-src "
        "'unsafe-inline'\">\n<title>{}</title>\n<style>\n{}\n</style>\n</head>\n"
        "<body>\n<main>\n<h1>{}</h1>\n",
        markup_text(spoken_language()), markup_text(title), kStyle, markup_text(title));
}

}  // namespace handrail::report
