#include "worlds/base/latest_value.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <thread>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "worlds/base/spsc_ring.h"

namespace handrail {
namespace latest_value_test {

// A value so large that a torn copy would be noticed: a complete copy has the same number in every element.
struct Wide {
    std::array<std::uint64_t, 64> words{};
    static Wide of(std::uint64_t number) {
        Wide wide;
        wide.words.fill(number);
        return wide;
    }
    bool whole() const {
        return std::all_of(words.begin(), words.end(), [&](std::uint64_t word) { return word == words[0]; });
    }
};

TEST(LatestValue, shows_the_first_value_until_a_publication_and_then_only_the_newest) {
    LatestValue<int> value(7);
    EXPECT_FALSE(value.refresh());
    EXPECT_EQ(value.read(), 7);
    value.publish(8);
    value.publish(9);
    EXPECT_EQ(value.read(), 7) << "nothing changes under a reader before it asks";
    EXPECT_TRUE(value.refresh());
    EXPECT_EQ(value.read(), 9);
    EXPECT_FALSE(value.refresh());
    EXPECT_EQ(value.read(), 9);
}

TEST(LatestValue, passes_whole_values_between_threads_in_order_and_never_loses_the_last) {
    LatestValue<Wide> value;
    const auto last = static_cast<std::uint64_t>(test::scaled(200'000));
    std::thread producer([&] {
        for (std::uint64_t number = 1; number <= last; ++number) value.publish(Wide::of(number));
    });
    std::uint64_t seen = 0, torn = 0, backwards = 0;
    while (seen < last) {
        if (!value.refresh()) {
            std::this_thread::yield();
            continue;
        }
        torn += value.read().whole() ? 0 : 1;
        backwards += value.read().words[0] > seen ? 0 : 1;
        seen = value.read().words[0];
    }
    producer.join();
    EXPECT_EQ(torn, 0U);
    EXPECT_EQ(backwards, 0U);
    EXPECT_FALSE(value.refresh());
}

// If two processes share the memory, the other process may write anything into the indices.
TEST(LatestValue, stays_within_its_memory_for_any_content_of_its_indices) {
    struct Slot {
        std::array<std::uint64_t, 4> words{};
    };
    using Value = LatestValue<Slot>;
    struct Room {
        std::array<std::byte, 4096> before{};
        Value value;
        std::array<std::byte, 4096> after{};
    };
    const auto room = std::make_unique<Room>();
    auto* bytes = reinterpret_cast<unsigned char*>(&room->value);
    const auto* begin = reinterpret_cast<const unsigned char*>(&room->value);
    constexpr std::size_t kSlotBytes = 4 * sizeof(Slot);
    for (int index = 0; index < 256; ++index) {
        for (std::size_t i = kSlotBytes; i < sizeof(Value); ++i) bytes[i] = static_cast<unsigned char>(index);
        const auto* shown = reinterpret_cast<const unsigned char*>(&room->value.read());
        EXPECT_TRUE(shown >= begin && shown + sizeof(Slot) <= begin + kSlotBytes) << index;
        Slot full;
        full.words.fill(~std::uint64_t{0});
        room->value.publish(full);
        room->value.refresh();
        shown = reinterpret_cast<const unsigned char*>(&room->value.read());
        EXPECT_TRUE(shown >= begin && shown + sizeof(Slot) <= begin + kSlotBytes) << index;
    }
    const auto untouched = [](const auto& wall) {
        return std::all_of(wall.begin(), wall.end(), [](std::byte b) { return b == std::byte{0}; });
    };
    EXPECT_TRUE(untouched(room->before) && untouched(room->after));
}

TEST(SpscRing, keeps_everything_in_order_between_two_threads_and_refuses_when_full) {
    SpscRing<int, 3> small;
    EXPECT_TRUE(small.push(1) && small.push(2) && small.push(3));
    EXPECT_FALSE(small.push(4));
    SpscRing<int, 64> ring;
    const int count = test::scaled(200'000);
    std::thread producer([&] {
        for (int i = 0; i < count;) {
            if (ring.push(i)) ++i;
            else std::this_thread::yield();
        }
    });
    int next = 0, out_of_order = 0, got = 0;
    while (next < count) {
        if (!ring.pop(got)) {
            std::this_thread::yield();
            continue;
        }
        out_of_order += got == next ? 0 : 1;
        ++next;
    }
    producer.join();
    EXPECT_EQ(out_of_order, 0);
}

}  // namespace latest_value_test
}  // namespace handrail
