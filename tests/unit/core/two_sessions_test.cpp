// Tests two sessions in one world. In the end, the file contains everything that either session has added, changed or
// deleted, whatever the order in which they save.
#include <gmock/gmock.h>
#include <sys/file.h>

#include <map>
#include <random>
#include <set>

#include "app/core/kept/folder_lock.h"
#include "app/core/kept/side_merge.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/random_families.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/app_session.h"
#include "worlds/base/files.h"

namespace handrail {
namespace two_sessions_test {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

SideEntry entry(const std::string& name, double x) {
    return {{"name", name}, {"place_m", std::vector<double>{x, 0.0, 0.0}}};
}

std::vector<std::string> names(const std::vector<SideEntry>& entries) {
    std::vector<std::string> all;
    for (const SideEntry& one : entries) all.push_back(text_of(one, "name"));
    return all;
}

TEST(SideMerge, keeps_what_either_session_added_and_drops_what_either_deleted) {
    const std::vector<SideEntry> base{entry("a", 1.0), entry("b", 2.0), entry("c", 3.0)};
    const MergedEntries merged = merge_entries(base, {base[0], base[2], entry("mine", 4.0)},
                                               {base[0], base[1], entry("theirs", 5.0)}, Alike::OneThing);
    EXPECT_THAT(names(merged.entries), ElementsAre("a", "mine", "theirs"));
    EXPECT_THAT(merged.conflicts, IsEmpty());
    EXPECT_TRUE(merged.differs);
}

TEST(SideMerge, accepts_each_change_that_only_one_session_made) {
    const std::vector<SideEntry> base{entry("a", 1.0), entry("b", 2.0)};
    const MergedEntries merged =
        merge_entries(base, {entry("A", 1.0), base[1]}, {base[0], entry("b", 2.5)}, Alike::OneThing);
    ASSERT_EQ(merged.entries.size(), 2U);
    EXPECT_TRUE(same(merged.entries[0], entry("A", 1.0)));
    EXPECT_TRUE(same(merged.entries[1], entry("b", 2.5)));
    EXPECT_THAT(merged.conflicts, IsEmpty());
}

TEST(SideMerge, keeps_both_versions_of_a_conflicting_change_and_reports_the_name) {
    const std::vector<SideEntry> base{entry("a", 1.0), entry("b", 2.0), entry("c", 3.0)};
    const MergedEntries merged = merge_entries(base, {entry("mine", 1.0), entry("b changed", 2.0)},
                                               {entry("theirs", 1.0), entry("c changed", 3.0)}, Alike::OneThing);
    EXPECT_THAT(names(merged.entries), UnorderedElementsAre("mine", "theirs", "b changed", "c changed"))
        << "a change counts more than a deletion";
    EXPECT_THAT(merged.conflicts, UnorderedElementsAre("mine", "b changed", "c changed"));
    // If both sessions make the same change, there is no conflict. If both add the same entry, the result contains that
    // entry once.
    const MergedEntries alike = merge_entries(base, {entry("x", 1.0), base[1], base[2], entry("new", 9.0)},
                                              {entry("x", 1.0), base[1], base[2], entry("new", 9.0)}, Alike::OneThing);
    EXPECT_THAT(names(alike.entries), ElementsAre("x", "b", "c", "new"));
    EXPECT_THAT(alike.conflicts, IsEmpty());
    EXPECT_FALSE(alike.differs);
}

TEST(SideMerge, reports_a_name_that_both_sessions_gave_to_new_things) {
    const MergedEntries merged = merge_entries({}, {entry("Mark 1", 1.0)}, {entry("mark 1", 2.0)}, Alike::OneThing);
    EXPECT_EQ(merged.entries.size(), 2U);
    EXPECT_THAT(merged.twice, ElementsAre("mark 1"));
}

TEST(SideMerge, treats_values_that_are_not_numbers_as_unchanged) {
    SideEntry odd = entry("a", std::nan(""));
    odd["near_m"] = std::nan("");
    const MergedEntries merged = merge_entries({odd, odd}, {odd, odd}, {odd, odd}, Alike::OneThing);
    EXPECT_EQ(merged.entries.size(), 2U);
    EXPECT_FALSE(merged.differs);
}

TEST(SideMerge, treats_identical_marks_of_two_sessions_as_two_independent_marks) {
    const SideEntry mark = entry("Mark 1", 1.0);
    EXPECT_EQ(merge_entries({}, {mark}, {mark}, Alike::OneThing).entries.size(), 1U);
    EXPECT_EQ(merge_entries({}, {mark}, {mark}, Alike::TwoThings).entries.size(), 2U);
    const std::vector<SideEntry> base{mark, mark};
    const auto merged = [&](const std::vector<SideEntry>& here, const std::vector<SideEntry>& other) {
        MergedEntries all = merge_entries(base, here, other, Alike::TwoThings);
        EXPECT_THAT(all.conflicts, IsEmpty());
        return names(all.entries);
    };
    EXPECT_THAT(merged({entry("Coat", 1.0), mark}, {mark, entry("Shoes", 1.0)}), UnorderedElementsAre("Coat", "Shoes"));
    EXPECT_THAT(merged({entry("Coat", 1.0), mark}, {entry("Shoes", 1.0), mark}), UnorderedElementsAre("Coat", "Shoes"));
    EXPECT_THAT(merged({entry("Coat", 1.0), mark}, {entry("Coat", 1.0), mark}), UnorderedElementsAre("Coat", "Coat"));
    EXPECT_THAT(merged({mark}, {entry("Shoes", 1.0), mark}), ElementsAre("Shoes"));
    EXPECT_THAT(merged({entry("Coat", 1.0), mark}, {mark}), ElementsAre("Coat"));
}

TEST(SideMerge, merges_tables_key_by_key) {
    const MergedTable merged = merge_table({{"a", 1.0}, {"b", 1.0}, {"c", 1.0}},
                                           {{"a", 2.0}, {"b", 1.0}, {"c", 2.0}, {"d", 1.0}}, {{"a", 1.0}, {"c", 3.0}});
    EXPECT_TRUE(same(merged.table, SideEntry{{"a", 2.0}, {"c", 2.0}, {"d", 1.0}}));
    EXPECT_THAT(merged.conflicts, ElementsAre("c"));
}

// A reference model of two sessions and their file. It identifies each entry by a number and keeps all its values. The
// tested code knows only the file.
class Twin {
public:
    using Values = std::map<int, std::set<std::string>>;  // the values of each existing entry
    struct One {
        Values base, now;
        bool changed = false;
    };
    One a, b;
    Values file;

    // The values of an entry are a set. The set contains the common values that neither session has removed, and all
    // values that either session has added. So a change wins over a deletion, and two changes are both kept.
    void save(One& s) {
        if (!std::exchange(s.changed, false)) return;
        std::set<int> all;
        for (const Values* one : {&s.base, &s.now, &file})
            for (const auto& [id, values] : *one) all.insert(id);
        Values merged;
        const auto at = [](const Values& values, int id) {
            const auto found = values.find(id);
            return found == values.end() ? std::set<std::string>{} : found->second;
        };
        for (const int id : all) {
            const auto before = at(s.base, id), here = at(s.now, id), there = at(file, id);
            std::set<std::string> stays;
            for (const std::string& value : before)
                if (here.contains(value) && there.contains(value)) stays.insert(value);
            for (const auto& values : {here, there})
                for (const std::string& value : values)
                    if (!before.contains(value)) stays.insert(value);
            if (!stays.empty()) merged[id] = stays;
        }
        file = s.base = s.now = merged;
    }
};

std::multiset<std::string> all_of(const Twin::Values& values) {
    std::multiset<std::string> all;
    for (const auto& [id, ones] : values) all.insert(ones.begin(), ones.end());
    return all;
}

TEST(TwoSessions, lose_nothing_in_random_interleavings_of_their_edits) {
    const std::uint32_t seed = test::seed_of_run();
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto upto = [&](int most) { return std::uniform_int_distribution(0, most)(random); };
    const TemporaryFolder folder;
    const fs::path world = folder.write("a.map", "x");
    const int runs = test::scaled(20);
    for (int run = 0; run < runs; ++run) {
        fs::remove(folder.path() / "a.map.handrail.toml");
        std::vector<SideFile> files;
        for (int i = 0; i < 2; ++i) files.push_back(SideFile::of_world(world, {}));
        Twin twin;
        int last_id = 0, last_name = 0;
        for (int step = 0; step < 40; ++step) {
            const int who = upto(1);
            SideFile& file = files[static_cast<std::size_t>(who)];
            Twin::One& session = who == 0 ? twin.a : twin.b;
            std::vector<SideEntry> list = file.entries("mark");
            const auto here = names(list);
            ASSERT_EQ(std::multiset<std::string>(here.begin(), here.end()), all_of(session.now))
                << "run " << run << ", step " << step;
            const int what = upto(9);
            // If both sessions have changed an entry, it is in the list twice. The test cannot distinguish the two, so
            // it does not change them.
            std::vector<int> plain;
            for (const auto& [id, values] : session.now)
                if (values.size() == 1) plain.push_back(id);
            const auto place = [&](int id) {
                return std::find_if(list.begin(), list.end(),
                                    [&](const SideEntry& one) { return numbers_of(one, "place_m", 3)[0] == id; });
            };
            if (what < 4) {
                const std::string name = "n" + std::to_string(++last_name);
                list.push_back(entry(name, ++last_id));
                session.now[last_id] = {name};
            } else if (what < 6 && !plain.empty()) {
                const int id = plain[static_cast<std::size_t>(upto(static_cast<int>(plain.size()) - 1))];
                const std::string name = "n" + std::to_string(++last_name);
                (*place(id))["name"] = name;
                session.now[id] = {name};
            } else if (what < 7 && !plain.empty()) {
                const int id = plain[static_cast<std::size_t>(upto(static_cast<int>(plain.size()) - 1))];
                list.erase(place(id));
                session.now.erase(id);
            } else {
                ASSERT_TRUE(file.save());
                twin.save(session);
                const auto there = names(SideFile::of_world(world, {}).entries("mark"));
                ASSERT_EQ(std::multiset<std::string>(there.begin(), there.end()), all_of(twin.file))
                    << "run " << run << ", step " << step;
                continue;
            }
            session.changed = true;
            std::shuffle(list.begin(), list.end(), random);
            file.set_entries("mark", list);
        }
    }
}

TEST(TwoSessions, learn_on_saving_what_the_other_session_has_added) {
    const TemporaryFolder folder;
    const fs::path world = folder.write("a.map", "x");
    SideFile mine = SideFile::of_world(world, {}), theirs = SideFile::of_world(world, {});
    theirs.set_entries("mark", {entry("theirs", 1.0)});
    theirs.set_table("other", {{"kept", true}});
    ASSERT_TRUE(theirs.save());
    EXPECT_FALSE(theirs.take_over().differs);
    mine.set_entries("mark", {entry("mine", 2.0)});
    ASSERT_TRUE(mine.save());
    EXPECT_THAT(names(mine.entries("mark")), ElementsAre("mine", "theirs"));
    EXPECT_EQ(mine.table("other").size(), 1U);
    EXPECT_TRUE(mine.take_over().differs);
    EXPECT_FALSE(mine.take_over().differs) << "once";
}

TEST(TwoSessions, set_aside_and_report_a_file_that_was_damaged_meanwhile) {
    const TemporaryFolder folder;
    const fs::path world = folder.write("a.map", "x");
    SideFile mine = SideFile::of_world(world, {});
    mine.set_entries("mark", {entry("mine", 2.0)});
    folder.write("a.map.handrail.toml", "[[mark]]\nname = \"theirs");
    ASSERT_TRUE(mine.save());
    EXPECT_EQ(test::content_of(folder.path() / "a.map.handrail.toml.damaged"), "[[mark]]\nname = \"theirs");
    EXPECT_THAT(mine.take_over().news, ElementsAre(HasSubstr("left line 2 of this world")));
    EXPECT_THAT(names(SideFile::of_world(world, {}).entries("mark")), ElementsAre("mine"));
}

TEST(TwoSessions, wait_for_each_others_save_and_report_one_that_does_not_end) {
    const TemporaryFolder folder;
    const fs::path world = folder.write("a.map", "x");
    SideFile mine = SideFile::of_world(world, {});
    mine.set_entries("mark", {entry("mine", 2.0)});
    {
        const FolderLock other(folder.path(), 1.0);
        ASSERT_TRUE(other.held());
        const auto saved = mine.save();
        ASSERT_FALSE(saved);
        EXPECT_THAT(saved.error().sentence(), HasSubstr("Another session"));
        EXPECT_FALSE(fs::exists(folder.path() / "a.map.handrail.toml"));
    }
    EXPECT_TRUE(mine.save()) << "nothing was forgotten";
    EXPECT_TRUE(fs::exists(folder.path() / "a.map.handrail.toml"));
}

struct Visitor : test::AppSession {
    explicit Visitor(const fs::path& world) {
        app.apply(WorldEntered{make_ready(test::world_in(world)), SideFile::of_world(world, {})}, now);
        run(0.1);
    }
    // Sets a mark and gives it this name. Returns the answer.
    std::string mark(const std::string& name) {
        request(Command::DropMark);
        return line(name);
    }
    std::string marks() {
        request(Command::Marks);
        std::string all;
        for (const ListItem& item : app.dialogue().view().items) all += item.name + "; ";
        app.apply(KeyTapped{"Escape"}, now);
        listen();
        return all;
    }
};

TEST(Additions, that_cannot_be_saved_are_reported_each_time_and_saved_once_that_is_possible) {
    const TemporaryFolder folder;
    const fs::path world = folder.path() / "first_room.map", link = folder.path() / "first_room.map.handrail.toml";
    fs::copy_file(test::project_root() / "worlds/maps/first_room.map", world);
    fs::create_symlink("elsewhere", link);  // No save writes through a link, whichever user runs the test.
    Visitor visitor(world);
    EXPECT_THAT(visitor.mark("Coat"), HasSubstr("Not saved yet: Coat"));
    EXPECT_THAT(visitor.mark("Shoes"), HasSubstr("Not saved yet: Shoes")) << "not only the first time";
    visitor.request(Command::DeleteMark);
    EXPECT_THAT(visitor.line("Coat"), HasSubstr("Not saved yet: Coat deleted"));
    fs::remove(link);
    visitor.news();
    visitor.run(31.0);
    EXPECT_THAT(visitor.news(), HasSubstr("What you added has now been saved."));
    EXPECT_THAT(names(SideFile::of_world(world, {}).entries("mark")), ElementsAre("Shoes"));
    EXPECT_THAT(visitor.mark("Hat"), Not(HasSubstr("Not saved")));
}

TEST(TwoSessions, at_one_spot_name_two_marks_without_a_conflict) {
    const TemporaryFolder folder;
    const fs::path world = folder.path() / "first_room.map";
    fs::copy_file(test::project_root() / "worlds/maps/first_room.map", world);
    Visitor first(world), second(world);
    first.request(Command::DropMark);
    second.request(Command::DropMark);
    EXPECT_THAT(first.line("Coat"), Not(HasSubstr("changed the same")));
    EXPECT_THAT(second.line("Shoes"), Not(HasSubstr("changed the same")));
    EXPECT_THAT(names(SideFile::of_world(world, {}).entries("mark")), UnorderedElementsAre("Coat", "Shoes"));
    EXPECT_THAT(first.news() + second.news(), Not(HasSubstr("changed the same")));
}

TEST(TwoSessions, both_keep_their_marks_and_a_conflict_is_announced) {
    const TemporaryFolder folder;
    const fs::path world = folder.path() / "first_room.map";
    fs::copy_file(test::project_root() / "worlds/maps/first_room.map", world);
    Visitor first(world), second(world);
    first.mark("Coat");
    second.hold(Command::Forward, 0.5);
    second.mark("Shoes");
    EXPECT_THAT(second.marks(), testing::AllOf(HasSubstr("Coat"), HasSubstr("Shoes")));
    first.hold(Command::Back, 0.5);
    first.mark("Hat");
    EXPECT_THAT(first.marks(), testing::AllOf(HasSubstr("Coat"), HasSubstr("Shoes"), HasSubstr("Hat")));
    std::vector<std::string> there = names(SideFile::of_world(world, {}).entries("mark"));
    EXPECT_THAT(there, UnorderedElementsAre("Coat", "Shoes", "Hat"));
    // Both sessions delete and rename the same entry.
    SideFile other = SideFile::of_world(world, {});
    std::vector<SideEntry> list = other.entries("mark");
    for (SideEntry& one : list)
        if (text_of(one, "name") == "Coat") one["name"] = std::string("Jacket");
    other.set_entries("mark", list);
    ASSERT_TRUE(other.save());
    first.request(Command::DeleteMark);
    first.news();
    first.line("Coat");
    EXPECT_THAT(first.news(),
                HasSubstr("Another session changed the same things as you did: Jacket. Both versions are kept."));
    EXPECT_THAT(first.marks(), testing::AllOf(HasSubstr("Jacket"), Not(HasSubstr("Coat"))));
}

}  // namespace two_sessions_test
}  // namespace handrail
