#include "app/main/end_in_time.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

namespace handrail {
namespace end_in_time_test {

// Blocks forever. The function stands for a thread that searches a huge building for routes and does not end in time.
void wait_for_ever() {
    std::mutex mutex;
    std::condition_variable never;
    std::unique_lock lock(mutex);
    never.wait(lock, [] { return false; });
}

TEST(EndInTime, ends_a_process_that_still_waits_for_a_thread_with_its_intended_status) {
    EXPECT_EXIT(
        {
            EndInTime in_time;
            in_time.end_within(0.01, 3);
            wait_for_ever();
        },
        testing::ExitedWithCode(3), "");
}

TEST(EndInTime, leaves_a_process_alone_that_waits_for_nothing) {
    EndInTime never_armed;
    EndInTime in_time;
    in_time.end_within(3600.0, 3);
}

}  // namespace end_in_time_test
}  // namespace handrail
