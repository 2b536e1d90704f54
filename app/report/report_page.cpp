#include "app/report/report_page.h"

#include <algorithm>
#include <cmath>

#include "app/report/page_parts.h"
#include "worlds/base/language.h"
#include "worlds/base/markup.h"
#include "worlds/base/spoken_time.h"

namespace handrail {
namespace {

std::string measures_html(const SessionReport& report) {
    std::string html;
    for (const ReportTask& task : report.tasks) {
        std::string rows;
        for (const ReportMeasure& measure : task.measures) {
            const ReportMeasureInfo* info = info_of(measure.key);
            if (!info) continue;
            rows += row_of(phrase("report.measure_" + measure.key),
                           {value_words(*info, measure.value), phrase("report.means_" + measure.key)});
        }
        if (rows.empty()) continue;
        html += table_head(task_words(task), {phrase("report.column_what"), phrase("report.column_value"),
                                              phrase("report.column_means")});
        html += rows + "</tbody>\n</table>\n";
    }
    return html.empty() ? html : heading("numbers", phrase("report.numbers")) + html;
}

// Lines of the plan in tenths of a metre, north up. Its texts are hidden from screen readers, which else read them in
// the middle of the page; the words below say them in order.
std::string plan_svg(const SessionReport& report) {
    const Storey& storey = *report.storey;
    const auto x = [&](const Vec2& p) { return (p.x - storey.min_m.x) * 10.0; };
    const auto y = [&](const Vec2& p) { return (storey.max_m.y - p.y) * 10.0; };
    const double wide = x(storey.max_m), high = y(storey.min_m), letter = std::max(3.0, std::max(wide, high) / 45.0);
    std::string svg = fmt::format(
        "<svg role=\"img\" aria-labelledby=\"plan-name\" aria-describedby=\"plan-words\" viewBox=\"0 0 {:.1f} "
        "{:.1f}\">\n<title id=\"plan-name\">{}</title>\n<g class=\"wall\">\n",
        wide, high, markup_text(phrase("report.plan_title", {{"world", storey.world}, {"storey", storey.number}})));
    const auto path = [&](std::span<const Vec2> points) {
        std::string d;
        for (std::size_t i = 0; i < points.size(); ++i)
            d += fmt::format("{}{:.1f} {:.1f}", i == 0 ? 'M' : 'L', x(points[i]), y(points[i]));
        return d;
    };
    for (const PlanOutline& wall : storey.walls_m) svg += fmt::format("<path d=\"{}Z\"/>\n", path(wall));
    svg += "</g>\n<g class=\"wall\" stroke=\"currentColor\">\n";
    for (const auto& sheet : storey.sheets_m) svg += fmt::format("<path d=\"{}\"/>\n", path(sheet));
    svg += "</g>\n";
    const double stroke = letter / 4.0;
    for (const std::vector<Vec2>& way : report.ways_m)
        if (way.size() >= 2)
            svg += fmt::format("<path class=\"way\" stroke-width=\"{:.2f}\" d=\"{}\"/>\n", stroke, path(way));
    svg += fmt::format("<g aria-hidden=\"true\" text-anchor=\"middle\" font-size=\"{:.1f}\">\n", letter);
    for (const StoreyRoom& room : storey.rooms)
        svg += fmt::format("<text class=\"name\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x(room.middle_m),
                           y(room.middle_m), markup_text(capitalised(room.name)));
    for (std::size_t i = 0; i < report.contacts.size(); ++i) {
        const Vec2& at = report.contacts[i].place_m;
        svg += fmt::format(
            "<circle class=\"spot\" stroke-width=\"{:.2f}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/><text "
            "class=\"name\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
            stroke, x(at), y(at), letter, x(at), y(at) + 0.35 * letter, i + 1);
    }
    return svg + "</g>\n</svg>\n";
}

std::string plan_html(const SessionReport& report) {
    if (!report.storey) return {};
    std::string html = heading("plan", phrase("report.plan")) + plan_svg(report) + "<p id=\"plan-words\">";
    for (const std::string& sentence : plan_words(report)) html += markup_text(sentence) + " ";
    html += "</p>\n";
    if (report.contacts.empty()) return html;
    html += "<p>" + markup_text(phrase("report.contacts")) + "</p>\n<ol>\n";
    for (const ReportContact& contact : report.contacts)
        html += "<li>" +
                markup_text(phrase("report.contact", {{"name", capitalised(contact.name)}, {"count", contact.count}})) +
                "</li>\n";
    return html + "</ol>\n";
}

std::string notes_html(const SessionReport& report) {
    if (report.notes.empty()) return {};
    std::string html = heading("notes", phrase("report.notes"));
    html += table_head(phrase("report.notes_caption"), {phrase("report.column_time"), phrase("report.column_note")});
    for (const ReportEvent& note : report.notes) html += row_of(clock_of(note.at_s), {note.text});
    return html + "</tbody>\n</table>\n";
}

std::string course_html(const SessionReport& report) {
    if (report.course.empty()) return {};
    std::string html = heading("course", phrase("report.course"));
    html += table_head(phrase("report.course_caption"), {phrase("report.column_time"), phrase("report.column_said")});
    for (const ReportEvent& event : report.course) html += row_of(clock_of(event.at_s), {event.text});
    return html + "</tbody>\n</table>\n";
}

}  // namespace

std::string report_page(const SessionReport& report) {
    const std::string title =
        phrase("report.title", {{"session", report.session.empty() ? report.world : report.session}});
    std::string html = page_begin(title);
    std::string about;
    for (const auto& [key, value] :
         {std::pair{"report.about_learner", report.learner}, std::pair{"report.about_lesson", report.lesson},
          std::pair{"report.about_started", day_and_time_words(report.started_utc)}})
        if (!value.empty()) about += (about.empty() ? "" : " ") + phrase(key, {{"value", value}});
    if (!about.empty()) html += "<p>" + markup_text(about) + "</p>\n";
    html += heading("words", phrase("report.words"));
    html += "<ul>\n";
    for (const std::string& sentence : report_words(report)) html += "<li>" + markup_text(sentence) + "</li>\n";
    html += "</ul>\n";
    html += measures_html(report) + strategies_html(report.strategies) + plan_html(report) + notes_html(report) +
            course_html(report);
    return html + std::string(kPageEnd);
}

}  // namespace handrail
