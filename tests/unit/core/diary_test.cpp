// Tests the diary: the rooms that a person visited, with dates and what was learnt. It is kept only with consent.
#include <gmock/gmock.h>

#include "app/core/learning/diary.h"
#include "app/core/learning/learnt_file.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace diary_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

// A person in the house on one day, who may have agreed to be remembered.
struct OnADay : test::AppSession {
    OnADay(const fs::path& world, const std::string& day, bool agreed = true)
        : AppSession({}, {}, SessionOptions{.day = day}) {
        SideFile additions = SideFile::of_world(world, {});
        set_remembers(additions, agreed);
        app.apply(WorldEntered{make_ready(test::our_world("house.map")), std::move(additions)}, 0.0);
        run(0.1);
        request(Command::Exits);  // after this query, the session knows the rooms of the world
        run(0.1);
        said.clear();
    }
    // Stays for some seconds and walks meanwhile, so that there is something to remember.
    void stay() {
        walk(1.0);
        run(8.0);
    }
    void leave() {
        app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, now);
        run(0.1);
    }
};

TEST(Diary, lists_the_rooms_of_each_day_with_what_was_learnt) {
    const test::TemporaryFolder folder;
    const fs::path world = folder.path() / "house.map";
    {
        OnADay first(world, "2026-11-30");
        EXPECT_EQ(first.request(Command::Diary), "The diary is empty. A visit to a room counts after five seconds.");
        first.stay();
        first.request(Command::Diary);
        ASSERT_TRUE(first.app.dialogue().is_open());
        EXPECT_THAT(first.said.back(), StartsWith("Diary, one visit. Today: Hall, "));
        EXPECT_THAT(first.said.back(), HasSubstr(" percent, floor "));
        first.leave();
    }
    OnADay second(world, "2026-12-01");
    second.stay();
    second.request(Command::Diary);
    const auto items = second.app.dialogue().view().items;
    ASSERT_EQ(items.size(), 2U);
    EXPECT_EQ(items[0].name, "Today: Hall");
    EXPECT_EQ(items[1].name, "30 November 2026: Hall");
}

TEST(Diary, is_not_kept_without_consent_and_is_deleted_with_it) {
    const test::TemporaryFolder folder;
    const fs::path world = folder.path() / "house.map";
    {
        OnADay person(world, "2026-11-30", false);
        person.stay();
        EXPECT_THAT(person.request(Command::Diary), StartsWith("There is no diary."));
        person.leave();
    }
    EXPECT_TRUE(read_diary(SideFile::of_world(world, {})).empty());
    {
        OnADay person(world, "2026-11-30");
        person.stay();
        person.leave();
    }
    SideFile kept = SideFile::of_world(world, {});
    EXPECT_EQ(read_diary(kept).size(), 1U);
    set_remembers(kept, false);
    EXPECT_TRUE(read_diary(kept).empty());
}

TEST(Diary, joins_visits_of_one_day_and_is_written_as_a_table) {
    std::vector<DiaryEntry> diary{{"2026-11-30", "Hall", 60.0, 10, 5, {}}};
    add_visit(diary, {"2026-11-30", "Hall", 30.0, 20, 15, {}});
    add_visit(diary, {"2026-12-01", "Room \"A\"", 5.4, 1, 2, {}});
    EXPECT_EQ(diary_csv("house.map", diary),
              "\"house.map\",2026-11-30,\"Hall\",90,20,15\r\n\"house.map\",2026-12-01,\"Room \"\"A\"\"\",5,1,2\r\n");
    SideFile file;
    write_diary(file, diary);
    EXPECT_EQ(diary_csv("", read_diary(file)), diary_csv("", diary));
    SideEntry broken{{"room", std::string("Hall")}, {"spent_s", -3.0}};
    file.set_entries("diary", {broken});
    EXPECT_TRUE(read_diary(file).empty());
}

}  // namespace diary_test
}  // namespace handrail
