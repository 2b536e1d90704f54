// Tests files that a separate process reads, and the cache of its results.
#include "app/import/import_world.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "app/import/kept_scene.h"
#include "app/import/requested_files.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/ifc/ifc_text.h"
#include "worlds/base/files.h"
#include "worlds/confine/confine.h"
#include "worlds/navigation/navigation.h"
#include "worlds/stored/stored_navigation.h"
#include "worlds/stored/stored_scene.h"

namespace handrail {
namespace import_world_test {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Returns a bundled model, enlarged with furniture without geometry until it is large enough for the cache.
std::string large_house() {
    std::string more;
    for (int i = 0; i < 1200; ++i)
        more += fmt::format("#{}=IFCFURNISHINGELEMENT('{}',$,'a chair of no shape',$,$,$,$,$);\n", 200'000 + i, i);
    return test::with_instances(test::small_house(), more);
}

std::vector<fs::path> kept_in(const fs::path& cache) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(cache)) files.push_back(entry.path());
    return files;
}

TEST(ImportedWorld, is_bit_identical_whether_read_in_this_process_or_from_the_cache) {
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("house.ifc", large_house()), cache = folder.path() / "cache";
    ASSERT_GE(fs::file_size(path), kLeastKept_bytes);
    const Result<Scene> here = read_world(path);
    ASSERT_TRUE(here.has_value()) << here.error().sentence();
    const ImportHow how{Cache(cache), find_reader_program(), {}};
    ASSERT_FALSE(how.program.empty());
    for (const bool again : {false, true}) {
        const Result<ImportedWorld> world = import_world(path, {}, how);
        ASSERT_TRUE(world.has_value()) << world.error().sentence();
        EXPECT_EQ(world->kept, again);
        EXPECT_FALSE(world->kept_damaged);
        EXPECT_EQ(stored::stored(world->scene), stored::stored(*here));
        EXPECT_EQ(kept_in(cache).size(), 1U);
    }
}

TEST(ImportedWorld, of_a_map_is_cached_if_reading_it_takes_long) {
    const test::TemporaryFolder folder;
    const std::string house = read_whole_file(test::bundled_world("house.map")).value();
    std::string large = house;
    while (large.size() < kLeastKeptMap_bytes) large += "// " + std::string(1000, '-') + "\n";
    const ImportHow how{Cache(folder.path() / "cache"), find_reader_program(), {}};
    const Result<Scene> here = read_world(folder.write("large.map", large));
    ASSERT_TRUE(here.has_value());
    for (const auto& [name, text] : {std::pair("small.map", house), std::pair("large.map", large)})
        for (const bool again : {false, true}) {
            const Result<ImportedWorld> world = import_world(folder.write(name, text), {}, how);
            ASSERT_TRUE(world.has_value()) << world.error().sentence();
            EXPECT_EQ(world->kept, again && text.size() > house.size()) << name;
            if (text.size() > house.size()) {
                EXPECT_EQ(stored::stored(world->scene), stored::stored(*here));
            }
        }
}

TEST(ImportedWorld, is_read_again_if_any_of_its_sources_has_changed) {
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("house.ifc", large_house());
    const ImportHow how{Cache(folder.path() / "cache"), find_reader_program(), {}};
    const auto is_kept = [&](const ReadOptions& options = {}) {
        const Result<ImportedWorld> world = import_world(path, options, how);
        EXPECT_TRUE(world.has_value());
        return world && world->kept;
    };
    EXPECT_FALSE(is_kept());
    EXPECT_TRUE(is_kept());
    ReadOptions other;
    other.guess_materials = false;
    EXPECT_FALSE(is_kept(other));
    EXPECT_TRUE(is_kept(other));
    EXPECT_TRUE(is_kept()) << "each is kept";
    folder.write("house.ifc", test::replaced(large_house(), "a chair of no shape", "a table of no shape"));
    EXPECT_FALSE(is_kept());
    EXPECT_TRUE(is_kept());
    ASSERT_TRUE(speak_language("de").has_value());
    EXPECT_FALSE(is_kept());
    ASSERT_TRUE(speak_language("en").has_value());
}

// Returns a glTF file with a triangle. The triangle's three points are in a separate file with the name `buffer`.
std::string ramp_gltf(const std::string& buffer) {
    return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"name":"Ramp"}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
        "bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"uri":")" +
           buffer + R"(","byteLength":36}]})";
}
std::string ramp_bytes(float far) {
    const float points[9] = {0, 0, 0, far, 0, 0, 0, 1, 4};
    return {reinterpret_cast<const char*>(points), sizeof points};
}

TEST(ImportedWorld, depends_on_the_files_that_it_references_too) {
    const test::TemporaryFolder folder;
    const auto write_bin = [&](float far) { folder.write("ramp.bin", ramp_bytes(far)); };
    write_bin(4.0F);
    // Blanks make the file large enough for the cache.
    const fs::path path = folder.write("ramp.gltf", ramp_gltf("ramp.bin") + std::string(kLeastKept_bytes, ' '));
    const ImportHow how{Cache(folder.path() / "cache"), find_reader_program(), {}};
    for (const bool again : {false, true}) {
        const Result<ImportedWorld> world = import_world(path, {}, how);
        ASSERT_TRUE(world.has_value()) << world.error().sentence();
        EXPECT_EQ(world->kept, again);
        EXPECT_NEAR(world->scene.bounds_m.size_m().x, 4.0, 1e-6);
    }
    write_bin(5.0F);
    const Result<ImportedWorld> world = import_world(path, {}, how);
    ASSERT_TRUE(world.has_value()) << world.error().sentence();
    EXPECT_FALSE(world->kept);
    EXPECT_NEAR(world->scene.bounds_m.size_m().x, 5.0, 1e-6);
}

TEST(ImportedWorld, is_read_again_if_its_cache_entry_is_damaged) {
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("house.ifc", large_house());
    const ImportHow how{Cache(folder.path() / "cache"), find_reader_program(), {}};
    const Result<ImportedWorld> first = import_world(path, {}, how);
    ASSERT_TRUE(first.has_value()) << first.error().sentence();
    const std::string bytes = stored::stored(first->scene);
    const fs::path kept = kept_in(folder.path() / "cache").front();
    const std::string whole = test::content_of(kept);
    std::string changed = whole;
    changed[whole.size() / 2] = static_cast<char>(changed[whole.size() / 2] ^ 1);
    for (const std::string& damaged : {whole.substr(0, whole.size() / 2), changed, std::string()}) {
        std::ofstream(kept, std::ios::binary) << damaged;
        const Result<ImportedWorld> anew = import_world(path, {}, how);
        ASSERT_TRUE(anew.has_value()) << anew.error().sentence();
        EXPECT_TRUE(anew->kept_damaged);
        EXPECT_FALSE(anew->kept);
        EXPECT_EQ(stored::stored(anew->scene), bytes);
        EXPECT_EQ(test::content_of(kept), whole) << "mended";
    }
}

// Until November 2026, the program wrote the cache next to the file, and the cache's header named the source file. Such
// a cache must not be used.
TEST(ImportedWorld, uses_no_cache_entry_of_another_world_and_none_next_to_the_file) {
    const test::TemporaryFolder folder;
    const std::string another = test::replaced(large_house(), "a chair of no shape", "a table of no shape");
    const fs::path path = folder.write("house.ifc", large_house()), other = folder.write("other.ifc", another);
    const fs::path cache = folder.path() / "cache", diary = folder.write("diary", "mine");
    const ImportHow how{Cache(cache), find_reader_program(), {}};
    ASSERT_TRUE(import_world(other, {}, how).has_value());
    const fs::path of_other = kept_in(cache).front();
    const Result<ImportedWorld> first = import_world(path, {}, how);
    ASSERT_TRUE(first.has_value()) << first.error().sentence();
    for (const fs::path& kept : kept_in(cache))
        if (kept != of_other) fs::copy_file(of_other, kept, fs::copy_options::overwrite_existing);
    fs::copy_file(of_other, folder.path() / "house.ifc.handrail.scene");
    fs::create_symlink("diary", folder.path() / "other.ifc.handrail.scene");
    const Result<ImportedWorld> again = import_world(path, {}, how);
    ASSERT_TRUE(again.has_value()) << again.error().sentence();
    EXPECT_TRUE(again->kept_damaged);
    EXPECT_FALSE(again->kept);
    EXPECT_EQ(stored::stored(again->scene), stored::stored(first->scene));
    EXPECT_EQ(test::content_of(folder.path() / "house.ifc.handrail.scene"), test::content_of(of_other));
    EXPECT_EQ(test::content_of(diary), "mine");
    fs::remove_all(cache);
    ASSERT_TRUE(import_world(other, {}, how).has_value());
    EXPECT_EQ(test::content_of(diary), "mine");
}

TEST(KeptScene, cut_at_every_byte_is_reported_as_damaged) {
    const Result<Scene> scene = read_ifc(test::small_house(), "house.ifc");
    ASSERT_TRUE(scene.has_value());
    Scene small = *scene;  // keeps only a few solids, so that the test can cut the scene at every byte
    small.solids.resize(3);
    small.surfaces.clear();
    const std::string bytes = stored::stored(small);
    const std::vector<NeighbourFile> beside{{"beside.bin", std::string(64, 'a')}};
    const std::string whole = kept_scene(beside, bytes);
    const auto good = [&](const std::vector<NeighbourFile>& read) { return read == beside; };
    for (std::size_t length = 0; length < whole.size(); ++length)
        ASSERT_FALSE(scene_in(std::string_view(whole).substr(0, length), good).has_value()) << length;
    const auto all = scene_in(whole, good);
    ASSERT_TRUE(all.has_value() && all->has_value());
    EXPECT_EQ(stored::stored(**all), bytes);
    EXPECT_FALSE(scene_in(whole + "x", good).has_value());
    const auto old = scene_in(whole, [](const std::vector<NeighbourFile>&) { return false; });
    ASSERT_TRUE(old.has_value());
    EXPECT_FALSE(old->has_value());
}

TEST(KeptRoutes, are_unpacked_only_by_the_reader_process) {
    const test::TemporaryFolder folder;
    const Result<Scene> scene = read_ifc(test::small_house(), "house.ifc");
    ASSERT_TRUE(scene.has_value());
    const WalkerMeasures body = walker_measures(*scene, 0.25, 1.8, 0.25);
    const Result<WalkSpace> space = make_walk_space(*scene, body);
    ASSERT_TRUE(space.has_value());
    const RoomGraph graph = make_rooms(*scene, *space);
    const std::string packed = stored_navigation(*space, graph), name = navigation_key(*scene, body) + ".ways";
    const Cache cache(folder.path() / "cache");
    const auto unpacked = [&](const std::string& called) {
        const Descriptor file = cache.open(name);
        return file.get() < 0 ? std::string("not kept")
                              : unpack_navigation_apart({file.get(), called}, find_reader_program());
    };
    EXPECT_EQ(unpacked(name), "not kept");
    cache.keep(name, packed);
    EXPECT_EQ(unpacked(name), unpacked_navigation(packed));
    EXPECT_TRUE(navigation_from(unpacked(name), body, *scene).has_value());
    EXPECT_EQ(unpacked("another.ways"), "");
    cache.keep(name, packed.substr(0, packed.size() / 2));
    EXPECT_EQ(unpacked(name), "");
    cache.keep(name, packed);
    const Descriptor file = cache.open(name);
    EXPECT_EQ(unpack_navigation_apart({file.get(), name}, folder.path() / "no program"), "");
}

TEST(ImportedWorld, that_cannot_be_cached_is_read_all_the_same) {
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("house.ifc", large_house());
    const ImportHow how{Cache("/proc/no/such/folder"), find_reader_program(), {}};
    const Result<ImportedWorld> world = import_world(path, {}, how);
    ASSERT_TRUE(world.has_value()) << world.error().sentence();
    EXPECT_FALSE(world->kept);
}

TEST(ReaderProcess, reports_its_progress_and_its_current_stage) {
    const test::TemporaryFolder folder;
    std::vector<double> fractions;
    std::vector<std::string> stages;
    ReadOptions options;
    options.progress = [&](double fraction) { fractions.push_back(fraction); };
    options.stage = [&](std::string_view stage) { stages.emplace_back(stage); };
    const auto read = read_apart(folder.write("house.ifc", large_house()), options, find_reader_program());
    ASSERT_TRUE(read.has_value()) << read.error().sentence();
    EXPECT_GT(fractions.size(), 5U);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1.0);
    EXPECT_EQ(stages, (std::vector<std::string>{"import.file", "import.shapes", "import.surfaces"}));
    for (const std::string& stage : stages) EXPECT_NE(phrase(stage), stage);
}

TEST(ReaderProcess, passes_on_the_error_of_the_reader_with_its_line) {
    const test::TemporaryFolder folder;
    const std::string text = large_house();
    const fs::path path = folder.write("cut.ifc", text.substr(0, text.size() / 2));
    const auto apart = read_apart(path, {}, find_reader_program());
    const auto here = read_world(path);
    ASSERT_FALSE(apart.has_value());
    ASSERT_FALSE(here.has_value());
    EXPECT_EQ(apart.error().sentence(), here.error().sentence());
    EXPECT_GT(apart.error().line, 0);
    const auto missing = read_apart(folder.path() / "none.ifc", {}, find_reader_program());
    ASSERT_FALSE(missing.has_value());
    EXPECT_THAT(missing.error().sentence(), HasSubstr("none.ifc"));
}

// Returns a shell script that replaces the reader.
fs::path stand_in(const test::TemporaryFolder& folder, const std::string& script) {
    const fs::path program = folder.write("reader.sh", "#!/bin/sh\n" + script + "\n");
    fs::permissions(program, fs::perms::owner_all);
    return program;
}

TEST(ReaderProcess, gives_one_sentence_for_every_way_to_end) {
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("house.ifc", test::small_house());
    const auto reported = [&](const std::string& script) {
        const auto read = read_apart(path, {}, stand_in(folder, script), {2'000'000'000, 7, 0.5});
        return read ? std::string("a world") : read.error().sentence();
    };
    EXPECT_THAT(reported("kill -SEGV $$"), HasSubstr("failed: Segmentation fault"));
    EXPECT_THAT(reported("kill -ABRT $$"), HasSubstr("failed: Aborted"));
    EXPECT_THAT(reported("kill -XCPU $$"), HasSubstr("takes longer than 7 seconds"));
    EXPECT_THAT(reported("kill -KILL $$"), HasSubstr("more than 2 gigabytes"));
    EXPECT_THAT(reported("exit 3"), HasSubstr("more than 2 gigabytes"));
    EXPECT_THAT(reported("exit 4"), HasSubstr("too large"));
    EXPECT_THAT(reported("exit 77"), HasSubstr("exit status 77"));
    EXPECT_THAT(reported("exit 0"), HasSubstr("damaged"));
    EXPECT_THAT(reported("printf 'nonsense of a sort' >&3"), HasSubstr("damaged"));
    EXPECT_THAT(reported("printf 'p999999999999\\nsx\\n\\n\\0p' >&4; exit 77"), HasSubstr("exit status 77"));
    EXPECT_THAT(reported("sleep 60"), HasSubstr("takes longer than"));
    const auto none = read_apart(path, {}, folder.path() / "no program");
    ASSERT_FALSE(none.has_value());
    EXPECT_THAT(none.error().sentence(), HasSubstr("cannot be started"));
}

TEST(ReaderProcess, is_not_timed_out_while_it_works) {
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("house.ifc", test::small_house());
    // The reader computes without a pause for four times as long as an idle process may run.
    const std::string works = "end=$(($(date +%s) + 8)); while [ $(date +%s) -lt $end ]; do :; done; exit 77";
    const auto read = read_apart(path, {}, stand_in(folder, works), {2'000'000'000, 50, 2.0});
    ASSERT_FALSE(read.has_value());
    EXPECT_THAT(read.error().sentence(), HasSubstr("exit status 77"));
}

TEST(ReaderProcess, has_limited_memory) {
#if defined(HANDRAIL_SANITIZED)
    GTEST_SKIP() << "sanitizers need all the address space there is";
#endif
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("house.ifc", large_house());
    const auto little = read_apart(path, {}, find_reader_program(), {30'000'000, 60, 60.0});
    ASSERT_FALSE(little.has_value());
    std::string text = test::small_house(), more;
    for (int i = 0; i < 60'000; ++i)
        more += fmt::format("#{}=IFCSPACE('x',$,'{}',$,$,#20,#21,'Room',.ELEMENT.,.INTERNAL.,$);\n", 300'000 + i, i);
    const fs::path bomb = folder.write("memory.ifc", test::with_instances(text, more));
    const auto much = read_apart(bomb, {}, find_reader_program(), {60'000'000, 60, 60.0});
    ASSERT_FALSE(much.has_value());
    EXPECT_THAT(much.error().sentence(), HasSubstr("gigabytes of memory"));
    fs::resize_file(bomb, 80'000'000);  // the file alone now exceeds the memory limit
    const auto larger = read_apart(bomb, {}, find_reader_program(), {60'000'000, 60, 60.0});
    ASSERT_FALSE(larger.has_value());
    EXPECT_THAT(larger.error().sentence(), HasSubstr("gigabytes of memory"));
}

TEST(ReaderProcess, ends_at_once_when_it_is_cancelled) {
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("house.ifc", test::small_house());
    std::stop_source stop;
    ReadOptions options;
    options.stop = stop.get_token();
    options.progress = [&](double) { stop.request_stop(); };
    const auto begun = std::chrono::steady_clock::now();
    const auto read = read_apart(
        path, options,
        stand_in(folder, fmt::format("echo $$ > {}/pid; echo p1 >&4; sleep 600 & wait", folder.path().string())));
    ASSERT_FALSE(read.has_value());
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(20));
    const pid_t process = std::stoi(test::content_of(folder.path() / "pid"));
    EXPECT_NE(::kill(process, 0), 0) << "it is gone and waited for";
}

// Examines the real reader process, which the test has paused in the middle of its work.
TEST(ReaderProcess, is_confined_and_has_no_environment) {
#if defined(HANDRAIL_SANITIZED)
    GTEST_SKIP() << "a sanitizer keeps its options";
#endif
    if (confinement_offered() == Confinement{}) GTEST_SKIP() << "this kernel cannot confine";
    ::setenv("SSH_AUTH_SOCK", "/run/user/agent", 1);
    const test::TemporaryFolder folder;
    std::string environment = "not read", status;
    ReadOptions options;
    options.stage = [&](std::string_view) {
        const std::string reader = test::content_of(fmt::format("/proc/self/task/{}/children", ::getpid()));
        const fs::path facts = fs::path("/proc") / std::to_string(std::stoi(reader));
        environment = test::content_of(facts / "environ");
        status = test::content_of(facts / "status");
    };
    ASSERT_TRUE(read_apart(folder.write("house.ifc", large_house()), options, find_reader_program()));
    ::unsetenv("SSH_AUTH_SOCK");
    EXPECT_EQ(environment, "");
    EXPECT_THAT(status, HasSubstr("NoNewPrivs:\t1"));
    EXPECT_EQ(status.find("Seccomp:\t2") != std::string::npos, confinement_offered().seccomp) << status;
}

TEST(ReaderProcess, receives_only_files_in_the_folder_of_the_world) {
    const test::TemporaryFolder outside, folder;
    const fs::path secret = outside.write("secret.bin", ramp_bytes(4.0F));
    fs::create_directories(folder.path() / "world" / "parts");
    folder.write("next_to_it.bin", ramp_bytes(4.0F));
    folder.write("world/ramp.bin", ramp_bytes(4.0F));
    folder.write("world/parts/ramp.bin", ramp_bytes(4.0F));
    fs::create_symlink(secret, folder.path() / "world" / "link.bin");
    fs::create_symlink(outside.path(), folder.path() / "world" / "linked");
    const auto read_naming = [&](const std::string& buffer) {
        return read_apart(folder.write("world/ramp.gltf", ramp_gltf(buffer)), {}, find_reader_program());
    };
    for (const char* own : {"ramp.bin", "parts/ramp.bin", "parts/../ramp.bin"}) {
        const auto read = read_naming(own);
        ASSERT_TRUE(read) << own << ": " << read.error().sentence();
    }
    for (const std::string& foreign :
         {secret.string(), std::string("/etc/passwd"), std::string("../next_to_it.bin"),
          std::string("parts/../../next_to_it.bin"), std::string("link.bin"), std::string("linked/secret.bin")}) {
        const auto read = read_naming(foreign);
        EXPECT_FALSE(read) << foreign;
    }
    const auto link = read_naming("link.bin");
    EXPECT_THAT(link.error().sentence(), HasSubstr("link"));
}

TEST(RequestedFiles, of_a_compromised_reader_are_opened_only_in_the_folder_of_the_world) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder.path() / "world");
    const fs::path world = folder.write("world/house.map", "the world");
    folder.write("world/picture.png", "a picture");
    folder.write("secret", "of the person");
    fs::create_symlink(folder.path() / "secret", folder.path() / "world" / "link");
    std::array<int, 2> ends{-1, -1};
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()), 0);
    const Descriptor program(ends[0]);
    Descriptor reader(ends[1]);
    std::thread serves([&] {
        while (answer_request(program.get(), world)) {
        }
    });
    const auto content = [](const Result<OpenFile>& file) {
        return file ? read_whole_file(*file, 100, {}).value() : file.error().sentence();
    };
    EXPECT_EQ(content(request_world(reader.get())), "the world");
    EXPECT_EQ(content(request_next_to(reader.get(), "picture.png")), "a picture");
    for (const std::string& name :
         {std::string(), std::string("."), std::string(".."), std::string("../secret"), std::string("./.././secret"),
          std::string("link"), std::string("/etc/passwd"), (folder.path() / "secret").string(),
          std::string("picture.png\0/../../secret", 25), std::string(4095, 'x'), std::string(5000, 'x'),
          std::string("/proc/self/environ")}) {
        const Result<OpenFile> file = request_next_to(reader.get(), name);
        EXPECT_FALSE(file) << name;
    }
    EXPECT_EQ(content(request_next_to(reader.get(), "picture.png")), "a picture") << "and it goes on";
    reader = Descriptor(-1);
    serves.join();
}

// The reader requests files but never fetches the answers. This must not block the program.
TEST(RequestedFiles, never_block_the_program_if_a_reader_fetches_no_answer) {
    const test::TemporaryFolder folder;
    const fs::path world = folder.write("house.map", "the world");
    std::array<int, 2> ends{-1, -1};
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()), 0);
    const Descriptor program(ends[0]), reader(ends[1]);
    bool goes_on = true;
    for (int i = 0; i < 100'000 && goes_on; ++i) {
        ASSERT_EQ(::send(reader.get(), "w", 1, MSG_DONTWAIT), 1);
        goes_on = answer_request(program.get(), world);
    }
    EXPECT_FALSE(goes_on);
}

// The program does not copy the file. So when the test truncates the file, it removes data that the reader has yet to
// read. If the reader finishes before the test pauses it, the test tries again.
TEST(ReaderProcess, reports_a_file_that_is_truncated_during_reading) {
    const test::TemporaryFolder folder;
    bool said = false;
    for (int attempt = 0; attempt < 50 && !said; ++attempt) {
        const fs::path path = folder.write("house.ifc", large_house());
        ReadOptions options;
        bool stopped = false;
        options.stage = [&](std::string_view) {
            if (std::exchange(stopped, true)) return;
            const std::string children = test::content_of(fmt::format("/proc/self/task/{}/children", ::getpid()));
            const auto reader = static_cast<pid_t>(std::stoi(children));
            ::kill(reader, SIGSTOP);
            fs::resize_file(path, 0);
            ::kill(reader, SIGCONT);
        };
        const auto read = read_apart(path, options, find_reader_program());
        ASSERT_TRUE(stopped);
        if (read) continue;
        EXPECT_THAT(read.error().sentence(), HasSubstr("cut short while it was being read"));
        said = true;
    }
    EXPECT_TRUE(said);
}

// Returns true if the process is gone, or if it has died and its parent has not yet waited for it.
bool is_dead(pid_t process) {
    const std::string stat = test::content_of(fmt::format("/proc/{}/stat", process));
    const std::size_t after = stat.rfind(')');
    return after == std::string::npos || stat.substr(after + 2, 1) == "Z";
}

TEST(ReaderProcess, dies_with_the_program_even_if_that_is_killed) {
    const test::TemporaryFolder folder;
    const fs::path path = folder.write("house.ifc", large_house());
    const fs::path reported = folder.path() / "reader";
    const pid_t program = ::fork();
    ASSERT_GE(program, 0);
    if (program == 0) {
        ReadOptions options;
        // Pauses the reader in the middle of its work, so that the reader cannot end before the test kills the program.
        options.stage = [&](std::string_view) {
            const std::string children = test::content_of(fmt::format("/proc/self/task/{}/children", ::getpid()));
            ::kill(static_cast<pid_t>(std::stoi(children)), SIGSTOP);
            std::ofstream(reported.string() + ".new") << children;
            fs::rename(reported.string() + ".new", reported);
            ::pause();
        };
        (void)read_apart(path, options, find_reader_program());
        ::_exit(0);
    }
    ASSERT_TRUE(test::eventually([&] { return fs::exists(reported); }));
    const pid_t reader = std::stoi(test::content_of(reported));
    EXPECT_FALSE(is_dead(reader));
    ::kill(program, SIGKILL);
    EXPECT_TRUE(test::eventually([&] { return is_dead(reader); }));
    ::waitpid(program, nullptr, 0);
}

}  // namespace import_world_test
}  // namespace handrail
