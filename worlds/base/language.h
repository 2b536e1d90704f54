// Handrail's texts in the person's language. Every string that a person hears or reads is in settings/languages under a
// key, in one file for each language; the code gives the key and the values. Patterns use ICU's MessageFormat, so that
// each language has its own number format, plural forms and word order: "{steps, plural, one {# step} other {#
// steps}}".
//
// The whole process has one spoken language, as it has one C locale, because a reader that fails deep in a file has no
// access to a session. It starts as English. The app thread changes it with speak_language; any thread except the
// servo's may read it (phrase allocates).
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

// One value of a pattern: "{name}". Whole numbers select plural forms. The pattern decides how many decimals a number
// gets ("{m, number, ::.0}").
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
// lacks the key, the text is English; if English lacks it too, the key itself is returned. docs/results.md has the cost
// of a text with values; its first use costs up to ten times as much.
std::string phrase(std::string_view key, std::initializer_list<TextValue> values = {});
// True if the spoken language or English has the key. For keys built from names that come from files ("material.moss").
bool has_phrase(std::string_view key);

// A text of a world in a further language.
struct TextIn {
    std::string language;  // its code: "de"
    std::string text;
};
using OtherLanguages = std::vector<TextIn>;
// The text in the spoken language if there is one, else `text`, the world's main text.
std::string in_spoken_language(const std::string& text, const OtherLanguages& others);

// Puts the first letter in upper case, for the start of a sentence, in any script. A text that begins with no letter
// stays.
std::string capitalised(std::string_view text);

// A language that can be chosen: its code ("de") and its own name for itself ("Deutsch").
struct LanguageName {
    std::string code;
    std::string name;
};

// The languages that come with the program, English first.
std::vector<LanguageName> bundled_languages();
// The bundled languages and those with a file of the person's own in `folder`, by their codes. A file that cannot be
// read is left out.
std::vector<LanguageName> languages_to_choose(const std::filesystem::path& folder);
// The code of the spoken language: "en".
std::string spoken_language();
// The code of the language that the environment requests (the first one set of LC_ALL, LC_MESSAGES, LANG) if it is
// bundled or has a file in `folder`, which is not opened; else "en".
std::string language_of_environment(const std::filesystem::path& folder);
// The folder that the language's own file was read from, for a child process that must speak the same; empty if there
// was none.
std::filesystem::path spoken_language_folder();

// Speaks `code` from now on. A file CODE.toml in `folder` (which may be empty or absent) adds a language or replaces
// single texts of a bundled one. Returns the faults of that file; each faulty text is replaced by the bundled one, else
// by English. Faults are in the bundled language of that code, if there is one. If there is no such language or its
// file is damaged, it fails and changes nothing. App thread.
Result<std::vector<Diagnostic>> speak_language(std::string_view code, const std::filesystem::path& folder = {});

// Returns a pattern's fault in ICU's words, or an empty string. `names` receives the sorted names of the values that
// the pattern uses.
std::string pattern_fault(std::string_view pattern, std::vector<std::string>* names = nullptr);
// The texts of a bundled language, sorted by key; empty if there is no such language. For tests and translators.
std::vector<std::pair<std::string, std::string>> bundled_texts(std::string_view code);

}  // namespace handrail
