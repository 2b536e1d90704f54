// Measures the peak memory while the program finds walkable places, routes and rooms. The test counts every allocation
// of this program.
#include <malloc.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>
#include <thread>

#include "app/core/whereabouts/rooms_of_world.h"
#include "app/core/world/walker.h"
#include "tests/support/names.h"
#include "tests/support/office_world.h"
#include "tests/support/scale.h"
#include "worlds/base/language.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/readers/reader.h"

namespace {

// Bytes that are allocated now, their maximum, and a limit above which allocations fail.
std::atomic<std::size_t> held{0}, most_held{0}, room_for{~std::size_t{0}};

void* counted(std::size_t bytes, const std::nothrow_t&) noexcept {
    void* made = held + bytes > room_for ? nullptr : std::malloc(bytes);
    if (!made) return nullptr;
    const std::size_t now = held += malloc_usable_size(made);
    for (std::size_t most = most_held; now > most && !most_held.compare_exchange_weak(most, now);) {
    }
    return made;
}
void* counted(std::size_t bytes) {
    void* made = counted(bytes, std::nothrow);
    if (!made) throw std::bad_alloc();
    return made;
}
void given_back(void* made) {
    if (made) held -= malloc_usable_size(made);
    std::free(made);
}

}  // namespace

void* operator new(std::size_t bytes) { return counted(bytes); }
void* operator new[](std::size_t bytes) { return counted(bytes); }
void* operator new(std::size_t bytes, const std::nothrow_t& tag) noexcept {
    return counted(bytes, tag);
}  // std::stable_sort uses this operator for its buffer
void* operator new[](std::size_t bytes, const std::nothrow_t& tag) noexcept { return counted(bytes, tag); }
void operator delete(void* made) noexcept { given_back(made); }
void operator delete[](void* made) noexcept { given_back(made); }
void operator delete(void* made, std::size_t) noexcept { given_back(made); }
void operator delete[](void* made, std::size_t) noexcept { given_back(made); }

namespace handrail {
namespace {

// Under a sanitizer, the office is so small that the test takes only seconds. In such an office, a larger part of the
// memory is fixed for each world, so the limit is higher: 238 bytes per place.
constexpr bool kSmall = test::kSanitizerScale < 1.0;
constexpr int kBrushes = kSmall ? 500 : 2'000;
constexpr double kMost_bytes = kSmall ? 300.0 : 150.0;

TEST(SpanMemory, peaks_at_150_bytes_or_less_for_each_place_to_stand) {
    const Result<Scene> scene = read_quake_map(test::office_world(test::office_size(kBrushes)).map, "office.map");
    ASSERT_TRUE(scene);
    const WalkerSize size = walker_size(*scene, 0.25);
    const std::size_t before = held;
    most_held = before;
    const auto bytes_each = [&](std::size_t spans) {
        return static_cast<double>(most_held - before) / static_cast<double>(spans);
    };
    const auto made = Navigation::make(*scene, walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m));
    ASSERT_TRUE(made);
    const std::size_t spans = (*made)->space().spans.size();
    EXPECT_GT(spans, 200U * kBrushes);
    EXPECT_LE(bytes_each(spans), kMost_bytes) << "with the ways";
    const RoomGraph graph = make_rooms(*scene, (*made)->space());
    EXPECT_GT(graph.rooms.size(), kBrushes / 40U);
    EXPECT_LE(bytes_each(spans), kMost_bytes) << "with the rooms";
    RecordProperty("bytes_for_each_place", std::to_string(bytes_each(spans)));
}

// The file of a flat is in millimetres, but the reader treats the numbers as metres. So the floor is 60 by 40 km.
TEST(SpanMemory, is_limited_in_a_world_too_large_to_be_examined_completely) {
    if (kSmall) GTEST_SKIP() << "too large for a sanitizer";
    (void)phrase("direction.ahead");  // loads the texts of the language before the test counts memory
    std::string mesh;
    auto box = [&, points = 0](double x0, double y0, double x1, double y1, double z1) mutable {
        for (const double z : {0.0, z1})
            for (const auto& [x, y] : {std::pair{x0, y0}, std::pair{x1, y0}, std::pair{x1, y1}, std::pair{x0, y1}})
                mesh += fmt::format("v {} {} {}\n", x, y, z);
        for (const auto& f : {std::array{1, 2, 3, 4}, std::array{5, 6, 7, 8}, std::array{1, 2, 6, 5},
                              std::array{2, 3, 7, 6}, std::array{3, 4, 8, 7}, std::array{4, 1, 5, 8}})
            mesh += fmt::format("f {} {} {} {}\n", points + f[0], points + f[1], points + f[2], points + f[3]);
        points += 8;
    };
    mesh += "o floor\n";
    box(0, 0, 60'000, 40'000, 200);
    for (int x = 0; x < 5; ++x) {
        mesh += fmt::format("o wall {}\n", x);
        box(12'000.0 * x, 0, 12'000.0 * x + 100, 39'000, 2'800);
    }
    const Result<Scene> scene = read_obj(mesh, "flat.obj");
    ASSERT_TRUE(scene);
    const std::size_t before = held;
    most_held = before;
    const auto made = Navigation::make(*scene, WalkerMeasures{});
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_TRUE((*made)->space().part);
    EXPECT_LT(most_held - before, std::size_t{700} << 20);
}

TEST(SpanMemory, exhaustion_is_reported_and_does_no_further_harm) {
    const auto scene =
        std::make_shared<const Scene>(*read_quake_map(test::office_world(test::office_size(300)).map, "office.map"));
    for (const Executor* executor : {&at_once(), &on_threads()})
        for (const std::size_t room : {std::size_t{100'000}, std::size_t{1'000'000}, std::size_t{4'000'000}}) {
            room_for = held + room;
            RoomsOfWorld rooms(scene, WalkerMeasures{}, *executor);
            while (!rooms.ready()) std::this_thread::yield();
            room_for = ~std::size_t{0};
            EXPECT_FALSE(rooms.found());
            EXPECT_EQ(rooms.problem(), "There is not enough memory to find rooms and routes in this world.");
        }
    RoomsOfWorld rooms(scene, WalkerMeasures{}, at_once());
    EXPECT_TRUE(rooms.ready());
    EXPECT_TRUE(rooms.found());
}

}  // namespace
}  // namespace handrail
