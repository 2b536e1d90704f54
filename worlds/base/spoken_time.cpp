#include "worlds/base/spoken_time.h"

#include <fmt/format.h>
#include <unicode/datefmt.h>
#include <unicode/smpdtfmt.h>

#include <memory>
#include <optional>

#include "worlds/base/language.h"

namespace handrail {
namespace {

// The English texts are British English, so dates are British too.
icu::Locale locale_of(const std::string& language) {
    return language == "en" ? icu::Locale("en", "GB") : icu::Locale(language.c_str());
}

std::optional<UDate> moment_of(std::string_view iso_utc) {
    UErrorCode error = U_ZERO_ERROR;
    icu::SimpleDateFormat format("yyyy-MM-dd'T'HH:mm:ss'Z'", icu::Locale::getRoot(), error);
    if (U_FAILURE(error)) return std::nullopt;
    format.setTimeZone(*icu::TimeZone::getGMT());
    format.setLenient(false);
    const UDate moment =
        format.parse(icu::UnicodeString::fromUTF8({iso_utc.data(), static_cast<int>(iso_utc.size())}), error);
    return U_SUCCESS(error) ? std::optional(moment) : std::nullopt;
}

std::string words_of(const icu::DateFormat* format, UDate moment, std::string_view otherwise) {
    if (!format) return std::string(otherwise);
    icu::UnicodeString words;
    std::string text;
    return format->format(moment, words).toUTF8String(text);
}

}  // namespace

std::string day_words(std::string_view iso_utc) {
    const auto moment = moment_of(iso_utc);
    if (!moment) return std::string(iso_utc);
    const std::unique_ptr<icu::DateFormat> format(
        icu::DateFormat::createDateInstance(icu::DateFormat::kLong, locale_of(spoken_language())));
    return words_of(format.get(), *moment, iso_utc);
}

std::string day_and_time_words(std::string_view iso_utc) {
    const auto moment = moment_of(iso_utc);
    if (!moment) return std::string(iso_utc);
    UErrorCode error = U_ZERO_ERROR;
    const icu::SimpleDateFormat clock("HH:mm", locale_of(spoken_language()), error);
    const std::string time = words_of(U_SUCCESS(error) ? &clock : nullptr, *moment, iso_utc);
    return phrase("report.day_and_time", {{"day", day_words(iso_utc)}, {"time", time}});
}

}  // namespace handrail
