#include "app/core/kept/save_soon.h"

#include <gtest/gtest.h>

#include "app/core/kept/background_writer.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace save_soon_test {

TEST(SaveSoon, saves_2_s_after_the_first_change_even_if_more_follow) {
    SaveSoon save;
    EXPECT_FALSE(save.take_due(100.0));
    save.changed(10.0);
    for (double now_s = 10.0; now_s < 11.95; now_s += 0.1) {
        save.changed(now_s);
        EXPECT_FALSE(save.take_due(now_s)) << now_s;
    }
    EXPECT_TRUE(save.unsaved());
    EXPECT_TRUE(save.take_due(12.0));
    EXPECT_FALSE(save.take_due(12.1)) << "once";
    EXPECT_FALSE(save.unsaved());
    save.changed(12.2);
    EXPECT_FALSE(save.take_due(14.1));
    EXPECT_TRUE(save.take_due(14.3));
}

TEST(SaveSoon, reports_a_failure_once_retries_and_resets_after_a_success) {
    SaveSoon save;
    save.changed(0.0);
    ASSERT_TRUE(save.take_due(2.0));
    EXPECT_EQ(save.ended(fail("full"), 2.1), "full");
    EXPECT_TRUE(save.unsaved());
    EXPECT_FALSE(save.take_due(2.1 + SaveSoon::kRetry_s - 0.1));
    ASSERT_TRUE(save.take_due(2.1 + SaveSoon::kRetry_s));
    EXPECT_EQ(save.ended(fail("full"), 33.0), std::nullopt) << "said already";
    save.changed(34.0);
    ASSERT_TRUE(save.take_due(36.0)) << "a new change does not wait for the next trial";
    EXPECT_EQ(save.ended(fail("read-only"), 36.0), "read-only");
    ASSERT_TRUE(save.take_due(66.0));
    EXPECT_EQ(save.ended({}, 66.0), std::nullopt);
    EXPECT_FALSE(save.unsaved());
    save.changed(70.0);
    ASSERT_TRUE(save.take_due(72.0));
    EXPECT_EQ(save.ended(fail("read-only"), 72.0), "read-only") << "it had worked in between";
}

TEST(BackgroundWriter, writes_and_reports_the_outcome_once) {
    const test::TemporaryFolder folder;
    BackgroundWriter writer(on_threads());
    EXPECT_FALSE(writer.busy());
    EXPECT_FALSE(writer.take_result());
    writer.write(folder.path() / "a", "text");
    writer.wait();
    EXPECT_FALSE(writer.busy());
    const auto result = writer.take_result();
    ASSERT_TRUE(result);
    EXPECT_TRUE(*result);
    EXPECT_FALSE(writer.take_result());
    EXPECT_EQ(test::content_of(folder.path() / "a"), "text");
    writer.write(folder.path() / "a" / "below a file", "text");
    writer.wait();
    EXPECT_FALSE(*writer.take_result());
}

}  // namespace save_soon_test
}  // namespace handrail
