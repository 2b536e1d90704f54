// Simulates a walker who follows the announced directions exactly. The walker turns by notches. It walks some steps, or
// until something stops it, or until the stairs are behind it. It also opens doors and requests the next leg. The
// walker understands the form of legs in two languages, but knows neither the map nor where it is. The session is a
// real session. The walker goes from each room to every other room.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <random>

#include "tests/support/every.h"
#include "tests/support/heard_legs.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/core/app_session.h"
#include "worlds/base/language.h"
#include "worlds/navigation/directions_route.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"

namespace handrail {
namespace word_way_test {

using test::english_legs;
using test::every;
using test::german_legs;
using test::HeardLeg;
using test::LegForm;
using test::understood;

struct Errors {
    double step_part = 0.0, turn_rad = 0.0, start_m = 0.0;
};
constexpr Errors kExact{}, kUsual{0.1, 5.0 * kPi / 180.0, 0.3};

class Literal {
public:
    Literal(std::shared_ptr<const Scene> world, const LegForm& form) : form_(form) {
        person_.app.apply(WorldEntered{make_ready(std::move(world))}, person_.now);
        person_.run(0.1);
        person_.request(Command::Exits);  // so that the session knows the rooms from now on
    }
    // Shuts each door that the walker opened, from the place where the walker opened it, so that all doors are as
    // before.
    void shut_all() {
        if (!there()) person_.request(Command::TakeMe);  // a second TakeMe stops following the route
        for (; !opened_.empty(); opened_.pop_back()) {
            person_.app.apply(Placed{opened_.back().first, opened_.back().second}, person_.now);
            person_.run(0.1);
            person_.request(Command::Use);
            person_.run(3.0);
        }
    }
    // Walks from `from_m` to the room called `room`. Returns the walker's final place.
    Vec3 go(const Vec3& from_m, const std::string& room, const Errors& errors, std::uint64_t seed) {
        random_.seed(seed);
        errors_ = errors;
        person_.app.apply(Placed{from_m, 0.0}, person_.now);
        person_.run(0.1);
        if (errors.start_m > 0.0) {
            const double way_rad = kPi * either(), off_m = errors.start_m * std::sqrt(std::abs(either()));
            drift(off_m, way_rad);
        }
        person_.said.clear();
        person_.request(Command::Routes);
        person_.line(room);
        first_ = true;
        std::string leg = person_.request(Command::RepeatLeg);
        for (legs_ = 0; legs_ < 60 && !there(); ++legs_) {
            const auto requested = understood(leg, form_);
            if (!requested) break;
            do_as_requested(*requested);
            if (there()) break;
            leg = person_.request(Command::NextLeg);
        }
        return person_.app.feet_m();
    }
    bool there() const { return person_.heard(form_.there); }
    std::string last_lines() const {
        std::string all;
        for (const std::string& line : person_.said) all += "    " + line + "\n";
        return all;
    }
    int legs() const { return legs_; }
    const Vec3& feet_m() const { return person_.app.feet_m(); }

private:
    double either() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
    void wait() {
        for (int i = 0; i < 6000 && !person_.app.idle(); ++i) person_.run(1.0 / 60.0);
        person_.run(0.15);
    }
    // Moves the walker away from its place before the walk, so that the walk does not begin exactly where it should.
    void drift(double way_m, double way_rad) {
        person_.app.apply(Steered{{std::cos(way_rad), std::sin(way_rad), 0.0}}, person_.now);
        person_.run(way_m / person_.app.settings().walk.speed_m_per_s);
        person_.app.apply(Steered{{}}, person_.now);
        person_.run(0.1);
    }
    void do_as_requested(const HeardLeg& requested) {
        if (requested.turn_notches != 0) {
            const Command turn = requested.turn_notches > 0 ? Command::TurnRight : Command::TurnLeft;
            person_.app.apply(CommandDown{turn, std::abs(requested.turn_notches)}, person_.now);
            person_.app.apply(CommandUp{turn}, person_.now);
            wait();
        }
        if ((requested.turn_notches != 0 || first_) && errors_.turn_rad > 0.0) turn_wrong(errors_.turn_rad * either());
        first_ = false;
        const std::size_t said = person_.said.size();
        const double step_m = person_.app.settings().walk.step_length_m;
        const double part = 1.0 + errors_.step_part * either();
        if (part != 1.0) set_step(step_m * part);
        if (requested.until == HeardLeg::Until::FlightOver) walk_until_over(said, requested.steps);
        else walk(requested.until == HeardLeg::Until::Counted ? requested.steps : 2 * requested.steps + 6);
        if (part != 1.0) set_step(step_m);
        if (!requested.use) return;
        opened_.emplace_back(person_.app.feet_m(), person_.app.heading_rad());
        person_.request(Command::Use);
        person_.run(3.0);
    }
    void set_step(double step_m) {
        EXPECT_TRUE(person_.app.apply(SettingSet{"walk.step_length_m", fmt::format("{:.4f}", step_m)}, person_.now));
    }
    void walk(int steps) {
        person_.app.apply(CommandDown{Command::Forward, steps}, person_.now);
        person_.app.apply(CommandUp{Command::Forward}, person_.now);
        wait();
    }
    // Walks until the session announces the end of the flight of stairs, and then releases the key.
    void walk_until_over(std::size_t said, int steps) {
        person_.app.apply(CommandDown{Command::Forward}, person_.now);
        for (int i = 0; i < 60 * (30 + 2 * steps); ++i) {
            person_.run(1.0 / 60.0);
            for (; said < person_.said.size(); ++said)
                if (person_.said[said].find(form_.landed_up) == 0 || person_.said[said].find(form_.landed_down) == 0)
                    i = 1000000;
        }
        person_.app.apply(CommandUp{Command::Forward}, person_.now);
        wait();
    }
    void turn_wrong(double by_rad) {
        constexpr double kRate_rad_per_s = 1.6;
        const int ticks = std::max(1, static_cast<int>(std::ceil(std::abs(by_rad) / kRate_rad_per_s * 60.0)));
        person_.app.apply(Steered{{0.0, 0.0, by_rad * 60.0 / kRate_rad_per_s / ticks}}, person_.now);
        for (int i = 0; i < ticks; ++i) person_.run(1.0 / 60.0);
        person_.app.apply(Steered{{}}, person_.now);
        wait();
    }

    const LegForm& form_;
    test::AppSession person_;
    Errors errors_;
    std::mt19937_64 random_;
    std::vector<std::pair<Vec3, double>> opened_;
    bool first_ = true;
    int legs_ = 0;
};

// What the judge of the walks knows about the world. The walker does not know any of it.
struct Judge {
    std::shared_ptr<Navigation> navigation;
    RoomGraph graph;

    explicit Judge(const Scene& scene) {
        const WalkerSize size = walker_size(scene, 0.25);
        auto made = Navigation::make(scene, walker_measures(scene, size.radius_m, size.height_m, size.step_up_m));
        if (!made) throw std::runtime_error(made.error().message);
        navigation = *made;
        graph = make_rooms(scene, navigation->space());
    }
    std::vector<std::uint32_t> rooms() const {
        std::vector<std::uint32_t> found;
        for (std::uint32_t r = 0; r < graph.rooms.size(); ++r)
            if (graph.rooms[r].kind == RoomKind::Room && !is_lift(r)) found.push_back(r);
        return found;
    }
    bool is_lift(std::uint32_t room) const {
        return std::any_of(graph.portals.begin(), graph.portals.end(), [&](const Portal& portal) {
            return portal.kind == PassageKind::Lift && (portal.rooms[0] == room || portal.rooms[1] == room);
        });
    }
    // Returns true if the route uses only floors and stairs, as routes for directions do.
    bool walks(const Vec3& from_m, const Vec3& to_m) const {
        const Route route = navigation->plan(from_m, to_m);
        return route.reaches && route.points_m.size() > 1 &&
               std::none_of(route.passages.begin(), route.passages.end(), [](const RoutePassage& passage) {
                   return passage.kind == PassageKind::Lift || passage.kind == PassageKind::Teleporter ||
                          passage.kind == PassageKind::Drop;
               });
    }
};

struct Counted {
    int routes = 0, came = 0, legs = 0;
};

// Walks one route after another. The random errors of the walks use `seed` and the numbers after it.
class Routes {
public:
    Routes(const std::shared_ptr<const Scene>& world, const LegForm& form, const Errors& errors, std::uint64_t seed)
        : judge_(*world), literal_(world, form), errors_(errors), seed_(seed), base_m_(literal_.feet_m()) {}

    // Walks from each room to every other room. `every` is the stride between the tried pairs.
    Counted between_rooms(std::uint32_t every) {
        for (const std::uint32_t from : judge_.rooms())
            for (const std::uint32_t to : judge_.rooms())
                if (from != to && (7 * from + 3 * to) % every == 0)
                    walk(judge_.graph.rooms[from].middle_m, judge_.graph.rooms[from].name, to);
        return counted();
    }
    // Walks from the entrance to each room.
    Counted from_base(std::uint32_t every) {
        for (const std::uint32_t to : judge_.rooms())
            if (to % every == 0 && room_at(judge_.graph, judge_.navigation->space(), base_m_) != to)
                walk(base_m_, "base", to);
        return counted();
    }

private:
    void walk(const Vec3& start_m, const std::string& from, std::uint32_t to) {
        if (!judge_.walks(start_m, judge_.graph.rooms[to].middle_m)) return;
        const std::uint64_t seed = seed_ + static_cast<std::uint64_t>(++counted_.routes);
        const std::string name = capitalised(judge_.graph.rooms[to].name);
        const Vec3 end = literal_.go(start_m, name, errors_, seed);
        const bool came = literal_.there() && room_at(judge_.graph, judge_.navigation->space(), end) == to;
        counted_.came += came ? 1 : 0;
        counted_.legs += literal_.legs();
        if (!came)
            fmt::print("  {} to {}, seed {}, ends at {:.2f} {:.2f} {:.2f}\n{}", from, name, seed, end.x, end.y, end.z,
                       literal_.last_lines());
        literal_.shut_all();
    }
    Counted counted() const {
        fmt::print("seeds from {}: {} of {} came, {:.1f} legs each\n", seed_, counted_.came, counted_.routes,
                   static_cast<double>(counted_.legs) / std::max(1, counted_.routes));
        return counted_;
    }

    Judge judge_;
    Literal literal_;
    Errors errors_;
    std::uint64_t seed_;
    Vec3 base_m_;
    Counted counted_;
};

Counted count(const std::shared_ptr<const Scene>& world, const LegForm& form, std::uint32_t every, const Errors& errors,
              std::uint64_t seed) {
    return Routes(world, form, errors, seed).between_rooms(every);
}

void expect_share(const Counted& counted, int percent) {
    EXPECT_GT(counted.routes, 0);
    EXPECT_TRUE(test::enough(counted.came, counted.routes, percent)) << counted.came << " of " << counted.routes;
}

TEST(LiteralSession, gets_from_each_room_of_the_house_to_each_other_with_exact_steps) {
    expect_share(count(test::our_world("house.map"), english_legs(), every(8, 41), kExact, 0), 98);
}

TEST(LiteralSession, gets_from_each_room_of_the_house_to_each_other_with_walking_errors) {
    expect_share(count(test::our_world("house.map"), english_legs(), every(11, 47), kUsual, test::seed_of_run()), 95);
}

TEST(LiteralSession, reaches_the_goal_in_german_with_exact_steps) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "under a sanitizer the walks with errors are enough";
    const test::InLanguage german_spoken("de");
    expect_share(count(test::our_world("house.map"), german_legs(), every(17, 53), kExact, 0), 98);
}

TEST(LiteralSession, reaches_the_goal_in_german_with_walking_errors) {
    const test::InLanguage german_spoken("de");
    expect_share(count(test::our_world("house.map"), german_legs(), every(19, 59), kUsual, test::seed_of_run()), 95);
}

TEST(LiteralSession, gets_from_room_to_room_of_the_school_with_exact_steps) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "under a sanitizer the walks with errors are enough";
    expect_share(count(test::our_world("school.map"), english_legs(), every(97, 211), kExact, 0), 98);
}

TEST(LiteralSession, gets_from_room_to_room_of_the_school_with_walking_errors) {
    expect_share(count(test::our_world("school.map"), english_legs(), every(113, 223), kUsual, test::seed_of_run()),
                 95);
}

TEST(LiteralSession, gets_from_room_to_room_of_the_school_in_german) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "under a sanitizer German in the house is enough";
    const test::InLanguage german_spoken("de");
    expect_share(count(test::our_world("school.map"), german_legs(), every(211, 211), kExact, 0), 98);
    expect_share(count(test::our_world("school.map"), german_legs(), every(223, 223), kUsual, test::seed_of_run()), 95);
}

void comes_from_the_base(const char* map, int percent_exact, int percent_with_errors, std::uint32_t usual = 1) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "takes minutes under a sanitizer";
    const auto file = test::real_world(map);
    if (!file) GTEST_SKIP() << test::needs_real_world(map);
    const LegForm form = english_legs();
    const auto world = test::world_in(*file);
    expect_share(Routes(world, form, kExact, 0).from_base(every(usual, usual)), percent_exact);
    expect_share(Routes(world, form, kUsual, test::seed_of_run()).from_base(every(usual, usual)), percent_with_errors);
}

TEST(LiteralSession, gets_from_the_base_to_the_rooms_of_the_first_tutorial_map) {
    comes_from_the_base("agtut01.map", 98, 95);
}

TEST(LiteralSession, gets_from_the_base_to_the_rooms_of_the_third_tutorial_map) {
    comes_from_the_base("agtut03.map", 98, 95, 3);
}

TEST(LiteralSession, gets_from_the_base_to_rooms_of_the_melee) { comes_from_the_base("agdm01.map", 98, 95, 7); }

}  // namespace word_way_test
}  // namespace handrail
