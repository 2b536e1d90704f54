// Compiled patterns of the texts in settings/languages. The program uses ICU, which knows the plural forms and number
// formats of every language for which a person may have a file. A page speaks only the bundled languages, so it uses
// PlainMessage (plain_message.h) instead, and ICU need not be part of it. Tests compare both.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/language.h"

namespace handrail {

// A compiled pattern. Only one thread at a time may use it.
class Message {
public:
    virtual ~Message() = default;
    // Returns the text with the values filled in. Returns nothing if a value has the wrong type.
    virtual std::optional<std::string> filled(std::span<const TextValue> values) const = 0;
    // Returns the names of the values in the pattern, sorted.
    virtual std::vector<std::string> names() const = 0;
};

struct MessageFault {
    std::string name;   // ICU's name for the fault
    int character = 0;  // the first character that is wrong, counted from 0
};

// Compiles a pattern for the language with this code. Returns null and fills in `fault` if the pattern is faulty.
std::unique_ptr<const Message> compile_message(std::string_view pattern, const std::string& language,
                                               MessageFault* fault = nullptr);

}  // namespace handrail
