#include "app/window/key_gate.h"
#include "tests/support/names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace handrail {
namespace key_gate_test {

using testing::ElementsAre;
using testing::IsEmpty;

struct KeyGateTest : testing::Test {
    void with_reader() {
        gate.set_reader({[this](const KeyStroke& stroke) {
                             offered.push_back(stroke.name);
                             verdicts[offered.size()] = KeyVerdict::Waiting;
                             return std::uint64_t{offered.size()};
                         },
                         [this](std::uint64_t ticket) { return verdicts.at(ticket); }});
    }
    void take(int key, const std::string& name, double now_s) {
        gate.take({key, 1, 0}, {.press = true, .name = name}, now_s);
    }
    // Returns the decided keys. A key is positive if the gate passed it to the program, and negative if the screen
    // reader used it.
    std::vector<int> decided(double now_s) {
        std::vector<int> keys;
        for (const KeyGate::Passed& passed : gate.decided(now_s))
            keys.push_back(passed.ours ? passed.key.glfw_key : -passed.key.glfw_key);
        return keys;
    }

    KeyGate gate;
    std::vector<std::string> offered;
    std::map<std::uint64_t, KeyVerdict> verdicts;
};

TEST_F(KeyGateTest, without_a_screen_reader_keys_pass_at_once) {
    take(65, "a", 0.0);
    take(66, "b", 0.0);
    EXPECT_THAT(decided(0.0), ElementsAre(65, 66));
    EXPECT_THAT(decided(0.0), IsEmpty());
}

TEST_F(KeyGateTest, keys_wait_for_the_screen_reader_and_keep_their_order) {
    with_reader();
    take(65, "a", 0.0);
    take(66, "b", 0.0);
    EXPECT_THAT(offered, ElementsAre("a", "b")) << "asked at once, not one after the other";
    verdicts[2] = KeyVerdict::Ours;
    EXPECT_THAT(decided(0.01), IsEmpty()) << "b may not overtake a";
    verdicts[1] = KeyVerdict::Readers;
    EXPECT_THAT(decided(0.02), ElementsAre(-65, 66));
}

TEST_F(KeyGateTest, a_screen_reader_that_does_not_answer_is_no_longer_consulted) {
    with_reader();
    take(65, "a", 1.0);
    EXPECT_THAT(decided(1.0 + 0.99 * KeyGate::kPatience_s), IsEmpty());
    EXPECT_THAT(decided(1.0 + KeyGate::kPatience_s), ElementsAre(65));
}

TEST_F(KeyGateTest, the_text_of_a_key_is_passed_or_dropped_together_with_it) {
    EXPECT_FALSE(gate.take_text("a")) << "no key is here";
    with_reader();
    take(65, "a", 0.0);
    EXPECT_TRUE(gate.take_text("a"));
    verdicts[1] = KeyVerdict::Ours;
    const auto passed = gate.decided(0.0);
    ASSERT_EQ(passed.size(), 1U);
    EXPECT_EQ(passed[0].text, "a");
}

TEST_F(KeyGateTest, undecided_keys_are_dropped_when_the_keyboard_is_lost) {
    with_reader();
    take(65, "a", 0.0);
    gate.clear();
    verdicts[1] = KeyVerdict::Ours;
    EXPECT_THAT(decided(0.0), IsEmpty());
}

}  // namespace key_gate_test
}  // namespace handrail
