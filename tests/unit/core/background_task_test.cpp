// Tests background tasks: only the result of the task that was begun last is used, a cancelled task ends soon, and no
// task outlives its owner.
#include "worlds/base/background_task.h"
#include "tests/support/child_process.h"

#include <pthread.h>

#include <array>
#include <string>
#include <thread>
#include <vector>

namespace handrail {
namespace background_task_test {

template <class T>
std::optional<T> wait_for(BackgroundTask<T>& task) {
    std::optional<T> made;
    test::eventually([&] { return (made = task.take()).has_value(); });
    return made;
}

int until_stopped(const std::stop_token& stop) {
    while (!stop.stop_requested()) std::this_thread::yield();
    return -1;
}

TEST(BackgroundTask, delivers_each_result_once) {
    BackgroundTask<int> task(on_threads(), "test");
    EXPECT_FALSE(task.busy());
    EXPECT_FALSE(task.take());
    task.begin([](const std::stop_token&) { return 5; });
    EXPECT_TRUE(task.busy());
    EXPECT_EQ(wait_for(task), 5);
    EXPECT_FALSE(task.busy());
    EXPECT_FALSE(task.take());
}

TEST(BackgroundTask, delivers_only_the_result_of_the_latest_start) {
    BackgroundTask<int> task(on_threads(), "test");
    task.begin(until_stopped);
    task.begin([](const std::stop_token&) { return 1; });
    task.begin([](const std::stop_token&) { return 2; });
    EXPECT_EQ(wait_for(task), 2);
    EXPECT_FALSE(task.busy());
}

TEST(BackgroundTask, discards_abandoned_work_and_ends_with_its_owner) {
    const auto held = std::make_shared<int>(3);
    {
        BackgroundTask<int> task(on_threads(), "test");
        task.begin(until_stopped);
        task.give_up();
        EXPECT_FALSE(task.busy());
        task.begin([held](const std::stop_token& stop) { return *held + until_stopped(stop); });
        EXPECT_TRUE(task.busy());
    }
    EXPECT_EQ(held.use_count(), 1);
}

TEST(BackgroundTask, delivers_nothing_when_memory_runs_out_and_can_be_started_again) {
    BackgroundTask<int> task(on_threads(), "test");
    task.begin([](const std::stop_token&) -> int { throw std::bad_alloc(); });
    EXPECT_TRUE(test::eventually([&] {
        EXPECT_FALSE(task.take());
        return !task.busy();
    }));
    task.begin([](const std::stop_token&) { return 7; });
    EXPECT_EQ(wait_for(task), 7);
}

TEST(BackgroundTask, queries_its_own_arrivals_while_another_session_has_its_turn) {
    std::vector<std::uint64_t> reported, reported_to_other;
    Arrivals own([&](std::uint64_t requested) { reported.push_back(requested); }),
        other([&](std::uint64_t requested) { reported_to_other.push_back(requested); });
    BackgroundTask<int> task(at_once(), "test", &own);
    const auto begin = [&] { task.begin([](const std::stop_token&) { return 3; }); };
    const Arrivals::Turn turn_of_other(&other);
    begin();
    EXPECT_EQ(task.take(), 3) << "outside of its session's turns";
    EXPECT_TRUE(reported.empty());
    begin();
    {
        const Arrivals::Turn looks(&own, true);
        EXPECT_FALSE(task.take()) << "somebody only reads the session";
        const Arrivals::Turn turn(&own);
        EXPECT_EQ(task.take(), 3);
        EXPECT_FALSE(task.take());
    }
    EXPECT_EQ(reported, std::vector<std::uint64_t>{1});
    EXPECT_TRUE(reported_to_other.empty());
}

TEST(BackgroundTask, finishes_at_once_if_there_are_no_threads) {
    BackgroundTask<int> task(at_once(), "test");
    task.begin([](const std::stop_token&) { return 1; });
    task.begin([](const std::stop_token&) { return 2; });
    EXPECT_TRUE(task.busy()) << "there is something to take";
    EXPECT_EQ(task.take(), 2);
    EXPECT_FALSE(task.busy());
}

TEST(Executor, names_its_threads_or_runs_without_threads) {
    std::string name;
    std::thread::id ran;
    const auto note = [&] {
        std::array<char, 16> here{};
        pthread_getname_np(pthread_self(), here.data(), here.size());
        name = here.data();
        ran = std::this_thread::get_id();
    };
    std::thread thread = on_threads().run("a-task", note);
    ASSERT_TRUE(thread.joinable());
    thread.join();
    EXPECT_EQ(name, "a-task");
    EXPECT_NE(ran, std::this_thread::get_id());
    EXPECT_FALSE(at_once().run("a-task", note).joinable());
    EXPECT_EQ(ran, std::this_thread::get_id());
}

}  // namespace background_task_test
}  // namespace handrail
