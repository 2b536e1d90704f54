// Patterns of ICU's MessageFormat, as far as the bundled languages use them: values, numbers (the formats "integer",
// "#0.##" and the skeletons ".00", ".##", "@##", "group-off", "precision-integer"), plural and
// selectordinal (=n, one, two, few, other, #), and select. A page uses it instead of ICU. It gives the same text as ICU
// for English and German, which tests check. Pure functions.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "worlds/base/message.h"

namespace handrail {

// How a number is written. Numbers are rounded to the nearest decimal, and halves to the even one.
struct NumberFormat {
    int least = 0, most = 3;  // number of decimals
    int significant = 0;      // if not 0, the greatest number of significant digits; the decimals then do not count
    bool grouped = true;      // separates thousands
};

class PlainMessage final : public Message {
public:
    std::optional<std::string> filled(std::span<const TextValue> values) const override;
    std::vector<std::string> names() const override;

    enum class Kind { Text, Value, Number, Plural, Ordinal, Select, Count };
    struct Part {
        Kind kind = Kind::Text;
        std::string text;  // the text itself, or the name of the value
        NumberFormat number = {};
        std::vector<std::pair<std::string, std::vector<Part>>> choices = {};
    };
    PlainMessage(std::vector<Part> parts, bool german) : parts_(std::move(parts)), german_(german) {}

private:
    std::vector<Part> parts_;
    bool german_;
};

// Does the same as compile_message. Any language but German gets the numbers and plural forms of English.
std::unique_ptr<const Message> compile_plain_message(std::string_view pattern, const std::string& language,
                                                     MessageFault* fault = nullptr);
// Does the same as capitalised(), if the C library's towupper knows the letter.
std::string plain_capitalised(std::string_view text);

}  // namespace handrail
