// A TOML file as plain values, each with the line where it is in the file. What reads TOML works on these and includes
// nothing of toml++, so that the file itself can be parsed in another process (app/import/toml_apart.h). Any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"
#include "worlds/base/variant.h"

namespace handrail {

// A date, a time of day, or both.
struct TomlMoment {
    bool has_date = false, has_time = false, has_offset = false;
    std::uint16_t year = 0;
    std::uint8_t month = 0, day = 0, hour = 0, minute = 0, second = 0;
    std::uint32_t nanosecond = 0;
    std::int16_t offset_minutes = 0;  // from UTC
    bool operator==(const TomlMoment&) const = default;
};

struct TomlMember;

struct TomlValue {
    using Array = std::vector<TomlValue>;
    using Table = std::vector<TomlMember>;  // each key once, in their order

    CopyableVariant<bool, std::int64_t, double, std::string, TomlMoment, Array, Table> value;
    std::int32_t line = 0, column = 0;  // 0: from no file
    bool in_line = false;               // a table that is written in braces

    static TomlValue empty_table();

    // Null if it is of another kind.
    const bool* flag() const { return std::get_if<bool>(&value); }
    const std::int64_t* whole() const { return std::get_if<std::int64_t>(&value); }
    const double* fraction() const { return std::get_if<double>(&value); }
    const std::string* text() const { return std::get_if<std::string>(&value); }
    const Array* array() const { return std::get_if<Array>(&value); }
    const Table* table() const { return std::get_if<Table>(&value); }
    std::optional<double> number() const;  // whole or not
    bool is_tables() const;                // an array of one table or more, and of nothing else

    // Of a table; null if there is none of that name, or this is no table.
    const TomlValue* find(std::string_view key) const;
    // This must be a table.
    void set(std::string_view key, TomlValue to);
    void erase(std::string_view key);
};

struct TomlMember {
    std::string key;
    TomlValue value;
};

// As files have them: wherever they are in the file, and a number that is none equals another one.
bool operator==(const TomlValue& a, const TomlValue& b);
bool operator==(const TomlMember& a, const TomlMember& b);

inline constexpr int kDeepestToml = 300;  // tables and arrays within each other

// From a file's text to its values, a table. If it is no TOML, the error has its line and column, and toml++'s own
// description as message. If nobody could find out, the line is 0 and the message a sentence to be spoken.
using TomlReader = std::function<Result<TomlValue>(const std::string& text)>;

// Parses in this process.
Result<TomlValue> toml_of(const std::string& text);

// A table as the text of a file.
std::string written_toml(const TomlValue& table);

}  // namespace handrail
