// Mutates small worlds, deterministically: the same seeds everywhere. The endless form is tests/fuzz/readers_fuzzer (clang).
#include <random>

#include "tests/support/map_text.h"
#include "tests/support/scale.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace {

using test::box_brush;
using test::entity;
using test::key;

std::string mutated(const std::string& seed_text, const std::vector<std::string>& words, std::mt19937& random) {
    std::string text = seed_text;
    for (std::uint32_t edits = 1 + random() % 6; edits > 0 && !text.empty(); --edits) {
        const std::size_t at = random() % text.size(), length = std::min<std::size_t>(random() % 40, text.size() - at);
        switch (random() % 6) {
            case 0:
                text[at] = static_cast<char>(random());
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, text.substr(random() % text.size(), length));
                break;
            case 3:
                text.insert(at, words[random() % words.size()]);
                break;
            case 4:
                text.resize(at);
                break;
            default:
                std::swap(text[at], text[random() % text.size()]);
        }
    }
    return text;
}

void expect_whole(const Result<Scene>& scene) {
    if (!scene) {
        EXPECT_FALSE(scene.error().message.empty());
        return;
    }
    const Result<void> valid = validate(*scene);
    EXPECT_TRUE(valid.has_value()) << valid.error().sentence();
}

TEST(MutationFuzz, maps) {
    const std::vector<std::string> seeds{
        entity("worldspawn", key("message", "x") + key("building", "1"),
               test::room_brushes(0, 0, 0, 256, 192, 96) + box_brush(64, 64, 0, 80, 80, 96, "*water1")),
        entity("worldspawn", {}, box_brush(0, 0, 0, 64, 64, 64)) +
            entity("thing", key("cs_name", "liquid") + key("viscosity", "3") + key("friction", "0.5"), box_brush(64, 0, 0, 70, 9, 9)) +
            entity("func_door", key("name", "d") + key("hinge", "left"), box_brush(0, 64, 0, 64, 70, 64, "\"a b\"")) +
            entity("info_player_start", key("origin", "1 2 3") + key("angle", "90")),
        entity("func_wall", key("shape", "capsule") + key("axis", "-x"),
               box_brush(0, 0, 0, 64, 16, 16) + "{\npatchDef2\n{\nbase/tin\n( 3 3 0 0 0 )\n(\n( ( 0 0 0 0 0 ) ( 0 8 8 0 0 ) ( 0 16 0 0 0 ) )\n" +
                   "( ( 8 0 4 0 0 ) ( 8 8 9 0 0 ) ( 8 16 4 0 0 ) )\n( ( 16 0 0 0 0 ) ( 16 8 8 0 0 ) ( 16 16 0 0 0 ) )\n)\n}\n}\n"),
        "{\n{\n( 0 0 0 ) ( 0 1 0 ) ( 1 0 0 ) t [ 1 0 0 0 ] [ 0 1 0 0 ] 0 1 1 0 0 0\npatchDef2\n{\n( ( 1 ) )\n}\n}\n}\n",
    };
    const std::vector<std::string> words{"{",
                                         "}",
                                         "\"",
                                         "( ",
                                         " )",
                                         "[",
                                         "\n",
                                         "1e308",
                                         "-",
                                         "nan",
                                         "1e-320",
                                         "//",
                                         ";",
                                         "\\\"",
                                         "brushDef",
                                         "\"classname\" \"trigger_once\"",
                                         std::string(1, '\0')};
    for (int round = 0; round < test::scaled(4000); ++round) {
        SCOPED_TRACE(round);
        std::mt19937 random(static_cast<unsigned>(round));
        expect_whole(read_quake_map(mutated(seeds[static_cast<std::size_t>(round) % seeds.size()], words, random), "fuzz.map"));
    }
}

TEST(MutationFuzz, meshes) {
    const std::string seed = "o A\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nusemtl wood\nf 1 2 3 4\nf 1/1/1 2//2 -1\n";
    const std::vector<std::string> words{"v ", "f ", "-1", "0", "\\\n", "1e308", "nan", "/", "#", "usemtl brick\n", "g x\n"};
    for (int round = 0; round < test::scaled(8000); ++round) {
        SCOPED_TRACE(round);
        std::mt19937 random(static_cast<unsigned>(round));
        expect_whole(read_obj(mutated(seed, words, random), "fuzz.obj"));
    }
}

}  // namespace
}  // namespace handrail
