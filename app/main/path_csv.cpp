#include "app/main/path_csv.h"

#include <array>
#include <cmath>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::program {
namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

// Parses a number. Accepts `nan` and `inf`, because a device with a fault may have written them.
bool parse_cell(std::string_view cell, double& value) {
    cell = trimmed(cell);
    const auto taken = take_number(cell);
    if (!taken || !cell.empty()) return false;
    value = taken->value;
    return true;
}

std::vector<std::string_view> cells_of(std::string_view line) {
    std::vector<std::string_view> cells;
    for (;;) {
        const std::size_t comma = line.find(',');
        cells.push_back(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos) return cells;
        line.remove_prefix(comma + 1);
    }
}

}  // namespace

Result<std::vector<PathRow>> parse_path(std::string_view text, const std::string& file) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::vector<PathRow> rows;
    bool has_header = false;
    for (int line_number = 1; !text.empty(); ++line_number) {
        const std::size_t end = text.find('\n');
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (line.empty()) continue;
        const std::vector<std::string_view> cells = cells_of(line);
        if (!has_header) {
            if (cells != std::vector<std::string_view>{"t", "x", "y", "z"})
                return fail(phrase("program.path_no_head"), file, line_number);
            has_header = true;
            continue;
        }
        if (cells.size() != 4) return fail(phrase("program.path_cells", {{"count", cells.size()}}), file, line_number);
        std::array<double, 4> numbers{};
        for (std::size_t i = 0; i < 4; ++i)
            if (!parse_cell(cells[i], numbers[i]))
                return fail(phrase("program.path_no_number", {{"text", cells[i]}}), file, line_number);
        if (!std::isfinite(numbers[0])) return fail(phrase("program.path_not_finite"), file, line_number);
        if (!rows.empty() && !(numbers[0] > rows.back().t_s))
            return fail(phrase("program.path_time"), file, line_number);
        rows.push_back({numbers[0], {numbers[1], numbers[2], numbers[3]}});
    }
    if (!has_header) return fail(phrase("program.path_empty"), file, 1);
    return rows;
}

}  // namespace handrail::program
