// Parses TOML as toml::parse does, for files that must not be lost. If memory is short, toml++ 3.3 may report a number
// as damaged although it only failed to read it. So this function reports damage only if it finds the damage twice. It
// passes the file name as a std::string, because that selects the parser that is compiled into the library. The other
// parser, in the headers, ends the program on some kinds of damage. Throws toml::parse_error or std::bad_alloc.
#pragma once

#include <toml++/toml.h>

#include <string>

namespace handrail::settings {

inline toml::table parse_toml(const std::string& text) {
    try {
        // The file name is empty, because toml++ would store a name with an allocation that must not fail.
        return toml::parse(text, std::string());
    } catch (const toml::parse_error&) {
        return toml::parse(text, std::string());
    }
}

}  // namespace handrail::settings
