// Tests saving and loading while the disk or the memory fails at any step. Each attempt must succeed, return a message
// or throw std::bad_alloc, and every file must be entirely old or entirely new. toml++ 3.3 ends the program if it has
// no memory for its own error. A child process shows that the files are intact in that case, too.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <map>

#include "app/core/kept/last_place.h"
#include "app/core/kept/side_file.h"
#include "app/core/kept/world_shelf.h"
#include "app/learners/learners.h"
#include "app/record/recorder.h"
#include "settings/settings.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/save_faults/injected.h"
#include "worlds/base/files.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace save_faults_test {

namespace fs = std::filesystem;
using test::BrokenDisk;
using test::NoMemory;
using test::TemporaryFolder;
using test::WriteFault;

SideEntry mark(const std::string& name, double x) {
    return {{"name", name}, {"place_m", std::vector<double>{x, 0.1, -3.25}}};
}

// Data of the user that is saved as one file.
struct Kept {
    std::string name;
    std::string file;  // path relative to the folder
    // Prepares the data and returns a function that saves it. The returned function returns false if it reported a
    // failure.
    std::function<std::function<bool()>(const fs::path& folder)> change;
    bool reports;  // true if saving reports a failure
};

std::vector<Kept> all_kept() {
    return {
        {"settings", "settings.toml",
         [](const fs::path& folder) {
             auto store = std::make_shared<SettingsStore>();
             store->load_file(folder / "settings.toml", SettingSource::UserFile);
             EXPECT_TRUE(store->set("workspace.scale", "17", SettingSource::Live));
             return [store] { return store->save_user_file().has_value(); };
         },
         true},
        {"what was added to a world", "a.map.handrail.toml",
         [](const fs::path& folder) {
             auto file = std::make_shared<SideFile>(SideFile::of_world(folder / "a.map", {}));
             std::vector<SideEntry> marks = file->entries("mark");
             marks.push_back(mark("new", 2.0));
             file->set_entries("mark", marks);
             return [file] { return file->save().has_value(); };
         },
         true},
        {"the list of last worlds", "recent-worlds.txt",
         [](const fs::path& folder) {
             auto list = std::make_shared<RecentWorlds>(folder / "recent-worlds.txt");
             return [list, folder] {
                 list->add(folder / "a.map");
                 return true;
             };
         },
         false},
        {"the last place", "place.toml",
         [](const fs::path& folder) {
             return [folder] {
                 return write_file_atomically(folder / "place.toml",
                                              text_of(LastPlace{{"/a.map"}, {1.0, 2.0, 3.0}, 0.5}))
                     .has_value();
             };
         },
         true},
    };
}

// A user's folder that contains a file of each kind.
struct Home {
    Home() {
        folder.write("a.map", "x");
        folder.write("settings.toml", "# mine\n[speech]\nverbosity = 3 # as I like it\n[unknown]\nkey = 1\n");
        folder.write("a.map.handrail.toml",
                     "[[mark]]\nname = \"old\"\nplace_m = [1.0, 2.0, 3.0]\n[[stranger]]\nkept = true\n");
        folder.write("recent-worlds.txt", "/worlds/old.map\n");
        folder.write("place.toml", text_of(LastPlace{{"/old.map"}, {}, 0.0}));
    }
    std::map<std::string, std::string> all() const {
        std::map<std::string, std::string> files;
        for (const auto& file : fs::directory_iterator(folder.path()))
            files[file.path().filename().string()] = test::content_of(file.path());
        return files;
    }
    TemporaryFolder folder;
};

// Returns the file's text after a successful save.
std::string saved(const Kept& kept) {
    const Home home;
    // Stored paths include the temporary folder. So the function replaces the folder in the text by a fixed word.
    EXPECT_TRUE(kept.change(home.folder.path())()) << kept.name;
    std::string text = test::content_of(home.folder.path() / kept.file);
    for (std::size_t at; (at = text.find(home.folder.path().string())) != std::string::npos;)
        text.replace(at, home.folder.path().string().size(), "HOME");
    return text;
}

// Returns the content that must survive if memory is short. Comments may be lost and numbers may get more zeros;
// nothing else may change.
std::vector<std::string> meaning(const Kept& kept, const std::string& text) {
    const TemporaryFolder folder;
    folder.write("a.map", "x");
    folder.write(kept.file, text);
    std::vector<std::string> all;
    if (kept.file == "settings.toml") {
        SettingsStore store;
        for (const Diagnostic& problem : store.load_file(folder.path() / kept.file, SettingSource::UserFile))
            all.push_back(problem.message);
        for (const SettingRow& row : store.explain()) all.push_back(row.key + " " + row.value);
    } else if (kept.file == "a.map.handrail.toml") {
        const SideFile file = SideFile::of_world(folder.path() / "a.map", {});
        for (const SideEntry& entry : file.entries("mark")) {
            all.push_back(text_of(entry, "name"));
            for (const double number : numbers_of(entry, "place_m", 3)) all.push_back(fmt::format("{}", number));
        }
        all.push_back(fmt::format("{} {}", file.entries("stranger").size(), file.news().size()));
    } else {
        all.push_back(text);
    }
    return all;
}

bool same_meaning(const Kept& kept, const std::string& text, const std::string& after) {
    return text == after || (!after.empty() && meaning(kept, text) == meaning(kept, after));
}

// Checks that the file is entirely old or entirely new, that all other files are unchanged, and that no file was added.
// Returns true if the file is new.
bool expect_whole(const Kept& kept, const Home& home, const std::map<std::string, std::string>& before,
                  const std::string& after) {
    std::map<std::string, std::string> now = home.all();
    std::string text = now[kept.file];
    for (std::size_t at; (at = text.find(home.folder.path().string())) != std::string::npos;)
        text.replace(at, home.folder.path().string().size(), "HOME");
    const bool old = text == before.at(kept.file);
    EXPECT_TRUE(old || same_meaning(kept, text, after)) << kept.name << " is half a file:\n" << text;
    now[kept.file] = before.at(kept.file);
    EXPECT_EQ(now, before) << kept.name;
    return !old;
}

TEST(SaveFaults, a_disk_error_at_any_step_leaves_the_old_file_and_is_reported) {
    for (const Kept& kept : all_kept()) {
        const std::string after = saved(kept);
        for (const int error : {ENOSPC, EIO, EDQUOT, EROFS}) {
            long step = 0;
            for (bool struck = true; struck; ++step) {
                ASSERT_LT(step, 100);
                const Home home;
                const auto before = home.all();
                ASSERT_NE(after, before.at(kept.file));
                const auto save = kept.change(home.folder.path());
                bool worked = false;
                {
                    const BrokenDisk broken(WriteFault::Error, step, error);
                    worked = save();
                    struck = BrokenDisk::struck();
                }
                SCOPED_TRACE(::testing::Message() << kept.name << ", errno " << error << " at step " << step);
                const bool is_new = expect_whole(kept, home, before, after);
                EXPECT_TRUE(is_new == worked || !kept.reports);
                EXPECT_TRUE(is_new || struck);
            }
            EXPECT_GE(step, 6) << "opened, written, its mode, flushed, renamed, the folder flushed";
        }
    }
}

TEST(SaveFaults, a_failure_is_reported_with_its_reason_and_saving_again_works) {
    const Home home;
    SettingsStore store;
    store.load_file(home.folder.path() / "settings.toml", SettingSource::UserFile);
    ASSERT_TRUE(store.set("workspace.scale", "17", SettingSource::Live));
    {
        const BrokenDisk broken(WriteFault::ShortThenError, 1, ENOSPC);
        const auto failed = store.save_user_file();
        ASSERT_FALSE(failed);
        EXPECT_THAT(failed.error().sentence(), testing::HasSubstr("settings.toml"));
        EXPECT_THAT(failed.error().sentence(), testing::HasSubstr("No space left"));
    }
    EXPECT_TRUE(store.save_user_file());
    EXPECT_THAT(test::content_of(home.folder.path() / "settings.toml"),
                testing::AllOf(testing::HasSubstr("scale = 17"), testing::HasSubstr("# as I like it")));
}

TEST(SaveFaults, partial_or_interrupted_writes_are_continued) {
    for (const Kept& kept : all_kept()) {
        const std::string after = saved(kept);
        for (const auto& [fault, error] : {std::pair{WriteFault::Short, 0}, std::pair{WriteFault::Error, EINTR}}) {
            const Home home;
            const auto before = home.all();
            const auto save = kept.change(home.folder.path());
            {
                const BrokenDisk broken(fault, 1, error);  // call 1 is the first write after the creation of the file
                EXPECT_TRUE(save());
                EXPECT_TRUE(BrokenDisk::struck());
            }
            EXPECT_TRUE(expect_whole(kept, home, before, after)) << kept.name;
        }
    }
}

TEST(SaveFaults, a_disk_that_fills_up_during_a_write_leaves_the_old_file) {
    for (const Kept& kept : all_kept()) {
        const Home home;
        const auto before = home.all();
        const auto save = kept.change(home.folder.path());
        {
            const BrokenDisk broken(WriteFault::ShortThenError, 1, ENOSPC);
            const bool worked = save();
            EXPECT_FALSE(worked && kept.reports) << kept.name;
        }
        EXPECT_FALSE(expect_whole(kept, home, before, {})) << kept.name;
    }
}

// Returns the next allocation to try: every one up to a few hundred, then fewer and fewer.
long next_step(long step) { return step + 1 + step / (test::kSanitizerScale < 1.0 ? 10 : 60); }

enum class End { Worked, Reported, NoMemory, Died };

// Runs `act` in a child process in which allocation `step` fails, and all later ones if `all_after` is true. Returns
// how the child process ended. Sets `struck` to whether it reached that allocation.
End in_child(const std::function<bool()>& act, long step, bool all_after, bool& struck) {
    const pid_t child = ::fork();
    if (child == 0) {
        // Libraries call terminate() if memory runs out in a function that must not throw. The handler of libstdc++
        // prints a message first, and that of libstdc++ 14 crashes.
        std::set_terminate([] { std::abort(); });
        int end = 0;
        {
            const NoMemory none(step, all_after);
            try {
                end = act() ? 0 : 1;
            } catch (const std::bad_alloc&) {
                end = 2;
            }
        }
        ::_exit(end + (NoMemory::struck() ? 10 : 0));
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    struck = true;
    if (!WIFEXITED(status)) {
        EXPECT_EQ(WTERMSIG(status), SIGABRT) << "allocation " << step;
        return End::Died;
    }
    struck = WEXITSTATUS(status) >= 10;
    return static_cast<End>(WEXITSTATUS(status) % 10);
}

TEST(SaveFaults, running_out_of_memory_at_any_allocation_leaves_the_old_or_the_new_file) {
    for (const Kept& kept : all_kept()) {
        const std::string after = saved(kept);
        int ends[4] = {};
        for (const bool all_after : {false, true}) {
            long step = 0;
            for (bool struck = true; struck; step = next_step(step)) {
                const Home home;
                const auto before = home.all();
                const auto save = kept.change(home.folder.path());
                const End end = in_child(save, step, all_after, struck);
                ++ends[static_cast<int>(end)];
                SCOPED_TRACE(::testing::Message()
                             << kept.name << ", allocation " << step << (all_after ? " and all after it" : ""));
                const bool is_new = expect_whole(kept, home, before, after);
                EXPECT_TRUE(is_new || end != End::Worked || !kept.reports);
                EXPECT_TRUE(end == End::Worked || struck);
            }
        }
        std::cout << "    " << kept.name << ": worked " << ends[0] << ", told " << ends[1] << ", bad_alloc " << ends[2]
                  << ", died " << ends[3] << "\n";
        EXPECT_GT(ends[2], 3) << kept.name;
    }
}

TEST(SaveFaults, changes_that_failed_for_lack_of_memory_are_saved_the_next_time) {
    const Home home;
    const auto before = home.all();
    const Kept kept = all_kept()[1];
    const std::string after = saved(kept);
    const auto save = kept.change(home.folder.path());
    {
        const NoMemory none(0, true);
        EXPECT_THROW(save(), std::bad_alloc);
    }
    EXPECT_FALSE(expect_whole(kept, home, before, after));
    EXPECT_TRUE(save());
    EXPECT_TRUE(expect_whole(kept, home, before, after));
}

// Returns the existing folders of learners or of recordings, including empty ones.
std::vector<std::string> folders_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code ec;
    for (const auto& entry : fs::directory_iterator(folder, ec))
        if (entry.is_directory()) names.push_back(entry.path().filename().string());
    return names;
}

bool makes_learner(const fs::path& folder) { return Learners(folder).make("Rook", "# none yet\n").has_value(); }

bool begins_recording(const fs::path& folder) {
    const auto begun = Recorder::begin(folder / "recordings", {});
    if (begun) (*begun)->end(0.0);
    return begun.has_value();
}

// Data of a kind that has a folder of its own. After a failure at the beginning, the folder must be complete or not
// exist.
struct Begun {
    const char* name;
    const char* folders;  // parent folder of the data's folders
    bool (*begin)(const fs::path& folder);
};
constexpr std::array kAllBegun{Begun{"a learner", "learners", makes_learner},
                               Begun{"a recording", "recordings", begins_recording}};

TEST(SaveFaults, no_empty_folder_remains_after_a_disk_error) {
    for (const Begun& one : kAllBegun)
        for (const WriteFault fault : {WriteFault::Error, WriteFault::ShortThenError}) {
            long step = 0;
            for (bool struck = true; struck; ++step) {
                ASSERT_LT(step, 100);
                const TemporaryFolder folder;
                bool worked = false;
                {
                    const BrokenDisk broken(fault, step, ENOSPC);
                    worked = one.begin(folder.path());
                    struck = BrokenDisk::struck();
                }
                EXPECT_EQ(folders_in(folder.path() / one.folders).size(), worked ? 1U : 0U)
                    << one.name << " at step " << step;
                EXPECT_TRUE(Learners(folder.path()).all().faults.empty()) << one.name << " at step " << step;
                EXPECT_TRUE(worked || one.begin(folder.path())) << one.name << ": the next time it works";
            }
            EXPECT_GT(step, 1) << one.name;
        }
}

TEST(SaveFaults, no_empty_folder_remains_after_a_failed_allocation) {
    for (const Begun& one : kAllBegun) {
        int ends[4] = {};
        long step = 0;
        for (bool struck = true; struck; step = next_step(step)) {
            const TemporaryFolder folder;
            const End end = in_child([&] { return one.begin(folder.path()); }, step, false, struck);
            ++ends[static_cast<int>(end)];
            // If the child process died, it could not remove the folder.
            if (end != End::Died) {
                EXPECT_EQ(folders_in(folder.path() / one.folders).size(), end == End::Worked ? 1U : 0U)
                    << one.name << ", allocation " << step;
            }
        }
        std::cout << "    " << one.name << ": worked " << ends[0] << ", told " << ends[1] << ", bad_alloc " << ends[2]
                  << ", died " << ends[3] << "\n";
        EXPECT_GT(ends[2], 3) << one.name;
    }
}

// After a consent was given or withdrawn, either the file contains the change or the caller gets an error.
TEST(SaveFaults, a_changed_learner_file_is_the_old_or_the_new_one) {
    const TemporaryFolder folder;
    const Learners learners(folder.path());
    const auto made = learners.make("Rook", "");
    ASSERT_TRUE(made) << made.error().sentence();
    const auto give = [&](const std::string& until) {
        return learners.change(made->id, [&](Learner& one) {
            one.consent(kPurposes[0]) = Consent{"2026-11-01", "Ann", until};
        });
    };
    ASSERT_TRUE(give("2027-01-01"));
    const auto until = [&] { return learners.find("Rook")->consent(kPurposes[0])->until; };
    for (const WriteFault fault : {WriteFault::Error, WriteFault::ShortThenError}) {
        long step = 0;
        for (bool struck = true; struck; ++step) {
            ASSERT_LT(step, 100);
            bool worked = false;
            {
                const BrokenDisk broken(fault, step, EIO);
                worked = give("2028-02-02").has_value();
                struck = BrokenDisk::struck();
            }
            EXPECT_EQ(until(), worked ? "2028-02-02" : "2027-01-01") << "step " << step;
            ASSERT_TRUE(give("2027-01-01"));
        }
        EXPECT_GE(step, 2);
    }
}

// Data that is read and summarised as text. Every successful read must give the same text as a read without faults.
struct Read {
    std::string name;
    std::function<std::string(const fs::path& folder)> read;
};

std::string outcome(const Result<Scene>& scene) {
    if (!scene) return scene.error().sentence();
    return fmt::format("{} {} {} {}", scene->name, scene->features.size(), scene->solids.size(),
                       scene->report.warnings_in_all);
}

TEST(LoadFaults, running_out_of_memory_at_any_allocation_changes_no_file_and_a_later_read_works) {
    const Home home;
    const fs::path folder = home.folder.path();
    fs::copy_file(test::project_root() / "worlds/maps/first_room.map", folder / "room.map");
    home.folder.write("odd.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 9\nf 1 3 4\n");
    home.folder.write("odd.map", "{\n\"classname\" \"worldspawn\"\n{\n( 0 0 0 ) ( 1 0 0 )");
    home.folder.write("session-old.toml", text_of(LastPlace{{"/old.map"}, {1.0, 2.0, 3.0}, 0.0}));
    const std::vector<Read> all{
        {"settings",
         [](const fs::path& at) {
             SettingsStore store;
             const auto problems = store.load_file(at / "settings.toml", SettingSource::UserFile);
             return fmt::format("{} {}", store.values().speech.verbosity,
                                problems.empty() ? "" : problems[0].sentence());
         }},
        {"what was added to a world",
         [](const fs::path& at) {
             const SideFile file = SideFile::of_world(at / "a.map", {});
             return fmt::format("{} {} {}", file.entries("mark").size(), file.entries("stranger").size(),
                                file.news().size());
         }},
        {"the list of last worlds",
         [](const fs::path& at) { return RecentWorlds(at / "recent-worlds.txt").worlds().at(0).string(); }},
        {"the last place",
         [](const fs::path& at) {
             const auto place = read_whole_file(at / "session-old.toml").and_then(read_last_place);
             return place ? place->world.file.string() : place.error().sentence();
         }},
        {"a map", [](const fs::path& at) { return outcome(read_world(at / "room.map", {})); }},
        {"a damaged map", [](const fs::path& at) { return outcome(read_world(at / "odd.map", {})); }},
        {"a damaged mesh", [](const fs::path& at) { return outcome(read_world(at / "odd.obj", {})); }},
    };
    const auto before = home.all();
    for (const Read& one : all) {
        const std::string expected = one.read(folder);
        for (const bool all_after : {false, true}) {
            long step = 0, thrown = 0;
            for (bool struck = true; struck; step = next_step(step)) {
                const End end = in_child([&] { return one.read(folder) == expected; }, step, all_after, struck);
                thrown += end == End::NoMemory;
                EXPECT_TRUE(struck || end == End::Worked) << one.name;
                ASSERT_EQ(home.all(), before) << one.name << ", allocation " << step;
            }
            EXPECT_GT(thrown, 3) << one.name;
        }
        EXPECT_EQ(one.read(folder), expected) << one.name;
        EXPECT_EQ(home.all(), before) << one.name;
    }
}

}  // namespace save_faults_test
}  // namespace handrail
