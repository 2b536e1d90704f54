// Tests the storage of what a person adds to a world: it is stored next to the world, never lost, and never misread.
#include "app/core/kept/side_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <random>

#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace side_file_test {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;

SideEntry mark(const std::string& name, double x) {
    return {{"name", name}, {"place_m", std::vector<double>{x, 0.1, -3.25}}, {"near_m", 0.1 + 0.2}};
}

TEST(SideFile, stores_entries_and_tables_next_to_the_world_to_the_last_bit) {
    const TemporaryFolder folder;
    const fs::path world = folder.write("house.map", "{ }");
    SideFile file = SideFile::of_world(world, {});
    EXPECT_TRUE(file.news().empty());
    EXPECT_TRUE(file.entries("mark").empty());
    file.set_entries("mark", {mark("Mark 1", 1e-17), mark("Zażółć \"gęślą\" \\ 家", 1.0)});
    file.set_table("names", {{"Room 3", std::string("Kitchen")}});
    ASSERT_TRUE(file.save());
    EXPECT_TRUE(fs::exists(folder.path() / "house.map.handrail.toml"));

    const SideFile again = SideFile::of_world(world, {});
    EXPECT_TRUE(again.news().empty());
    EXPECT_EQ(again.entries("mark"), (std::vector{mark("Mark 1", 1e-17), mark("Zażółć \"gęślą\" \\ 家", 1.0)}));
    EXPECT_EQ(text_of(again.table("names"), "Room 3"), "Kitchen");
    EXPECT_EQ(again.world_checksum(), file.world_checksum());
    EXPECT_EQ(again.world_checksum().size(), 8U);
}

TEST(SideFile, keeps_unknown_content) {
    const TemporaryFolder folder;
    const fs::path world = folder.write("a.map", "");
    folder.write("a.map.handrail.toml",
                 "later = 2031-01-02\n[[mark]]\nname = \"m\"\nof_a_later_version = { deep = [1, \"x\"] }\nwhole = [1, "
                 "2]\n[other.part]\nkey = 3\n");
    SideFile file = SideFile::of_world(world, {});
    auto marks = file.entries("mark");
    ASSERT_EQ(marks.size(), 1U);
    marks[0]["name"] = std::string("new");
    file.set_entries("mark", marks);
    ASSERT_TRUE(file.save());
    const std::string text = test::content_of(folder.path() / "a.map.handrail.toml");
    for (const char* part : {"2031-01-02", "of_a_later_version", "deep", "[ 1, \"x\" ]", "whole = [ 1, 2 ]",
                             "[other.part]", "key = 3", "new"})
        EXPECT_THAT(text, HasSubstr(part));
    EXPECT_EQ(SideFile::of_world(world, {}).entries("mark"), marks);
}

// In a folder of another person, the side file could be a link to any file of the user.
TEST(SideFile, is_never_read_or_written_through_a_symbolic_link) {
    const TemporaryFolder folder, data;
    const fs::path world = folder.write("a.map", "x");
    const std::string diary = "[[mark]]\nname = \"mine\"\nplace_m = [0.0, 0.0, 0.0]\n";
    for (const char* content : {diary.c_str(), "not of this form"}) {
        folder.write("diary", content);
        const fs::path link = folder.path() / "a.map.handrail.toml";
        fs::create_symlink("diary", link);
        for (const fs::path& elsewhere : {data.path(), fs::path()}) {
            SideFile file = SideFile::of_world(world, elsewhere);
            ASSERT_EQ(file.news().size(), 1U);
            EXPECT_THAT(file.news()[0], HasSubstr("a.map.handrail.toml is a link to another file"));
            EXPECT_TRUE(file.entries("mark").empty());
            EXPECT_TRUE(SideFile::peek(world, elsewhere, false, "unit").empty());
            file.set_entries("mark", {mark("new", 1.0)});
            const Result<void> saved = file.save();
            EXPECT_EQ(saved.has_value(), !elsewhere.empty());
            if (saved) EXPECT_EQ(SideFile::of_world(world, elsewhere).entries("mark").size(), 1U);
            else EXPECT_THAT(saved.error().sentence(), HasSubstr("a.map.handrail.toml: This is a link"));
        }
        EXPECT_EQ(test::content_of(folder.path() / "diary"), content);
        EXPECT_TRUE(fs::is_symlink(link));
        EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 3) << "nothing aside";
        fs::remove(link);
        fs::remove_all(data.path() / "worlds");
    }
}

TEST(SideFile, is_not_written_through_a_symbolic_link_that_appears_later) {
    const TemporaryFolder folder;
    const fs::path world = folder.write("a.map", "x"), diary = folder.write("diary", "mine");
    SideFile file = SideFile::of_world(world, {});
    file.set_entries("mark", {mark("new", 1.0)});
    fs::create_symlink("diary", folder.path() / "a.map.handrail.toml");
    EXPECT_FALSE(file.save());
    EXPECT_EQ(test::content_of(diary), "mine");
    fs::remove(folder.path() / "a.map.handrail.toml");
    EXPECT_TRUE(file.save()) << "nothing is lost";
}

TEST(SideFile, that_is_damaged_is_set_aside_reported_and_started_empty) {
    const TemporaryFolder folder;
    const fs::path world = folder.write("a.map", "x");
    for (int round = 1; round <= 2; ++round) {
        folder.write("a.map.handrail.toml", "[[mark]]\nname = \"half");
        SideFile file = SideFile::of_world(world, {});
        ASSERT_EQ(file.news().size(), 1U);
        const std::string kept = round == 1 ? "a.map.handrail.toml.damaged" : "a.map.handrail.toml.damaged-2";
        EXPECT_THAT(file.news()[0], HasSubstr("damaged in line 2"));
        EXPECT_THAT(file.news()[0], HasSubstr(kept));
        EXPECT_EQ(test::content_of(folder.path() / kept), "[[mark]]\nname = \"half");
        EXPECT_TRUE(file.entries("mark").empty());
        file.set_entries("mark", {mark("fresh", 1.0)});
        ASSERT_TRUE(file.save());
        EXPECT_EQ(SideFile::of_world(world, {}).entries("mark").size(), 1U);
    }
}

TEST(SideFile, survives_being_cut_or_changed_at_every_byte) {
    const TemporaryFolder folder;
    const fs::path world = folder.write("a.map", "x");
    SideFile file = SideFile::of_world(world, {});
    file.set_entries("mark", {mark("Mark 1", 2.0)});
    ASSERT_TRUE(file.save());
    const fs::path path = folder.path() / "a.map.handrail.toml";
    const std::string whole = test::content_of(path);
    std::mt19937 random(test::seed_of_run());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string broken = whole;
        if (i % 2 == 0) broken.resize(i);
        else broken[i] = static_cast<char>(random());
        folder.write("a.map.handrail.toml", broken);
        const SideFile read = SideFile::of_world(world, {});
        // Either the session reads the file, or it reports the file and keeps it under another name.
        if (read.news().empty()) EXPECT_LE(read.entries("mark").size(), 1U);
        else EXPECT_FALSE(fs::exists(path));
        for (const SideEntry& entry : read.entries("mark")) {
            text_of(entry, "name");
            EXPECT_TRUE(numbers_of(entry, "place_m", 3).empty() || numbers_of(entry, "place_m", 3).size() == 3);
        }
    }
}

TEST(SideFile, goes_to_the_data_folder_if_the_worlds_folder_is_not_writable) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    const TemporaryFolder folder, data, other;
    const fs::path world = folder.write("a.map", "x");
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    SideFile file = SideFile::of_world(world, data.path());
    file.set_entries("mark", {mark("m", 1.0)});
    ASSERT_TRUE(file.save());
    EXPECT_EQ(file.path().parent_path(), data.path() / "worlds");
    EXPECT_EQ(SideFile::of_world(world, data.path()).entries("mark").size(), 1U);
    // Another world of the same name has separate additions.
    EXPECT_TRUE(SideFile::of_world(other.write("a.map", "x"), data.path()).entries("mark").empty());
    // Once the folder can be written again, the earlier additions are still there.
    fs::permissions(folder.path(), fs::perms::owner_all);
    EXPECT_EQ(SideFile::of_world(world, data.path()).entries("mark").size(), 1U);
}

TEST(SideFile, goes_to_the_data_folder_if_the_worlds_folder_is_read_only_for_everyone) {
    const TemporaryFolder data;
    SideFile file = SideFile::of_world("/proc/version", data.path());
    file.set_entries("mark", {mark("m", 1.0)});
    ASSERT_TRUE(file.save());
    EXPECT_EQ(file.path().parent_path(), data.path() / "worlds");
    EXPECT_EQ(SideFile::of_world("/proc/version", data.path()).entries("mark").size(), 1U);
}

TEST(SideFile, uses_the_data_folder_if_saving_next_to_the_world_fails) {
    const TemporaryFolder folder, data;
    // The name is valid for the world, but leaves no room for the extension of the side file.
    const std::string name(244, 'w');
    const fs::path world = folder.write(name, "x");
    SideFile file = SideFile::of_world(world, data.path());
    file.set_entries("mark", {mark("m", 1.0)});
    ASSERT_TRUE(file.save());
    EXPECT_EQ(SideFile::of_world(world, data.path()).entries("mark").size(), 1U);
    SideFile nowhere = SideFile::of_world(world, {});
    nowhere.set_entries("mark", {mark("m", 1.0)});
    EXPECT_FALSE(nowhere.save());
}

TEST(SideFile, in_memory_stores_and_returns_values_without_writing) {
    SideFile file;
    file.set_entries("mark", {mark("m", 1.0)});
    EXPECT_EQ(file.entries("mark").size(), 1U);
    EXPECT_TRUE(file.save());
    EXPECT_TRUE(file.path().empty());
}

TEST(SideFile, is_copied_aside_before_a_value_that_is_not_a_list_is_overwritten) {
    const auto own_name = [](const SideEntry& entry) -> Result<std::string> { return text_of(entry, "name"); };
    for (const std::string& odd : {std::string("mark = 3\n"), std::string("mark = [{ name = \"a\" }, 3]\n"),
                                   std::string("[mark]\nname = \"a\"\n")}) {
        const TemporaryFolder folder;
        const fs::path world = folder.write("a.map", "x"), kept = folder.path() / "a.map.handrail.toml.damaged";
        const std::string text = "# mine\n" + odd + "[[way]]\nname = \"w\"\n";
        folder.write("a.map.handrail.toml", text);
        SideFile file = SideFile::of_world(world, {});
        std::vector<Error> faults;
        read_list(file, "way", own_name, faults);
        EXPECT_TRUE(faults.empty());
        read_list(file, "mark", own_name, faults);
        ASSERT_EQ(faults.size(), 1U) << odd;
        EXPECT_EQ(
            faults[0].sentence(),
            "a.map.handrail.toml, line 2: mark must be a list of entries, each under [[mark]]. Correct it. Before "
            "any change, the file is copied to a.map.handrail.toml.damaged.");
        file.set_entries("way", file.entries("way"));
        ASSERT_TRUE(file.save());
        EXPECT_FALSE(fs::exists(kept)) << "it is still there";
        folder.write("a.map.handrail.toml", text);
        file.set_entries("mark", {mark("new", 1.0)});
        ASSERT_TRUE(file.save());
        EXPECT_EQ(test::content_of(kept), text);
        EXPECT_EQ(SideFile::of_world(world, {}).entries("mark").size(), 1U);
        EXPECT_FALSE(SideFile::of_world(world, {}).fault_of_list("mark"));
        file.set_entries("mark", {mark("newer", 1.0)});
        ASSERT_TRUE(file.save());
        EXPECT_FALSE(fs::exists(kept.string() + "-2")) << "once";
        // If the file cannot be copied, it is not overwritten.
        folder.write("a.map.handrail.toml", text);
        SideFile again = SideFile::of_world(world, {});
        fs::remove(folder.path() / "a.map.handrail.toml");
        again.set_entries("mark", {mark("new", 1.0)});
        EXPECT_FALSE(again.save());
    }
}

TEST(SideFile, reads_values_of_the_wrong_type_as_missing) {
    const TemporaryFolder folder;
    const fs::path world = folder.write("a.map", "x");
    folder.write("a.map.handrail.toml",
                 "mark = 3\nnames = [1]\n[[spot]]\nname = 7\nplace_m = [1.0, nan, 2.0]\nnear_m = inf\n");
    const SideFile file = SideFile::of_world(world, {});
    EXPECT_TRUE(file.entries("mark").empty());
    EXPECT_TRUE(file.table("names").empty());
    const SideEntry spot = file.entries("spot").at(0);
    EXPECT_EQ(text_of(spot, "name", "none"), "none");
    EXPECT_TRUE(numbers_of(spot, "place_m", 3).empty());
    EXPECT_EQ(number_of(spot, "near_m", -1.0), -1.0);
}

TEST(GoodName, accepts_any_utf8_line_of_up_to_200_bytes) {
    EXPECT_EQ(*good_name("  Bücher — 本  "), "Bücher — 本");
    EXPECT_EQ(good_name(std::string(200, 'x'))->size(), 200U);
    for (const std::string& bad : {std::string(), std::string("  \n"), std::string(201, 'x'), std::string("a\nb"),
                                   std::string("\xff"), std::string("a\0b", 3)})
        EXPECT_FALSE(good_name(bad)) << bad;
}

}  // namespace side_file_test
}  // namespace handrail
