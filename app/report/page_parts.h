// What pages of reports are made of: head and style, headings, tables, values in words. Pure functions; any thread. All
// texts are given as they are, and marked up here.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "app/report/report_page.h"

namespace handrail {

// From the doctype to the page's one first heading; kPageEnd ends it.
std::string page_begin(const std::string& title);
inline constexpr std::string_view kTableEnd = "</tbody>\n</table>\n</div>\n";
inline constexpr std::string_view kPageEnd = "</main>\n</body>\n</html>\n";

std::string heading(std::string_view id, const std::string& text);
// A table up to its rows, which </tbody></table> ends; the first column heads its rows.
std::string table_head(const std::string& caption, std::initializer_list<std::string> columns);
std::string row_of(const std::string& head, std::initializer_list<std::string> cells);
// How one went, as a table of shares; empty where there is nothing to share.
std::string strategies_html(std::span<const ReportStrategy> strategies);

// Null: it is none that pages tell.
const ReportMeasureInfo* info_of(const std::string& key);
// With its unit.
std::string value_words(const ReportMeasureInfo& info, double value);
std::string task_words(const ReportTask& task);
// "3:05", from the start.
std::string clock_of(double seconds);

// The plan, the words for it, and what was touched most; nothing without a plan. id: of its parts, once on a page.
std::string plan_html(const SessionReport& report, std::string_view id);

}  // namespace handrail
