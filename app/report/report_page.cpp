#include "app/report/report_page.h"

#include <algorithm>
#include <cmath>

#include "app/report/page_parts.h"
#include "worlds/base/language.h"
#include "worlds/base/markup.h"
#include "worlds/base/spoken_time.h"

namespace handrail::report {
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
        html += rows + std::string(kTableEnd);
    }
    return html.empty() ? html : heading("numbers", phrase("report.numbers")) + html;
}

std::string notes_html(const SessionReport& report) {
    if (report.notes.empty()) return {};
    std::string html = heading("notes", phrase("report.notes"));
    html += table_head(phrase("report.notes_caption"), {phrase("report.column_time"), phrase("report.column_note")});
    for (const ReportEvent& note : report.notes) html += row_of(clock_of(note.at_s), {note.text});
    return html + std::string(kTableEnd);
}

std::string course_html(const SessionReport& report) {
    if (report.course.empty()) return {};
    std::string html = heading("course", phrase("report.course"));
    html += table_head(phrase("report.course_caption"), {phrase("report.column_time"), phrase("report.column_said")});
    for (const ReportEvent& event : report.course) html += row_of(clock_of(event.at_s), {event.text});
    return html + std::string(kTableEnd);
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
    html += measures_html(report) + strategies_html(report.strategies) +
            (report.storey ? heading("plan", phrase("report.plan")) + plan_html(report, "plan") : std::string()) +
            notes_html(report) + course_html(report);
    return html + std::string(kPageEnd);
}

}  // namespace handrail::report
