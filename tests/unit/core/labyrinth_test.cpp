// Plays the bundled labyrinths by keys and ears. A player who follows the announcements finishes each one. The ball
// falls into holes, a plank covers one hole, the best time is stored, and the player can start again.
#include <filesystem>
#include <regex>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/app_session.h"
#include "worlds/scene/models.h"

namespace handrail {
namespace labyrinth_test {

using test::box_brush;
using test::entity;
using test::key;

struct Player : test::AppSession {
    explicit Player(const char* map, const SessionOptions& options = {}) : AppSession({}, {}, options) {
        app.apply(WorldEntered{make_ready(test::our_world(map))}, 0.0);
        run(0.1);
    }
    void taps(Command command, int times, double each_s = 1.0) {
        for (int i = 0; i < times; ++i) tap(command, each_s);
    }
    std::string stands() { return request(Command::Labyrinth); }
};

TEST(Labyrinth, first_level_can_be_finished_in_under_two_minutes_with_only_the_spoken_information) {
    Player player("labyrinth1.map");
    EXPECT_TRUE(player.heard("Labyrinth 1.")) << player.news();
    // The announcements name the keys that this player presses.
    const KeyMap keys_of({});
    for (const Command reported : {Command::Use, Command::Labyrinth, Command::PutBack})
        EXPECT_TRUE(player.heard(keys_of.keys_of(reported))) << keys_of.keys_of(reported) << ": " << player.news();
    player.tap(Command::Use, 0.5);
    ASSERT_TRUE(player.heard("Ball held"));
    const double began_s = player.now;
    const std::regex goal_part("The goal is ([^.]*(?:\\.5[^.]*)*)\\."),
        free_part("The ball can roll ([^.]*(?:\\.5[^.]*)*)\\."), piece("([0-9.]+) rolls? (north|east|south|west)");
    const std::map<std::string, Command> keys{{"north", Command::Forward},
                                              {"east", Command::TurnRight},
                                              {"south", Command::Back},
                                              {"west", Command::TurnLeft}};
    const auto sides = [&](const std::string& text) {
        std::map<std::string, double> found;
        for (std::sregex_iterator i(text.begin(), text.end(), piece), end; i != end; ++i)
            found[(*i)[2]] = std::stod((*i)[1]);
        return found;
    };
    // Rolls the ball towards the goal as far as it can go.
    while (!player.heard("Finished") && player.now - began_s < 120.0) {
        const std::string text = player.stands();
        std::smatch goal, free;
        ASSERT_TRUE(std::regex_search(text, goal, goal_part) && std::regex_search(text, free, free_part)) << text;
        const auto wanted = sides(goal[1]), can = sides(free[1]);
        std::string way;
        for (const auto& [side, rolls] : wanted)
            if (can.contains(side) && (way.empty() || can.at(side) > can.at(way))) way = side;
        ASSERT_FALSE(way.empty()) << text;
        player.taps(keys.at(way), std::max(1, static_cast<int>(std::min(can.at(way), wanted.at(way)))));
    }
    EXPECT_TRUE(player.heard("Finished in ")) << player.news();
    EXPECT_LT(player.now - began_s, 120.0);
}

TEST(Labyrinth, a_hole_swallows_the_ball_and_everything_returns_to_the_start) {
    Player player("labyrinth2.map");
    EXPECT_NE(player.stands().find("A hole is 1.5 rolls east."), std::string::npos) << player.news();
    player.tap(Command::Use, 0.5);
    player.tap(Command::TurnRight, 1.0);
    player.hold(Command::TurnRight, 0.05);
    const auto heard_at_s = [&](const char* text) {
        for (int frame = 0; frame < 240 && !player.heard(text); ++frame) player.run(1.0 / 60.0);
        EXPECT_TRUE(player.heard(text)) << text;
        return player.now;
    };
    const double fell_s = heard_at_s("The ball fell into the hole.");
    EXPECT_NEAR(heard_at_s("Back at the start.") - fell_s, 1.0, 0.1) << "time to hear that the ball fell";
    player.run(1.0);
    EXPECT_FALSE(player.heard("Finished"));
    const std::string news = player.news();
    EXPECT_EQ(news.find("Ball moved.", news.find("The ball fell into the hole.")), std::string::npos) << news;
    const Vec3 ball = player.app.thing_at("Ball").value_or(Placement{}).position_m;
    EXPECT_NEAR(ball.x, 1.25, 1e-3);
    EXPECT_NEAR(ball.z, 0.55, 2e-3);
}

TEST(Labyrinth, a_hole_hums_faster_when_the_ball_is_nearer_and_is_heard_swallowing_it) {
    Player player("labyrinth2.map");
    player.run(1.0);
    const auto hum = [&] {
        const auto last = std::find_if(player.world_sounds.rbegin(), player.world_sounds.rend(),
                                       [](const CueRequest& cue) { return cue.sound == SoundKind::Hum; });
        return last == player.world_sounds.rend() ? CueRequest{} : *last;
    };
    const double far = hum().pulses_per_s;
    EXPECT_GE(far, 2.0);
    player.tap(Command::Use, 0.5);
    player.tap(Command::TurnRight, 0.3);
    EXPECT_GT(hum().pulses_per_s, far + 0.5);
    EXPECT_LE(hum().pulses_per_s, 10.0);
    player.taps(Command::TurnRight, 2);
    player.run(2.0);
    EXPECT_NE(std::find(player.sounds.begin(), player.sounds.end(), SoundKind::Falls), player.sounds.end());
    EXPECT_NEAR(hum().pulses_per_s, far, 1e-9) << "back at the start";
    player.taps(Command::SideLeft, 1);
    player.tap(Command::Use, 0.5);
    player.taps(Command::TiltUp, 1);
    player.taps(Command::TurnRight, 3);
    player.taps(Command::TiltDown, 1);
    EXPECT_NE(std::find(player.sounds.begin(), player.sounds.end(), SoundKind::Knock), player.sounds.end());
    EXPECT_EQ(hum().loudness, 0.0) << "a covered hole is silent";
}

TEST(Labyrinth, corridors_are_listed_with_their_contents_and_destinations) {
    Player player("labyrinth2.map");
    player.tap(Command::Overview, 0.5);
    EXPECT_TRUE(player.heard(
        "3 corridors. Corridor 1, running west to east, 7.5 rolls long, Plank after 1 roll, Ball after 2.5 "
        "rolls, hole after 4 rolls, corridor 2 to the north after 7 rolls, 1 of 3"))
        << player.news();
    for (int i = 0; i < 2; ++i) {
        player.app.apply(KeyTapped{"Down"}, player.now);
        player.run(0.1);
    }
    EXPECT_TRUE(
        player.heard("Corridor 2, running south to north, 3 rolls long, corridor 1 to the south at the beginning, "
                     "corridor 3 to the north at the end"));
    EXPECT_TRUE(
        player.heard("Corridor 3, running west to east, 7.5 rolls long, goal at the beginning, corridor 2 to the south "
                     "after 7 rolls"));
}

TEST(Labyrinth, corridors_are_listed_even_after_the_ball_was_rolled_against_a_wall) {
    for (const char* world : {"labyrinth1.map", "labyrinth2.map"}) {
        Player player(world);
        player.tap(Command::Use, 0.5);
        player.taps(Command::Forward, 3);
        player.taps(Command::TurnRight, 1);
        player.tap(Command::Use, 1.0);
        player.tap(Command::Overview, 0.5);
        EXPECT_TRUE(player.heard("corridors. Corridor 1, ")) << world << ": " << player.news();
    }
}

TEST(Labyrinth, the_border_thuds_when_the_ball_hits_it) {
    Player player("labyrinth1.map");
    const auto thuds = [&] { return std::count(player.sounds.begin(), player.sounds.end(), SoundKind::Border); };
    player.tap(Command::Use, 0.5);
    EXPECT_EQ(thuds(), 0);
    player.taps(Command::TurnRight, 12);
    EXPECT_TRUE(player.heard("Ball stopped by Border")) << player.news();
    EXPECT_GE(thuds(), 1);
}

TEST(Labyrinth, the_goal_rings_faster_when_the_ball_is_nearer) {
    Player player("labyrinth1.map");
    const auto rate = [&] {
        const auto last = std::find_if(player.world_sounds.rbegin(), player.world_sounds.rend(),
                                       [](const CueRequest& cue) { return cue.sound == SoundKind::Tolling; });
        return last == player.world_sounds.rend() ? 0.0 : last->pulses_per_s;
    };
    player.run(0.5);
    player.tap(Command::Use, 0.5);
    std::vector<double> rates;
    for (int i = 0; i < 8; ++i) {
        player.tap(i < 4 ? Command::TurnRight : Command::Forward, 1.0);
        if (rate() > 0.0) rates.push_back(rate());
    }
    ASSERT_GE(rates.size(), 2U);
    EXPECT_GT(rates.back(), rates.front()) << fmt::format("{}", fmt::join(rates, " "));
}

TEST(Labyrinth, is_seen_from_above_and_arrows_move_the_camera_to_the_edge_while_nothing_is_held) {
    Player player("labyrinth2.map");
    const Vec3 feet_m = player.app.feet_m();
    const auto view = [&] { return player.app.view(player.tool); };
    EXPECT_EQ(view().pictures, Pictures::Plan);
    EXPECT_FALSE(player.heard("to walk")) << player.news();
    ASSERT_TRUE(view().camera_m);
    const Vec3 ball_m = *view().camera_m;
    player.tap(Command::Forward, 0.5);
    EXPECT_TRUE(player.heard("View: 1 roll north.")) << player.news();
    EXPECT_GT(view().camera_m->y, ball_m.y + 0.1);
    for (int i = 0; i < 40; ++i) player.tap(Command::TurnRight, 0.1);
    EXPECT_TRUE(player.heard("Edge of the table in the east. View: ")) << player.news();
    EXPECT_GT(player.count(SoundKind::Border), 0);
    EXPECT_LT(view().camera_m->x, ball_m.x + 5.0);
    EXPECT_LT(glm::length(player.app.feet_m() - feet_m), 1e-6) << "the person stays";
    for (int i = 0; i < 40; ++i) player.tap(Command::TurnLeft, 0.1);
    for (int i = 0; i < 40; ++i) player.tap(Command::Back, 0.1);
    EXPECT_TRUE(player.heard("Edge of the table in the west.") && player.heard("Edge of the table in the south."));
    player.tap(Command::Use, 0.5);
    player.tap(Command::TurnRight, 1.0);
    EXPECT_NEAR(view().camera_m->x, ball_m.x + 0.2, 0.08) << "the camera follows the ball again";
    player.app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, player.now);
    player.run(0.1);
    EXPECT_EQ(view().pictures, Pictures::Both);
    EXPECT_FALSE(view().camera_m);
    player.walk(1.0);
    EXPECT_GT(glm::length(player.app.feet_m() - feet_m), 0.5) << "elsewhere, arrows walk";
}

TEST(Labyrinth, camera_names_what_is_under_it) {
    Player player("labyrinth2.map");
    for (int i = 0; i < 4; ++i) player.tap(Command::TurnRight, 0.1);
    EXPECT_TRUE(player.heard("Hole.")) << player.news();
}

TEST(Labyrinth, fourth_level_is_finished_over_the_see_saw_which_tips_under_the_ball) {
    Player player("labyrinth4.map");
    EXPECT_TRUE(player.heard("Labyrinth 4.")) << player.news();
    const Scene& scene = *player.app.scene();
    const int plank = find_placed(scene, "See-saw");
    ASSERT_GE(plank, 0);
    // Returns how much higher the eastern end of the plank is than its western end, per metre.
    const auto tilt = [&] {
        return PlacedFrame(player.app.world().things.at(static_cast<std::size_t>(plank))).axes[0].z;
    };
    player.tap(Command::Use, 0.5);
    ASSERT_TRUE(player.heard("Ball held"));
    const double before = tilt();
    double lowest = before;
    for (int i = 0; i < 13; ++i) {
        player.tap(Command::TurnRight, 1.0);
        lowest = std::min(lowest, tilt());
    }
    EXPECT_LT(lowest, before - 0.2) << "it tips by more than ten degrees";
    EXPECT_NEAR(tilt(), before, 0.05) << "it tips back behind the ball";
    player.taps(Command::Forward, 6);
    player.taps(Command::TurnLeft, 13);
    EXPECT_TRUE(player.heard("Finished")) << player.news();
}

TEST(RubberStrings, of_the_demonstration_world_hold_their_balls_and_pull_them_back) {
    test::AppSession person;
    person.app.apply(WorldEntered{make_ready(test::our_world("strings.map"))}, 0.0);
    person.run(2.0);
    const auto at = [&](const char* name) { return person.app.thing_at(name)->position_m; };
    constexpr double kHooks_m = 2.0;
    for (const auto& [name, kg, n_per_m] : {std::tuple("Soft ball", 0.3, 10.0), std::tuple("Middle ball", 0.6, 40.0),
                                            std::tuple("Hard ball", 1.2, 160.0)}) {
        ASSERT_TRUE(person.app.thing_at(name)) << name;
        EXPECT_NEAR(at(name).z, kHooks_m - kg * 9.81 / n_per_m, 0.02) << name << " hangs at rest";
    }
    const Vec3 rests = at("Middle ball");
    person.walk(3.0);
    EXPECT_GT(glm::length(at("Middle ball") - rests), 0.05) << "the walker pushes it";
    person.hold(Command::Back, 2.0);
    person.run(30.0);
    EXPECT_LT(glm::length(at("Middle ball") - rests), 0.05) << "the string brings it back";
}

// Puts the plank over the hole, and rolls the ball over the plank.
void finish_second(Player& player) {
    player.taps(Command::SideLeft, 1);
    player.tap(Command::Use, 0.5);
    player.taps(Command::TiltUp, 1);
    player.taps(Command::TurnRight, 3);
    player.taps(Command::TiltDown, 1);
    player.tap(Command::Use, 1.0);
    player.tap(Command::Use, 0.5);
    player.taps(Command::TurnRight, 6);
    player.taps(Command::Forward, 5);
    player.taps(Command::TurnLeft, 9);
}

TEST(Labyrinth, second_level_is_finished_over_the_plank_twice_and_the_best_time_is_saved) {
    const test::TemporaryFolder folder;
    SessionOptions options;
    options.records_in = folder.path() / "not there yet";
    std::vector<std::string> first;
    {
        Player player("labyrinth2.map", options);
        finish_second(player);
        EXPECT_TRUE(player.heard("Plank held, 0.4 kilograms."));
        EXPECT_TRUE(player.heard("The hole is covered."));
        EXPECT_TRUE(player.heard("Ball stopped by Border, wood."));
        EXPECT_TRUE(player.heard("That is the first result recorded here.")) << player.news();
        EXPECT_EQ(player.request(Command::PutBack), "Everything is back at the start.");
        player.said.clear();
        player.run(0.5);
        EXPECT_NE(player.stands().find("A hole is 1.5 rolls east."), std::string::npos);
        const std::string before = player.stands();
        EXPECT_EQ(player.request(Command::RepeatLeg), "You are not following a route.")
            << "who asks for a leg loses no game";
        EXPECT_EQ(player.stands(), before);
    }
    EXPECT_TRUE(std::filesystem::exists(options.records_in / "labyrinth.handrail.toml"));
    Player again("labyrinth2.map", options);
    again.run(20.0);  // The clock does not start until the ball moves.
    finish_second(again);
    EXPECT_TRUE(again.heard("Finished in "));
    EXPECT_TRUE(again.heard("The best time here is ") || again.heard("That is a new best time")) << again.news();
}

// Returns the positions of all things in every frame after each tap.
std::vector<Placement> course_of(Player& player) {
    std::vector<Placement> course;
    const auto step = [&](Command command, int times, double each_s) {
        for (int i = 0; i < times; ++i) {
            player.tap(command, 0.0);
            for (int frame = 0; frame < static_cast<int>(60.0 * each_s); ++frame) {
                player.run(1.0 / 60.0);
                for (const char* name : {"Ball", "Plank"})
                    course.push_back(player.app.thing_at(name).value_or(Placement{}));
            }
        }
    };
    step(Command::SideLeft, 1, 1.0);
    step(Command::Use, 1, 0.5);
    step(Command::TiltUp, 1, 1.0);
    step(Command::TurnRight, 3, 1.0);
    step(Command::TiltDown, 1, 1.0);
    step(Command::Use, 2, 1.0);
    step(Command::TurnRight, 6, 1.0);
    step(Command::Forward, 5, 1.0);
    step(Command::SideRight, 1, 1.0);
    return course;
}

TEST(Labyrinth, restarted_behaves_bit_identically_to_another_run) {
    Player first("labyrinth2.map"), second("labyrinth2.map");
    const std::vector<Placement> once = course_of(first);
    EXPECT_EQ(once, course_of(second));
    // Both the ball and the plank have moved.
    EXPECT_GT(glm::length(once.back().position_m - once[1].position_m), 0.3);
    EXPECT_GT(glm::length(once[once.size() - 2].position_m - once[0].position_m), 0.3);
    for (Player* player : {&first, &second})
        EXPECT_EQ(player->request(Command::PutBack), "Everything is back at the start.");
    const std::vector<Placement> again = course_of(first);
    EXPECT_EQ(again, course_of(second));
}

TEST(Labyrinth, third_level_is_finished_by_filling_the_pit_and_lifting_the_crate_away) {
    Player player("labyrinth3.map");
    player.taps(Command::SideLeft, 1);
    player.tap(Command::Use, 0.5);
    ASSERT_TRUE(player.heard("Block held, 1 kilogram."));
    player.taps(Command::TiltUp, 1);
    player.taps(Command::TurnRight, 8);
    player.taps(Command::Forward, 2);
    player.tap(Command::Use, 2.0);
    EXPECT_TRUE(player.heard("The hole is covered."));
    player.taps(Command::SideRight, 2);
    player.tap(Command::Use, 0.5);
    ASSERT_TRUE(player.heard("Crate held, 2 kilograms."));
    player.taps(Command::TiltUp, 1);
    player.taps(Command::Forward, 1);
    player.taps(Command::TiltDown, 1);
    player.tap(Command::Use, 1.0);
    player.taps(Command::SideLeft, 2);
    player.tap(Command::Use, 0.5);
    ASSERT_TRUE(player.heard("Ball held"));
    player.taps(Command::TurnRight, 9);
    player.taps(Command::Forward, 6);
    player.taps(Command::TurnLeft, 12);
    EXPECT_TRUE(player.heard("Finished in ")) << player.news();
}

TEST(Labyrinth, third_level_has_a_safe_that_blocks_the_shorter_route) {
    Player player("labyrinth3.map");
    // The walker is placed at the north side of the table, where the safe is the nearest thing.
    player.app.apply(Placed{{2.0, 3.15, 0.0}, kPi}, player.now);
    player.run(0.5);
    const Vec3 before = player.app.thing_at("Safe").value_or(Placement{}).position_m;
    player.said.clear();
    player.tap(Command::Use, 1.0);
    EXPECT_TRUE(player.heard("Safe. Heavy, 400 kilograms.")) << player.news();
    const Vec3 after = player.app.thing_at("Safe").value_or(Placement{}).position_m;
    EXPECT_LT(glm::length(after - before), 1e-3);
    // The safe stays between the two walls. The gap next to it is too narrow for a ball of 10 cm.
    EXPECT_GT(after.y, 1.75);
    EXPECT_LT(after.y, 2.45);
}

TEST(Labyrinth, a_person_who_gets_no_nearer_for_a_minute_gets_one_hint) {
    Player player("labyrinth1.map");
    player.tap(Command::Use, 0.5);
    player.taps(Command::TurnRight, 1);
    player.said.clear();
    player.run(150.0);
    EXPECT_EQ(std::count_if(player.said.begin(), player.said.end(),
                            [](const std::string& text) { return text.find("no nearer") != std::string::npos; }),
              1);
}

TEST(Labyrinth, commands_say_so_in_worlds_that_are_not_labyrinths) {
    test::AppSession house;
    house.app.apply(WorldEntered{make_ready(test::our_world("first_room.map"))}, 0.0);
    house.run(0.1);
    EXPECT_FALSE(house.heard("Labyrinth"));
    EXPECT_EQ(house.request(Command::Labyrinth), "This world is not a labyrinth. The list of worlds has some.");
    EXPECT_EQ(house.request(Command::PutBack), "Nothing can be moved here.");
}

TEST(Labyrinth, is_played_in_german) {
    const test::InLanguage german("de");
    Player player("labyrinth2.map");
    const std::string text = player.stands();
    EXPECT_NE(text.find("Ein Loch: 1,5 Ballschritte nach Osten."), std::string::npos) << text;
}

// Returns the warnings of the reader. Faults in the game of a map are reported with their lines.
std::string warnings_of(const std::string& world_keys, const std::string& entities) {
    const std::string room = test::room_brushes(0, 0, 0, 256, 256, 128);
    const auto scene = read_quake_map(
        entity("worldspawn", key("message", "Hall") + key("building", "1") + world_keys, room) + entities, "hall.map");
    EXPECT_TRUE(scene);
    std::string text;
    for (const Diagnostic& warning : scene->report.warnings) text += warning.sentence() + "\n";
    EXPECT_EQ(scene->labyrinth.there(), scene->report.warnings.empty()) << text;
    return text;
}
const std::string kBall = entity("thing", key("cs_name", "dynamic_sphere") + key("name", "Ball") + key("role", "ball"),
                                 box_brush(100, 100, 0, 110, 110, 10));
const std::string kGoal = entity("trigger_goal", "", box_brush(200, 200, 0, 220, 220, 20, "trigger"));

TEST(LabyrinthKeys, that_make_no_complete_game_are_reported_with_their_line) {
    EXPECT_EQ(warnings_of(key("labyrinth", "1"), kBall + kGoal), "");
    EXPECT_NE(warnings_of(key("labyrinth", "1"), kGoal).find("a labyrinth needs a ball"), std::string::npos);
    EXPECT_NE(warnings_of(key("labyrinth", "1"), kBall).find("a labyrinth needs a goal"), std::string::npos);
    EXPECT_NE(warnings_of("", kBall + kGoal).find("belong to a labyrinth"), std::string::npos);
    EXPECT_NE(warnings_of(key("labyrinth", "nan"), kBall + kGoal).find("labyrinth is not a number"), std::string::npos);
}

TEST(LabyrinthKeys, that_are_misplaced_are_ignored_and_the_rest_is_played) {
    const auto reported = [](const std::string& entities, const std::string& sentence) {
        const std::string room = test::room_brushes(0, 0, 0, 256, 256, 128);
        const auto scene = read_quake_map(
            entity("worldspawn", key("message", "Hall") + key("building", "1") + key("labyrinth", "2"), room) + kBall +
                kGoal + entities,
            "hall.map");
        ASSERT_TRUE(scene);
        ASSERT_EQ(scene->report.warnings.size(), 1U);
        EXPECT_NE(scene->report.warnings[0].sentence().find(sentence), std::string::npos)
            << scene->report.warnings[0].sentence();
        EXPECT_TRUE(scene->labyrinth.there());
    };
    reported(entity("trigger_hole", "", box_brush(50, 50, -40, 60, 60, -20, "trigger")),
             "there is floor over this hole");
    reported(entity("thing", key("name", "Bench") + key("role", "plank"), box_brush(50, 50, 0, 60, 60, 10)),
             "only a thing that is free to move");
    reported(entity("thing", key("cs_name", "dynamic_box") + key("name", "Bench") + key("role", "plonk"),
                    box_brush(50, 50, 0, 60, 60, 10)),
             "the nearest is plank");
    reported(entity("thing", key("cs_name", "dynamic_sphere") + key("name", "Second") + key("role", "ball"),
                    box_brush(50, 50, 0, 60, 60, 10)),
             "there is already a ball");
}

}  // namespace labyrinth_test
}  // namespace handrail
