#include "tests/support/child_process.h"
#include "worlds/readers/reader.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <set>
#include <stop_token>
#include <thread>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace read_world_test {

using testing::HasSubstr;

std::string sentence_for(const std::string& name, std::string_view bytes) {
    const test::TemporaryFolder folder;
    const Result<Scene> scene = read_world(folder.write(name, bytes));
    return scene ? "read as " + scene->report.format : scene.error().sentence();
}

TEST(ReadWorld, chooses_the_reader_by_the_file_extension) {
    EXPECT_EQ(sentence_for("a.map", test::entity("worldspawn", {}, test::box_brush(0, 0, 0, 64, 64, 64))),
              "read as map");
    EXPECT_EQ(sentence_for("A.MAP", test::entity("worldspawn", {}, test::box_brush(0, 0, 0, 64, 64, 64))),
              "read as map");
    EXPECT_EQ(sentence_for("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "read as obj");
    EXPECT_EQ(
        sentence_for("a.txt", "hello"),
        "a.txt: Handrail reads .map, .ifc, .ifczip, .osm, .imdf.zip, .rooms, .obj, .glb, .gltf, .ply and .stl files. "
        "The name of this file ends differently.");
}

TEST(ReadWorld, recognises_files_of_other_kinds_and_gives_advice) {
    EXPECT_THAT(sentence_for("a.map", "version https://git-lfs.github.com/spec/v1\noid sha256:00\n"),
                HasSubstr("git lfs pull"));
    EXPECT_THAT(sentence_for("a.map", std::string("\x1D\0\0\0rest", 8)), HasSubstr("compiled Quake level"));
    EXPECT_THAT(sentence_for("a.bsp", "IBSP...."), HasSubstr("compiled game level"));
    EXPECT_THAT(sentence_for("a.map", std::string("\x66\x66\x0E\x40RMF....", 11)), HasSubstr("export it as a .map"));
    EXPECT_THAT(sentence_for("pak0.pak", "PACK...."), HasSubstr("Unpack it"));
    EXPECT_THAT(sentence_for("a.ifc", "ISO-10303-21;"), HasSubstr("cut short"));
    EXPECT_EQ(sentence_for("a.map", ""), "a.map: This file is empty.");
}

// Returns faces with the greatest number of corners that the reader accepts. Cutting them into triangles takes half a
// minute.
std::string endless_faces() {
    constexpr int kCorners = 4096, kFaces = 1000;
    std::string text, face = "f";
    for (int i = 0; i < kCorners; ++i) {
        const double turn = 2.0 * kPi * i / kCorners, out_m = 100.0 + (i % 2 == 0 ? 10.0 : 0.0);
        text += fmt::format("v {} {} 0\n", out_m * std::cos(turn), out_m * std::sin(turn));
        face += fmt::format(" {}", i + 1);
    }
    for (int i = 0; i < kFaces; ++i) text += face + "\n";
    return text;
}

TEST(ReadWorld, can_be_cancelled_while_a_face_is_cut) {
    std::stop_source stop;
    const std::string bytes = endless_faces();
    std::atomic<bool> begun{false};
    auto reading = std::async(std::launch::async, [&] {
        ReadOptions options;
        options.stop = stop.get_token();
        begun = true;
        return read_obj(bytes, "endless.obj", options);
    });
    while (!begun) std::this_thread::yield();
    EXPECT_EQ(reading.wait_for(std::chrono::milliseconds(200)), std::future_status::timeout) << "it is long";
    stop.request_stop();
    ASSERT_EQ(reading.wait_for(std::chrono::duration<double>(test::kPatience_s)), std::future_status::ready);
    EXPECT_THAT(reading.get().error().sentence(), HasSubstr("was cancelled"));
}

TEST(ReadWorld, can_be_cancelled_at_each_step_of_a_map) {
    std::string brushes;
    for (int x = 0; x < 20; ++x)
        for (int y = 0; y < 20; ++y) brushes += test::box_brush(64 * x, 64 * y, 0, 64 * x + 80, 64 * y + 48, 64);
    const std::string map = test::entity("worldspawn", {}, brushes);
    std::set<double> steps;
    ReadOptions options;
    options.progress = [&](double fraction) { steps.insert(fraction); };
    ASSERT_TRUE(read_quake_map(map, "a.map", options));
    steps.erase(1.0);
    steps.erase(0.9);  // after this step, the reader no longer checks for a cancellation
    ASSERT_GE(steps.size(), 2U);
    for (const double step : steps) {
        std::stop_source stop;
        ReadOptions stopped;
        stopped.stop = stop.get_token();
        double reached = 0.0;
        stopped.progress = [&](double fraction) {
            reached = fraction;
            if (fraction == step) stop.request_stop();
        };
        const Result<Scene> scene = read_quake_map(map, "a.map", stopped);
        ASSERT_FALSE(scene) << step;
        EXPECT_THAT(scene.error().sentence(), HasSubstr("was cancelled"));
        EXPECT_LE(reached, 0.5) << "the steps after " << step << " are not begun";
    }
}

TEST(ReadWorld, gives_the_reason_if_a_file_cannot_be_read) {
    const test::TemporaryFolder folder;
    const Result<Scene> missing = read_world(folder.path() / "none.map");
    ASSERT_FALSE(missing.has_value());
    EXPECT_EQ(missing.error().sentence(), "none.map: This file cannot be opened: No such file or directory.");
    const Result<Scene> is_folder = read_world(folder.path());
    ASSERT_FALSE(is_folder.has_value());
    EXPECT_THAT(is_folder.error().sentence(), HasSubstr("This is a folder"));
}

}  // namespace read_world_test
}  // namespace handrail
