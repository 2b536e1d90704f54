// Tests lines that a person types to the program, in virtual time.
#include "app/main/program_lines.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/clock.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace program_lines_test {

// A session that receives typed lines. Each tick is a frame of the program.
struct Typed {
    explicit Typed(std::shared_ptr<const Scene> world, bool by_person = false) : lines{app, worlds, by_person} {
        arguments.common.data_in = folder.path();
        if (world) app.apply(WorldEntered{make_ready(std::move(world))}, 0.0);
    }
    void run(double seconds) {
        for (const double until = now + seconds; now < until && !lines.left(); now += 1.0 / 60.0) {
            lines.take(now, nullptr);
            app.tick(now, {});
            for (const CueRequest& cue : app.take_cues())
                if (cue.kind == CueRequestKind::Say) said += cue.text + "\n";
        }
    }
    bool heard(const std::string& text) const { return said.find(text) != std::string::npos; }

    test::TemporaryFolder folder;
    ExploreArguments arguments;
    VirtualClock clock;
    std::string said;
    SessionVoice say{clock, [this](std::string text, double) { said += text + "\n"; }};
    Session app{Settings{}, {}};
    SettingsStore settings;
    WorldVisits worlds{arguments, settings, app, say};
    ProgramLines lines;
    double now = 0.0;
};

TEST(ProgramLines, quit_a_world_without_a_floor_once_the_fall_has_ended) {
    auto sheet = std::make_shared<Scene>();
    sheet->materials.emplace_back();
    sheet->triangles.push_back({{0, 0, 0}, {4, 0, 0}, {0, 0, 3}});
    sheet->bounds_m = {{0, 0, 0}, {4, 0, 3}};
    sheet->starts.emplace_back().feet_m = {2, -1, 0};
    Typed typed(sheet);
    typed.lines.lines().add("quit");
    typed.run(9.0);
    EXPECT_TRUE(typed.lines.left());
}

TEST(ProgramLines, quit_only_after_earlier_commands_are_done) {
    const auto house = read_world(test::bundled_world("house.map"));
    ASSERT_TRUE(house);
    Typed typed(std::make_shared<const Scene>(*house));
    typed.run(0.5);
    const Vec3 begun_m = typed.app.feet_m();
    typed.lines.lines().add("forward 3");
    typed.lines.lines().add("quit");
    typed.run(20.0);
    EXPECT_TRUE(typed.lines.left());
    EXPECT_NEAR(glm::length(typed.app.feet_m() - begun_m), 2.1, 0.05);
}

TEST(ProgramLines, quit_during_the_first_loading_if_typed_but_wait_for_it_in_a_script) {
    Typed person(nullptr, true), script(nullptr, false);
    for (Typed* typed : {&person, &script}) {
        typed->lines.lines().add("quit");
        typed->run(1.0);
    }
    EXPECT_TRUE(person.lines.left());
    EXPECT_FALSE(script.lines.left());
    EXPECT_EQ(script.lines.lines().waiting(), 1U);
}

TEST(ProgramLines, of_a_person_are_performed_while_another_world_is_being_read) {
    const auto house = read_world(test::bundled_world("house.map"));
    ASSERT_TRUE(house);
    for (const bool by_person : {true, false}) {
        Typed typed(std::make_shared<const Scene>(*house), by_person);
        typed.run(0.5);
        const Vec3 begun_m = typed.app.feet_m();
        // `typed.worlds` reports that it is reading the world until somebody queries whether the world is ready.
        typed.app.requests().world = WorldRequest{test::bundled_world("school.map")};
        typed.worlds.change(typed.now);
        ASSERT_TRUE(typed.worlds.reading());
        typed.lines.lines().add("forward 3");
        typed.run(10.0);
        EXPECT_EQ(glm::length(typed.app.feet_m() - begun_m) > 1.0, by_person);
    }
}

// The house has a room called Kitchen, and a thing whose name begins with "Kitchen".
TEST(ProgramLines, find_a_room_with_the_exact_name_before_things_whose_names_begin_with_it) {
    const auto house = read_world(test::bundled_world("house.map"));
    ASSERT_TRUE(house);
    for (const auto& [line, answer] :
         {std::pair("where is the kitchen", "Kitchen: "), std::pair("where is the kitchen counter", "Kitchen counter"),
          std::pair("where is the piano", "Piano")}) {
        Typed typed(std::make_shared<const Scene>(*house));
        typed.run(0.5);
        typed.lines.lines().add(line);
        typed.run(3.0);
        EXPECT_TRUE(typed.heard(answer)) << line << ": " << typed.said;
        EXPECT_EQ(typed.heard("Kitchen counter"), std::string(answer) == "Kitchen counter")
            << line << ": " << typed.said;
    }
}

}  // namespace program_lines_test
}  // namespace handrail
