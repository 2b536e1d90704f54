// Tests that after any crash, the next start announces the crash and offers to continue at the last place. Sessions
// that run at the same time are not reported as crashed.
#include "app/core/kept/last_place.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace last_place_test {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

const LastPlace kKitchen{
    {"/worlds/\"odd\" \\ house ü.map", 0.1 + 0.2, 0.3048, "The \"Annex\""}, {1.0 / 3.0, -2e-17, 1234567.125}, -3.0};

TEST(LastPlace, is_restored_to_the_last_bit) {
    const auto again = read_last_place(text_of(kKitchen));
    ASSERT_TRUE(again) << again.error().sentence();
    EXPECT_EQ(again->world, kKitchen.world);
    EXPECT_EQ(again->feet_m, kKitchen.feet_m);
    EXPECT_EQ(again->heading_rad, kKitchen.heading_rad);
}

TEST(LastPlace, cut_at_any_byte_is_refused_or_complete) {
    const std::string text = text_of(kKitchen);
    for (std::size_t length = 0; length < text.size(); ++length) {
        const auto read = read_last_place(text.substr(0, length));
        if (!read) continue;
        EXPECT_EQ(read->world, kKitchen.world) << length;
        EXPECT_TRUE(std::isfinite(read->feet_m.x) && std::isfinite(read->heading_rad)) << length;
    }
    for (const char* bad : {"", "world = 3", "world = \"/a\"\nfeet_m = [1.0, nan, 2.0]\nheading_rad = 0.0",
                            "world = \"/a\"\nfeet_m = [1.0, 2.0]\nheading_rad = 0.0",
                            "world = \"a\"\nfeet_m = [1.0, 2.0, 3.0]\nheading_rad = 0.0",
                            "world = \"/a\"\nfeet_m = [1.0, 2.0, 3.0]\nheading_rad = inf"})
        EXPECT_FALSE(read_last_place(bad)) << bad;
}

TEST(SessionTrace, of_an_orderly_end_leaves_no_file_and_reports_nothing) {
    const TemporaryFolder folder;
    {
        SessionTrace trace(folder.path());
        EXPECT_FALSE(trace.crashed());
        trace.note(kKitchen, 1.0);
        trace.end();
    }
    EXPECT_EQ(files_in(folder.path()), 0U);
    EXPECT_FALSE(SessionTrace(folder.path()).crashed());
}

TEST(SessionTrace, of_a_killed_session_is_reported_once_with_its_last_place) {
    const TemporaryFolder folder;
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        SessionTrace trace(folder.path());
        trace.note({{"/worlds/before.map"}, {9.0, 9.0, 9.0}, 0.0}, 1.0);
        while (files_in(folder.path()) < 2) ::usleep(1000);
        for (double now_s = 1.0 + SessionTrace::kEvery_s;; ::usleep(1000)) trace.note(kKitchen, now_s);
    }
    const auto kept = [&] {
        for (const auto& file : fs::directory_iterator(folder.path()))
            if (file.path().extension() == ".toml" && test::content_of(file.path()).find("odd") != std::string::npos)
                return true;
        return false;
    };
    const bool written = test::eventually(kept);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ASSERT_TRUE(written);
    {
        SessionTrace next(folder.path());
        EXPECT_TRUE(next.crashed());
        ASSERT_TRUE(next.left_at());
        EXPECT_EQ(next.left_at()->world, kKitchen.world);
        EXPECT_EQ(next.left_at()->feet_m, kKitchen.feet_m);
    }
    {
        // The session above has also just crashed, before it noted a place.
        SessionTrace after(folder.path());
        EXPECT_TRUE(after.crashed());
        ASSERT_TRUE(after.left_at());
        EXPECT_EQ(after.left_at()->feet_m, kKitchen.feet_m);
        after.end();
    }
    EXPECT_FALSE(SessionTrace(folder.path()).crashed());
}

TEST(SessionTrace, of_a_session_that_still_runs_is_not_a_crash) {
    const TemporaryFolder folder;
    SessionTrace one(folder.path());
    one.note(kKitchen, 1.0);
    ASSERT_TRUE(test::eventually([&] { return files_in(folder.path()) == 2; }));
    SessionTrace two(folder.path()), three(folder.path());
    EXPECT_FALSE(two.crashed());
    EXPECT_FALSE(three.crashed());
    two.note(kKitchen, 1.0);
    two.end();
    three.end();
    EXPECT_EQ(files_in(folder.path()), 2U) << "what the one keeps is still there";
    one.end();
    EXPECT_EQ(files_in(folder.path()), 0U);
}

TEST(SessionTrace, is_written_at_most_every_3_s_and_only_after_movement) {
    const TemporaryFolder folder;
    SessionTrace trace(folder.path());
    const auto place = [&](double x) { return LastPlace{{"/a.map"}, {x, 0.0, 0.0}, 0.0}; };
    const auto kept = [&]() -> double {
        for (const auto& file : fs::directory_iterator(folder.path()))
            if (const auto read = read_last_place(test::content_of(file.path()))) return read->feet_m.x;
        return -1.0;
    };
    trace.note(place(1.0), 10.0);
    ASSERT_TRUE(test::eventually([&] { return kept() == 1.0; }));
    trace.note(place(2.0), 12.9);
    EXPECT_EQ(kept(), 1.0);
    // If the disk is still writing the previous note when the next one is due, the new note waits for the next call.
    ASSERT_TRUE(test::eventually([&] {
        trace.note(place(3.0), 13.1);
        return kept() == 3.0;
    }));
    trace.note(place(3.01), 30.0);
    EXPECT_EQ(kept(), 3.0);
    trace.end();
}

TEST(SessionTrace, stores_nothing_if_that_is_not_permitted_and_continues) {
    SessionTrace nowhere{fs::path()};
    nowhere.note(kKitchen, 1.0);
    nowhere.end();
    EXPECT_FALSE(nowhere.crashed());
    SessionTrace proc("/proc/handrail/sessions");
    proc.note(kKitchen, 1.0);
    EXPECT_FALSE(proc.crashed());
    const TemporaryFolder folder;
    folder.write("session-abc.lock", "");
    folder.write("session-abc.toml", "no place at all");
    folder.write("session-abc.toml.new-Xy12Zz", "half a pl");
    folder.write("a stranger", "stays");
    SessionTrace odd(folder.path());
    EXPECT_TRUE(odd.crashed());
    EXPECT_FALSE(odd.left_at());
    EXPECT_TRUE(fs::exists(folder.path() / "a stranger"));
    odd.end();
    EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(GoOnAtLastPlace, puts_the_body_back_there_and_leaves_the_home_position_unchanged) {
    test::AppSession session;
    session.app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, 0.0);
    session.run(0.1);
    const Vec3 home = session.app.feet_m();
    EXPECT_THAT(session.request(Command::LastPlace), HasSubstr("No session ended unexpectedly"));
    session.hold(Command::Forward, 2.0);
    session.run(1.0);
    const LastPlace last{{"/house.map"}, session.app.feet_m(), 1.0};
    ASSERT_GT(glm::length(last.feet_m - home), 0.5);
    session.request(Command::Home);
    session.app.apply(LastPlaceKnown{last}, 0.0);
    session.request(Command::LastPlace);
    const auto wanted = session.app.requests().take_last_place();
    ASSERT_TRUE(wanted);
    EXPECT_FALSE(session.app.requests().take_last_place());
    session.app.apply(WentOnAt{*wanted}, session.now);
    EXPECT_THAT(session.news(), HasSubstr("You are back where you were. "));
    EXPECT_LT(glm::length(session.app.feet_m() - last.feet_m), 0.05);
    EXPECT_NEAR(session.app.heading_rad(), 1.0, 1e-9);
    session.request(Command::Home);
    EXPECT_LT(glm::length(session.app.feet_m() - home), 1e-9);
}

TEST(GoOnAtLastPlace, moves_nobody_out_of_the_world_or_into_a_wall) {
    test::AppSession session;
    session.app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, 0.0);
    session.run(0.1);
    const Vec3 home = session.app.feet_m();
    session.app.apply(WentOnAt{{{"/house.map"}, {1e6, 0.0, 0.0}, 0.0}}, session.now);
    EXPECT_THAT(session.news(), HasSubstr("no longer part of this world"));
    EXPECT_LT(glm::length(session.app.feet_m() - home), 1e-9);
    const std::string inside_nothing = session.request(Command::BringOut);
    // From any place within the bounds, the walker either can move afterwards or is at the base.
    const Aabb bounds = session.app.scene()->bounds_m;
    for (int i = 0; i < 40; ++i) {
        const Vec3 share(0.5 + 0.5 * std::sin(1.7 * i), 0.5 + 0.5 * std::sin(2.9 * i + 1.0), 0.05);
        session.app.apply(WentOnAt{{{"/house.map"}, bounds.min_m + share * bounds.size_m(), 0.0}}, session.now);
        session.run(1.0);
        EXPECT_THAT(session.request(Command::BringOut), HasSubstr(inside_nothing)) << i;
    }
}

}  // namespace last_place_test
}  // namespace handrail
