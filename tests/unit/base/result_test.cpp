#include "worlds/base/result.h"

#include "worlds/base/clock.h"
#include "worlds/base/contract.h"

namespace handrail {
namespace result_test {

TEST(Error, includes_only_the_known_parts_of_a_source_location) {
    EXPECT_EQ((Error{"house.map", 12, 4, "It ends early."}.sentence()), "house.map, line 12, column 4: It ends early.");
    EXPECT_EQ((Error{"house.map", 12, 0, "It ends early."}.sentence()), "house.map, line 12: It ends early.");
    EXPECT_EQ((Error{"house.map", 0, 4, "It ends early."}.sentence()), "house.map: It ends early.");
    EXPECT_EQ((Error{"", 12, 0, "It ends early."}.sentence()), "line 12: It ends early.");
    EXPECT_EQ((Error{"", 0, 0, "It ends early."}.sentence()), "It ends early.");
}

TEST(Diagnostic, gives_severity_message_and_the_action_taken) {
    EXPECT_EQ((Diagnostic{Severity::Error, "house.map", 4752, 41, "a face ends early.", "This brush was left out."}
                   .sentence()),
              "house.map, line 4752, column 41: error: a face ends early. This brush was left out.");
    EXPECT_EQ((Diagnostic{Severity::Warning, "", 0, 0, "no start.", ""}.sentence()), "warning: no start.");
}

TEST(Fail, passes_place_and_sentence_on_into_any_result) {
    const Result<int> result = fail("It ends early.", "house.map", 3, 2);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().sentence(), "house.map, line 3, column 2: It ends early.");
}

TEST(ContractPre, ends_the_program_and_names_file_line_and_condition_but_no_folder) {
    contract_pre(1 + 1 == 2);
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_DEATH(contract_pre(1 + 1 == 3),
                 "^Handrail has a fault of its own at result_test.cpp line [0-9]+: 1 \\+ 1 == 3 does not hold");
}

TEST(VirtualClock, moves_only_on_request_and_never_backwards) {
    VirtualClock clock;
    EXPECT_EQ(clock.now_s(), 0.0);
    clock.advance_s(0.25);
    clock.sleep_until_s(1.0);
    clock.sleep_until_s(0.5);
    clock.advance_s(-1.0);
    EXPECT_EQ(clock.now_s(), 1.0);
}

TEST(SteadyClock, never_goes_back_and_sleepers_do_not_wake_early) {
    SteadyClock clock;
    double before = clock.now_s();
    for (int i = 0; i < 1000; ++i) {
        const double now = clock.now_s();
        ASSERT_GE(now, before);
        before = now;
    }
    const double until = clock.now_s() + 0.002;
    clock.sleep_until_s(until);
    EXPECT_GE(clock.now_s(), until - 1e-6);
    clock.sleep_until_s(until - 10.0);  // a time in the past, so sleep_until_s() returns immediately
}

}  // namespace result_test
}  // namespace handrail
