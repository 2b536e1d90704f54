// Tests that the reader returns a world or one sentence, whatever a text contains.
#include <random>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/words/words_text.h"

namespace handrail {
namespace words_damaged_test {

std::vector<std::string> seeds() {
    std::vector<std::string> texts;
    for (const auto& file : std::filesystem::directory_iterator(test::project_root() / "tests/fuzz/inputs/rooms/seeds"))
        texts.push_back(test::content_of(file.path()));
    std::sort(texts.begin(), texts.end());
    return texts;
}

void expect_world_or_sentence(const std::string& text, const std::string& what) {
    const Result<Scene> scene = read_words(text, "cut.rooms");
    if (!scene) {
        ASSERT_FALSE(scene.error().sentence().empty()) << what;
        return;
    }
    const Result<void> valid = validate(*scene);
    ASSERT_TRUE(valid.has_value()) << what << ": " << valid.error().sentence();
}

TEST(DamagedWords, cut_at_any_byte_become_a_world_or_an_error_sentence) {
    const std::vector<std::string> texts = seeds();
    ASSERT_GE(texts.size(), 3U);
    for (const std::string& text : texts)
        for (std::size_t at = 0; at < text.size(); ++at)
            ASSERT_NO_FATAL_FAILURE(expect_world_or_sentence(text.substr(0, at), "cut at " + std::to_string(at)));
}

TEST(DamagedWords, with_swapped_words_and_numbers_become_a_world_or_an_error_sentence) {
    std::mt19937 random(20261124);
    const std::vector<std::string> texts = seeds();
    for (int round = 0; round < 400; ++round) {
        std::string text = texts[random() % texts.size()];
        for (std::uint32_t edits = 1 + random() % 6; edits > 0; --edits) {
            const std::size_t at = random() % text.size();
            constexpr std::array<std::string_view, 8> kWords{" north of ",   " 1e9 ",    "-7", "Hall",
                                                             ", stairs to ", " metres ", "\"", ". "};
            if (random() % 2 == 0) text[at] = static_cast<char>(random());
            else text.insert(at, kWords[random() % kWords.size()]);
        }
        ASSERT_NO_FATAL_FAILURE(expect_world_or_sentence(text, text));
    }
}

TEST(DamagedWords, an_oversized_text_is_refused_in_one_sentence) {
    std::string text = "Hall, 4 by 4 metres.\n";
    for (int i = 0; i < 4100; ++i) text += "Room: R" + std::to_string(i) + ", 4 by 4 metres.\n";
    const Result<Scene> scene = read_words(text, "large.rooms");
    ASSERT_FALSE(scene.has_value());
    EXPECT_NE(scene.error().sentence().find("too large"), std::string::npos);
}

}  // namespace words_damaged_test
}  // namespace handrail
