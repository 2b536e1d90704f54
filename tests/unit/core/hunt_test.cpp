#include "app/core/hunt.h"

#include <cmath>
#include <set>

#include "app/core/app_core.h"
#include "app/core/session_log.h"
#include "tests/support/box_scene.h"
#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace {

using test::SceneBuilder;

// Two rooms with a doorway; the second has a raised floor that is climbed by steps.
std::shared_ptr<const Scene> rooms() {
    SceneBuilder b;
    b.box({0, 0, -0.2}, {12, 5, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
    b.box({-0.2, -0.2, 0}, {12.2, 0, 3}, "south wall");
    b.box({-0.2, 5, 0}, {12.2, 5.2, 3}, "north wall");
    b.box({-0.2, 0, 0}, {0, 5, 3}, "west wall");
    b.box({12, 0, 0}, {12.2, 5, 3}, "east wall");
    b.box({6, 0, 0}, {6.2, 3, 3}, "middle wall");
    b.box({6, 4, 0}, {6.2, 5, 3}, "middle wall");
    for (int i = 0; i < 4; ++i) b.box({9.0 + 0.4 * i, 0, 0}, {12, 5, 0.2 * (i + 1)}, "step");
    b.start({1, 1, 0}, 0.0);
    b.scene().name = "two rooms";
    return b.share();
}

TEST(Hunt, hides_where_one_can_walk_far_enough_away_and_leads_there) {
    const auto scene = rooms();
    const BodyWorld world(scene);
    const BodySize body = body_size(*scene, 0.25);
    HuntGround ground(world, {1, 1, 0}, body);
    std::set<std::pair<int, int>> places;
    for (std::uint64_t number = 0; number < 40; ++number) {
        HuntGround hunt = ground;
        const Vec3 clock = hunt.hiding_place(number, 6.0);
        places.emplace(static_cast<int>(clock.x * 4), static_cast<int>(clock.y * 4));
        EXPECT_FALSE(world.blocked(clock, BodyShape{0.2, 1.5}));
        hunt.aim(clock);
        // Whoever goes where it says, arrives.
        Vec3 at(1, 1, 0);
        ASSERT_TRUE(hunt.way_m(at));
        EXPECT_GE(*hunt.way_m(at), 6.0 - 1e-9);
        int legs = 0;
        while (glm::length(at - clock) > 0.3 && legs++ < 30) {
            const auto next = hunt.next_m(world, at, body);
            ASSERT_TRUE(next);
            at = *next;
        }
        EXPECT_LT(glm::length(at - clock), 0.3);
        EXPECT_TRUE(finds(world, at, clock));
    }
    EXPECT_GT(places.size(), 20U);
    EXPECT_FALSE(finds(world, {5.8, 1, 0}, {6.5, 1, 0})) << "through a wall nothing is found";
}

// Who knows only what is said and turns and walks by keys.
class Newcomer {
public:
    explicit Newcomer(AppCore& app) : app_(app) {}
    void run(double seconds) {
        for (const double until = now_ + seconds; now_ < until - 1e-9;) {
            now_ += 1.0 / 60.0;
            app_.tick(now_, ToolState{});
            for (const CueRequest& cue : app_.take_cues()) {
                if (cue.kind == CueRequestKind::Say) heard_.push_back(cue.text);
                bumped_ |= cue.kind == CueRequestKind::Bump;
            }
        }
    }
    void tap(Command command, double then_s) {
        app_.press(command, now_);
        app_.release(command);
        run(then_s);
    }
    // What was said to a key.
    std::string ask(Command command) {
        const std::size_t before = heard_.size();
        tap(command, 0.2);
        std::string all;
        for (std::size_t i = before; i < heard_.size(); ++i) all += heard_[i] + " ";
        return all;
    }
    bool heard(const std::string& words) const {
        return std::any_of(heard_.begin(), heard_.end(), [&](const std::string& line) { return words_in_order(words, line); });
    }
    // "Facing north, 12 degrees".
    double heading() {
        const std::string text = ask(Command::Heading);
        const std::size_t comma = text.rfind(", ");
        return std::stod(text.substr(comma + 2));
    }
    void face(double deg) {
        for (int i = 0; i < 80; ++i) {
            const double off = std::remainder(deg - heading(), 360.0);
            if (std::abs(off) <= 3.0) return;
            tap(off > 0 ? (off > 20 ? Command::TurnRight : Command::FreeRight) : (off < -20 ? Command::TurnLeft : Command::FreeLeft), 0.25);
        }
    }
    // One hint obeyed.
    void follow() {
        const std::string hint = ask(Command::Hunt);
        last_hint = hint;
        const std::size_t go = hint.find("Go "), degrees = hint.find(" degrees");
        if (go == std::string::npos || degrees == std::string::npos) return;
        const std::size_t comma = hint.rfind(", ", degrees);
        face(std::stod(hint.substr(comma + 2)));
        const std::string way = hint.substr(go + 3);
        const int steps = way.rfind("close", 0) == 0 ? 1 : std::max(1, std::stoi(way));
        const bool door = hint.find("Open the ") != std::string::npos;
        for (int i = 0; i < steps; ++i) {
            bumped_ = false;
            tap(Command::Forward, 1.0);
            if (!bumped_) continue;
            if (door) {
                tap(Command::Use, 3.0);
            } else {
                tap(Command::Back, 1.0);
                // Something is in the way: a step to one side, and another question.
                for (int k = 0; k < 4; ++k) tap(side_ ? Command::TurnRight : Command::TurnLeft, 0.2);
                side_ = !side_;
                tap(Command::Forward, 1.0);
            }
            return;
        }
    }
    std::string last_hint;
    double now() const { return now_; }
    const std::vector<std::string>& lines() const { return heard_; }

private:
    AppCore& app_;
    double now_ = 0.0;
    bool bumped_ = false, side_ = false;
    std::vector<std::string> heard_;
};

TEST(Hunt, a_newcomer_with_keys_and_ears_wins_it_in_the_house_and_the_best_time_is_kept) {
    auto scene = read_world(std::filesystem::path(HANDRAIL_SOURCE_DIR) / "worlds" / "maps" / "house.map");
    ASSERT_TRUE(scene);
    const auto house = std::make_shared<const Scene>(std::move(*scene));
    const test::TemporaryFolder folder;
    for (int game = 0; game < 3; ++game) {
        AppCore app(Settings{}, HandFacts{});
        app.keep_records_in(folder.path());
        app.enter_world(house, 0.0);
        Newcomer newcomer(app);
        newcomer.run(0.5 + 0.37 * game);
        newcomer.tap(Command::Hunt, 0.5);
        ASSERT_TRUE(newcomer.heard("A clock is hidden and ticks"));
        int hints = 0;
        while (!newcomer.heard("You found the clock") && hints++ < 150) newcomer.follow();
        ASSERT_TRUE(newcomer.heard("You found the clock")) << "game " << game << ": " << newcomer.last_hint;
        std::cout << "game " << game << ": " << hints << " hints, " << newcomer.now() << " s\n";
        EXPECT_EQ(newcomer.heard("That is the first time here"), game == 0);
        EXPECT_EQ(newcomer.heard("best time here"), game > 0);
    }
}

}  // namespace
}  // namespace handrail
