// Tests that the reader returns a world or one sentence, whatever a file contains.
#include <gmock/gmock.h>

#include <random>

#include "tests/support/names.h"
#include "tests/unit/osm/osm_text.h"

namespace handrail {
namespace osm_torture_test {

using ::testing::HasSubstr;

std::string small_plan() {
    return "<osm version='0.6'>\n<node id='1' lat='51.0' lon='13.0'/>\n<node id='2' lat='51.0' lon='13.0001'>"
           "<tag k='door' v='hinged'/></node>\n<node id='3' lat='51.00005' lon='13.0001'/>\n"
           "<way id='4'>\n<nd ref='1'/><nd ref='2'/><nd ref='3'/><nd ref='1'/>\n<tag k='indoor' v='room'/>"
           "<tag k='level' v='0'/><tag k='name' v='Hall'/></way>\n</osm>\n";
}

TEST(OsmTorture, files_cut_at_any_byte_are_reported) {
    const std::string whole = small_plan();
    ASSERT_TRUE(read_osm(whole, "small.osm").has_value());
    for (std::size_t at = 0; at + 2 < whole.size(); ++at) {
        const Result<Scene> scene = read_osm(whole.substr(0, at), "cut.osm");
        ASSERT_FALSE(scene.has_value()) << "cut at " << at;
        ASSERT_FALSE(scene.error().sentence().empty());
    }
    EXPECT_THAT(read_osm(whole.substr(0, 200), "cut.osm").error().sentence(), HasSubstr("line 6"));
}

TEST(OsmTorture, coordinates_with_any_power_of_ten_become_a_place_or_an_error_sentence) {
    for (const char* power : {"e0", "e-7", "e2", "e9", "e11", "e18", "e19", "e63", "e64", "e139", "e13964", "e99999"}) {
        std::string plan = small_plan();
        plan.replace(plan.find("13.0001"), 7, std::string("13.0001") + power);
        const Result<Scene> scene = read_osm(plan, "power.osm");
        EXPECT_TRUE(scene.has_value() || !scene.error().sentence().empty()) << power;
    }
    const auto with = [](const char* longitude) {
        std::string plan = small_plan();
        for (std::size_t at = 0; (at = plan.find("13.0001", at)) != std::string::npos; ++at)
            plan.replace(at, 7, longitude);
        return read_osm(plan, "power.osm");
    };
    ASSERT_TRUE(with("130001e-4").has_value());
    EXPECT_EQ(with("130001e-4")->triangles.size(), with("13.0001")->triangles.size());
    EXPECT_FALSE(with("13.0001e9").has_value());
}

// Returns the text with some random changes to bytes and numbers.
std::string mutated(const std::string& text, std::mt19937& random) {
    std::string other = text;
    for (std::uint32_t edits = 1 + random() % 5; edits > 0; --edits) {
        const std::size_t at = random() % other.size();
        constexpr std::array<std::string_view, 9> kWords{"room",  "-1e300", "0-300",  "stairs",  "elevator",
                                                         "/><nd", "180.0",  "hinged", "corridor"};
        switch (random() % 3) {
            case 0:
                other[at] = static_cast<char>(random());
                break;
            case 1:
                if (const std::size_t quote = other.find("v=\"", at); quote != std::string::npos)
                    other.replace(quote + 3, other.find('"', quote + 3) - quote - 3, kWords[random() % kWords.size()]);
                break;
            default: {
                const std::size_t digit = other.find_first_of("0123456789", at);
                if (digit != std::string::npos) other[digit] = static_cast<char>('0' + random() % 10);
            }
        }
    }
    return other;
}

TEST(OsmTorture, mutated_files_become_a_complete_scene_or_an_error_sentence) {
    std::mt19937 random(20261124);
    const std::string text = test::test_house();
    int read = 0;
    for (int round = 0; round < 200; ++round) {
        const Result<Scene> scene = read_osm(mutated(text, random), "mutated.osm");
        if (!scene) {
            EXPECT_FALSE(scene.error().sentence().empty());
            continue;
        }
        ++read;
        const Result<void> valid = validate(*scene);
        EXPECT_TRUE(valid.has_value()) << "round " << round << ": " << valid.error().sentence();
    }
    EXPECT_GT(read, 50) << "most become a world";
}

TEST(OsmTorture, self_crossing_outlines_and_circular_relations_terminate) {
    const std::string crossing =
        "<osm version='0.6'><node id='1' lat='51.0' lon='13.0'/><node id='2' lat='51.0001' lon='13.0001'/>"
        "<node id='3' lat='51.0' lon='13.0001'/><node id='4' lat='51.0001' lon='13.0'/>"
        "<way id='4'><nd ref='1'/><nd ref='2'/><nd ref='3'/><nd ref='4'/><nd ref='1'/><tag k='indoor' v='room'/></way>"
        "<way id='5'><nd ref='1'/><nd ref='2'/></way><way id='6'><nd ref='2'/><nd ref='1'/></way>"
        "<relation id='7'><member type='way' ref='5' role='outer'/><member type='way' ref='6' role='inner'/>"
        "<member type='relation' ref='7' role='outer'/><tag k='type' v='multipolygon'/><tag k='indoor' v='room'/>"
        "</relation></osm>";
    const Result<Scene> scene = read_osm(crossing, "crossing.osm");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_TRUE(validate(*scene).has_value());
}

TEST(OsmTorture, files_of_another_kind_are_reported) {
    for (const std::string text :
         {"", "<osm/>", "<osm version='0.6'></osm>", "<html></html>", "\0\0\0\x0c", "BZh9junk"}) {
        const Result<Scene> scene = read_osm(text, "odd.osm");
        ASSERT_FALSE(scene.has_value()) << text;
        EXPECT_FALSE(scene.error().sentence().empty());
    }
}

TEST(OsmTorture, recursively_growing_entities_are_refused) {
    const Result<Scene> scene = read_osm(
        "<?xml version='1.0'?><!DOCTYPE osm [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;&a;'>]><osm version='0.6'>"
        "<node id='1' lat='0' lon='0'><tag k='name' v='&b;'/></node></osm>",
        "grows.osm");
    ASSERT_FALSE(scene.has_value());
    EXPECT_THAT(scene.error().sentence(), HasSubstr("damaged"));
}

}  // namespace osm_torture_test
}  // namespace handrail
