// Looks up Handrail's texts in the person's language. Every string that a person hears or reads is in
// settings/languages under a key, with one file for each language. The code supplies only the key and the values.
// Patterns use ICU's MessageFormat, so each language has its own number format, plural forms and word order: "{steps,
// plural, one {# step} other {# steps}}".
//
// The whole process has one spoken language, as it has one C locale, because a reader that fails deep in a file has no
// access to a session. The process starts in English. The app thread changes the language with speak_language(). Any
// thread except the servo thread may read texts; phrase() allocates.
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

// One value for a pattern, where it appears as "{name}". Whole numbers select plural forms. The pattern states the
// number of decimals ("{m, number, ::.0}").
struct TextValue {
    std::string_view name;
    std::variant<std::int64_t, double, std::string_view> value;

    template <std::integral T>
    TextValue(std::string_view n, T v) : name(n), value(static_cast<std::int64_t>(v)) {}
    template <std::floating_point T>
    TextValue(std::string_view n, T v) : name(n), value(static_cast<double>(v)) {}
    TextValue(std::string_view n, std::string_view v) : name(n), value(v) {}
};

// Returns the text under `key` ("rooms.too_far") in the spoken language, with its values filled in. If that language
// lacks the key, the English text is used. If English lacks the key too, phrase() returns the key itself. The cost is
// in docs/results.md; the first use of a text costs up to ten times as much as later ones.
std::string phrase(std::string_view key, std::initializer_list<TextValue> values = {});
// True if the spoken language or English has the key. Use it for keys that contain a name from a file
// ("material.moss").
bool has_phrase(std::string_view key);

// A translation of a world's text into one further language.
struct TextIn {
    std::string language;  // the code of that language: "de"
    std::string text;
};
using OtherLanguages = std::vector<TextIn>;
// Returns the translation into the spoken language from `others`. If there is none, returns `text`, which is in the
// world's main language.
std::string in_spoken_language(const std::string& text, const OtherLanguages& others);

// Puts the first letter into upper case, in any script, for the start of a sentence. A text that does not begin with a
// letter is returned unchanged.
std::string capitalised(std::string_view text);

// A language that a person can choose: its code ("de") and its name in the language itself ("Deutsch").
struct LanguageName {
    std::string code;
    std::string name;
};

// Returns the languages that come with the program, English first.
std::vector<LanguageName> bundled_languages();
// Returns the bundled languages and those for which the person has a file in `folder`, sorted by code. Leaves out files
// that cannot be read.
std::vector<LanguageName> languages_to_choose(const std::filesystem::path& folder);
// Returns the code of the spoken language, such as "en".
std::string spoken_language();
// Returns the code of the language that the environment requests: the first of LC_ALL, LC_MESSAGES and LANG that is
// set. Returns "en" if that language is neither bundled nor has a file in `folder`; the file is not opened.
std::string language_of_environment(const std::filesystem::path& folder);
// Returns the folder that holds the person's own language file; empty if none was read. A child process needs this
// folder if it must speak the same language.
std::filesystem::path spoken_language_folder();

// Changes the spoken language to `code`. A file CODE.toml in `folder` adds a language or replaces single texts of a
// bundled one; `folder` may be empty or absent. Returns the faults of that file. Handrail uses the bundled text, or
// else the English one, instead of each faulty text. Faults are reported in the bundled language of that code, if it
// exists. If the language does not exist or its file is damaged, the call fails and changes nothing. App thread only.
Result<std::vector<Diagnostic>> speak_language(std::string_view code, const std::filesystem::path& folder = {});

// Returns ICU's description of the fault in a pattern, or an empty string. `names` receives the sorted names of the
// values that the pattern uses.
std::string pattern_fault(std::string_view pattern, std::vector<std::string>* names = nullptr);
// Returns the texts of a bundled language, sorted by key; empty if that language is not bundled. For tests and
// translators.
std::vector<std::pair<std::string, std::string>> bundled_texts(std::string_view code);

}  // namespace handrail
