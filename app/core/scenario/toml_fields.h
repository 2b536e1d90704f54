// Reads TOML that people have written. The calling code requests the fields of a table one after the other, and each
// mistake in the file becomes one sentence with its line. The readers of scenarios and lessons use it. Any thread may
// call it.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "settings/toml_value.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/base/vec.h"

namespace handrail::core {

// Thrown by functions that read a table. The reader of the file turns it into a Result.
struct BadField {
    int line;
    std::string message;
};

// Reads the fields of a table. If the table contains a key that was not requested before done() is called, that is a
// mistake in the file.
class TomlFields {
public:
    TomlFields(const settings::TomlValue& table, std::string what) : table_(table), what_(std::move(what)) {}
    int line() const { return table_.line; }
    bool has(const char* key) {
        queried_.insert(key);
        return table_.find(key) != nullptr;
    }
    double number(const char* key, double low, double high) {
        const settings::TomlValue& node = need(key);
        const auto value = node.number();
        if (!value || !(*value >= low && *value <= high))
            throw BadField{node.line, phrase("scenario.number", {{"key", key},
                                                                 {"least", fmt::format("{}", low)},
                                                                 {"most", fmt::format("{}", high)}})};
        return *value;
    }
    double number_or(const char* key, double otherwise, double low, double high) {
        return has(key) ? number(key, low, high) : otherwise;
    }
    std::string text(const char* key) {
        const settings::TomlValue& node = need(key);
        if (!node.text() || node.text()->empty()) throw BadField{node.line, phrase("scenario.text", {{"key", key}})};
        return *node.text();
    }
    bool flag(const char* key) {
        const settings::TomlValue& node = need(key);
        if (!node.flag()) throw BadField{node.line, phrase("scenario.flag", {{"key", key}})};
        return *node.flag();
    }
    // Reads three numbers. If `allow_any` is true, the text "any" may replace a number and becomes NaN.
    Vec3 vector(const char* key, bool allow_any = false) {
        const settings::TomlValue::Array* list = need(key).array();
        if (!list || list->size() != 3) throw BadField{need(key).line, phrase("scenario.three", {{"key", key}})};
        Vec3 v{0.0};
        for (int i = 0; i < 3; ++i) {
            const settings::TomlValue& node = (*list)[static_cast<std::size_t>(i)];
            const auto number = node.number();
            if (allow_any && node.text() && *node.text() == "any") v[i] = std::numeric_limits<double>::quiet_NaN();
            else if (number && std::isfinite(*number)) v[i] = *number;
            else throw BadField{node.line, phrase("scenario.three_finite", {{"key", key}})};
        }
        return v;
    }
    std::array<double, 2> range(const char* key) {
        const settings::TomlValue::Array* list = need(key).array();
        if (!list || list->size() != 2 || !list->front().number() || !list->back().number())
            throw BadField{need(key).line, phrase("scenario.two", {{"key", key}})};
        const std::array<double, 2> r{*list->front().number(), *list->back().number()};
        if (!(r[0] <= r[1])) throw BadField{need(key).line, phrase("scenario.lower_first", {{"key", key}})};
        return r;
    }
    const settings::TomlValue& node(const char* key) { return need(key); }
    void done() const {
        std::vector<std::string> known(queried_.begin(), queried_.end());
        for (const auto& [key, node] : *table_.table())
            if (!queried_.contains(key))
                throw BadField{
                    node.line,
                    phrase("scenario.has_no", {{"what", what_}, {"key", key}, {"nearest", nearest_name(key, known)}})};
    }

private:
    const settings::TomlValue& need(const char* key) {
        queried_.insert(key);
        const settings::TomlValue* node = table_.find(key);
        if (!node) throw BadField{table_.line, phrase("scenario.needs", {{"what", what_}, {"key", key}})};
        return *node;
    }
    const settings::TomlValue& table_;  // the value must be a table
    std::string what_;
    std::set<std::string> queried_;
};

}  // namespace handrail::core
