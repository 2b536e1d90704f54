// Defines errors that a person can act on. Files, devices and users can be wrong, so functions that deal with them
// return Result<T>.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace handrail {

// One sentence that can be spoken, and the place in a file that it refers to. Line and column count from 1; columns are
// in bytes. 0 means unknown.
struct Error {
    std::string file;
    int line = 0;
    int column = 0;
    std::string message;

    // Returns the error as text, such as "house.map, line 12, column 4: message". Leaves out unknown parts.
    std::string sentence() const;
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(std::string message, std::string file = {}, int line = 0, int column = 0) {
    return tl::unexpected<Error>(Error{std::move(file), line, column, std::move(message)});
}

enum class Severity { Warning, Error };

// A fault that a reader found. `message` states what the reader expected and found; `action` states what the reader did
// about the fault.
struct Diagnostic {
    Severity severity = Severity::Warning;
    std::string file;
    int line = 0;
    int column = 0;
    std::string message;
    std::string action;

    // Returns the fault as text, such as "house.map, line 4752, column 41: error: a face ends early. This brush was
    // left out."
    std::string sentence() const;
};

}  // namespace handrail
