// Tests what the program remembers of learning from session to session. The tests use plain state and a separate side
// file.
#include <gmock/gmock.h>

#include <random>

#include "app/core/learning/learnt_file.h"
#include "app/core/learning/place_learning.h"
#include "app/core/learning/route_memory.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/features/plain_session.h"

namespace handrail {
namespace learnt_features_test {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// Returns a hall of 10 by 6 m with three things. A wall from the south leaves two metres free in the north.
std::shared_ptr<const Scene> hall() {
    test::SceneBuilder builder;
    const auto wall = [&](const Vec3& min_m, const Vec3& max_m, const std::string& name) {
        builder.box(min_m, max_m, name, SolidRole::Solid, {}, FeatureKind::Wall);
    };
    const auto thing = [&](const Vec3& min_m, const std::string& name) {
        builder.box(min_m, min_m + Vec3(0.3, 0.3, 0.8), name, SolidRole::Solid, {}, FeatureKind::Object);
    };
    builder.box({-0.2, -0.2, -0.2}, {10.2, 6.2, 0.0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    wall({-0.2, -0.2, 0.0}, {10.2, 0.0, 3.0}, "south wall");
    wall({-0.2, 6.0, 0.0}, {10.2, 6.2, 3.0}, "north wall");
    wall({-0.2, 0.0, 0.0}, {0.0, 6.0, 3.0}, "west wall");
    wall({10.0, 0.0, 0.0}, {10.2, 6.0, 3.0}, "east wall");
    wall({4.9, 0.0, 0.0}, {5.1, 4.0, 3.0}, "screen");
    thing({0.9, 5.5, 0.0}, "clock");
    thing({4.3, 0.9, 0.0}, "bench");
    builder.start({1.0, 1.0, 0.0}, 0.0);
    builder.scene().name = "hall";
    return builder.share();
}

struct Session : test::PlainSession {
    explicit Session(const std::filesystem::path& world_file) : PlainSession(hall()) {
        additions = SideFile::of_world(world_file, {});
        set_session_requests();
        rooms.enter_world(as_read);
        rooms.tick(0.0);
        learning.enter_world(0.0);
        learning.announce_kept(0.0);
        events.on_reported = [this](const SessionEvent& event) { ways.see(event); };
    }
    void set_session_requests() {
        context.session_requests.save_additions = [this](double) {
            const auto saved = additions.save();
            EXPECT_TRUE(saved) << saved.error().sentence();
            return saved.has_value();
        };
    }
    void go(const Vec3& to_m) {
        while (glm::length(to_m - avatar.feet_m()) > 0.05) {
            const Vec3 way = to_m - avatar.feet_m();
            stand(avatar.feet_m() + way * std::min(1.0, 0.1 / glm::length(way)));
            avatar.walker->tick(Vec3(0.0), 0.05);
            tick();
        }
    }
    void tick(const std::optional<Vec3>& trailed = std::nullopt) {
        now_s += 0.1;
        learning.note(std::nullopt, trailed, now_s);
        learning.tick(now_s);
        ways.tick(now_s);
    }
    void trail_south() {
        for (double x = 0.3; x < 4.6; x += 0.1) {
            stand({x, 0.35, 0.0});
            avatar.walker->tick(Vec3(0.0), 0.1);
            tick(Vec3(0.0, 1.0, 0.0));
        }
    }
    std::string progress() {
        said();
        EXPECT_TRUE(learning.act(Command::ProgressReport, now_s));
        const std::vector<std::string> words = said();
        return words.size() == 1 ? words.front() : std::string("not one answer");
    }
    double now_s = 0.0;
    Rooms rooms{context};
    PlaceLearning learning{context, rooms};
    RouteMemory ways{context, rooms};
};

struct Remembered : testing::Test {
    Remembered() {
        SideFile additions = SideFile::of_world(world, {});
        set_remembers(additions, true);
        EXPECT_TRUE(additions.save());
    }
    test::TemporaryFolder folder;
    std::filesystem::path world = folder.write("hall.map", "x"), file = folder.path() / "hall.map.handrail.toml";
};

std::string without_time(const std::string& words) { return words.substr(0, words.find("percent. ")); }

TEST_F(Remembered, learning_resumes_where_it_ended) {
    std::string before;
    {
        Session first(world);
        EXPECT_THAT(first.said(), IsEmpty()) << "nothing is remembered yet";
        first.trail_south();
        before = first.progress();
        EXPECT_THAT(before, Not(HasSubstr("Walls 0 percent")));
        first.learning.keep(first.now_s);
    }
    Session second(world);
    EXPECT_THAT(second.said(), ElementsAre(HasSubstr("You have learnt this place once before")));
    EXPECT_EQ(without_time(second.progress()), without_time(before));
    second.learning.keep(1.0);
    second.go({2.0, 3.0, 0.0});
    second.learning.keep(second.now_s);
    Session third(world);
    EXPECT_THAT(third.said(), ElementsAre(HasSubstr("You have learnt this place twice before")));
}

TEST_F(Remembered, learning_by_only_walking_or_only_touching_is_restored_too) {
    for (const bool walked : {true, false}) {
        SideFile additions = SideFile::of_world(world, {});
        KeptLearning kept;
        kept.sessions = 1;
        if (walked) kept.steps_m = {{1.0, 2.0, 0.0}};
        else kept.touches = {{{1.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, 0.5}};
        write_learnt(additions, kept);
        ASSERT_TRUE(additions.save());
        const auto again = read_learnt(SideFile::of_world(world, {}));
        ASSERT_TRUE(again) << again.error().sentence();
        EXPECT_EQ(again->steps_m.size(), walked ? 1U : 0U);
        EXPECT_EQ(again->touches.size(), walked ? 0U : 1U);
    }
}

TEST_F(Remembered, learning_mode_resumes_at_the_same_base_and_announces_no_wall_twice) {
    {
        Session first(world);
        first.go({1.0, 1.2, 0.0});
        EXPECT_TRUE(first.learning.act(Command::LearnPlace, first.now_s));
        first.trail_south();
        first.learning.keep(first.now_s);
    }
    Session second(world);
    second.go({3.0, 3.0, 0.0});
    second.said();
    EXPECT_TRUE(second.learning.act(Command::LearnPlace, second.now_s));
    EXPECT_THAT(second.said(), ElementsAre(AllOf(HasSubstr("Learning continues"), HasSubstr("The base is"))));
    for (int i = 0; i < 30; ++i) second.go({3.0 + 0.1 * (i % 2), 3.2, 0.0});
    EXPECT_THAT(second.said(), Not(Contains(HasSubstr("done, "))));
}

TEST(LearnPlaceMode, leads_back_to_the_base_after_each_wall_and_onwards_from_there) {
    const test::TemporaryFolder folder;
    Session session(folder.write("hall.map", "x"));
    session.go({1.0, 1.2, 0.0});
    EXPECT_TRUE(session.learning.act(Command::LearnPlace, session.now_s));
    for (double y = 0.3; y < 5.8; y += 0.1) {
        session.stand({0.35, y, 0.0});
        session.avatar.walker->tick(Vec3(0.0), 0.1);
        session.tick(Vec3(1.0, 0.0, 0.0));
    }
    for (int i = 0; i < 12; ++i) session.go({0.5 + 0.1 * (i % 2), 5.0, 0.0});
    EXPECT_THAT(session.said(), Contains(AllOf(HasSubstr("est wall done"), HasSubstr("The base is"))));
    session.go({1.0, 1.2, 0.0});
    EXPECT_THAT(session.said(), ElementsAre(AllOf(HasSubstr("Back at the base."), HasSubstr("Unexplored"))));
}

TEST(LearnPlaceMode, queries_directions_of_things_relative_to_the_base) {
    const test::TemporaryFolder folder;
    Session session(folder.write("hall.map", "x"));
    ASSERT_TRUE(session.rooms.have(0.0));
    const auto questions =
        relation_questions(session.context, session.rooms, session.rooms.here(), session.avatar.feet_m());
    ASSERT_EQ(questions.size(), 2U);
    EXPECT_EQ(questions[0].thing, "Clock");
    EXPECT_EQ(questions[0].right, Quarter::Ahead) << "north of the base";
    EXPECT_NEAR(questions[0].distance_m, 4.65, 0.01);
    EXPECT_EQ(questions[1].thing, "Bench");
    EXPECT_EQ(questions[1].right, Quarter::Right) << "east of the base";
}

TEST_F(Remembered, learning_is_deleted_when_remembering_is_switched_off_and_then_not_stored) {
    {
        Session first(world);
        first.trail_south();
        first.learning.keep(first.now_s);
    }
    EXPECT_THAT(test::content_of(file), HasSubstr("touches"));
    SideFile again = SideFile::of_world(world, {});
    set_remembers(again, false);
    EXPECT_TRUE(again.save());
    EXPECT_THAT(test::content_of(file), Not(HasSubstr("learnt")));
    const std::string bytes = test::content_of(file);
    Session second(world);
    second.trail_south();
    second.learning.keep(second.now_s);
    EXPECT_EQ(test::content_of(file), bytes);
}

TEST_F(Remembered, damage_is_reported_with_file_and_line_and_never_overwritten) {
    for (const char* text :
         {"[[learnt]]\nname = \"walls and floor\"\nsteps_m = [1.0, 2.0]\n", "[[learnt]]\ntouches = \"many\"\n",
          "[[learnt]]\nspent_s = -1.0\n", "learnt = 3\n", "[[learnt]]\nx = 1\n[[learnt_room]]\nspent_s = 2.0\n"}) {
        folder.write("hall.map.handrail.toml", text);
        Session session(world);
        const std::vector<std::string> words = session.said();
        const bool list = std::string(text).starts_with("[[");
        if (list) {
            EXPECT_THAT(words, ElementsAre(AllOf(HasSubstr("hall.map.handrail.toml"), HasSubstr("line"),
                                                 HasSubstr("is left unchanged"))))
                << text;
        }
        session.trail_south();
        session.learning.keep(session.now_s);
        EXPECT_EQ(test::content_of(file), text);
    }
}

TEST_F(Remembered, a_file_cut_at_every_byte_is_never_overwritten) {
    {
        Session first(world);
        for (int i = 0; i < 3; ++i) first.go({1.0 + 0.3 * i, 1.0, 0.0});
        first.learning.keep(first.now_s);
    }
    const std::string whole = test::content_of(file);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        folder.write("hall.map.handrail.toml", whole.substr(0, length));
        const SideFile cut = SideFile::of_world(world, {});
        if (!cut.news().empty()) {  // The damaged file was set aside, and the fault was reported.
            std::filesystem::path aside = file;
            aside += ".damaged";
            EXPECT_EQ(test::content_of(aside), whole.substr(0, length));
            std::filesystem::remove(aside);
            continue;
        }
        if (remembers(cut))
            if (const auto kept = read_learnt(cut); !kept) {
                EXPECT_GT(kept.error().line, 0) << length;
            }
    }
}

TEST(LearntFile, after_thinning_holds_the_same_knowledge_and_thinning_again_changes_nothing) {
    std::mt19937_64 draw(5);
    const auto between = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(draw); };
    LearningNotes notes;
    for (int i = 0; i < 20000; ++i) {
        notes.walked({between(0.3, 6.0), between(0.3, 5.7), 0.0});
        notes.touched({between(0.2, 7.0), 0.0, between(0.8, 1.2)}, {0.0, 1.0, 0.0}, 0.1);
        if (i % 20 == 0) notes.touched({0.0, between(1.0, 3.0), 1.0}, {1.0, 0.02, 0.0}, 0.05);
    }
    KeptLearning once, twice;
    thin_out(notes, once);
    EXPECT_LT(once.touches.size(), 60U) << "of " << notes.touches().size();
    EXPECT_LT(once.steps_m.size(), 3200U) << "of " << notes.steps_m().size();
    LearningNotes again;
    for (const TouchNote& note : once.touches) again.touched(note.point_m, note.normal, note.reach_m);
    for (const Vec3& step : once.steps_m) again.walked(step);
    thin_out(again, twice);
    EXPECT_EQ(twice.steps_m.size(), once.steps_m.size());
    EXPECT_EQ(twice.touches.size(), once.touches.size());
    // The thinned notes must still contain each touched place of the wall, and no others.
    const auto known = [](const std::vector<TouchNote>& touches, double x) {
        return std::any_of(touches.begin(), touches.end(), [&](const TouchNote& note) {
            return note.normal.y > 0.9 && std::abs(note.point_m.x - x) <= note.reach_m + 1e-9;
        });
    };
    for (double x = 0.0; x < 8.0; x += 0.01)
        if (known(notes.touches(), x - 0.01) == known(notes.touches(), x + 0.01)) {
            EXPECT_EQ(known(once.touches, x), known(notes.touches(), x)) << x;
        }
}

TEST_F(Remembered, a_premature_turn_is_announced_on_the_next_guidance_until_it_is_learnt) {
    {
        Session first(world);
        ASSERT_TRUE(first.rooms.have(0.0));
        first.events.report(Led{"library", LedBy::Ear}, 0.0);
        first.tick();
        EXPECT_THAT(first.said(), IsEmpty());
        for (const Vec3& at : {Vec3(4.0, 1.6, 0.0), Vec3(4.5, 4.6, 0.0), Vec3(5.5, 4.6, 0.0), Vec3(9.0, 1.0, 0.0)})
            first.go(at);
        first.events.report(Arrived{"library", LedBy::Ear, false}, first.now_s);
        first.tick();
    }
    EXPECT_THAT(test::content_of(file), HasSubstr("early = 1"));
    {
        Session second(world);
        ASSERT_TRUE(second.rooms.have(0.0));
        second.said();
        second.events.report(Led{"library", LedBy::Ear}, 0.0);
        second.tick();
        EXPECT_THAT(second.said(), ElementsAre(HasSubstr("Earlier, you turned too soon once at")));
        second.tick();
        EXPECT_THAT(second.said(), IsEmpty()) << "told once";
        const Route right = second.rooms.navigation().plan(second.avatar.feet_m(), {9.0, 1.0, 0.0});
        ASSERT_TRUE(right.reaches);
        for (const Vec3& at : right.points_m) second.go(at);
        second.events.report(Arrived{"library", LedBy::Ear, false}, second.now_s);
        second.tick();
    }
    EXPECT_THAT(test::content_of(file), Not(HasSubstr("early")));
}

}  // namespace learnt_features_test
}  // namespace handrail
