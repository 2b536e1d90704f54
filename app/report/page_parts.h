// Parts of report pages: head and style, headings, tables, values in words. Pure functions; any thread. Texts are
// passed as they are, and escaped here.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "app/report/report_page.h"

namespace handrail::report {

// From the doctype to the only first-level heading of the page; kPageEnd ends the page.
std::string page_begin(const std::string& title);
inline constexpr std::string_view kTableEnd = "</tbody>\n</table>\n</div>\n";
inline constexpr std::string_view kPageEnd = "</main>\n</body>\n</html>\n";

std::string heading(std::string_view id, const std::string& text);
// A table up to its rows, which end with </tbody></table>. The first column contains the row headings.
std::string table_head(const std::string& caption, std::initializer_list<std::string> columns);
std::string row_of(const std::string& head, std::initializer_list<std::string> cells);
// The exploration strategies as a table of shares; empty if there are none.
std::string strategies_html(std::span<const ReportStrategy> strategies);

// Null if the pages do not show this measure.
const ReportMeasureInfo* info_of(const std::string& key);
// The value with its unit.
std::string value_words(const ReportMeasureInfo& info, double value);
std::string task_words(const ReportTask& task);
// "3:05", counted from the start.
std::string clock_of(double seconds);

// The plan, its description in words, and what was touched most; empty without a plan. `id` identifies its parts and
// must be unique on the page.
std::string plan_html(const SessionReport& report, std::string_view id);

}  // namespace handrail::report
