#include "worlds/base/result.h"

#include <fmt/format.h>

namespace handrail {
namespace {

std::string place(const std::string& file, int line, int column) {
    std::string text = file;
    const auto add = [&](const std::string& part) {
        if (!text.empty()) text += ", ";
        text += part;
    };
    if (line > 0) add(fmt::format("line {}", line));
    if (line > 0 && column > 0) add(fmt::format("column {}", column));
    if (!text.empty()) text += ": ";
    return text;
}

}  // namespace

std::string Error::sentence() const { return place(file, line, column) + message; }

std::string Diagnostic::sentence() const {
    std::string text = place(file, line, column) + (severity == Severity::Error ? "error: " : "warning: ") + message;
    if (!action.empty()) text += " " + action;
    return text;
}

}  // namespace handrail
