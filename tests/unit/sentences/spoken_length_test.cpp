// Estimates how long each text of the languages takes to say at 180 words a minute, and compares the duration with a
// limit. A word in passing must end before the walker's next step. An alarm must first say what is wrong. At the end of
// an answer, a person must still remember its beginning.
#include <espeak-ng/speak_lib.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/support/names.h"
#include "tests/unit/sentences/sentence_rules.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace spoken_length_test {

constexpr int kWordsPerMinute = 180;

// ---- a pattern as it is spoken: each value becomes a word or a number, and each choice its longest branch ----

// Returns the position after the brace that closes the one at `open`.
std::size_t behind_brace(std::string_view text, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
        depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
        if (depth == 0) return i + 1;
    }
    return text.size();
}

std::string said(std::string_view pattern);

// Returns the spoken form of a value such as "name", "name, number, ::.0" or "name, plural, one {...} other {...}".
// `value` comes without its own braces.
std::string value_said(std::string_view value) {
    const std::size_t comma = value.find(',');
    if (comma == std::string_view::npos) return "Kitchen";
    const std::string_view kind = value.substr(comma + 1);
    if (kind.find("plural") != 1 && kind.find("select") != 1) return "12";
    std::string longest;
    for (std::size_t open = value.find('{'); open != std::string_view::npos; open = value.find('{', open)) {
        const std::size_t end = behind_brace(value, open);
        std::string branch = said(value.substr(open + 1, end - open - 2));
        if (branch.size() > longest.size()) longest = std::move(branch);
        open = end;
    }
    return longest;
}

std::string said(std::string_view pattern) {
    std::string text;
    for (std::size_t i = 0; i < pattern.size();) {
        if (pattern[i] == '{') {
            const std::size_t end = behind_brace(pattern, i);
            text += value_said(pattern.substr(i + 1, end - i - 2));
            i = end;
            continue;
        }
        text += pattern[i] == '#' ? "12" : std::string(1, pattern[i]);
        ++i;
    }
    return text;
}

// ---- duration in seconds ----

// Returns the text in lower case with plain ASCII letters. A letter with an umlaut or accent becomes one vowel, 'e' or
// 'y'; the sharp s becomes 'x'.
std::string plain_letters(std::string_view text) {
    std::string letters;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        if (c < 0x80U) {
            letters += static_cast<char>(std::tolower(c));
        } else if (c == 0xC3U && i + 1 < text.size()) {
            const auto second = static_cast<unsigned char>(text[++i]);
            letters += second == 0x9FU ? 'x' : second == 0xA9U || second == 0xA8U ? 'e' : 'y';
        }
    }
    return letters;
}

bool is_vowel(char c) { return std::string_view("aeiouy").find(c) != std::string_view::npos; }

int syllables(const std::string& word, bool german) {
    int count = 0;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (!is_vowel(word[i])) continue;
        ++count;
        if (german) {  // two letters can make one sound
            const std::string_view two = std::string_view(word).substr(i, 2);
            for (const std::string_view one : {"au", "ei", "ie", "eu", "ai", "yu", "aa", "ee", "oo"})
                if (two == one) {
                    ++i;
                    break;
                }
        } else {
            while (i + 1 < word.size() && is_vowel(word[i + 1])) ++i;
        }
    }
    // The e of these endings is silent, as in "gate", "times" and "placed".
    if (!german && count > 1) {
        const auto ends = [&](std::string_view end) { return word.ends_with(end); };
        const bool spoken_s = ends("ses") || ends("ces") || ends("xes") || ends("zes") || ends("shes") ||
                              ends("ches") || ends("ges") || ends("les") || ends("tres");
        const std::size_t e = word.size() - (ends("e") ? 1 : 2);
        const char before = e > 0 && e <= word.size() ? word[e - 1] : 'a';
        const bool silent = ends("e")    ? !is_vowel(before) && before != 'l' && !ends("tre")
                            : ends("es") ? !is_vowel(before) && !spoken_s
                            : ends("ed") ? !is_vowel(before) && before != 't' && before != 'd'
                                         : false;
        if (silent) --count;
    }
    return std::max(count, 1);
}

// Estimates the duration of a text: a mean duration for each syllable, plus pauses. The constants were measured with
// the built-in voice; the last test compares the estimate with that voice.
double spoken_s(const std::string& text, const std::string& language) {
    const bool german = language == "de";
    const double syllable_s = german ? 0.195 : 0.21;
    const std::string letters = plain_letters(text);
    double seconds = 0.0;
    std::string word;
    for (std::size_t i = 0; i <= letters.size(); ++i) {
        const char c = i < letters.size() ? letters[i] : ' ';
        if (c >= 'a' && c <= 'z') {
            word += c;
            continue;
        }
        if (!word.empty()) seconds += syllable_s * syllables(word, german);
        word.clear();
        if (c >= '0' && c <= '9') seconds += syllable_s;
        const bool before_blank = i + 1 < letters.size() && letters[i + 1] == ' ';
        if (before_blank && (c == '.' || c == '!' || c == '?')) seconds += 0.35;
        if (before_blank && (c == ',' || c == ';' || c == ':')) seconds += 0.2;
    }
    return seconds;
}

// ---- limits ----

struct Bound {
    const char* what;
    double whole_s;     // limit for the whole text
    double sentence_s;  // limit for each sentence
    double first_s;     // limit for the first sentence
};
constexpr double kAny = 1e9;
// Words in passing are short, because a step takes half a second and a turn somewhat longer.
constexpr Bound kPassing{"a word in passing or a heading", 2.5, kAny, kAny};
// An alarm first says what is wrong, and then what to do.
constexpr Bound kAlarm{"an alarm", 8.0, kAny, 4.0};
constexpr Bound kAnswer{"an answer", 8.0, kAny, kAny};
// A line about a command or setting, in a list that a person goes through.
constexpr Bound kLine{"a line of help", 7.0, kAny, kAny};
constexpr Bound kHelp{"help that was asked for, a task", 12.0, kAny, kAny};
// Problems of files, reports and printed texts. The limit is for each sentence, because a screen reader moves by
// sentences.
constexpr Bound kReported{"what is told of files or printed", 15.0, 8.0, kAny};

constexpr std::array kPassingParts{
    "direction",    "compass",       "side",           "kind",          "material", "key_name",    "room_name",
    "setting_name", "setting_topic", "setting_choice", "setting_value", "unit",     "effect_name", "device_name",
    "command_word", "list_word",     "wizard_word",    "replay_word",   "osm_kind", "imdf_kind",   "place"};
constexpr std::array kReportedParts{
    "bench",       "check",         "compile",       "desk_order",    "effect",      "error",     "export",
    "files",       "help",          "honest",        "ifc",           "imdf",        "imdf_fact", "import",
    "info",        "learner",       "lint",          "log",           "map",         "mesh",      "obj",
    "osm",         "osm_fact",      "plan",          "program",       "reader",      "report",    "rooms_text",
    "scenario",    "settings_file", "setting_error", "sound_contact", "sound_words", "teaching",  "touch_part",
    "touch_stage", "window",        "world_fault",   "world_fault_do"};

template <std::size_t N>
bool is_among(std::string_view part, const std::array<const char*, N>& parts) {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
}

const Bound& bound_of(const std::string& key) {
    const std::size_t dot = key.find('.');
    const std::string part = key.substr(0, dot), rest = key.substr(dot + 1);
    const auto begins = [&rest](std::string_view with) { return rest.starts_with(with); };
    if (part == "fault" || key == "guard.may_still_push") return kAlarm;
    if (is_among(part, kPassingParts)) return kPassing;
    if ((part == "route" || part == "leg") &&
        (begins("turn_") || begins("stairs_") || begins("ramp_") || begins("straight")))
        return kPassing;
    if (is_among(part, kReportedParts) || begins("entry_")) return kReported;
    if (rest == "title") return kPassing;
    if (part == "lesson" || part == "wizard" || part == "wizard_part" || begins("help_") || begins("begin_") ||
        rest == "begin" || rest == "begun" || key == "companion.pad")
        return kHelp;
    if (part == "setting" || part == "setting_range" || part == "sound" || part == "command") return kLine;
    return kAnswer;
}

std::vector<std::string> too_long(const std::string& key, const std::string& pattern, const std::string& language) {
    // The program never speaks these texts: words from which it chooses names, and words that a person may type.
    if (key == "learner.trees" || key == "learner.birds" || key.starts_with("typed_sentence.") ||
        key.starts_with("question_word."))
        return {};
    const Bound& bound = bound_of(key);
    const std::string text = said(pattern);
    std::vector<std::string> faults;
    const auto hold = [&](double seconds, double most_s, const char* which) {
        if (seconds > most_s)
            faults.push_back(fmt::format("{} {}: {:.1f} s {}, {} may take {:.1f}: {}", language, key, seconds, which,
                                         bound.what, most_s, text));
    };
    hold(spoken_s(text, language), bound.whole_s, "in all");
    const std::vector<std::string> sentences = test::sentences_of(text);
    for (const std::string& sentence : sentences) hold(spoken_s(sentence, language), bound.sentence_s, "in a sentence");
    if (!sentences.empty()) hold(spoken_s(sentences.front(), language), bound.first_s, "at first");
    return faults;
}

TEST(SpokenLength, of_every_text_is_within_its_limit) {
    for (const LanguageName& language : bundled_languages()) {
        std::map<std::string, int> seen;
        for (const auto& [key, pattern] : bundled_texts(language.code)) {
            for (const std::string& fault : too_long(key, pattern, language.code)) ADD_FAILURE() << fault;
            ++seen[bound_of(key).what];
        }
        EXPECT_EQ(seen.size(), 6U) << language.code << ": a kind has no text any more";
        for (const auto& [what, count] : seen) EXPECT_GE(count, 15) << what;
    }
}

TEST(SpokenLength, detects_texts_that_are_too_long) {
    const std::string word = "banana ";
    const auto words = [&](int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += word;
        return text;
    };
    EXPECT_TRUE(too_long("compass.north", words(3), "en").empty());
    EXPECT_EQ(too_long("compass.north", words(5), "en").size(), 1U);
    EXPECT_TRUE(too_long("rooms.nowhere", words(12), "en").empty());
    EXPECT_EQ(too_long("rooms.nowhere", words(14), "en").size(), 1U);
    EXPECT_EQ(too_long("fault.jump", words(8) + ". " + word, "en").size(), 1U) << "what is wrong comes too late";
    EXPECT_EQ(too_long("map.no_face", words(14), "de").size(), 1U) << "one sentence";
    EXPECT_EQ(too_long("rooms.nowhere", "{n, plural, one {short} other {" + words(14) + "}}", "en").size(), 1U);
}

TEST(SpokenLength, uses_the_longest_spoken_form_of_a_pattern) {
    EXPECT_EQ(said("{steps, plural, one {# step} other {# steps}} to {name}"), "12 steps to Kitchen");
    EXPECT_EQ(said("{x, number, ::.0} {y, select, yes {a {b} c} other {}}"), "12 a Kitchen c");
    const auto count = [](const char* text, bool german) { return syllables(plain_letters(text), german); };
    EXPECT_EQ(count("table", false), 2);
    EXPECT_EQ(count("placed", false), 1);
    EXPECT_EQ(count("metres", false), 2);
    EXPECT_EQ(count("times", false), 1);
    EXPECT_EQ(count("Türöffnung", true), 3);
    EXPECT_EQ(count("Gebäude", true), 3);
    EXPECT_EQ(count("Treppe", true), 2);
}

// ---- comparison with the real voice ----

std::int64_t samples_made = 0;
int count_samples(short*, int count, espeak_EVENT*) {
    samples_made += count;
    return 0;
}

// The estimate must match the real duration on average, though not for each text. espeak-ng speaks an eighth of the
// texts for the comparison.
TEST(SpokenLength, matches_the_duration_of_the_built_in_voice) {
    const int rate = espeak_Initialize(AUDIO_OUTPUT_SYNCHRONOUS, 0, nullptr, espeakINITIALIZE_DONT_EXIT);
    if (rate <= 0) GTEST_SKIP() << "espeak-ng has no voices here";
    espeak_SetSynthCallback(count_samples);
    for (const std::string language : {"en", "de"}) {
        ASSERT_EQ(espeak_SetVoiceByName(language.c_str()), EE_OK);
        espeak_SetParameter(espeakRATE, kWordsPerMinute, 0);
        double model_s = 0.0, voice_s = 0.0;
        std::size_t number = 0;
        for (const auto& [key, pattern] : bundled_texts(language)) {
            if (++number % 8 != 0 || key.starts_with("learner.")) continue;
            const std::string text = said(pattern);
            samples_made = 0;
            espeak_Synth(text.c_str(), text.size() + 1, 0, POS_CHARACTER, 0, espeakCHARS_UTF8, nullptr, nullptr);
            voice_s += static_cast<double>(samples_made) / rate;
            model_s += spoken_s(text, language);
        }
        EXPECT_GT(voice_s, 300.0);
        EXPECT_NEAR(model_s / voice_s, 1.0, 0.1) << language << ": " << model_s << " s and " << voice_s << " s";
    }
    espeak_Terminate();
}

}  // namespace spoken_length_test
}  // namespace handrail
