// Tests that a walker who follows the announced directions arrives. The walker only hears announcements, and walks by
// name to the rooms of whole buildings and back to where it began. Then the test compares the position of the walker's
// feet with the rooms.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <random>
#include <sstream>
#include <string>

#include "tests/support/every.h"
#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "tests/support/word_walker.h"
#include "tests/unit/core/app_session.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace words_alone_test {

using test::WordWalker;

// What the judge of the walks knows about the world. The walker does not know any of it.
class Judge {
public:
    explicit Judge(const Scene& scene) : scene_(scene) {
        const WalkerSize size = walker_size(scene, 0.25);
        auto made = Navigation::make(scene, walker_measures(scene, size.radius_m, size.height_m, size.step_up_m));
        if (!made) return;
        ways_ = *made;
        graph_ = make_rooms(scene, ways_->space());
    }
    const std::vector<Room>& rooms() const { return graph_.rooms; }
    std::uint32_t room(const Vec3& at_m) const { return ways_ ? room_at(graph_, ways_->space(), at_m) : kNothing; }
    Route way(const Vec3& from_m, std::uint32_t to) const { return ways_->plan(from_m, graph_.rooms[to].middle_m); }
    // Returns true if the feet are in a room with that name. Pieces of one street may have the same name.
    bool in_room_named(const Vec3& feet_m, const std::string& name) const {
        for (std::uint32_t i = 0; i < graph_.rooms.size(); ++i)
            if (graph_.rooms[i].name == name && in_room(feet_m, i)) return true;
        return false;
    }

private:
    // Returns true if the feet are inside the outline that the file states for the room. If the file states no outline,
    // returns true if the feet are on the room's floor. In a room too narrow to stand inside, such as the end of a
    // footway at stairs, the feet must be at its middle.
    bool in_room(const Vec3& feet_m, std::uint32_t room_index) const {
        constexpr double kAtMiddle_m = 0.2;
        if (glm::length(feet_m - graph_.rooms[room_index].middle_m) < kAtMiddle_m) return true;
        if (scene_.stated)
            for (const StatedRoom& stated : scene_.stated->rooms)
                if (holds(stated, graph_.rooms[room_index].middle_m)) return holds(stated, feet_m);
        return room(feet_m) == room_index;
    }

    const Scene& scene_;
    std::shared_ptr<Navigation> ways_;
    RoomGraph graph_;
};

struct Row {
    int named = 0, connected = 0, walks = 0, reached = 0, falsely = 0, loops = 0;
    std::vector<std::string> missed, no_route;
};

const char* end_word(WordWalker::End end) {
    switch (end) {
        case WordWalker::End::Arrived:
            return "told that it is there";
        case WordWalker::End::NoRoute:
            return "no way";
        case WordWalker::End::Loop:
            return "for ever";
        case WordWalker::End::Stuck:
            return "stuck";
        case WordWalker::End::NotUnderstood:
            return "not understood";
    }
    return "";
}

// The rooms that the test tries in a building with more rooms. It draws them at random, because a building of 400 rooms
// would take an hour.
struct Draw {
    std::size_t most = 100;
    std::uint32_t seed = 20261129;
};

std::vector<std::uint32_t> drawn(std::vector<std::uint32_t> rooms, const Draw& draw) {
    if (rooms.size() <= draw.most) return rooms;
    std::mt19937 random(draw.seed);
    for (std::size_t i = 0; i < draw.most; ++i) std::swap(rooms[i], rooms[i + random() % (rooms.size() - i)]);
    fmt::print("  {} of {} rooms, drawn by seed {}\n", draw.most, rooms.size(), draw.seed);
    rooms.resize(draw.most);
    std::sort(rooms.begin(), rooms.end());
    return rooms;
}

// Returns true if the environment variable HANDRAIL_WALK_TO names this room, or is not set. It has names with |
// between.
bool chosen(const std::string& room) {
    const char* const rooms = std::getenv("HANDRAIL_WALK_TO");
    return !rooms || fmt::format("|{}|", rooms).find(fmt::format("|{}|", room)) != std::string::npos;
}

// Returns the place that the environment variable HANDRAIL_WALK_FROM names as "X Y Z" in metres, if it is set. Walks to
// rooms then begin there, to try again where an earlier walk failed.
std::optional<Vec3> chosen_start() {
    const char* const place = std::getenv("HANDRAIL_WALK_FROM");
    Vec3 at_m(0.0);
    if (!place) return std::nullopt;
    std::istringstream(place) >> at_m.x >> at_m.y >> at_m.z;
    return at_m;
}

using Go = WordWalker::End (WordWalker::*)(const std::string& room);

// Walks from the start to the rooms that the file names, and back. `every` is the stride between the tried rooms.
Row walk_all(const std::shared_ptr<const Scene>& world, std::uint32_t every, const Draw& draw, Go go) {
    Row row;
    const Judge judge(*world);
    WordWalker walker(world);
    const Vec3 start_m = walker.feet_m();
    const std::uint32_t start = judge.room(start_m);
    const auto walk = [&](std::uint32_t from, std::uint32_t to) {
        ++row.walks;
        const std::string name = sentence_case(judge.rooms()[to].name);
        const WordWalker::End end = (walker.*go)(name);
        const bool there =
            end == WordWalker::End::Arrived && judge.in_room_named(walker.feet_m(), judge.rooms()[to].name);
        row.reached += there ? 1 : 0;
        row.falsely += end == WordWalker::End::Arrived && !there ? 1 : 0;
        row.loops += end == WordWalker::End::Loop ? 1 : 0;
        if (there) return true;
        const Vec3 at_m = walker.feet_m();
        row.missed.push_back(fmt::format("{} to {}: {} at {:.2f} {:.2f} {:.2f}",
                                         from == kNothing ? "start" : judge.rooms()[from].name, name, end_word(end),
                                         at_m.x, at_m.y, at_m.z));
        if (std::getenv("HANDRAIL_ALL_ROUTES"))
            fmt::print("  {}\n{}", row.missed.back(), walker.last_lines(std::getenv("HANDRAIL_WALK_TO") ? 80 : 12));
        return false;
    };
    std::vector<std::uint32_t> connected;
    for (std::uint32_t room = 0; room < judge.rooms().size(); ++room) {
        if (judge.rooms()[room].map_name.empty() || room == start) continue;
        ++row.named;
        if (const Route way = judge.way(start_m, room); !way.reaches) {
            row.no_route.push_back(
                fmt::format("{}, {:.1f} m beyond where one comes", judge.rooms()[room].name, way.short_of_m));
            continue;
        }
        if (row.connected++ % every == 0) connected.push_back(room);
    }
    for (const std::uint32_t room : drawn(std::move(connected), draw)) {
        if (!chosen(judge.rooms()[room].name)) continue;
        if (const auto from_m = chosen_start()) walker.put(*from_m);
        if (!walk(start, room)) walker.put(judge.rooms()[room].middle_m);
        if (start == kNothing || !walk(room, start)) walker.put(start_m);
    }
    return row;
}

// A bundled world, or a real one, which the test tries if it is present.
struct Walked {
    const char* file;
    bool real = false;
    // Stride between the tried rooms in an ordinary run; 0: none. With HANDRAIL_ALL_ROUTES, the test tries all rooms.
    std::uint32_t every = 1;
    int percent = 95;  // least percentage of the walks that must arrive
    Draw draw = {};
};

class WordsAlone : public testing::TestWithParam<Walked> {};

// Prints a row with these counts: named rooms with a floor, those among them with a route, walks, arrivals, false
// arrivals, loops.
void expect_arrivals(const Walked& walked, Go go) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "takes minutes under a sanitizer";
    std::filesystem::path file = test::project_root() / "worlds" / "maps" / walked.file;
    if (walked.real) {
        const auto present = test::real_world(walked.file);
        if (!present) GTEST_SKIP() << test::needs_real_world(walked.file);
        file = *present;
    }
    const std::uint32_t every = test::every(walked.every, walked.every);
    if (every == 0) GTEST_SKIP() << "takes minutes; set HANDRAIL_ALL_ROUTES";
    const Row row = walk_all(test::world_once(file), every, walked.draw, go);
    fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", walked.file, row.named, row.connected, row.walks, row.reached,
               row.falsely, row.loops);
    for (const std::string& missed : row.missed) fmt::print("  missed: {}\n", missed);
    for (const std::string& room : row.no_route) fmt::print("  no way: {}\n", room);
    if (row.connected == 0 && walked.real) GTEST_SKIP() << "no room with a name has a way";
    EXPECT_GT(row.walks, 0);
    EXPECT_EQ(row.falsely, 0);
    EXPECT_EQ(row.loops, 0);
    EXPECT_TRUE(test::enough(row.reached, row.walks, walked.percent)) << row.reached << " of " << row.walks;
}

TEST_P(WordsAlone, lead_to_each_named_room_and_back) { expect_arrivals(GetParam(), &WordWalker::go); }

TEST_P(WordsAlone, lead_there_and_back_when_all_legs_are_heard_before_the_first_step) {
    expect_arrivals(GetParam(), &WordWalker::go_by_rest);
}

std::string file_name(const testing::TestParamInfo<Walked>& info) {
    std::string name = info.param.file;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(
    In, WordsAlone,
    testing::Values(Walked{"house.map"}, Walked{"school.map", false, 12}, Walked{"fzk-haus.ifc", true},
                    Walked{"institute.ifczip", true, 0}, Walked{"duplex-apartment.ifc", true, 15},
                    Walked{"smiley-west.ifc", true, 24}, Walked{"minimal.imdf.zip", true},
                    Walked{"delft-station.osm", true, 0}, Walked{"frankfurt-hauptwache.osm", true, 0},
                    Walked{"aachen-university.osm", true, 0}, Walked{"cologne-central.osm", true, 0},
                    Walked{"apb-tu-dresden.osm", true, 0}, Walked{"addenbrookes.imdf.zip", true, 0},
                    Walked{"london-waterloo.osm.pbf", true, 0}, Walked{"large-building.ifc", true, 0}),
    file_name);

class WordsByVoice : public testing::TestWithParam<Walked> {};

TEST_P(WordsByVoice, lead_to_each_named_room_and_back) { expect_arrivals(GetParam(), &WordWalker::go_by_voice); }

INSTANTIATE_TEST_SUITE_P(In, WordsByVoice,
                         testing::Values(Walked{"house.map", false, 4}, Walked{"school.map", false, 0},
                                         Walked{"duplex-apartment.ifc", true, 0}, Walked{"delft-station.osm", true, 0},
                                         Walked{"apb-tu-dresden.osm", true, 0, 95, {20, 1}}),
                         file_name);

}  // namespace words_alone_test
}  // namespace handrail
