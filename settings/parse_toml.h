// toml::parse for text whose file may not be lost: where memory is short toml++ 3.3 takes a number it could not read
// for damage, so damage counts only when it is found twice. The name as a string of its own picks the library's parser:
// the one that is made of the headers ends the program on some damage. Throws toml::parse_error, or std::bad_alloc.
#pragma once

#include <toml++/toml.h>

#include <string>

namespace handrail {

inline toml::table parse_toml(const std::string& text) {
    try {
        return toml::parse(
            text, std::string());  // without the file's name, which toml++ keeps by an allocation that may not fail
    } catch (const toml::parse_error&) {
        return toml::parse(text, std::string());
    }
}

}  // namespace handrail
