// A toml::parse for files that must not be lost. If memory is short, toml++ 3.3 may report a number as damaged that it
// only failed to read, so damage counts only if it is found twice.
// Passing the name as a std::string selects the parser that is compiled into the library; the header-only one ends the
// program on some damage. Throws toml::parse_error or std::bad_alloc.
#pragma once

#include <toml++/toml.h>

#include <string>

namespace handrail::settings {

inline toml::table parse_toml(const std::string& text) {
    try {
        // Without the file's name: toml++ stores it with an allocation that must not fail.
        return toml::parse(text, std::string());
    } catch (const toml::parse_error&) {
        return toml::parse(text, std::string());
    }
}

}  // namespace handrail::settings
