// Reading TOML that people write, so that the reading code can be a list of what is wanted: each mistake is one
// sentence with its line. For readers of scenarios and lessons only, which link the TOML library. Any thread.
#pragma once

#include <fmt/format.h>

#include <toml++/toml.h>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/base/vec.h"

namespace handrail {

// Thrown by what reads a table, and turned into a Result by the reader of the file.
struct BadField {
    int line;
    std::string message;
};

inline int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

// A table whose every key must be asked for by the time done() is called.
class TomlFields {
public:
    TomlFields(const toml::table& table, std::string what) : table_(table), what_(std::move(what)) {}
    int line() const { return line_of(table_); }
    bool has(const char* key) {
        asked_.insert(key);
        return table_.contains(key);
    }
    double number(const char* key, double low, double high) {
        const toml::node& node = need(key);
        const auto value = node.value<double>();
        if (!value || !(node.is_number()) || !(*value >= low && *value <= high))
            throw BadField{line_of(node), phrase("scenario.number", {{"key", key},
                                                                     {"least", fmt::format("{}", low)},
                                                                     {"most", fmt::format("{}", high)}})};
        return *value;
    }
    double number_or(const char* key, double otherwise, double low, double high) {
        return has(key) ? number(key, low, high) : otherwise;
    }
    std::string text(const char* key) {
        const toml::node& node = need(key);
        if (!node.is_string() || node.value<std::string>()->empty())
            throw BadField{line_of(node), phrase("scenario.text", {{"key", key}})};
        return *node.value<std::string>();
    }
    bool flag(const char* key) {
        const toml::node& node = need(key);
        if (!node.is_boolean()) throw BadField{line_of(node), phrase("scenario.flag", {{"key", key}})};
        return *node.value<bool>();
    }
    // Three numbers; `any` is written "any" and becomes NaN where allowed.
    Vec3 vector(const char* key, bool allow_any = false) {
        const toml::array* list = need(key).as_array();
        if (!list || list->size() != 3) throw BadField{line_of(need(key)), phrase("scenario.three", {{"key", key}})};
        Vec3 v{0.0};
        for (int i = 0; i < 3; ++i) {
            const toml::node& node = *list->get(static_cast<std::size_t>(i));
            if (allow_any && node.is_string() && *node.value<std::string>() == "any")
                v[i] = std::numeric_limits<double>::quiet_NaN();
            else if (node.is_number() && std::isfinite(*node.value<double>())) v[i] = *node.value<double>();
            else throw BadField{line_of(node), phrase("scenario.three_finite", {{"key", key}})};
        }
        return v;
    }
    std::array<double, 2> range(const char* key) {
        const toml::array* list = need(key).as_array();
        if (!list || list->size() != 2 || !list->get(0)->is_number() || !list->get(1)->is_number())
            throw BadField{line_of(need(key)), phrase("scenario.two", {{"key", key}})};
        const std::array<double, 2> r{*list->get(0)->value<double>(), *list->get(1)->value<double>()};
        if (!(r[0] <= r[1])) throw BadField{line_of(*list), phrase("scenario.lower_first", {{"key", key}})};
        return r;
    }
    const toml::node& node(const char* key) { return need(key); }
    void done() const {
        std::vector<std::string> known(asked_.begin(), asked_.end());
        for (const auto& [key, node] : table_)
            if (!asked_.contains(std::string(key.str())))
                throw BadField{line_of(node), phrase("scenario.has_no", {{"what", what_},
                                                                         {"key", key.str()},
                                                                         {"nearest", nearest_name(key.str(), known)}})};
    }

private:
    const toml::node& need(const char* key) {
        asked_.insert(key);
        const toml::node* node = table_.get(key);
        if (!node) throw BadField{line_of(table_), phrase("scenario.needs", {{"what", what_}, {"key", key}})};
        return *node;
    }
    const toml::table& table_;
    std::string what_;
    std::set<std::string> asked_;
};

}  // namespace handrail
