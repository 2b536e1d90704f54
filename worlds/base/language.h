// What Handrail says, in the person's language. Every string that a person hears or reads stands in settings/languages,
// one file for each language, under a key; code names the key and gives the values. Patterns are ICU's MessageFormat,
// so that each language has its own number signs, plural forms and word order: "{steps, plural, one {# step} other {#
// steps}}".
//
// The language spoken is one for the whole process, as the C locale is: a reader that fails deep in a file has nobody
// to ask. It starts as English, is changed on the app thread by speak_language, and may be read on any thread but the
// servo's (phrase allocates).
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "worlds/base/result.h"

namespace handrail {

// One value of a pattern: "{name}". Whole numbers choose plural forms; how many decimals a number gets, the pattern
// says ("{m, number, ::.0}").
struct TextValue {
    std::string_view name;
    std::variant<std::int64_t, double, std::string_view> value;

    template <std::integral T>
    TextValue(std::string_view n, T v) : name(n), value(static_cast<std::int64_t>(v)) {}
    template <std::floating_point T>
    TextValue(std::string_view n, T v) : name(n), value(static_cast<double>(v)) {}
    TextValue(std::string_view n, std::string_view v) : name(n), value(v) {}
};

// The text under `key` ("rooms.too_far") in the language spoken, with its values put in; English where that language
// lacks it, the key itself where English lacks it too. What a text with values costs stands in docs/results.md; the
// first time it is said, up to ten times that.
std::string phrase(std::string_view key, std::initializer_list<TextValue> values = {});
// Whether the language spoken, or English, has the key: for keys made of names that come from files ("material.moss").
bool has_phrase(std::string_view key);

// A text of a world in one more language.
struct TextIn {
    std::string language;  // its code: "de"
    std::string text;
};
using OtherLanguages = std::vector<TextIn>;
// The one in the language spoken, where there is one; else `text`, which the world is known by.
std::string in_spoken_language(const std::string& text, const OtherLanguages& others);

// First letter in upper case, for the start of a sentence, in any script; a text that begins with no letter stays.
std::string capitalised(std::string_view text);

// A language that can be chosen: its code ("de") and its own name for itself ("Deutsch").
struct LanguageName {
    std::string code;
    std::string name;
};

// The languages that come with the program, English first.
std::vector<LanguageName> bundled_languages();
// Those, and the languages of files of one's own in `folder` by their codes. A file that cannot be read is left out.
std::vector<LanguageName> languages_to_choose(const std::filesystem::path& folder);
// The code of the language spoken: "en".
std::string spoken_language();
// The code of the language that the environment asks for (LC_ALL, LC_MESSAGES, LANG, the first that is set) if it comes
// with the program or has a file in `folder`, which is not opened; else "en".
std::string language_of_environment(const std::filesystem::path& folder);
// Where its own file was read from, for a process that is to speak the same; empty where there was none.
std::filesystem::path spoken_language_folder();

// Speaks `code` from now on. A file CODE.toml in `folder` (which may be empty or absent) adds a language or replaces
// single texts of a bundled one. Returns what is wrong with that file, text by text, each of which is then said as
// before (bundled, else English); a bundled language tells it itself. Fails, and changes nothing, if there is no such
// language or its file is damaged. App thread.
Result<std::vector<Diagnostic>> speak_language(std::string_view code, const std::filesystem::path& folder = {});

// A pattern's fault in ICU's words, or nothing. `names` receives the values that it asks for, sorted.
std::string pattern_fault(std::string_view pattern, std::vector<std::string>* names = nullptr);
// The texts of a bundled language by key, sorted; empty for one that is not there. For tests and translators.
std::vector<std::pair<std::string, std::string>> bundled_texts(std::string_view code);

}  // namespace handrail
