// Tests that the reader returns a world or one sentence, whatever a file contains.
#include <gmock/gmock.h>

#include <array>
#include <random>

#include "tests/support/names.h"
#include "tests/support/office_ifc.h"
#include "tests/support/real_worlds.h"
#include "tests/unit/ifc/ifc_text.h"

namespace handrail {
namespace torture_test {

using ::testing::HasSubstr;

TEST(IfcTorture, a_file_cut_anywhere_is_reported_with_its_line) {
    const std::string whole = test::small_house();
    for (std::size_t at = 30; at < whole.size() - 20; at += 97) {
        const Result<Scene> scene = read_ifc(whole.substr(0, at), "cut.ifc");
        ASSERT_FALSE(scene.has_value()) << "cut at " << at;
        EXPECT_THAT(scene.error().sentence(), HasSubstr("line")) << "cut at " << at;
    }
}

TEST(IfcTorture, whole_buildings_cut_anywhere_are_reported) {
    std::vector<std::string> buildings{test::office_ifc({2, 1, 8, 240}).text};
    for (const auto& path : test::with_real_worlds({}, {"duplex-apartment.ifc"}))
        buildings.push_back(test::content_of(path));
    for (const std::string& whole : buildings)
        for (std::size_t at = 997; at < whole.size() - 20; at += 997 * 97) {
            const Result<Scene> scene = read_ifc(whole.substr(0, at), "cut.ifc");
            EXPECT_FALSE(scene.has_value()) << "cut at " << at;
        }
}

TEST(IfcTorture, circular_placements_terminate_and_are_counted) {
    const std::string text = test::small_house();
    const std::size_t at = text.find("=IFCLOCALPLACEMENT($,");
    const std::string own = text.substr(text.rfind('#', at), at - text.rfind('#', at));
    const Result<Scene> scene =
        read_ifc(test::replaced(text, "=IFCLOCALPLACEMENT($,", "=IFCLOCALPLACEMENT(" + own + ","), "circle.ifc");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_THAT(scene->report.left_out, ::testing::Contains(HasSubstr("refers to itself")));
}

TEST(IfcTorture, huge_numbers_only_remove_their_part) {
    for (const char* number : {"1.E308", "-1.E308", "1.E9999", "1.E30"}) {
        const Result<Scene> scene =
            read_ifc(test::replaced(test::small_house(), "((8.2,", std::string("((") + number + ","), "far.ifc");
        if (!scene) {
            EXPECT_FALSE(scene.error().sentence().empty());
            continue;
        }
        const Result<void> valid = validate(*scene);
        EXPECT_TRUE(valid.has_value()) << number << ": " << valid.error().sentence();
        EXPECT_LT(glm::length(scene->bounds_m.size_m()), 1e6) << number;
    }
}

TEST(IfcTorture, shapes_that_contain_themselves_terminate) {
    std::string text = test::small_house();
    const std::size_t at = text.find("=IFCEXTRUDEDAREASOLID(");
    const std::string own = text.substr(text.rfind('#', at), at - text.rfind('#', at));
    const std::size_t end = text.find(';', at);
    text.replace(at, end - at, "=IFCBOOLEANRESULT(.UNION.," + own + "," + own + ")");
    const Result<Scene> scene = read_ifc(text, "itself.ifc");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_THAT(scene->report.left_out, testing::Contains(HasSubstr("IFCBOOLEANRESULT")));
}

// Returns the text with some random changes to bytes, numbers and lines.
std::string mutated(const std::string& text, std::mt19937& random) {
    std::string other = text;
    for (std::uint32_t edits = 1 + random() % 5; edits > 0; --edits) {
        const std::size_t at = random() % other.size(), line = other.rfind('\n', at), end = other.find('\n', at);
        constexpr std::array<std::string_view, 8> kWords{"$", "*", "-1.E300", "0.", "#1", "()", ".F.", "1.E7"};
        switch (random() % 4) {
            case 0:
                other[at] = static_cast<char>(random());
                break;
            case 1:
                other.insert(at, kWords[random() % kWords.size()]);
                break;
            case 2:
                if (line != std::string::npos && end != std::string::npos) other.erase(line, end - line);
                break;
            default: {  // replaces one digit of a number or a reference
                const std::size_t digit = other.find_first_of("0123456789", at);
                if (digit != std::string::npos) other[digit] = static_cast<char>('0' + random() % 10);
            }
        }
    }
    return other;
}

TEST(IfcTorture, mutated_files_become_a_complete_scene_or_an_error_sentence) {
    std::mt19937 random(20261123);
    int read = 0;
    for (const char* file : {"small_house.ifc", "small_house_millimetres.ifc"}) {
        const std::string text = test::small_house(file);
        for (int round = 0; round < 150; ++round) {
            const Result<Scene> scene = read_ifc(mutated(text, random), "mutated.ifc");
            if (!scene) {
                EXPECT_FALSE(scene.error().sentence().empty());
                continue;
            }
            ++read;
            const Result<void> valid = validate(*scene);
            EXPECT_TRUE(valid.has_value()) << file << ", round " << round << ": " << valid.error().sentence();
        }
    }
    EXPECT_GT(read, 50) << "most become a world";
}

TEST(IfcTorture, the_cost_of_many_rooms_grows_only_with_their_number) {
    std::string text = test::small_house(), more;
    const std::size_t at = text.find("=IFCSPACE(");
    const std::string space = text.substr(at, text.find(';', at) + 1 - at) + "\n";
    for (int i = 0; i < 2000; ++i) more += "#" + std::to_string(100'000 + i) + space;
    const Result<Scene> scene = read_ifc(test::with_instances(text, more), "many.ifc");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_EQ(scene->stated->rooms.size(), 2002U);
}

}  // namespace torture_test
}  // namespace handrail
