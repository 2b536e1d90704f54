#include "settings/toml_value.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "settings/parse_toml.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/overloaded.h"

namespace handrail::settings {
namespace {

TomlMoment moment_of(const toml::date* date, const toml::time* time, const toml::time_offset* offset) {
    TomlMoment moment;
    if (date) {
        moment.has_date = true;
        moment.year = date->year;
        moment.month = date->month;
        moment.day = date->day;
    }
    if (time) {
        moment.has_time = true;
        moment.hour = time->hour;
        moment.minute = time->minute;
        moment.second = time->second;
        moment.nanosecond = time->nanosecond;
    }
    if (offset) {
        moment.has_offset = true;
        moment.offset_minutes = offset->minutes;
    }
    return moment;
}

// Thrown for values that are nested deeper than kDeepestToml. toml++ limits the nesting of brackets, but not the number
// of parts of a dotted key.
struct TooDeep {
    int line;
};

TomlValue value_of(const toml::node& node, int depth) {
    if (depth > kDeepestToml) throw TooDeep{static_cast<int>(node.source().begin.line)};
    TomlValue made;
    made.line = static_cast<std::int32_t>(node.source().begin.line);
    made.column = static_cast<std::int32_t>(node.source().begin.column);
    if (const auto* flag = node.as_boolean()) {
        made.value = flag->get();
    } else if (const auto* whole = node.as_integer()) {
        made.value = whole->get();
    } else if (const auto* fraction = node.as_floating_point()) {
        made.value = fraction->get();
    } else if (const auto* text = node.as_string()) {
        made.value = text->get();
    } else if (const auto* date = node.as_date()) {
        made.value = moment_of(&date->get(), nullptr, nullptr);
    } else if (const auto* time = node.as_time()) {
        made.value = moment_of(nullptr, &time->get(), nullptr);
    } else if (const auto* both = node.as_date_time()) {
        const toml::date_time& v = both->get();
        made.value = moment_of(&v.date, &v.time, v.offset ? &*v.offset : nullptr);
    } else if (const toml::array* list = node.as_array()) {
        TomlValue::Array items;
        items.reserve(list->size());
        for (const toml::node& item : *list) items.push_back(value_of(item, depth + 1));
        made.value = std::move(items);
    } else if (const toml::table* table = node.as_table()) {
        TomlValue::Table members;
        members.reserve(table->size());
        for (const auto& [key, member] : *table)
            members.push_back({std::string(key.str()), value_of(member, depth + 1)});
        made.value = std::move(members);
        made.in_line = table->is_inline();
    }
    return made;
}

toml::array array_of(const TomlValue::Array& items);
toml::table table_of(const TomlValue& value);

// Converts the value to the type that toml++ uses for it, and calls `add` with the result.
template <class Add>
void add_node(const TomlValue& value, const Add& add) {
    std::visit(
        Overloaded{[&](const TomlMoment& v) {
                       const toml::date date(v.year, v.month, v.day);
                       const toml::time time(v.hour, v.minute, v.second, v.nanosecond);
                       if (!v.has_time) return add(date);
                       if (!v.has_date) return add(time);
                       toml::date_time both(date, time);
                       if (v.has_offset) {
                           both.offset.emplace();
                           both.offset->minutes = v.offset_minutes;
                       }
                       add(both);
                   },
                   [&](const TomlValue::Array& items) { add(array_of(items)); },
                   [&](const TomlValue::Table&) { add(table_of(value)); }, [&](const auto& plain) { add(plain); }},
        value.value);
}

toml::array array_of(const TomlValue::Array& items) {
    toml::array list;
    for (const TomlValue& item : items) add_node(item, [&](auto&& node) { list.push_back(std::move(node)); });
    return list;
}

toml::table table_of(const TomlValue& value) {
    toml::table table;
    for (const TomlMember& member : *value.table())
        add_node(member.value, [&](auto&& node) { table.insert_or_assign(member.key, std::move(node)); });
    table.is_inline(value.in_line);
    return table;
}

template <class Members>
auto place_of_key(Members& members, std::string_view key) {
    const auto before = [](const TomlMember& member, std::string_view than) { return member.key.compare(than) < 0; };
    return std::lower_bound(members.begin(), members.end(), key, before);
}

}  // namespace

TomlValue TomlValue::empty_table() {
    TomlValue table;
    table.value = Table{};
    return table;
}

std::optional<double> TomlValue::number() const {
    if (const auto* v = whole()) return static_cast<double>(*v);
    if (const auto* v = fraction()) return *v;
    return std::nullopt;
}

bool TomlValue::is_tables() const {
    const Array* list = array();
    return list && !list->empty() &&
           std::all_of(list->begin(), list->end(), [](const TomlValue& item) { return item.table() != nullptr; });
}

const TomlValue* TomlValue::find(std::string_view key) const {
    const Table* members = table();
    if (!members) return nullptr;
    const auto at = place_of_key(*members, key);
    return at == members->end() || at->key != key ? nullptr : &at->value;
}

void TomlValue::set(std::string_view key, TomlValue to) {
    auto* members = std::get_if<Table>(&value);
    contract_pre(members != nullptr);
    const auto at = place_of_key(*members, key);
    if (at != members->end() && at->key == key) at->value = std::move(to);
    else members->insert(at, {std::string(key), std::move(to)});
}

void TomlValue::erase(std::string_view key) {
    auto* members = std::get_if<Table>(&value);
    contract_pre(members != nullptr);
    const auto at = place_of_key(*members, key);
    if (at != members->end() && at->key == key) members->erase(at);
}

bool operator==(const TomlMember& a, const TomlMember& b) { return a.key == b.key && a.value == b.value; }

bool operator==(const TomlValue& a, const TomlValue& b) {
    const auto *x = a.fraction(), *y = b.fraction();
    if (x && y && std::isnan(*x) && std::isnan(*y)) return true;
    return a.value == b.value;
}

Result<TomlValue> toml_of(const std::string& text) {
    try {
        return value_of(parse_toml(text), 1);
    } catch (const toml::parse_error& error) {
        const toml::source_position& at = error.source().begin;
        return fail(std::string(error.description()), {}, std::max(1, static_cast<int>(at.line)),
                    static_cast<int>(at.column));
    } catch (const TooDeep& place) {
        return fail(phrase("settings_file.too_deep"), {}, std::max(1, place.line));
    }
}

std::string written_toml(const TomlValue& table) {
    contract_pre(table.table() != nullptr);
    std::ostringstream out;
    out.exceptions(std::ios::badbit);  // without exceptions, a lack of memory would cut the text short unnoticed
    out << toml::toml_formatter{table_of(table), toml::format_flags::none};
    return out.str();
}

}  // namespace handrail::settings
