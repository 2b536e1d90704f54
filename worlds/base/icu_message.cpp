#include <unicode/locid.h>
#include <unicode/messagepattern.h>
#include <unicode/msgfmt.h>
#include <unicode/uchar.h>
#include <unicode/unistr.h>

#include <set>

#include "worlds/base/message.h"

namespace handrail {
namespace {

icu::UnicodeString wide(std::string_view utf8) {
    return icu::UnicodeString::fromUTF8(icu::StringPiece(utf8.data(), static_cast<int32_t>(utf8.size())));
}

std::string narrow(const icu::UnicodeString& text) {
    std::string utf8;
    text.toUTF8String(utf8);
    return utf8;
}

class IcuMessage final : public Message {
public:
    IcuMessage(std::string_view pattern, const std::string& language, UParseError& where, UErrorCode& status)
        : format_(wide(pattern), icu::Locale(language.c_str()), where, status) {}

    std::optional<std::string> filled(std::span<const TextValue> values) const override {
        std::vector<icu::UnicodeString> names;
        std::vector<icu::Formattable> given;
        for (const TextValue& value : values) {
            names.push_back(wide(value.name));
            if (const auto* whole = std::get_if<std::int64_t>(&value.value)) given.emplace_back(*whole);
            else if (const auto* number = std::get_if<double>(&value.value)) given.emplace_back(*number);
            else given.emplace_back(wide(std::get<std::string_view>(value.value)));
        }
        UErrorCode status = U_ZERO_ERROR;
        icu::UnicodeString made;
        format_.format(names.data(), given.data(), static_cast<int32_t>(names.size()), made, status);
        return U_SUCCESS(status) ? std::optional(narrow(made)) : std::nullopt;
    }

    std::vector<std::string> names() const override {
        icu::UnicodeString pattern;
        UErrorCode status = U_ZERO_ERROR;
        const icu::MessagePattern parts(format_.toPattern(pattern), nullptr, status);
        std::set<std::string> found;
        for (int32_t i = 0; i < parts.countParts(); ++i)
            if (parts.getPartType(i) == UMSGPAT_PART_TYPE_ARG_NAME)
                found.insert(narrow(parts.getSubstring(parts.getPart(i))));
        return {found.begin(), found.end()};
    }

private:
    icu::MessageFormat format_;
};

}  // namespace

std::unique_ptr<const Message> compile_message(std::string_view pattern, const std::string& language,
                                               MessageFault* fault) {
    UErrorCode status = U_ZERO_ERROR;
    UParseError where{};
    auto message = std::make_unique<const IcuMessage>(pattern, language, where, status);
    if (U_SUCCESS(status)) return message;
    if (fault) *fault = {u_errorName(status), where.offset};
    return nullptr;
}

std::string capitalised(std::string_view text) {
    icu::UnicodeString made = wide(text);
    const UChar32 first = made.isEmpty() ? 0 : made.char32At(0), upper = u_totitle(first);
    if (first == upper) return std::string(text);
    return narrow(made.replace(0, U16_LENGTH(first), upper));
}

}  // namespace handrail
