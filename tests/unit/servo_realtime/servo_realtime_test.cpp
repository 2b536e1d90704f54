// Tests that the servo thread neither allocates nor locks. This test is a separate program, because it replaces malloc
// and the locks of the whole program to count their calls.
#include <dlfcn.h>
#include <pthread.h>
#include <semaphore.h>
#include <time.h>

#include <atomic>
#include <cstdlib>
#include <random>

#include "haptic/device/simulated_device.h"
#include "haptic/drivers/guarded_device.h"
#include "haptic/servo/servo_loop.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "tests/support/scale.h"
#include "tests/support/servo_rig.h"

namespace {

// The replacements count calls only on a thread that has set `counting`, and only while it is set.
thread_local bool counting = false;
thread_local int allocations = 0, locks = 0, clocks = 0;

}  // namespace

#if !defined(HANDRAIL_SANITIZED)
#define HANDRAIL_INTERPOSES 1

extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
void __libc_free(void*);

void* malloc(size_t size) {
    allocations += counting;
    return __libc_malloc(size);
}
void* calloc(size_t count, size_t size) {
    allocations += counting;
    return __libc_calloc(count, size);
}
void* realloc(void* old, size_t size) {
    allocations += counting;
    return __libc_realloc(old, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
    allocations += counting;
    return __libc_memalign(alignment, size);
}
void free(void* old) {
    allocations += counting;
    __libc_free(old);
}

// Looks up the real library function behind a replacement. Each lookup happens once, before any counting.
#define HANDRAIL_NEXT(name) reinterpret_cast<decltype(&name)>(dlsym(RTLD_NEXT, #name))

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
    static const auto next = HANDRAIL_NEXT(pthread_mutex_lock);
    locks += counting;
    return next(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
    static const auto next = HANDRAIL_NEXT(pthread_mutex_trylock);
    locks += counting;
    return next(mutex);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
    static const auto next = HANDRAIL_NEXT(pthread_rwlock_rdlock);
    locks += counting;
    return next(lock);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
    static const auto next = HANDRAIL_NEXT(pthread_rwlock_wrlock);
    locks += counting;
    return next(lock);
}
int clock_gettime(clockid_t id, timespec* time) noexcept {
    static const auto next = HANDRAIL_NEXT(clock_gettime);
    clocks += counting;
    return next(id, time);
}
}
#endif

namespace handrail {
namespace {

using test::kTick;
using test::ServoRig;

struct Counts {
    int allocations = 0, locks = 0, clocks = 0;
};

template <class Work>
Counts count(const Work& work) {
    allocations = locks = clocks = 0;
    counting = true;
    work();
    counting = false;
    return {allocations, locks, clocks};
}

class ServoRealtime : public testing::Test {
protected:
    void SetUp() override {
#ifndef HANDRAIL_INTERPOSES
        GTEST_SKIP() << "the sanitizer owns malloc and the locks";
#endif
    }
};

TEST_F(ServoRealtime, the_counters_detect_allocations_locks_and_clocks) {
    static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
    const Counts counts = count([] {
        const std::vector<int> some(static_cast<std::size_t>(std::rand() % 5 + 1));
        EXPECT_FALSE(some.empty());
        pthread_mutex_lock(&mutex);
        pthread_mutex_unlock(&mutex);
        SteadyClock().now_s();
    });
    EXPECT_GE(counts.allocations, 2);
    EXPECT_GE(counts.locks, 1);
    EXPECT_GE(counts.clocks, 1);
}

// Returns a crowded room with random boxes and triangles around the hand, so that the solver's candidates change often.
std::shared_ptr<const HapticScene> crowded_scene(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-0.1, 0.1), size(0.003, 0.02);
    HapticSceneBuilder builder;
    for (std::uint32_t i = 0; i < 150; ++i) {
        const Vec3 at(place(random), place(random), place(random));
        builder.add_box({at, at + Vec3(size(random), size(random), size(random))},
                        SurfaceLabel{FeatureId{i}, kDefaultMaterial, false});
        const Vec3 corner(place(random), place(random), place(random));
        builder.add_triangle(corner, corner + Vec3(size(random), 0, size(random)), corner + Vec3(0, size(random), 0),
                             SurfaceLabel{FeatureId{1000 + i}, kDefaultMaterial, false});
    }
    return builder.build();
}

TEST_F(ServoRealtime, a_tick_never_allocates_locks_or_reads_a_clock) {
    const std::vector<std::shared_ptr<const HapticScene>> scenes{crowded_scene(1), crowded_scene(2),
                                                                 test::wall_scene(0.03)};
    ServoState state(*find_device_spec("sim-t"));
    ServoTuning tuning;
    tuning.touch.damping_ns_per_m = 5.0;
    tuning.touch.default_friction_static = 0.5;
    tuning.touch.default_friction_kinetic = 0.4;
    tuning.touch.passivity_guard = true;
    WorkspacePose pose;
    DeviceSample sample;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const int ticks = test::scaled(30000);
    double now_s = 10.0;
    std::uint64_t events = 0, touching = 0;
    const Counts counts = count([&] {
        for (int i = 0; i < ticks; ++i) {
            const unsigned dice = random() % 1000;
            sample.fresh = dice % 50 != 0;
            sample.connected = dice != 7;
            sample.position_m =
                Vec3(0.05 * std::sin(0.003 * i), 0.05 * std::sin(0.0041 * i), 0.05 * std::sin(0.0017 * i));
            if (dice == 11) sample.position_m.x = NAN;
            if (dice == 13) sample.position_m.y += 0.06;
            if (dice == 17) ++pose.jump;
            if (dice == 19) tuning.panic = !tuning.panic;
            if (dice == 23) tuning.forces_on = !tuning.forces_on;
            if (dice == 29) tuning.touch.world_m_per_hand_m = 1.0 + 0.1 * unit(random);
            if (i % 100 == 0) ++tuning.confirm;
            if (i % 16 == 0) {
                pose.time_s = now_s;
                pose.origin_m = Vec3(0.02 * unit(random), 0.02 * unit(random), 0.0);
                pose.heading_rad = unit(random);
            }
            const auto& scene = scenes[static_cast<std::size_t>(i / 500) % scenes.size()];
            servo_tick(state, {dice == 31 ? nullptr : scene.get(), tuning, pose, sample, now_s});
            events += state.events().count;
            touching += state.tool().contacts.count > 0;
            now_s += dice == 37 ? 0.04 : kTick;
        }
    });
    EXPECT_EQ(counts.allocations, 0);
    EXPECT_EQ(counts.locks, 0);
    EXPECT_EQ(counts.clocks, 0);
    EXPECT_GT(events, 100u);
    EXPECT_GT(touching, static_cast<std::uint64_t>(ticks) / 20);
}

TEST_F(ServoRealtime, the_surrounding_loop_never_allocates_or_frees) {
    VirtualClock clock;
    auto hand = std::make_shared<SimulatedHand>();
    ServoLoop loop(std::make_unique<SimulatedDevice>(*find_device_spec("sim-f"), hand), clock);
    ASSERT_TRUE(loop.open());
    ServoTuning tuning;
    loop.set_tuning(tuning);
    loop.set_pose({});
    hand->command.publish({HandMode::Follow, Vec3(0, 0.03, 0), 0.0, Vec3(0.0), 0});
    Counts sum;
    for (int swap = 0; swap < 20; ++swap) {
        loop.set_scene(test::wall_scene(0.02));  // set_scene() frees the previous scene on this thread
        const Counts counts = count([&] {
            for (int i = 0; i < 200; ++i) {
                loop.step();
                clock.advance_s(kTick);
            }
        });
        sum.allocations += counts.allocations;
        sum.locks += counts.locks;
    }
    EXPECT_EQ(sum.allocations, 0);
    EXPECT_EQ(sum.locks, 0);
}

// Tests a guarded device, which the servo uses like a real device. The device runs in a separate guard process.
TEST_F(ServoRealtime, a_guarded_device_is_exchanged_without_allocation_lock_or_clock) {
    GuardedDevice device(*find_device_spec("falcon"), test::built_program("standin_guard"), {"echo"});
    const auto opened = device.open();
    ASSERT_TRUE(opened) << opened.error().sentence();
    Counts sum;
    int fresh = 0;
    SteadyClock clock;
    for (int i = 0; i < 500; ++i) {
        const Counts counts = count([&] {
            fresh += device.read(0.0).fresh;
            device.write({{0.0, 0.001 * i, 0.0}});
        });
        sum.allocations += counts.allocations;
        sum.locks += counts.locks;
        sum.clocks += counts.clocks;
        clock.sleep_until_s(clock.now_s() + 2e-4);
    }
    EXPECT_EQ(sum.allocations, 0);
    EXPECT_EQ(sum.locks, 0);
    EXPECT_EQ(sum.clocks, 0);
    EXPECT_GT(fresh, 5);
}

}  // namespace
}  // namespace handrail
