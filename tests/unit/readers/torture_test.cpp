// Tests files that no editor writes. The reader must end in time, with a valid Scene or with a sentence.
#include <atomic>
#include <cstdlib>
#include <random>
#include <thread>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace torture_test {

using test::box_brush;
using test::entity;

// Reads the bytes as a map and checks the result. Returns the number of solids.
std::size_t survive(std::string_view bytes) {
    const Result<Scene> scene = read_quake_map(bytes, "torture.map");
    if (!scene) {
        EXPECT_FALSE(scene.error().message.empty());
        return 0;
    }
    const Result<void> valid = validate(*scene);
    EXPECT_TRUE(valid.has_value()) << valid.error().sentence();
    EXPECT_LE(scene->report.warnings.size(), 20U);
    EXPECT_GE(scene->report.warnings_in_all, static_cast<int>(scene->report.warnings.size()));
    return scene->solids.size();
}

const std::string kSmall = "// small\n" +
                           entity("worldspawn", "\"message\" \"a \\\"b\\\"\"\n",
                                  box_brush(0, 0, 0, 64, 64, 64, "{x") + box_brush(64, 0, 0, 96, 64, 64, "*water")) +
                           entity("func_door", "\"name\" \"D\"\n", box_brush(0, 64, 0, 64, 80, 64, "\"q r\"")) +
                           entity("info_player_start", "\"origin\" \"1 2 3\"\n");

TEST(Torture, a_map_cut_at_every_byte_is_survived) {
    std::size_t most = 0;
    for (std::size_t length = 0; length <= kSmall.size(); ++length) {
        const std::size_t solids = survive(std::string_view(kSmall).substr(0, length));
        EXPECT_GE(solids, most) << "a longer file lost what a shorter one had, at byte " << length;
        most = std::max(most, solids);
    }
    EXPECT_EQ(most, 3U);
}

TEST(Torture, complete_maps_cut_at_every_97th_byte_are_survived) {
    // Cuts the small map at every place, and the larger maps at some places all over the file. If HANDRAIL_EVERY_CUT=1
    // is set, cuts every map at every place, which takes minutes of processor time on all processors together.
    const bool every = std::getenv("HANDRAIL_EVERY_CUT") != nullptr;
    const auto maps = test::project_root() / "worlds/maps";
    for (const auto& path :
         test::with_real_worlds({maps / "first_room.map", maps / "house.map", maps / "school.map"},
                                {"agtut01.map", "agdm01.map", "house.map", "office.map", "quake-e1m1.map",
                                 "quake-start.map", "quake-dm3.map", "agtut03.map", "agtut05.map"})) {
        const std::string bytes = test::content_of(path);
        const std::size_t cuts = bytes.size() / 97,
                          tried = static_cast<std::size_t>(test::scaled(bytes.size() < 20000 ? 150 : 8));
        const std::size_t step = every ? 97 : std::max<std::size_t>(1, cuts / tried) * 97;
        std::atomic<std::size_t> next{97}, survived{0};
        const auto work = [&] {
            for (std::size_t length = next.fetch_add(step); length < bytes.size(); length = next.fetch_add(step)) {
                survive(std::string_view(bytes).substr(0, length));
                ++survived;
            }
        };
        std::vector<std::thread> helpers;
        for (unsigned i = 1; every && i < std::thread::hardware_concurrency(); ++i) helpers.emplace_back(work);
        work();
        for (std::thread& helper : helpers) helper.join();
        EXPECT_EQ(survived, (bytes.size() - 98) / step + 1);
        if (every) fmt::print("{}: {} cuts survived\n", path.filename().string(), survived.load());
    }
}

TEST(Torture, two_hundred_thousand_braces_are_survived) {
    EXPECT_EQ(survive(std::string(200000, '{')), 0U);
    EXPECT_EQ(survive(std::string(200000, '}')), 0U);
    std::string pairs;
    for (int i = 0; i < 100000; ++i) pairs += "{}";
    EXPECT_EQ(survive(pairs), 0U);
    EXPECT_EQ(survive(entity("worldspawn", {}, box_brush(0, 0, 0, 64, 64, 64)) + std::string(200000, '{')), 1U);
}

TEST(Torture, lines_of_a_hundred_megabytes_are_survived) {
    const std::size_t length = static_cast<std::size_t>(100e6 * test::kSanitizerScale * test::kSanitizerScale);
    EXPECT_EQ(survive(std::string(length, 'x')), 0U);
    EXPECT_EQ(survive("{\n\"a\" \"" + std::string(length / 4, 'x')), 0U);
    EXPECT_EQ(survive(entity("worldspawn", "\"message\" \"" + std::string(length / 4, '\\') + "\"\n",
                             box_brush(0, 0, 0, 64, 64, 64, std::string(length / 40, 'x')))),
              1U);
}

TEST(Torture, random_bytes_and_random_tokens_are_survived) {
    std::mt19937 random(1);
    for (int round = 0; round < test::scaled(300); ++round) {
        std::string bytes(random() % 4000, '\0');
        for (char& c : bytes) c = static_cast<char>(random());
        survive(bytes);
    }
    const std::vector<std::string> tokens{"{",
                                          "}",
                                          "(",
                                          ")",
                                          "[",
                                          "]",
                                          "\"",
                                          "\\\"",
                                          "\n",
                                          "\r",
                                          " ",
                                          "//",
                                          ";",
                                          "0",
                                          "64",
                                          "-1e9",
                                          "1e300",
                                          "tex",
                                          "*water",
                                          "patchDef2",
                                          "brushDef",
                                          "\"classname\" \"worldspawn\"\n",
                                          "\"cs_name\" \"liquid\"\n",
                                          "( 0 0 0 ) ( 1 0 0 ) ( 0 1 0 ) t 0 0 0 1 1\n",
                                          box_brush(0, 0, 0, 64, 64, 64)};
    for (int round = 0; round < test::scaled(2000); ++round) {
        std::string text = "{\n";
        for (int i = 0; i < 60; ++i) text += tokens[random() % tokens.size()] + (random() % 3 ? " " : "");
        survive(text);
    }
}

TEST(Torture, random_planes_through_a_small_grid_are_survived) {
    // Thousands of needles and wedges, brushes with repeated and opposite planes, and empty and open brushes, all on
    // top of each other.
    std::mt19937 random(2);
    for (int round = 0; round < test::scaled(60); ++round) {
        std::string brushes = box_brush(0, 0, 0, 8, 8, 8);
        for (int b = 0; b < 40; ++b) {
            brushes += "{\n";
            for (int f = 0; f < 4 + static_cast<int>(random() % 8); ++f) {
                for (int p = 0; p < 3; ++p)
                    brushes += fmt::format("( {} {} {} ) ", random() % 9, random() % 9, random() % 9);
                brushes += "t 0 0 0 1 1\n";
            }
            brushes += "}\n";
        }
        EXPECT_GE(survive(entity("worldspawn", {}, brushes)), 1U);
    }
}

TEST(Torture, far_and_tiny_coordinates_are_survived) {
    for (const double far : {1e4, 1e6, 3e7, 1e9, 1e150, 1e300})
        for (const double size : {1e-6, 1e-3, 1.0, 1e4})
            survive(
                entity("worldspawn", {},
                       box_brush(far, far, far, far + size, far + size, far + size) + box_brush(0, 0, 0, 64, 64, 64)));
}

}  // namespace torture_test
}  // namespace handrail
