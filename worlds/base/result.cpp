#include "worlds/base/result.h"

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

std::string place(const std::string& file, int line, int column) {
    std::string where = file;
    const auto add = [&](const std::string& part) {
        if (!where.empty()) where += ", ";
        where += part;
    };
    if (line > 0) add(phrase("error.line", {{"line", line}}));
    if (line > 0 && column > 0) add(phrase("error.column", {{"column", column}}));
    if (!where.empty()) where += ": ";
    return where;
}

}  // namespace

std::string Error::sentence() const { return one_line(place(file, line, column) + message); }

std::string Diagnostic::sentence() const {
    std::string all =
        place(file, line, column) + phrase(severity == Severity::Error ? "error.error" : "error.warning") + message;
    if (!action.empty()) all += " " + action;
    return one_line(all);
}

}  // namespace handrail
