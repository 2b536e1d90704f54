#include "app/main/sleep_watch.h"

#include <atomic>
#include <cstdlib>

#include "tests/support/child_process.h"
#include "tests/support/login_manager.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/clock.h"

namespace handrail {
namespace sleep_watch_test {

using test::eventually;

const std::string kDelay = "sleep Handrail delay\n";

struct SleepWatchTest : testing::Test {
    void SetUp() override {
        if (const std::string reason = test::LoginManager::why_not(); !reason.empty()) GTEST_SKIP() << reason;
        logind.emplace(folder.path());
        ASSERT_TRUE(logind->ready());
        ::setenv("DBUS_SYSTEM_BUS_ADDRESS", logind->address().c_str(), 1);
        watch.emplace([this] { ++released; });
        ASSERT_TRUE(eventually([this] { return logind->inhibitors() == kDelay; }));
    }
    void TearDown() override { ::unsetenv("DBUS_SYSTEM_BUS_ADDRESS"); }

    test::TemporaryFolder folder;
    std::optional<test::LoginManager> logind;
    std::atomic<int> released{0};
    std::optional<SleepWatch> watch;
};

TEST_F(SleepWatchTest, removes_the_force_before_it_lets_the_computer_sleep_each_time) {
    for (int sleeps = 1; sleeps <= 2; ++sleeps) {
        logind->announce_sleep(true);
        ASSERT_TRUE(eventually([&] { return released == sleeps && watch->delays_sleep(); }));
        EXPECT_FALSE(watch->take_woken());
        watch->let_sleep();
        EXPECT_TRUE(eventually([this] { return logind->inhibitors().empty(); }));
        logind->announce_sleep(false);
        EXPECT_TRUE(eventually([this] { return watch->take_woken(); }));
        EXPECT_TRUE(eventually([this] { return logind->inhibitors() == kDelay; })) << "for the next time";
        EXPECT_FALSE(watch->delays_sleep());
    }
}

TEST_F(SleepWatchTest, does_not_delay_suspend_for_long_if_nobody_confirms_that_the_force_is_gone) {
    const SteadyClock clock;
    const double begun_s = clock.now_s();
    logind->announce_sleep(true);
    EXPECT_TRUE(eventually([this] { return logind->inhibitors().empty(); }));
    EXPECT_EQ(released, 1);
    EXPECT_GE(clock.now_s() - begun_s, SleepWatch::kMostDelay_s);
}

TEST_F(SleepWatchTest, releases_the_suspend_lock_when_the_watch_or_the_bus_ends) {
    watch.reset();
    EXPECT_TRUE(eventually([this] { return logind->inhibitors().empty(); }));
    watch.emplace([this] { ++released; });
    EXPECT_TRUE(eventually([this] { return logind->inhibitors() == kDelay; }));
    logind.reset();
    watch.reset();
    EXPECT_EQ(released, 0);
}

}  // namespace sleep_watch_test
}  // namespace handrail
