// Work beside the owner's thread: the last one begun counts, what is given up ends soon, nothing outlives the owner.
#include "app/core/world/beside.h"

#include <chrono>

namespace handrail {
namespace beside_test {

template <class T>
std::optional<T> wait_for(Beside<T>& beside) {
    for (int i = 0; i < 20000; ++i) {
        if (auto made = beside.take()) return made;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return std::nullopt;
}

int until_stopped(const std::stop_token& stop) {
    while (!stop.stop_requested()) std::this_thread::yield();
    return -1;
}

TEST(Beside, gives_what_was_made_once) {
    Beside<int> beside;
    EXPECT_FALSE(beside.busy());
    EXPECT_FALSE(beside.take());
    beside.begin([](const std::stop_token&) { return 5; });
    EXPECT_TRUE(beside.busy());
    EXPECT_EQ(wait_for(beside), 5);
    EXPECT_FALSE(beside.busy());
    EXPECT_FALSE(beside.take());
}

TEST(Beside, counts_only_the_last_of_what_was_begun) {
    Beside<int> beside;
    beside.begin(until_stopped);
    beside.begin([](const std::stop_token&) { return 1; });
    beside.begin([](const std::stop_token&) { return 2; });
    EXPECT_EQ(wait_for(beside), 2);
    EXPECT_FALSE(beside.busy());
}

TEST(Beside, forgets_what_was_given_up_and_ends_with_its_owner) {
    const auto held = std::make_shared<int>(3);
    {
        Beside<int> beside;
        beside.begin(until_stopped);
        beside.give_up();
        EXPECT_FALSE(beside.busy());
        beside.begin([held](const std::stop_token& stop) { return *held + until_stopped(stop); });
        EXPECT_TRUE(beside.busy());
    }
    EXPECT_EQ(held.use_count(), 1);
}

TEST(Beside, makes_nothing_where_memory_does_not_suffice_and_goes_on_afterwards) {
    Beside<int> beside;
    beside.begin([](const std::stop_token&) -> int { throw std::bad_alloc(); });
    for (int i = 0; i < 20000 && beside.busy(); ++i) {
        EXPECT_FALSE(beside.take());
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_FALSE(beside.busy());
    beside.begin([](const std::stop_token&) { return 7; });
    EXPECT_EQ(wait_for(beside), 7);
}

}  // namespace beside_test
}  // namespace handrail
