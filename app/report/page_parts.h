// Makes parts of report pages: head and style, headings, tables, and values in words. Pure functions; any thread. Pass
// unescaped texts, because these functions escape them.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "app/report/report_page.h"

namespace handrail::report {

// Returns the beginning of the page, from the doctype to the only first-level heading. kPageEnd ends the page.
std::string page_begin(const std::string& title);
inline constexpr std::string_view kTableEnd = "</tbody>\n</table>\n</div>\n";
inline constexpr std::string_view kPageEnd = "</main>\n</body>\n</html>\n";

std::string heading(std::string_view id, const std::string& text);
// Returns the beginning of a table, up to the first row. kTableEnd ends the rows and the table. The first column
// contains the row headings.
std::string table_head(const std::string& caption, std::initializer_list<std::string> columns);
std::string row_of(const std::string& head, std::initializer_list<std::string> cells);
// Returns a table with the share of each exploration strategy; empty if there are none.
std::string strategies_html(std::span<const ReportStrategy> strategies);

// Returns the description of a measure; null if the pages do not show it.
const ReportMeasureInfo* info_of(const std::string& key);
// Returns the value with its unit.
std::string value_words(const ReportMeasureInfo& info, double value);
std::string task_words(const ReportTask& task);
// Returns the time since the start of the session as text, such as "3:05".
std::string clock_of(double seconds);

// Returns the plan, its description in words, and the most frequently touched objects. Returns an empty text if the
// report has no plan. `id` is part of the identifiers in this HTML and must be unique on the page.
std::string plan_html(const SessionReport& report, std::string_view id);

}  // namespace handrail::report
