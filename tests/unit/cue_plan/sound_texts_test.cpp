// Tests that every sound and every material has texts in every language.
#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "audio-cues/plan/sound_table.h"
#include "audio-cues/plan/sound_words.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"

namespace handrail {
namespace sound_texts_test {

TEST(SoundTexts, exist_for_every_sound_and_material_and_for_nothing_else) {
    std::set<std::string> wanted;
    for (const SoundInfo& row : sound_table()) {
        if (row.kind == SoundKind::Contact) continue;  // the texts describe the contact sound for each material instead
        std::string key = "sound." + std::string(row.name);
        std::replace(key.begin(), key.end(), ' ', '_');
        wanted.insert(key);
    }
    for (int m = 0; m < static_cast<int>(SoundClass::Generic); ++m)
        wanted.insert("sound_contact." + std::string(material_sound_name(static_cast<SoundClass>(m))));
    for (const LanguageName& language : bundled_languages()) {
        std::set<std::string> found;
        for (const auto& [key, pattern] : bundled_texts(language.code))
            if (key.starts_with("sound.") || key.starts_with("sound_contact.")) found.insert(key);
        EXPECT_EQ(found, wanted) << language.code;
    }
}

TEST(SoundTexts, are_spoken_in_german_while_scenarios_keep_their_names) {
    const test::InLanguage german("de");
    const auto all = sound_dictionary();
    const auto tone = std::find_if(all.begin(), all.end(),
                                   [](const DictionaryEntry& entry) { return entry.kind == SoundKind::WallTone; });
    ASSERT_NE(tone, all.end());
    EXPECT_EQ(tone->text, "Wandton: Eine Wand ist nah, auf der Seite, auf der er klingt; je näher, desto lauter.");
    EXPECT_EQ(info(SoundKind::WallTone).name, "wall tone");
    EXPECT_EQ(all.back().text, "Berührung: Gitter.");
}

// Formerly, if a sound was ahead to one side, the program announced the key of a text that did not exist.
TEST(SoundTexts, give_the_direction_of_a_sound_in_words_all_round) {
    for (const LanguageName& language : bundled_languages()) {
        const test::InLanguage spoken(language.code);
        const std::string ahead = phrase("direction.half_left");
        for (int eighth = 0; eighth < 8; ++eighth) {
            SoundCue cue;
            cue.kind = SoundKind::Beacon;
            const double bearing_rad = 0.25 * kPi * eighth;
            cue.position_m = {3.0 * std::sin(bearing_rad), 3.0 * std::cos(bearing_rad), 0.0};
            const std::string said = SoundWords().describe(cue, Listener{}, 0.0);
            EXPECT_FALSE(said.empty());
            EXPECT_EQ(said.find("direction."), std::string::npos) << said;
            if (eighth == 7) {
                EXPECT_THAT(said, testing::HasSubstr(ahead));
            }
        }
    }
}

}  // namespace sound_texts_test
}  // namespace handrail
