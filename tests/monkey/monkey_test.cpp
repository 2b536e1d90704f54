// Tests the program with 8,000 random actions, or 2,400 under a sanitizer, in eight parts, each with its own worlds.
// HANDRAIL_ACTS sets the number of actions. HANDRAIL_SEED repeats a run.
#include "tests/monkey/monkey.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/random_families.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/support/worlds_once.h"
#include "worlds/base/language.h"

namespace handrail::test {
namespace monkey_test {

namespace fs = std::filesystem;

constexpr int kParts = 8;

int acts_of_part() {
    const char* all = std::getenv("HANDRAIL_ACTS");
    return (all ? std::atoi(all) : kSanitizerScale < 1.0 ? 2400 : 8000) / kParts;
}

std::shared_ptr<const Scene> world(const fs::path& file) { return world_once(file); }

std::vector<std::shared_ptr<const Scene>> worlds_of(int part) {
    const fs::path root = test::project_root(), maps = root / "worlds/maps", small = root / "tests/scenarios/worlds";
    switch (part) {
        case 0:
            return {world(maps / "first_room.map"), world(maps / "seams.map")};
        case 1:
            return {world(maps / "house.map")};
        case 2:
            return {world(maps / "school.map"), world(maps / "first_room.map")};
        case 3: {
            const auto games = with_real_worlds({maps / "house.map"}, {"quake-e1m1.map"});
            return {world(games.back()), world(small / "game_step.map")};
        }
        case 4:
            return {world(small / "every_property.map"), world(small / "two_pools.map")};
        case 5:
            return {world(small / "two_rooms_door.map"), world(small / "stairs_hall.map")};
        case 6:
            return {world(small / "unit_box.obj"), world(small / "diagonal.map"), world(small / "picture_panel.map")};
        default:
            return {world(small / "messages.map"), world(small / "materials_board.map"),
                    world(small / "original_tags.map")};
    }
}

class MonkeySession : public testing::TestWithParam<int> {};

TEST_P(MonkeySession, never_exceeds_the_force_ceiling_never_enters_a_wall_and_always_gets_an_answer) {
    const std::uint32_t seed = seed_of_run() + static_cast<std::uint32_t>(GetParam());
    RecordProperty("seed", std::to_string(seed));
    std::cout << "HANDRAIL_SEED=" << seed_of_run() << "\n";
    Monkey monkey(seed, worlds_of(GetParam()));
    const int acts = acts_of_part();
    for (int i = 0; i < acts; ++i)
        ASSERT_TRUE(monkey.act()) << "HANDRAIL_SEED=" << seed_of_run() << ", act " << i << ": " << monkey.story();
    const auto looks = monkey.done().find("ball in its place");
    const auto looked = looks == monkey.done().end() ? 0 : looks->second;
    // In a short run, a rare act may not happen, and no proxy may be checked at its place.
    if (acts >= 1000) {
        for (const char* kind : {"command", "key", "text", "line", "hand", "trouble", "device", "setting", "question"})
            EXPECT_GT(monkey.done().count(kind), 0U) << kind << " never came about";
        EXPECT_GT(looked, 0) << "the ball was never looked at";
    }
    std::cout << acts << " acts, " << monkey.seconds() << " s of its time, " << monkey.lines()
              << " lines, the ball looked at " << looked << " times\n";
    EXPECT_TRUE(speak_language("en"));
}

INSTANTIATE_TEST_SUITE_P(Part, MonkeySession, testing::Range(0, kParts));

}  // namespace monkey_test
}  // namespace handrail::test
