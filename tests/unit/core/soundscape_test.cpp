#include "app/core/context/soundscape.h"

#include <random>
#include <set>

#include "app/core/session/session.h"
#include "audio-cues/plan/sound_table.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"

namespace handrail {
namespace soundscape_test {

using test::SceneBuilder;

constexpr Vec3 kEars_m{2.0, 1.0, 1.6};

// Makes two rooms along y with a wall between them from y = 4 to 4.2. The wall has an opening, x 1.5 to 2.5 and z 0 to
// 2.1, which may be filled.
SceneBuilder two_rooms() {
    SceneBuilder b;
    b.box({0, 0, -0.2}, {4, 8.2, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
    b.box({0, 4, 0}, {1.5, 4.2, 2.6}, "wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({2.5, 4, 0}, {4, 4.2, 2.6}, "wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({1.5, 4, 2.1}, {2.5, 4.2, 2.6}, "wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    return b;
}

TEST(Muffling, is_zero_for_an_open_path_and_at_least_12_db_for_a_closed_door) {
    const Vec3 clock{2.0, 7.0, 1.6};
    EXPECT_EQ(muffling_db(WalkerWorld(two_rooms().share()), kEars_m, clock), 0.0);
    SceneBuilder closed = two_rooms();
    closed.box({1.5, 4.05, 0}, {2.5, 4.1, 2.1}, "Door", SolidRole::Mover, "wood", FeatureKind::Door);
    EXPECT_NEAR(muffling_db(WalkerWorld(closed.share()), kEars_m, clock), kDoorMuffles_db, 1e-9);
    EXPECT_GE(kDoorMuffles_db, 12.0);
}

TEST(Muffling, of_a_wall_is_stronger_than_of_a_door_and_a_wall_of_two_layers_counts_once) {
    const Vec3 ears{0.7, 1.0, 1.6}, source{0.7, 7.0, 1.6};
    EXPECT_NEAR(muffling_db(WalkerWorld(two_rooms().share()), ears, source), kWallMuffles_db, 1e-9);
    SceneBuilder layered = two_rooms();
    layered.box({0, 4.2, 0}, {1.5, 4.3, 2.6}, "panel", SolidRole::Solid, "wood", FeatureKind::Wall);
    EXPECT_NEAR(muffling_db(WalkerWorld(layered.share()), ears, source), kWallMuffles_db, 1e-9);
    SceneBuilder second = two_rooms();
    second.box({0, 6, 0}, {4, 6.2, 2.6}, "wall", SolidRole::Solid, "brick", FeatureKind::Wall);
    EXPECT_NEAR(muffling_db(WalkerWorld(second.share()), ears, source), 2.0 * kWallMuffles_db, 1e-9);
    EXPECT_GT(2.0 * kWallMuffles_db, kUnheard_db);
}

TEST(Muffling, rises_gradually_behind_an_edge_and_is_small_for_furniture) {
    // The ears move so that the line to the source passes the corner at (2.5, 4) first on one side, then on the other.
    const WalkerWorld world(two_rooms().share());
    const Vec3 source{2.5, 7.0, 1.6};
    double last_db = -1.0;
    int between = 0;
    for (double x = 2.2; x <= 2.9; x += 0.02) {
        const double db = muffling_db(world, {x, 1.0, 1.6}, source);
        EXPECT_GE(db, last_db - 1e-9);
        if (db > 0.5 && db < kWallMuffles_db - 0.5) ++between;
        last_db = db;
    }
    EXPECT_NEAR(last_db, kWallMuffles_db, 1e-9);
    EXPECT_GE(between, 5);
    SceneBuilder b = two_rooms();
    b.box({1.5, 2, 0}, {2.5, 2.5, 1.7}, "Shelf", SolidRole::Solid, "wood", FeatureKind::Object);
    EXPECT_NEAR(muffling_db(WalkerWorld(b.share()), kEars_m, {2.0, 3.5, 1.6}), kThingMuffles_db, 1e-9);
}

TEST(Muffling, ignores_the_solid_around_the_source_and_solids_that_only_stop_bodies) {
    SceneBuilder b = two_rooms();
    b.box({1.9, 6.9, 1.5}, {2.1, 7.1, 1.7}, "Lamp", SolidRole::Solid, "glass");
    b.box({0, 3, 0}, {4, 3.1, 2.6}, "clip", SolidRole::BodyClip);
    EXPECT_EQ(muffling_db(WalkerWorld(b.share()), kEars_m, {2.0, 7.0, 1.6}), 0.0);
}

TEST(Crossings, agree_with_walking_along_the_line_in_small_steps) {
    std::mt19937 random(7);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
    };
    SceneBuilder b;
    std::vector<Aabb> boxes;
    for (int i = 0; i < 30; ++i) {
        const Vec3 low{uniform(-4, 3), uniform(-4, 3), uniform(-4, 3)},
            high = low + Vec3(uniform(0.1, 2), uniform(0.1, 2), uniform(0.1, 2));
        b.box(low, high);
        boxes.push_back({low, high});
    }
    const WalkerWorld world(b.share());
    for (int i = 0; i < 300; ++i) {
        const Vec3 from{uniform(-5, 5), uniform(-5, 5), uniform(-5, 5)},
            to{uniform(-5, 5), uniform(-5, 5), uniform(-5, 5)};
        const auto inside = [](const Aabb& box, const Vec3& p) {
            return p.x > box.min_m.x && p.y > box.min_m.y && p.z > box.min_m.z && p.x < box.max_m.x &&
                   p.y < box.max_m.y && p.z < box.max_m.z;
        };
        double sampled = 0.0, found = 0.0;
        const int steps = 2000;
        for (const Aabb& box : boxes) {
            if (inside(box, from) || inside(box, to)) continue;
            for (int k = 0; k < steps; ++k)
                sampled += inside(box, from + (to - from) * ((k + 0.5) / steps)) ? 1.0 / steps : 0.0;
        }
        for (const Crossing& crossing : world.crossings(from, to))
            found += (crossing.leave_m - crossing.enter_m) / glm::length(to - from);
        EXPECT_NEAR(found, sampled, 0.01) << "seed 7, line " << i;
    }
}

// Makes a closed room whose inner size is 6 by 4 by 2.6 metres.
SceneBuilder closed_room(const std::string& floor, const std::string& walls, const std::string& ceiling) {
    SceneBuilder b;
    b.box({-0.2, -0.2, -0.2}, {6.2, 4.2, 0}, "floor", SolidRole::Solid, floor, FeatureKind::Floor);
    if (!ceiling.empty())
        b.box({-0.2, -0.2, 2.6}, {6.2, 4.2, 2.8}, "ceiling", SolidRole::Solid, ceiling, FeatureKind::Ceiling);
    b.box({-0.2, 4, 0}, {6.2, 4.2, 2.6}, "north wall", SolidRole::Solid, walls, FeatureKind::Wall);
    b.box({-0.2, -0.2, 0}, {6.2, 0, 2.6}, "south wall", SolidRole::Solid, walls, FeatureKind::Wall);
    b.box({6, 0, 0}, {6.2, 4, 2.6}, "east wall", SolidRole::Solid, walls, FeatureKind::Wall);
    b.box({-0.2, 0, 0}, {0, 4, 2.6}, "west wall", SolidRole::Solid, walls, FeatureKind::Wall);
    return b;
}

TEST(Reverberation, follows_sabine_within_10_percent_at_any_place_in_the_room) {
    // V is 62.4 cubic metres. The areas are: floor 24, ceiling 24, walls 52 square metres.
    const double carpeted_s = 0.161 * 62.4 / (24 * 0.35 + 24 * 0.05 + 52 * 0.05),
                 tiled_s = 0.161 * 62.4 / (24 * 0.02 + 24 * 0.03 + 52 * 0.03);
    const WalkerWorld carpeted(closed_room("carpet", "plaster", "plaster").share()),
        tiled(closed_room("tile", "concrete", "concrete").share());
    for (const Vec3 ears : {Vec3(3, 2, 1.6), Vec3(0.5, 0.5, 1.6), Vec3(5.6, 3.0, 1.2)}) {
        EXPECT_NEAR(reverberation_s(carpeted, ears), carpeted_s, 0.1 * carpeted_s);
        EXPECT_NEAR(reverberation_s(tiled, ears), tiled_s, 0.1 * tiled_s);
    }
    EXPECT_GT(tiled_s, 2.0 * carpeted_s);
}

TEST(Reverberation, is_absent_outdoors_and_on_open_ground) {
    EXPECT_EQ(reverberation_s(WalkerWorld(closed_room("tile", "brick", "").share()), {3, 2, 1.6}), 0.0);
    SceneBuilder b;
    b.box({-100, -100, -1}, {100, 100, 0}, "ground", SolidRole::Solid, "grass", FeatureKind::Floor);
    EXPECT_EQ(reverberation_s(WalkerWorld(b.share()), {0, 0, 1.6}), 0.0);
}

// Sources in the open air, along x at y = 2.
struct Field {
    explicit Field(std::initializer_list<double> places) {
        SceneBuilder b;
        b.box({-100, -100, -1}, {100, 100, 0}, "ground", SolidRole::Solid, "grass", FeatureKind::Floor);
        for (const double x : places) b.scene().sounds.push_back({{x, 2.0, 1.6}, "lamp", "ambient_light_buzz", 1.0});
        scene = b.share();
        world = std::make_unique<WalkerWorld>(scene);
        soundscape.enter(*scene);
    }
    void stand(double x, double seconds) {
        for (double t = 0.0; t < seconds; t += 1.0 / 60.0) {
            now_s += 1.0 / 60.0;
            std::vector<CueRequest> cues;
            soundscape.tick(*world, {x, 0.0, 1.6}, now_s, cues);
            for (const CueRequest& cue : cues) {
                if (cue.loudness > 0.0) playing.insert(cue.source);
                else playing.erase(cue.source);
            }
            changes += cues.size();
            most = std::max(most, playing.size());
        }
    }
    std::shared_ptr<const Scene> scene;
    std::unique_ptr<WalkerWorld> world;
    Soundscape soundscape;
    std::set<std::uint32_t> playing;
    std::size_t changes = 0, most = 0;
    double now_s = 0.0;
};

TEST(Soundscape, plays_the_three_loudest_sources_and_follows_the_walker) {
    Field f{0, 4, 8, 12, 16, 20};
    f.stand(0.0, 1.0);
    EXPECT_EQ(f.playing, (std::set<std::uint32_t>{0, 1, 2}));
    for (double x = 0.0; x <= 20.0; x += 0.1) f.stand(x, 0.1);
    EXPECT_EQ(f.playing, (std::set<std::uint32_t>{3, 4, 5}));
    EXPECT_LE(f.most, 3U);
}

TEST(Soundscape, keeps_a_source_when_another_becomes_about_equally_loud) {
    Field f{-3, 3, 9, -9};  // around the middle, the levels of the two far sources differ by less than 3 dB
    f.stand(0.0, 1.0);
    const auto before = f.playing;
    const std::size_t changes = f.changes;
    for (int i = 0; i < 60; ++i) f.stand(i % 2 == 0 ? 0.5 : -0.5, 0.2);
    EXPECT_EQ(f.playing, before);
    EXPECT_EQ(f.changes, changes) << "nothing is told again that did not change";
}

TEST(Soundscape, drops_sources_out_of_range_or_behind_two_walls_and_all_on_a_change_of_world) {
    Field f{0, 200};
    f.stand(0.0, 0.5);
    EXPECT_EQ(f.playing, std::set<std::uint32_t>{0});
    f.soundscape.enter(Scene{});
    f.stand(0.0, 0.1);
    EXPECT_TRUE(f.playing.empty());
}

TEST(Soundscape, follows_sources_of_a_crowded_map_within_a_few_ticks_at_limited_cost) {
    SceneBuilder b;
    b.box({-100, -100, -1}, {100, 100, 0}, "ground", SolidRole::Solid, "grass", FeatureKind::Floor);
    for (int i = 0; i < 60; ++i)
        b.scene().sounds.push_back({{5.0 + 0.1 * i, 2.0, 1.6}, "lamp", "lamp", i == 59 ? 1.0 : 0.2});
    const auto scene = b.share();
    const WalkerWorld world(scene);
    Soundscape soundscape;
    soundscape.enter(*scene);
    std::vector<CueRequest> cues;
    for (int tick = 0; tick < 8; ++tick) soundscape.tick(world, {0.0, 0.0, 1.6}, tick / 60.0, cues);
    for (int tick = 8; tick < 60; ++tick) soundscape.tick(world, {0.0, 0.0, 1.6}, tick / 60.0, cues);
    std::set<std::uint32_t> playing;
    for (const CueRequest& cue : cues) {
        if (cue.loudness > 0.0) playing.insert(cue.source);
        else playing.erase(cue.source);
    }
    EXPECT_EQ(playing.size(), 3U);
    EXPECT_TRUE(playing.contains(59));
}

TEST(SessionSounds, listener_gets_the_reverberation_of_the_current_room) {
    SceneBuilder b = closed_room("tile", "concrete", "concrete");
    b.start({3, 2, 0}, 0.0);
    Session app(Settings{}, HandFacts{});
    app.apply(WorldEntered{make_ready(b.share())}, 0.0);
    app.tick(0.1, ToolState{});
    EXPECT_NEAR(app.listener().reverberation_s, 3.6, 0.4);
}

TEST(SessionSounds, world_sounds_are_passed_to_the_cue_planner) {
    SceneBuilder b = two_rooms();
    b.scene().sounds.push_back({{2.0, 3.0, 1.6}, "Clock", "clock_tick", 0.5});
    b.start({2, 1, 0}, 0.0);
    Session app(Settings{}, HandFacts{});
    app.apply(WorldEntered{make_ready(b.share())}, 0.0);
    app.tick(0.1, ToolState{});
    const std::vector<CueRequest> cues = app.take_cues();
    const auto sound = std::find_if(cues.begin(), cues.end(),
                                    [](const CueRequest& cue) { return cue.kind == CueRequestKind::WorldSound; });
    ASSERT_NE(sound, cues.end());
    EXPECT_EQ(sound->sound, SoundKind::Clock);
    EXPECT_EQ(sound->loudness, 0.5);
    EXPECT_EQ(sound->position_m, Vec3(2.0, 3.0, 1.6));
}

}  // namespace soundscape_test
}  // namespace handrail
