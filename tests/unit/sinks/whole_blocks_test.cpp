#include "audio-cues/sinks/whole_blocks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "audio-cues/sinks/openal_sink.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/scale.h"

namespace handrail {
namespace whole_blocks_test {

TEST(WholeBlocks, delivers_every_frame_once_in_order_and_requests_only_multiples_of_64) {
    const std::uint32_t seed = test::seed_of_run();
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    WholeBlocks blocks;
    int made = 0, had = 0;
    for (int i = 0; i < 2000; ++i) {
        const int frames = std::uniform_int_distribution(0, i % 10 == 0 ? 3000 : 200)(random);
        std::vector<float> stereo(2 * static_cast<std::size_t>(frames) + 2,
                                  -1.0F);  // one more frame than requested, which must stay unchanged
        blocks.take(stereo.data(), frames, [&](float* to, int count) {
            ASSERT_GT(count, 0);
            ASSERT_EQ(count % 64, 0);
            for (int k = 0; k < count; ++k, ++made) {
                to[2 * k] = static_cast<float>(made % 100003);
                to[2 * k + 1] = static_cast<float>(made % 7);
            }
        });
        for (int k = 0; k < frames; ++k, ++had) {
            ASSERT_EQ(stereo[2 * static_cast<std::size_t>(k)], static_cast<float>(had % 100003)) << "request " << i;
            ASSERT_EQ(stereo[2 * static_cast<std::size_t>(k) + 1], static_cast<float>(had % 7)) << "request " << i;
        }
        ASSERT_EQ(stereo[2 * static_cast<std::size_t>(frames)], -1.0F);
        ASSERT_LT(made - had, 64) << "nothing is made sooner than it is needed";
    }
}

// Simulates a person who goes from room to room. The sink reloads the reverberation about twice a second while
// footsteps sound in it.
class FromRoomToRoom {
public:
    FromRoomToRoom(const OpenALSink::Options& options, std::uint32_t seed) : random_(seed) {
        auto opened = OpenALSink::open(voice_, options);
        if (!opened) throw std::runtime_error(opened.error().sentence());
        sink_ = std::move(*opened);
        sink_->set_sound({.reverberation = 1.0});
    }
    OpenALSink& sink() { return *sink_; }
    double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
    int whole_between(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
    void tick(double dt_s) {
        now_s_ += dt_s;
        if (now_s_ >= next_room_s_) {
            next_room_s_ = now_s_ + between(0.3, 0.8);
            sink_->set_listener(
                {.ears_m = {0.0, 0.0, 1.7}, .heading_rad = between(-3.0, 3.0), .reverberation_s = between(0.1, 6.0)});
            sink_->play({.kind = SoundKind::Footstep,
                         .material = SoundClass::Tile,
                         .position_m = {between(-1.0, 1.0), between(-1.0, 1.0), 0.0},
                         .loudness = 1.0});
        }
        sink_->tick(now_s_);
    }

private:
    std::mt19937 random_;
    std::shared_ptr<VoiceChannel> voice_ = std::make_shared<VoiceChannel>();
    std::unique_ptr<OpenALSink> sink_;
    double now_s_ = 5.0, next_room_s_ = 5.0;
};

// Sanitizers cannot check inside OpenAL's library. If it wrote past its buffer, the heap would be damaged or the
// program would crash. So the test checks the sizes of the requests that cause such a write.
TEST(OpenALSinkLoopback, requests_only_whole_blocks_in_a_million_random_ticks_with_a_changing_room) {
    const std::uint32_t seed = test::seed_of_run();
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    long requested = 0, broken = 0;
    const auto look = [&](int frames) {
        ++requested;
        broken += frames % 64 != 0;
    };
    FromRoomToRoom walk({.output = OpenALSink::Output::OnDemand, .on_render = look}, seed);
    const int ticks = test::scaled(1'000'000);
    long had = 0;
    for (int i = 0; i < ticks; ++i) {
        walk.tick(walk.between(0.0, 0.004));
        const int frames = walk.whole_between(0, 12);
        ASSERT_EQ(walk.sink().render(frames).size(), 2 * static_cast<std::size_t>(frames));
        had += frames;
        ASSERT_EQ(broken, 0) << "tick " << i;
    }
    EXPECT_NEAR(static_cast<double>(requested), static_cast<double>(had) / 64.0, 1.0);
}

TEST(OpenALSinkLoopback, renders_unheard_samples_in_whole_blocks_and_loses_none) {
    const std::uint32_t seed = test::seed_of_run();
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    long made = 0;
    int broken = 0;
    const auto look = [&](int frames) {
        made += frames;
        broken += frames % 64 != 0;
    };
    FromRoomToRoom walk({.device = "a device that is not there", .on_render = look}, seed);
    ASSERT_FALSE(walk.sink().has_device());
    walk.tick(0.0);
    double lived_s = 0.0;
    const int ticks = test::scaled(20'000);
    for (int i = 0; i < ticks; ++i) {
        const double dt_s = walk.between(0.0, 0.012);
        lived_s += dt_s;
        walk.tick(dt_s);
        ASSERT_EQ(broken, 0) << "tick " << i;
    }
    EXPECT_NEAR(static_cast<double>(made), lived_s * 48000.0, 64.0);
}

}  // namespace whole_blocks_test
}  // namespace handrail
