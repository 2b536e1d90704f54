// The content of a TOML file as plain values, each with its line in the file. Code that reads TOML uses these and
// includes nothing of toml++, so that the file itself can be parsed in another process (app/import/toml_apart.h). Any
// thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"
#include "worlds/base/variant.h"

namespace handrail::settings {

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
    using Table = std::vector<TomlMember>;  // each key once, in the order of the file

    CopyableVariant<bool, std::int64_t, double, std::string, TomlMoment, Array, Table> value;
    std::int32_t line = 0, column = 0;  // 0: not from a file
    bool in_line = false;               // a table written in braces

    static TomlValue empty_table();

    // These return null if the value has another type.
    const bool* flag() const { return std::get_if<bool>(&value); }
    const std::int64_t* whole() const { return std::get_if<std::int64_t>(&value); }
    const double* fraction() const { return std::get_if<double>(&value); }
    const std::string* text() const { return std::get_if<std::string>(&value); }
    const Array* array() const { return std::get_if<Array>(&value); }
    const Table* table() const { return std::get_if<Table>(&value); }
    std::optional<double> number() const;  // of a whole or a decimal number
    bool is_tables() const;                // true for an array that contains only tables, and at least one

    // Finds a member of a table; null if there is no such member, or if this is no table.
    const TomlValue* find(std::string_view key) const;
    // Requires that this is a table.
    void set(std::string_view key, TomlValue to);
    void erase(std::string_view key);
};

struct TomlMember {
    std::string key;
    TomlValue value;
};

// Compares the content: positions in the file do not count, and nan equals nan.
bool operator==(const TomlValue& a, const TomlValue& b);
bool operator==(const TomlMember& a, const TomlMember& b);

inline constexpr int kDeepestToml = 300;  // greatest nesting of tables and arrays

// Parses the text of a file into a table. If it is not valid TOML, the error has the line and column, and toml++'s
// description as its message. If parsing was not possible at all, the line is 0 and the message is a sentence that can
// be spoken.
using TomlReader = std::function<Result<TomlValue>(const std::string& text)>;

// A TomlReader that parses in this process.
Result<TomlValue> toml_of(const std::string& text);

// Writes a table as the text of a file.
std::string written_toml(const TomlValue& table);

}  // namespace handrail::settings
