// Tests where the program caches its results, and that it never writes through a symbolic link in another person's
// folder.
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <thread>

#include "tests/support/names.h"
#include "tests/support/office_ifc.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace caches_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kTaken = "Loaded from the copy saved last time.";

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code ec;
    for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec))
        names.push_back(it->path().filename());
    return names;
}

class Caches : public testing::Test {
protected:
    // Runs `handrail info FILE` with the home folder of this test.
    ProgramRun info(const fs::path& file, std::map<std::string, std::string> environment = {}) const {
        ProgramCall call;
        call.program = built_program("handrail");
        call.arguments = {"info", file.string()};
        call.environment = std::move(environment);
        call.environment.emplace("HOME", home_.path().string());
        ProgramRun run = run_program(call);
        EXPECT_EQ(run.exit_status, 0) << run.err;
        return run;
    }
    std::string marked(const fs::path& world) const {
        ProgramCall call;
        call.program = built_program("handrail");
        call.arguments = {world.string(), "--no-window", "--device", "none"};
        call.input = "mark\nHere I was\nquit\n";
        call.environment["HOME"] = home_.path().string();
        const ProgramRun run = run_program(call);
        EXPECT_EQ(run.exit_status, 0) << run.err;
        return run.out + run.err;
    }
    // Writes an office that is large enough to be cached as a world, with enough rooms for its routes to be cached.
    fs::path office(const std::string& name) const {
        return folder_.write(name, office_ifc({.storeys = 2, .corridors = 1, .rooms_along = 20}).text);
    }
    long kept(const std::string& ending) const {
        const std::vector<std::string> names = names_in(cache_);
        return std::count_if(names.begin(), names.end(), [&](const auto& name) { return name.ends_with(ending); });
    }
    const TemporaryFolder home_, folder_;
    const fs::path cache_ = home_.path() / ".cache" / "handrail";
};

TEST_F(Caches, are_in_the_persons_folder_and_never_next_to_the_file) {
    const fs::path file = office("office.ifc"), map = folder_.path() / "house.map";
    fs::copy_file(bundled_world("house.map"), map);
    const std::string first = info(file).out, again = info(file).out;
    EXPECT_THAT(first, Not(HasSubstr(kTaken)));
    EXPECT_THAT(again, HasSubstr(kTaken));
    EXPECT_EQ(kept(".scene"), 1);
    EXPECT_EQ(kept(".ways"), 1);
    const std::string rooms = info(map).out;
    EXPECT_EQ(kept(".scene"), 1) << "a .map is read at once";
    EXPECT_EQ(kept(".ways"), 2);
    EXPECT_EQ(info(map).out.substr(0, 200), rooms.substr(0, 200));
    EXPECT_THAT(names_in(folder_.path()), testing::UnorderedElementsAre("office.ifc", "house.map"));
    struct stat of {};
    ASSERT_EQ(::stat(cache_.c_str(), &of), 0);
    EXPECT_EQ(of.st_mode & 07777, 0700U);
    for (const fs::directory_entry& entry : fs::directory_iterator(cache_)) {
        ASSERT_EQ(::lstat(entry.path().c_str(), &of), 0);
        EXPECT_EQ(of.st_mode & 07777, 0600U) << entry.path();
    }
    fs::remove_all(cache_);
    EXPECT_THAT(info(file).out, Not(HasSubstr(kTaken))) << "it may go at any time";
    EXPECT_THAT(info(file).out, HasSubstr(kTaken));
}

// Until November 2026 the program wrote through each of the links that this test makes.
TEST_F(Caches, never_write_through_a_symbolic_link_in_the_folder_of_a_world) {
    const fs::path map = folder_.path() / "house.map", file = office("office.ifc");
    fs::copy_file(bundled_world("house.map"), map);
    const fs::path diary = home_.write("diary", "my diary");
    for (const char* link : {"house.map.handrail.ways", "office.ifc.handrail.ways", "office.ifc.handrail.scene",
                             "house.map.handrail.toml", "office.ifc.handrail.toml"})
        fs::create_symlink(diary, folder_.path() / link);
    info(map);
    info(file);
    EXPECT_EQ(content_of(diary), "my diary");
    // Skip the rest, because the tests RequestedEarly.* run the same threads under this sanitizer.
    if (kThreadSanitizer) return;
    const std::string said = marked(map);
    EXPECT_EQ(content_of(diary), "my diary");
    EXPECT_THAT(said, HasSubstr("house.map.handrail.toml is a link to another file"));
    EXPECT_THAT(names_in(home_.path() / ".local/share/handrail/worlds"),
                testing::Contains(testing::HasSubstr("house.map")))
        << "the mark is kept elsewhere";
    EXPECT_EQ(names_in(folder_.path()).size(), 7U) << "nothing was put aside";
}

TEST_F(Caches, stored_for_another_file_are_rejected) {
    const fs::path file = office("office.ifc");
    const auto scenes = [&] {
        std::vector<fs::path> found;
        for (const fs::directory_entry& entry : fs::directory_iterator(cache_))
            if (entry.path().extension() == ".scene") found.push_back(entry.path());
        return found;
    };
    const std::string honest = info(file).out, rooms = honest.substr(0, honest.find("Read in "));
    ASSERT_EQ(scenes().size(), 1U);
    const fs::path own = scenes().front();
    const std::string whole = content_of(own);
    const fs::path other =
        folder_.write("other.ifc", office_ifc({.storeys = 1, .corridors = 1, .rooms_along = 30}).text);
    info(other);
    ASSERT_EQ(scenes().size(), 2U);
    const fs::path of_other = scenes()[scenes()[0] == own ? 1 : 0];
    fs::copy_file(of_other, own, fs::copy_options::overwrite_existing);
    const std::string again = info(file).out;
    EXPECT_THAT(again, Not(HasSubstr(kTaken)));
    EXPECT_EQ(again.substr(0, again.find("Read in ")), rooms);
    EXPECT_EQ(content_of(own), whole) << "mended";
    EXPECT_THAT(info(file).out, HasSubstr(kTaken));
}

TEST_F(Caches, that_cannot_be_stored_cause_no_failure) {
    const fs::path file = office("office.ifc");
    const std::string without = info(file, {{"HOME", ""}, {"XDG_CACHE_HOME", ""}}).out;
    EXPECT_THAT(without, Not(HasSubstr(kTaken)));
    EXPECT_THAT(info(file, {{"XDG_CACHE_HOME", "/dev/null"}}).out, Not(HasSubstr(kTaken)));
    EXPECT_THAT(info(file, {{"XDG_CACHE_HOME", "/proc"}}).out, Not(HasSubstr(kTaken))) << "as a home that is read-only";
    EXPECT_THAT(names_in(folder_.path()), testing::ElementsAre("office.ifc"));
    EXPECT_FALSE(fs::exists(cache_));
}

TEST_F(Caches, serve_several_programs_at_once_while_another_process_deletes_them) {
    const fs::path file = office("office.ifc");
    const std::string alone = info(file).out;
    const std::string begin = alone.substr(0, 150);
    std::vector<std::thread> others;
    std::atomic<int> running{3};
    for (int i = 0; i < 3; ++i)
        others.emplace_back([&] {
            for (int round = 0; round < 2; ++round) EXPECT_EQ(info(file).out.substr(0, 150), begin);
            --running;
        });
    while (running > 0) {
        std::error_code ec;
        fs::remove_all(cache_, ec);
        std::this_thread::yield();
    }
    for (std::thread& other : others) other.join();
    info(file);
    EXPECT_THAT(info(file).out, HasSubstr(kTaken));
}

}  // namespace caches_test
}  // namespace handrail::test
