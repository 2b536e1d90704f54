// Simulates a walker who follows the legs of directions literally and never sees the map. It turns by notches. It walks
// some steps, or until something stops it, or until the stairs are behind it. It also opens doors. A real walking body
// moves among the real solids. It walks from each room of the bundled house and school to every other room, with exact
// steps and with errors.
#include <ctime>
#include <filesystem>
#include <random>

#include "app/core/world/walker.h"
#include "app/core/world/walker_world.h"
#include "tests/support/every.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "worlds/geometry/closest_point.h"
#include "worlds/navigation/directions_route.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/models.h"

namespace handrail {
namespace literal_walker_test {

constexpr double kStep_m = 0.7;

struct Building {
    std::vector<int> thing_of_mover;
    std::shared_ptr<const Scene> scene;  // the building with its doors as separate things
    std::shared_ptr<Navigation> navigation;
    RoomGraph graph;
    std::unique_ptr<BlindGround> ground;
    std::unique_ptr<DirectionsPlanner> planner;
    std::unique_ptr<WalkerWorld> shut;

    explicit Building(const char* file) {
        auto read = read_world(test::project_root() / "worlds" / "maps" / file);
        if (!read) throw std::runtime_error(read.error().message);
        scene = std::make_shared<const Scene>(with_movers_apart(*read, 128, thing_of_mover));
        const WalkerSize size = walker_size(*scene, 0.25);
        auto made = Navigation::make(*read, walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m));
        if (!made) throw std::runtime_error(made.error().message);
        navigation = *made;
        graph = make_rooms(*read, navigation->space());
        ground = std::make_unique<BlindGround>(navigation->space(), word_doors(*scene, thing_of_mover));
        planner = std::make_unique<DirectionsPlanner>(*ground, kStep_m);
        shut = std::make_unique<WalkerWorld>(scene);
    }
    bool is_lift(std::uint32_t room) const {
        return std::any_of(graph.portals.begin(), graph.portals.end(), [&](const Portal& portal) {
            return portal.kind == PassageKind::Lift && (portal.rooms[0] == room || portal.rooms[1] == room);
        });
    }
    std::vector<std::uint32_t> rooms() const {
        std::vector<std::uint32_t> found;
        for (std::uint32_t r = 0; r < graph.rooms.size(); ++r)
            if (graph.rooms[r].kind == RoomKind::Room && !is_lift(r)) found.push_back(r);
        return found;
    }
};

// The walker's body with its abilities, and the doors, as in the program.
class Body {
public:
    explicit Body(const Building& in) : in_(in), size_(walker_size(*in.scene, 0.25)), open_(in.ground->all_shut()) {
        for (const PlacedModel& thing : in.scene->placed) things_.push_back(thing.at);
        stand_in(*in.shut);
    }
    void place(const Vec3& feet_m) { walker_->place(feet_m); }
    const Vec3& feet_m() const { return walker_->state().feet_m; }
    bool fell() const { return fell_; }

    struct Went {
        double walked_m = 0.0;
        bool stopped = false;
    };
    // Walks `most_m` towards `heading_rad`. Walks less if something stops the walker or `over` returns true.
    Went walk(double heading_rad, double most_m, const std::function<bool(double)>& over = {}) {
        constexpr double kSpeed_m_per_s = 1.2, kTick_s = 1.0 / 60.0;
        Went went;
        double intended_m = 0.0, made_m = 0.0;
        int lined_up = 0;
        while (went.walked_m < most_m - 1e-6 && !fell_) {
            const double way_m = std::min(kSpeed_m_per_s * kTick_s, most_m - went.walked_m);
            const WalkResult r = tick(forward_of_heading(heading_rad) * (way_m / kTick_s));
            went.walked_m += r.walked_m;
            intended_m += way_m;
            made_m += r.walked_m;
            if (over && over(went.walked_m)) break;
            if (intended_m < kStoppedWindow_m) continue;
            const bool slow = made_m < kStoppedBelow * intended_m;
            intended_m = made_m = 0.0;
            if (!slow) continue;
            const BlindWalker here = in_.ground->body_at(feet_m());
            const auto aside_m =
                lined_up < 2 && here.span != kNothing ? in_.ground->line_up_m(here, heading_rad, open_) : std::nullopt;
            if (!aside_m) {
                went.stopped = true;
                break;
            }
            ++lined_up;
            const Vec3 right = forward_of_heading(heading_rad + std::copysign(0.5 * kPi, *aside_m));
            for (double left_m = std::abs(*aside_m); left_m > 0.0; left_m -= kSpeed_m_per_s * kTick_s)
                tick(right * kSpeed_m_per_s);
        }
        return went;
    }
    // Opens the nearest shut door that the walker can reach.
    bool open() {
        constexpr double kReach_m = 1.2;
        const std::vector<DirectionsDoor>& doors = in_.ground->doors();
        std::size_t chosen = doors.size();
        double nearest_m2 = kReach_m * kReach_m;
        for (std::size_t d = 0; d < doors.size(); ++d) {
            if (open_[d] != DoorState::Shut || !doors[d].opens) continue;
            for (const DirectionsDoor::Leaf& leaf : doors[d].leaves) {
                const double far_m2 =
                    distance_squared(placed_bounds(leaf.own_m, leaf.shut), feet_m() + Vec3(0.0, 0.0, 1.0));
                if (far_m2 >= nearest_m2) continue;
                nearest_m2 = far_m2;
                chosen = d;
            }
        }
        if (chosen == doors.size()) return false;
        open_[chosen] = DoorState::Open;
        for (std::uint32_t m = 0; m < in_.scene->movers.size(); ++m) {
            if (in_.scene->movers[m].group != doors[chosen].group) continue;
            if (in_.thing_of_mover[m] >= 0)
                things_[static_cast<std::size_t>(in_.thing_of_mover[m])] = in_.scene->movers[m].at(1.0);
        }
        own_ = std::make_unique<WalkerWorld>(*in_.shut, in_.scene, things_);
        stand_in(*own_);
        return true;
    }

private:
    void stand_in(const WalkerWorld& world) {
        auto moved = std::make_unique<Walker>(world, size_);
        if (walker_) moved->resume(walker_->state());
        walker_ = std::move(moved);
    }
    WalkResult tick(const Vec3& intended) {
        const WalkResult r = walker_->tick(intended, 1.0 / 60.0);
        fell_ = fell_ || r.fell_m > 0.4;
        return r;
    }

    const Building& in_;
    WalkerSize size_;
    DoorsOpen open_;
    std::vector<Placement> things_;
    std::unique_ptr<WalkerWorld> own_;
    std::unique_ptr<Walker> walker_;
    bool fell_ = false;
};

// The content of a leg, as the session announces it.
struct SaidLeg {
    int turn_notches = 0, steps = 0;
    PaceEnd end = PaceEnd::Steps;
    bool open = false;
};
std::vector<SaidLeg> said_legs(const DirectionsRoute& route) {
    std::vector<SaidLeg> legs;
    for (const DirectionsLeg& leg : route.legs)
        legs.push_back({leg.turn_notches, leg.steps, leg.end, leg.door != kNothing});
    return legs;
}

struct Errors {
    double step_part = 0.0, turn_rad = 0.0, start_m = 0.0;
};

// Follows the legs. The function knows only the legs and the body's own movements.
void follow(Body& body, const std::vector<SaidLeg>& legs, const Errors& errors, std::mt19937_64& random) {
    std::uniform_real_distribution<double> either(-1.0, 1.0);
    int notch = 0;
    double off_rad = errors.turn_rad * either(random);
    for (const SaidLeg& leg : legs) {
        notch += leg.turn_notches;
        if (leg.turn_notches != 0) off_rad = errors.turn_rad * either(random);
        const double heading_rad = notch_heading_rad(notch) + off_rad;
        const double step_m = kStep_m * (1.0 + errors.step_part * either(random));
        if (leg.end == PaceEnd::Steps) {
            body.walk(heading_rad, leg.steps * step_m);
        } else if (leg.end == PaceEnd::Stopped) {
            body.walk(heading_rad, 2.0 * leg.steps * step_m + 4.0);
        } else {
            const double from_z = body.feet_m().z;
            double level_z = from_z, level_from_m = 0.0;
            body.walk(heading_rad, 2.0 * leg.steps * step_m + 4.0, [&](double walked_m) {
                if (std::abs(body.feet_m().z - level_z) > 0.03) {
                    level_z = body.feet_m().z;
                    level_from_m = walked_m;
                }
                return std::abs(level_z - from_z) > kFlightRise_m && walked_m - level_from_m > kFlightOver_m;
            });
        }
        if (leg.open) body.open();
    }
}

struct Counted {
    int routes = 0, without = 0, exact = 0, with_errors = 0, runs = 0;
    double longest_ms = 0.0, all_ms = 0.0;
    int legs = 0;
    std::string missed;
};

// Returns whether a walker can stand at `at_m`. Also checks the height, because the car of a lift may be elsewhere.
bool stands(const Building& in, const Vec3& at_m) {
    Body body(in);
    body.place(at_m);
    body.walk(0.0, 0.01);
    return std::abs(body.feet_m().z - at_m.z) < 0.1;
}

// Walks between pairs of rooms and counts the successes. `every` is the stride between the tried pairs.
Counted count(const Building& in, int seeds, std::uint32_t every = 1) {
    Counted counted;
    const std::vector<std::uint32_t> rooms = in.rooms();
    for (const std::uint32_t to : rooms) {
        const DirectionsGoal goal = goal_in_room(in.navigation->space(), in.graph.room_of_span, to);
        for (const std::uint32_t from : rooms) {
            const Vec3 start = in.graph.rooms[from].middle_m;
            if (!stands(in, start)) continue;
            if (from == to || (7 * from + 3 * to) % every != 0 ||
                !in.navigation->reachable(start, in.graph.rooms[to].middle_m))
                continue;
            ++counted.routes;
            const std::clock_t before = std::clock();
            const auto route = in.planner->plan(start, 0.0, goal, in.ground->all_shut());
            const double ms = 1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
            counted.longest_ms = std::max(counted.longest_ms, ms);
            counted.all_ms += ms;
            const std::string name = in.graph.rooms[from].name + " to " + in.graph.rooms[to].name;
            counted.runs += seeds;
            if (!route) {
                ++counted.without;
                counted.missed += fmt::format("{}: no route, {:.0f} ms\n", name, ms);
                continue;
            }
            counted.legs += static_cast<int>(route->legs.size());
            const auto reaches = [&](const Errors& errors, std::uint64_t seed) {
                std::mt19937_64 random(seed);
                std::uniform_real_distribution<double> either(-1.0, 1.0);
                Body body(in);
                body.place(start);
                const double way_rad = kPi * either(random);
                const double off_m = errors.start_m * std::sqrt(std::abs(either(random)));
                if (off_m > 0.0) body.walk(way_rad, off_m);
                follow(body, said_legs(*route), errors, random);
                return !body.fell() && room_at(in.graph, in.navigation->space(), body.feet_m()) == to;
            };
            const bool exact = reaches({}, 0);
            counted.exact += exact ? 1 : 0;
            int came = 0;
            std::string lost;
            for (int seed = 1; seed <= seeds; ++seed)
                if (reaches({0.1, 5.0 * kPi / 180.0, 0.3}, static_cast<std::uint64_t>(seed + seeds * counted.routes)))
                    ++came;
                else lost += fmt::format(" {}", seed + seeds * counted.routes);
            counted.with_errors += came;
            if (!exact || came < seeds)
                counted.missed +=
                    fmt::format("{}: exact {}, planned {}/{}, seeds lost{}; {} legs, {:.0f} ms\n", name,
                                exact ? "yes" : "NO", route->came, kWordTrials, lost, route->legs.size(), ms);
        }
    }
    fmt::print(
        "{} routes, {} without; exact {}, with errors {} of {}; {:.1f} legs on average; planned in {:.0f} ms on "
        "average, {:.0f} at most\n{}",
        counted.routes, counted.without, counted.exact, counted.with_errors, counted.runs,
        static_cast<double>(counted.legs) / std::max(1, counted.routes - counted.without),
        counted.all_ms / std::max(1, counted.routes), counted.longest_ms, counted.missed);
    return counted;
}

TEST(LiteralWalker, gets_from_each_room_of_the_house_to_each_other) {
    const Building house("house.map");
    const Counted counted = count(house, 5, test::every(11, 41));
    EXPECT_GT(counted.routes, 1);
    EXPECT_TRUE(test::enough(counted.exact, counted.routes, 98));
    EXPECT_TRUE(test::enough(counted.with_errors, counted.runs, 95));
}

TEST(LiteralWalker, gets_from_each_room_of_the_school_to_each_other) {
    const Building school("school.map");
    const Counted counted = count(school, 5, test::every(97, 211));
    EXPECT_GT(counted.routes, 1);
    EXPECT_EQ(counted.without, 0);
    // The shares of successful walks that the directions achieve now. The goals are 98 and 95 percent.
    EXPECT_TRUE(test::enough(counted.exact, counted.routes, 98));
    EXPECT_TRUE(test::enough(counted.with_errors, counted.runs, 90));
}

}  // namespace literal_walker_test
}  // namespace handrail
