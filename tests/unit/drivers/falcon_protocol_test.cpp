#include "haptic/drivers/falcon_protocol.h"

#include <limits>
#include <random>

#include "tests/emulators/falcon_emulator.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/scale.h"

namespace handrail {
namespace falcon_protocol_test {

FalconFrame answer_with(std::string_view groups) {
    FalconFrame frame{};
    frame.fill(0x41);
    frame[0] = '<';
    frame[15] = '>';
    std::copy(groups.begin(), groups.end(), frame.begin() + 1);
    return frame;
}

std::vector<FalconStatus> all_of(FalconFrameReader& reader, std::span<const std::uint8_t> bytes) {
    std::vector<FalconStatus> found;
    reader.push(bytes);
    while (const auto status = reader.next()) found.push_back(*status);
    return found;
}

TEST(FalconFrames, decode_the_published_vectors) {
    const std::vector<std::pair<std::string, std::array<int, 3>>> vectors{
        {"PPPACEPACMPA", {4095, 3906, 4034}}, {"PBFANKFAGPFA", {1311, 1453, 1526}}, {"MKEPLBAABKDA", {-2900, 27, 929}}};
    for (const auto& [groups, counts] : vectors) {
        FalconFrameReader reader;
        const auto found = all_of(reader, answer_with(groups));
        ASSERT_EQ(found.size(), 1U) << groups;
        EXPECT_EQ(found[0].encoders, counts) << groups;
    }
}

TEST(FalconFrames, carry_every_motor_value_and_flag) {
    for (int value = -5000; value <= 5000; ++value) {
        const FalconFrame frame = pack_falcon_command({{value, -value, 0}, false, false, false, true});
        FalconFrameReader reader;
        const auto found = all_of(reader, frame);
        ASSERT_EQ(found.size(), 1U);
        const int held = std::clamp(value, -4095, 4095);
        ASSERT_EQ(found[0].encoders, (std::array<int, 3>{held, -held, 0}));
    }
    EXPECT_EQ(pack_falcon_command({{}, false, false, false, true})[13], 0x42);
    EXPECT_EQ(pack_falcon_command({{}, true, false, false, false})[13], 0x43);
    EXPECT_EQ(pack_falcon_command({{}, false, true, false, false})[13], 0x45);
    EXPECT_EQ(pack_falcon_command({{}, false, false, true, false})[13], 0x49);
}

TEST(FalconFrames, decode_flags_wider_than_four_bits) {
    FalconFrame frame = answer_with("AAAAAAAAAAAA");
    frame[13] = static_cast<std::uint8_t>(0x41 + 0x7f);
    FalconFrameReader reader;
    const auto found = all_of(reader, frame);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].buttons, 15);
    EXPECT_EQ(found[0].homed_legs, 7);
}

TEST(FalconFrames, are_found_again_after_any_garbage) {
    const unsigned seed = 3;
    std::mt19937 random(seed);
    std::uint64_t frames = 0;
    FalconFrameReader reader;
    for (int i = 0; i < test::scaled(20000); ++i) {
        std::vector<std::uint8_t> bytes;
        const int noise = static_cast<int>(random() % 20);
        for (int k = 0; k < noise; ++k) bytes.push_back(static_cast<std::uint8_t>(random()));
        const int value = static_cast<int>(random() % 8001) - 4000;
        const FalconFrame frame = pack_falcon_command({{value, 12, -7}, false, false, false, false});
        bytes.insert(bytes.end(), frame.begin(), frame.end());
        std::optional<FalconStatus> last;
        for (std::size_t at = 0; at < bytes.size();) {  // the bytes arrive in pieces
            const std::size_t piece = std::min<std::size_t>(1 + random() % 7, bytes.size() - at);
            reader.push({bytes.data() + at, piece});
            at += piece;
            while (const auto status = reader.next()) last = status;
        }
        // The noise may contain a '<', with which frames begin. The reader must still find the real frame after the
        // noise.
        ASSERT_TRUE(last) << "seed " << seed << ", round " << i;
        ASSERT_EQ(last->encoders, (std::array<int, 3>{value, 12, -7})) << "seed " << seed << ", round " << i;
        ++frames;
    }
    EXPECT_GT(reader.skipped(), frames);
}

TEST(FalconFrames, drop_the_oldest_of_too_many_bytes) {
    FalconFrameReader reader;
    std::vector<std::uint8_t> flood(1000, '<');
    const FalconFrame frame = pack_falcon_command({{1, 2, 3}, false, false, false, false});
    flood.insert(flood.end(), frame.begin(), frame.end());
    const auto found = all_of(reader, flood);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].encoders, (std::array<int, 3>{1, 2, 3}));
}

TEST(FalconMotorCounts, stay_in_range_and_keep_the_direction_of_the_force) {
    const unsigned seed = 12;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0), power(-6.0, 9.0);
    for (int i = 0; i < test::scaled(50000); ++i) {
        const Vec3 direction{unit(random), unit(random), unit(random)};
        const Vec3 torques = direction * std::pow(10.0, power(random));
        const auto counts = falcon_motor_counts(torques, 10000.0);
        double largest = 0.0;
        for (int leg = 0; leg < 3; ++leg) {
            const int count = counts[static_cast<std::size_t>(leg)];
            ASSERT_LE(std::abs(count), 4095) << "seed " << seed;
            largest = std::max(largest, std::abs(torques[leg]));
        }
        // The direction must be exact to one count, where counts = -scale * torques.
        const double scale = std::min(4095.0 / largest, 10000.0);
        for (int leg = 0; leg < 3; ++leg)
            ASSERT_NEAR(counts[static_cast<std::size_t>(leg)], -scale * torques[leg], 1.0)
                << "seed " << seed << ", " << i;
    }
    const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
    for (const double odd : {inf, -inf, nan})
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 torques{0.01, -0.02, 0.03};
            torques[axis] = odd;
            EXPECT_EQ(falcon_motor_counts(torques, 10000.0), (std::array<int, 3>{}));
            EXPECT_EQ(falcon_motor_counts(Vec3(0.1), odd), (std::array<int, 3>{}));
        }
    EXPECT_EQ(falcon_motor_counts({1e300, -1e300, 1e300}, 10000.0), (std::array<int, 3>{-4095, 4095, -4095}));
    EXPECT_EQ(falcon_motor_counts({5e-320, 0.0, 0.0}, 10000.0), (std::array<int, 3>{}));
}

TEST(FalconFirmware, is_accepted_whole_and_refused_if_cut_at_any_byte) {
    for (const std::size_t size : {4, 36, 500}) {
        const std::vector<std::uint8_t> image = test::boot_image(size);
        EXPECT_TRUE(check_falcon_firmware(image, "f.bin"));
        for (std::size_t cut = 0; cut < image.size(); ++cut) {
            const auto checked = check_falcon_firmware(std::span(image).first(cut), "f.bin");
            ASSERT_FALSE(checked) << cut;
            EXPECT_EQ(checked.error().file, "f.bin");
        }
        std::vector<std::uint8_t> longer = image;
        longer.push_back(0);
        EXPECT_FALSE(check_falcon_firmware(longer, "f.bin"));
        std::vector<std::uint8_t> other = image;
        other[0] ^= 1;
        EXPECT_FALSE(check_falcon_firmware(other, "f.bin"));
    }
}

TEST(FalconFirmware, check_survives_any_bytes) {
    const unsigned seed = 44;
    std::mt19937 random(seed);
    for (int i = 0; i < test::scaled(5000); ++i) {
        std::vector<std::uint8_t> image = test::boot_image(60);
        for (int k = 0; k < 4; ++k) image[2 + random() % (image.size() - 2)] = static_cast<std::uint8_t>(random());
        const auto checked = check_falcon_firmware(image, "f.bin");
        EXPECT_TRUE(checked || !checked.error().sentence().empty());
    }
}

}  // namespace falcon_protocol_test
}  // namespace handrail
