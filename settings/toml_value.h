// Represents the content of a TOML file as plain values, each with its line in the file. Code that reads TOML uses only
// these values and no headers of toml++. So another process can parse the file (app/import/toml_apart.h). Any thread
// may use the values.
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
    std::int16_t offset_minutes = 0;  // difference from UTC
    bool operator==(const TomlMoment&) const = default;
};

struct TomlMember;

struct TomlValue {
    using Array = std::vector<TomlValue>;
    using Table = std::vector<TomlMember>;  // contains each key once, in the order of the file

    CopyableVariant<bool, std::int64_t, double, std::string, TomlMoment, Array, Table> value;
    std::int32_t line = 0, column = 0;  // place in the file; both are 0 if the value does not come from a file
    bool in_line = false;               // true for a table that the file writes in braces

    static TomlValue empty_table();

    // Each of these functions returns a pointer to the value, or null if the value has another type.
    const bool* flag() const { return std::get_if<bool>(&value); }
    const std::int64_t* whole() const { return std::get_if<std::int64_t>(&value); }
    const double* fraction() const { return std::get_if<double>(&value); }
    const std::string* text() const { return std::get_if<std::string>(&value); }
    const Array* array() const { return std::get_if<Array>(&value); }
    const Table* table() const { return std::get_if<Table>(&value); }
    std::optional<double> number() const;  // returns the value of a whole or a decimal number, else nothing
    bool is_tables() const;                // true for an array that contains at least one table and nothing else

    // Returns a member of a table. Null if there is no such member, or if this value is not a table.
    const TomlValue* find(std::string_view key) const;
    // Sets a member. Requires that this value is a table.
    void set(std::string_view key, TomlValue to);
    void erase(std::string_view key);
};

struct TomlMember {
    std::string key;
    TomlValue value;
};

// These operators compare only the content. They ignore the positions in the file, and nan equals nan.
bool operator==(const TomlValue& a, const TomlValue& b);
bool operator==(const TomlMember& a, const TomlMember& b);

inline constexpr int kDeepestToml = 300;  // greatest nesting of tables and arrays

// Parses the text of a file into a table. If the text is not valid TOML, the error has the line and column, and
// toml++'s description as its message. If the text could not be parsed for another reason, the line is 0, and the
// message is a sentence that can be spoken.
using TomlReader = std::function<Result<TomlValue>(const std::string& text)>;

// Parses a file's text in this process; it can be used as a TomlReader.
Result<TomlValue> toml_of(const std::string& text);

// Returns a table as the text of a file.
std::string written_toml(const TomlValue& table);

}  // namespace handrail::settings
