#include <fstream>
#include <regex>
#include <thread>

#include "tests/support/environment.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/spoken_time.h"
#include "worlds/base/typist.h"

namespace handrail {
namespace language_test {

void write(const std::filesystem::path& path, std::string_view content) {
    std::ofstream(path, std::ios::binary) << content;
}

TEST(SpokenTime, is_formatted_as_people_write_it) {
    // When it is noon in UTC, the date is the same in nearly every time zone.
    EXPECT_EQ(day_words("2026-11-02T12:00:00Z"), "2 November 2026");
    EXPECT_TRUE(std::regex_match(day_and_time_words("2026-11-02T12:00:00Z"), std::regex("2 November 2026, ..:..")))
        << day_and_time_words("2026-11-02T12:00:00Z");
    {
        const test::InLanguage german("de");
        EXPECT_EQ(day_words("2026-11-02T12:00:00Z"), "2. November 2026");
        EXPECT_TRUE(day_and_time_words("2026-11-02T12:00:00Z").ends_with(" Uhr"));
    }
    for (const char* none : {"", "yesterday", "2026-13-02T12:00:00Z"}) EXPECT_EQ(day_words(none), none);
}

TEST(Phrase, inserts_values_in_the_spoken_language) {
    EXPECT_EQ(phrase("language.unknown", {{"code", "xx"}, {"codes", "en, de"}}),
              "Handrail has no language \"xx\". Available languages: en, de.");
    const test::InLanguage german("de");
    EXPECT_EQ(phrase("language.unknown", {{"code", "xx"}, {"codes", "en, de"}}),
              "Die Sprache „xx“ gibt es nicht; es gibt: en, de.");
    EXPECT_EQ(spoken_language(), "de");
}

TEST(Phrase, returns_the_key_if_no_language_has_it) {
    EXPECT_EQ(phrase("nothing.like_this", {{"x", 1}}), "nothing.like_this");
    EXPECT_FALSE(has_phrase("nothing.like_this"));
    EXPECT_TRUE(has_phrase("language.name"));
}

TEST(Phrase, keeps_curly_brackets_and_apostrophes_of_values) {
    EXPECT_EQ(phrase("language.unknown_key", {{"key", "it's {odd} '{'"}}),
              "Handrail has no text called \"it's {odd} '{'\"; this entry is ignored.");
}

TEST(InSpokenLanguage, returns_a_text_that_outlives_its_arguments) {
    const std::string& reported = in_spoken_language(std::string(100, 'x'), {});
    const std::string other(100, 'y');  // may reuse the memory of the first string
    EXPECT_EQ(reported, std::string(100, 'x'));
}

TEST(BundledLanguages, are_listed_with_english_first_under_their_own_names) {
    const auto names = bundled_languages();
    ASSERT_GE(names.size(), 2U);
    EXPECT_EQ(names[0].code, "en");
    EXPECT_EQ(names[0].name, "English");
    EXPECT_TRUE(std::any_of(names.begin(), names.end(),
                            [](const LanguageName& l) { return l.code == "de" && l.name == "Deutsch"; }));
}

TEST(SpeakLanguage, accepts_a_custom_file_and_falls_back_to_english_for_missing_texts) {
    const test::TemporaryFolder folder;
    write(folder.path() / "nl.toml", "[language]\nname = \"Nederlands\"\n[error]\nline = \"regel {line}\"\n");
    const auto spoken = speak_language("nl", folder.path());
    ASSERT_TRUE(spoken) << spoken.error().sentence();
    EXPECT_TRUE(spoken->empty());
    EXPECT_EQ(phrase("error.line", {{"line", 3}}), "regel 3");
    EXPECT_EQ(phrase("error.column", {{"column", 3}}), "column 3");
    ASSERT_TRUE(speak_language("en"));
    EXPECT_EQ(phrase("error.line", {{"line", 3}}), "line 3");
}

TEST(SpeakLanguage, replaces_single_texts_of_a_bundled_language) {
    const test::TemporaryFolder folder;
    write(folder.path() / "de.toml", "error.line = \"Z. {line}\"\n");
    ASSERT_TRUE(speak_language("de", folder.path()));
    EXPECT_EQ(phrase("error.line", {{"line", 3}}), "Z. 3");
    EXPECT_EQ(phrase("error.column", {{"column", 3}}), "Spalte 3");
    ASSERT_TRUE(speak_language("en"));
}

TEST(SpeakLanguage, names_every_unsuitable_text_and_uses_the_bundled_one_instead) {
    const test::TemporaryFolder folder;
    write(folder.path() / "de.toml",
          "[error]\nline = \"Zeile {lien}\"\ncolumn = \"Spalte {column\"\nerror = 3\nwarning = \"Achtung: \"\nnothing "
          "= \"nichts\"\n");
    const auto spoken = speak_language("de", folder.path());
    ASSERT_TRUE(spoken) << spoken.error().sentence();
    std::vector<int> lines;
    for (const Diagnostic& fault : *spoken) lines.push_back(fault.line);
    std::sort(lines.begin(), lines.end());
    EXPECT_EQ(lines, (std::vector<int>{2, 3, 4, 6}));
    EXPECT_EQ(phrase("error.line", {{"line", 3}}), "Zeile 3");
    EXPECT_EQ(phrase("error.column", {{"column", 3}}), "Spalte 3");
    EXPECT_EQ(phrase("error.warning"), "Achtung: ");
    ASSERT_TRUE(speak_language("en"));
}

TEST(SpeakLanguage, replaces_empty_texts_with_english_ones) {
    const test::TemporaryFolder folder;
    write(folder.path() / "nl.toml",
          "[error]\nline = \"\"\ncolumn = \"{column, plural, =1 {} other {kolom {column}}}\"\n");
    const auto spoken = speak_language("nl", folder.path());
    ASSERT_TRUE(spoken) << spoken.error().sentence();
    ASSERT_EQ(spoken->size(), 1U);
    EXPECT_EQ(spoken->front().line, 2);
    EXPECT_EQ(spoken->front().message, phrase("language.empty_text", {{"key", "error.line"}}));
    EXPECT_EQ(phrase("error.line", {{"line", 3}}), "line 3");
    EXPECT_EQ(phrase("error.column", {{"column", 2}}), "kolom 2");
    EXPECT_EQ(phrase("error.column", {{"column", 1}}), "column 1") << "nothing in this language for this one";
    ASSERT_TRUE(speak_language("en"));
}

TEST(SpeakLanguage, reports_errors_in_custom_texts_of_a_bundled_language_in_that_language) {
    const test::TemporaryFolder folder;
    write(folder.path() / "de.toml", "error.nothing = \"nichts\"\n");
    const auto spoken = speak_language("de", folder.path());
    ASSERT_TRUE(spoken) << spoken.error().sentence();
    ASSERT_EQ(spoken->size(), 1U);
    EXPECT_EQ(spoken->front().message, phrase("language.unknown_key", {{"key", "error.nothing"}}));
    EXPECT_EQ(spoken_language(), "de");
    ASSERT_TRUE(speak_language("en"));
}

TEST(SpeakLanguage, reports_the_place_in_a_damaged_file_and_changes_nothing) {
    const test::TemporaryFolder folder;
    write(folder.path() / "de.toml", "[error]\nline = \"Zeile\n");
    const auto spoken = speak_language("de", folder.path());
    ASSERT_FALSE(spoken);
    EXPECT_EQ(spoken.error().file, "de.toml");
    EXPECT_EQ(spoken.error().line, 2);
    EXPECT_EQ(spoken_language(), "en");
    write(folder.path() / "de.toml", "error.line = \"Zeile \xff\"\n");
    EXPECT_FALSE(speak_language("de", folder.path()));
}

TEST(SpeakLanguage, survives_a_file_cut_at_every_byte) {
    const test::TemporaryFolder folder;
    const std::string whole =
        "[language]\nname = \"Français\"\n[error]\nline = \"ligne {line, plural, one {#} other {#}}\"\n";
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        write(folder.path() / "fr.toml", whole.substr(0, length));
        (void)speak_language("fr", folder.path());
        EXPECT_FALSE(phrase("error.line", {{"line", 1}}).empty());
    }
    EXPECT_EQ(phrase("error.line", {{"line", 1}}), "ligne 1");
    ASSERT_TRUE(speak_language("en"));
}

TEST(SpeakLanguage, refuses_invalid_language_names) {
    for (const char* name : {"", "xx", "../de", "de.toml", "a/b"}) {
        const auto spoken = speak_language(name, "/");
        ASSERT_FALSE(spoken) << name;
        EXPECT_NE(spoken.error().message.find("en"), std::string::npos);
    }
    EXPECT_EQ(spoken_language(), "en");
}

TEST(SpeakLanguage, can_be_called_while_other_threads_speak) {
    std::atomic<bool> done = false;
    std::thread other([&] {
        while (!done) {
            const std::string said = phrase("error.line", {{"line", 3}});
            ASSERT_TRUE(said == "line 3" || said == "Zeile 3") << said;
        }
    });
    for (int i = 0; i < 200; ++i) ASSERT_TRUE(speak_language(i % 2 ? "en" : "de"));
    done = true;
    other.join();
    EXPECT_EQ(spoken_language(), "en");
}

TEST(Phrase, reused_with_other_values_reads_like_a_first_use_on_every_thread) {
    const test::TemporaryFolder folder;
    write(folder.path() / "nl.toml", "[learning]\nseconds = \"{seconds, plural, one {# tel} other {# tellen}}\"\n");
    ASSERT_TRUE(speak_language("nl", folder.path()));
    for (const int seconds : {1, 2, 1, 1000})
        EXPECT_EQ(phrase("learning.seconds", {{"seconds", seconds}}), seconds == 1   ? "1 tel"
                                                                      : seconds == 2 ? "2 tellen"
                                                                                     : "1.000 tellen");
    write(folder.path() / "nl.toml", "[learning]\nseconds = \"{seconds} s\"\n");
    ASSERT_TRUE(speak_language("nl", folder.path()));
    EXPECT_EQ(phrase("learning.seconds", {{"seconds", 2}}), "2 s") << "the file is another one by now";
    ASSERT_TRUE(speak_language("en"));
    std::vector<std::thread> threads;
    std::atomic<int> wrong = 0;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            for (int i = 0; i < 300; ++i)
                wrong += phrase("learning.seconds", {{"seconds", 2 + t}}) != std::to_string(2 + t) + " seconds";
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
}

TEST(Phrase, has_a_second_form_for_typed_commands_in_every_language) {
    const std::string for_keys = phrase("session.begin_with_keys");
    speak_to_typist(true);
    EXPECT_EQ(phrase("session.begin_with_keys"), "Type forward to walk.");
    EXPECT_EQ(phrase("error.line", {{"line", 3}}), "line 3") << "the same where it names no key";
    speak_to_typist(false);
    EXPECT_EQ(phrase("session.begin_with_keys"), for_keys);
    for (const char* code : {"en", "de"})
        for (const auto& [key, text] : bundled_texts(code)) {
            if (!key.ends_with("_typed")) continue;
            for (const char* named : {"Enter", "Escape", "F1", "F2", "Krafttaste", "force key", "Pfeil"})
                EXPECT_EQ(text.find(named), std::string::npos) << code << " " << key;
        }
}

TEST(LanguageOfEnvironment, is_a_bundled_or_custom_language_and_is_found_without_opening_a_file) {
    const test::TemporaryFolder folder;
    // nl.toml is damaged. language_of_environment() must not report the fault, because it does not open the file. The
    // program must report it only when someone chooses the language.
    write(folder.path() / "nl.toml", "damaged = \"");
    write(folder.path() / "xx.toml", "");
    test::WithEnvironment environment("LC_ALL", nullptr);
    const auto language_for = [&](const char* locale) {
        environment.put(locale);
        return language_of_environment(folder.path());
    };
    EXPECT_EQ(language_for("de_DE.UTF-8"), "de");
    EXPECT_EQ(language_for("de@euro"), "de");
    EXPECT_EQ(language_for("nl_NL"), "nl");
    EXPECT_EQ(language_for("pt_BR.UTF-8"), "en");
    EXPECT_EQ(language_for("C.UTF-8"), "en");
    EXPECT_EQ(language_for("../xx"), "en");
    environment.put("nl");
    EXPECT_EQ(language_of_environment({}), "en");
}

TEST(PatternFault, reports_the_placeholders_of_a_pattern_and_its_syntax_errors) {
    std::vector<std::string> names;
    EXPECT_EQ(pattern_fault("{n, plural, one {# step of {who}} other {# steps}}", &names), "");
    EXPECT_EQ(names, (std::vector<std::string>{"n", "who"}));
    EXPECT_NE(pattern_fault("{n, plural, one {# step}}"), "");  // the required form "other" is missing
    EXPECT_NE(pattern_fault("{n"), "");
}

}  // namespace language_test
}  // namespace handrail
