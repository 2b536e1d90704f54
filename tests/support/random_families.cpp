#include "tests/support/random_families.h"
#include "tests/support/names.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>

namespace handrail::test {
namespace {

class Draw {
public:
    explicit Draw(std::uint32_t seed) : random_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
    }
    // Draws a number that is uniform in its logarithm, for sizes that matter over many orders of magnitude.
    double power(double low, double high) { return low * std::pow(high / low, between(0.0, 1.0)); }
    int count(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<std::uint32_t>(high - low + 1));
    }
    bool coin() { return random_() % 2 == 0; }
    Vec3 in_cube(double half) {
        const double x = between(-half, half), y = between(-half, half), z = between(-half, half);
        return {x, y, z};
    }
    std::mt19937& engine() { return random_; }

private:
    std::mt19937 random_;
};

constexpr double kSlab_m = 0.1;  // half the width of planes and slabs

// Draws a radius for the proxy. Usually a proxy of this radius can feel edges; sometimes the radius is that of nearly a
// point.
double some_radius(Draw& draw) { return draw.count(0, 4) == 0 ? 1e-5 : draw.between(0.002, 0.006); }

// Draws a path of a hand that comes from the air, presses across a horizontal surface at z = 0 and returns to the air.
std::vector<Vec3> over_level(Draw& draw, int stops) {
    std::vector<Vec3> way{{draw.between(-.05, .05), draw.between(-.05, .05), .02}};
    for (int i = 0; i < stops; ++i)
        way.emplace_back(draw.between(-.05, .05), draw.between(-.05, .05), -draw.between(0.001, 0.012));
    way.emplace_back(way.front());
    return hand_path(way, draw.between(0.05, 0.5));
}

// Draws a path of a hand that comes from outside a cube, moves to places in it and leaves it.
std::vector<Vec3> anywhere(Draw& draw, double half, int stops, double speed) {
    std::vector<Vec3> way{{draw.between(-half, half) * 0.1, 0.0, 2.0 * half}};
    for (int i = 0; i < stops; ++i) way.push_back(draw.in_cube(half));
    way.push_back(way.front());
    return hand_path(way, speed);
}

void level(TouchWorld& world, double from_x, double to_x) {
    world.quad({from_x, -kSlab_m, 0}, {to_x, -kSlab_m, 0}, {to_x, kSlab_m, 0}, {from_x, kSlab_m, 0});
}

// T1: a plane made of strips whose ends do not meet.
void strips(TouchCase& c, Draw& draw) {
    const double seam = draw.between(-.03, .03);
    level(c.world, -kSlab_m, seam);
    double y = -kSlab_m;
    for (int left = draw.count(2, 7); left > 0; --left) {
        const double to = left == 1 ? kSlab_m : y + (kSlab_m - y) * draw.between(0.1, 0.6);
        c.world.quad({seam, y, 0}, {kSlab_m, y, 0}, {kSlab_m, to, 0}, {seam, to, 0});
        y = to;
    }
    c.concave = true;
    c.goals_m = over_level(draw, 6);
}

// T2: a crack.
void crack(TouchCase& c, Draw& draw) {
    const double at = draw.between(-.02, .02), width = draw.power(1e-6, 1e-3);
    c.radius_m = std::max(some_radius(draw), 0.6 * width);
    level(c.world, -kSlab_m, at);
    level(c.world, at + width, kSlab_m);
    c.tidy = false;  // some goals have two places of rest, one in the dip and one on its far side
    c.goals_m = over_level(draw, 6);
}

// T3, T4: two or three overlapping boxes that form an inner edge or corner, in any representation.
void corner(TouchCase& c, Draw& draw) {
    const auto put = [&](const Vec3& low, const Vec3& high) {
        const int kind = draw.count(0, 2);
        if (kind == 0) c.world.box(low, high);
        else if (kind == 1) c.world.brush_box(low, high);
        else c.world.box_of_triangles(low, high);
    };
    const double depth = draw.between(.02, .06);
    put({-.06, -.06, -depth}, {.06, .06, 0});
    put({draw.between(.005, .015), -.07, -draw.between(0.0, depth)}, {.07, .07, .06});
    if (draw.coin()) put({-.07, draw.between(.02, .03), -draw.between(0.0, depth)}, {.07, .08, .05});
    const double speed = draw.between(0.05, 0.5);
    std::vector<Vec3> way{{-.02, 0, .02}};
    for (int i = 0; i < 6; ++i)
        way.emplace_back(draw.between(-.03, .03), draw.between(-.03, .035), -draw.between(0.0, 0.01));
    way.emplace_back(-.02, 0, .02);
    c.concave = true;
    c.goals_m = hand_path(way, speed);
}

// T5: a groove.
void groove(TouchCase& c, Draw& draw) {
    const double half = radians_from_degrees(draw.power(0.5, 60.0)) / 2, deep = 0.3, x = std::tan(half) * deep;
    c.world.quad({0, -kSlab_m, 0}, {-x, -kSlab_m, deep}, {-x, kSlab_m, deep}, {0, kSlab_m, 0});
    c.world.quad({0, -kSlab_m, 0}, {x, -kSlab_m, deep}, {x, kSlab_m, deep}, {0, kSlab_m, 0});
    c.radius_m = std::min(draw.between(.002, .006), 0.45 * deep * std::sin(half));
    const double z = c.radius_m / std::sin(half) + .02;
    std::vector<Vec3> way{{0, 0, z}};
    for (int i = 0; i < 5; ++i)
        way.emplace_back(draw.between(-.005, .005), draw.between(-.02, .02), z - draw.between(.01, .06));
    way.emplace_back(0, 0, z);
    c.concave = true;
    c.goals_m = hand_path(way, draw.between(0.05, 0.3));
}

// T6: a hand that passes over the edges of a box.
void edge(TouchCase& c, Draw& draw) {
    const Vec3 half(draw.between(.01, .03), draw.between(.01, .03), draw.between(.01, .03));
    if (draw.coin()) c.world.box(-half, half);
    else c.world.box_of_triangles(-half, half);
    c.goals_m = anywhere(draw, .04, 12, draw.between(0.05, 0.3));
}

// T7: a spike.
void spike(TouchCase& c, Draw& draw) {
    const double wide = .1 * std::tan(radians_from_degrees(draw.between(8.0, 45.0)) / 2);
    const int sides = draw.count(3, 6);
    const double turn = draw.between(0.0, kPi);
    const auto corner_at = [&](int i) {
        return Vec3(wide * std::cos(turn + 2 * kPi * i / sides), wide * std::sin(turn + 2 * kPi * i / sides), -.1);
    };
    for (int i = 0; i < sides; ++i) c.world.triangle({0, 0, 0}, corner_at(i), corner_at(i + 1));
    std::vector<Vec3> way{{.001, .0004, .02}};
    for (int i = 0; i < 8; ++i)
        way.emplace_back(draw.between(-.02, .02), draw.between(-.02, .02), draw.between(-.02, .003));
    way.emplace_back(.001, .0004, .02);
    c.tidy = false;
    c.goals_m = hand_path(way, 0.1);
}

// T8, T10: a plane with duplicates, overlaps and many degenerate triangles without area.
void litter(TouchCase& c, Draw& draw) {
    for (int i = draw.count(1, 3); i > 0; --i) level(c.world, -kSlab_m, kSlab_m);
    for (int i = draw.count(1, 3); i > 0; --i) level(c.world, draw.between(-.05, 0), draw.between(.01, .05));
    for (int i = draw.count(1, 5); i > 0; --i) {
        const Vec3 at(draw.between(-.04, .04), draw.between(-.04, .04), 0),
            along(draw.between(-.04, .04), draw.between(-.04, .04), 0);
        c.world.triangle(at, at + along * draw.between(0.0, 1.0), at + along);
        c.world.triangle(at, at, at);
    }
    c.concave = true;
    c.goals_m = over_level(draw, 6);
}

// T9: sliver triangles.
void slivers(TouchCase& c, Draw& draw) {
    const double height = 0.2 / draw.power(1e2, 1e7);
    const int strips = draw.count(4, 24);
    double y = -strips * height / 2;
    c.world.quad({-kSlab_m, -kSlab_m, 0}, {kSlab_m, -kSlab_m, 0}, {kSlab_m, y, 0}, {-kSlab_m, y, 0});
    for (int i = 0; i < strips; ++i, y += height)
        c.world.quad({-kSlab_m, y, 0}, {kSlab_m, y, 0}, {kSlab_m, y + height, 0}, {-kSlab_m, y + height, 0});
    c.world.quad({-kSlab_m, y, 0}, {kSlab_m, y, 0}, {kSlab_m, kSlab_m, 0}, {-kSlab_m, kSlab_m, 0});
    c.tidy = false;
    c.goals_m = over_level(draw, 6);
}

// T11, T12: a thin wall or a sheet, crossed at high speed.
void thin(TouchCase& c, Draw& draw) {
    if (draw.coin()) {
        const double half = draw.power(1e-6, 1e-3);
        c.world.box({-half, -kSlab_m, -kSlab_m}, {half, kSlab_m, kSlab_m});
    } else {
        c.world.quad({0, -kSlab_m, -kSlab_m}, {0, kSlab_m, -kSlab_m}, {0, kSlab_m, kSlab_m}, {0, -kSlab_m, kSlab_m});
    }
    const double side = draw.coin() ? 1.0 : -1.0;
    std::vector<Vec3> way{{-.05 * side, 0, 0}};
    for (int i = 0; i < 6; ++i)
        way.emplace_back(draw.between(-.05, .05), draw.between(-.04, .04), draw.between(-.04, .04));
    way.emplace_back(-.05 * side, 0, 0);
    c.concave = true;
    c.goals_m = hand_path(way, draw.between(1.0, 6.0));
}

// T13, T14: a corner, touched by a hand that stalls, trembles and is measured in coarse steps.
void rough_hand(TouchCase& c, Draw& draw) {
    corner(c, draw);
    const std::vector<Vec3> all = c.goals_m;
    const int keep = draw.count(1, 50);
    const double noise = draw.power(1e-6, 2e-4), quantum = draw.power(1e-6, 2e-4);
    c.goals_m.clear();
    for (std::size_t i = 0; i < all.size(); i += i == 0 ? 1 : static_cast<std::size_t>(keep))
        c.goals_m.push_back(glm::round((all[i] + (i == 0 ? Vec3(0.0) : draw.in_cube(noise))) / quantum) * quantum);
}

// T16: a soup of triangles.
void soup(TouchCase& c, Draw& draw) {
    c.radius_m = some_radius(draw);
    c.world.random_triangles(draw.engine(), draw.count(20, 200), .03, draw.between(.005, .03));
    c.tidy = false;
    c.goals_m = anywhere(draw, .05, 12, 0.5);
}

// T16: a heap of convex solids.
void heap(TouchCase& c, Draw& draw) {
    c.radius_m = some_radius(draw);
    for (int i = draw.count(5, 20); i > 0; --i)
        c.world.random_brush(draw.engine(), draw.in_cube(.04), draw.between(.005, .02), draw.count(0, 4));
    c.tidy = false;
    c.goals_m = anywhere(draw, .06, 12, 0.5);
}

struct Family {
    const char* name;
    void (*fill)(TouchCase&, Draw&);
};
constexpr Family kFamilies[] = {{"strips", strips},         {"crack", crack},     {"corner", corner},
                                {"groove", groove},         {"edge", edge},       {"spike", spike},
                                {"litter", litter},         {"slivers", slivers}, {"thin", thin},
                                {"rough hand", rough_hand}, {"soup", soup},       {"heap", heap}};
static_assert(std::size(kFamilies) == kRandomFamilies);

}  // namespace

TouchCase random_case(std::size_t family, std::uint32_t seed) {
    const Family& chosen = kFamilies[family];
    Draw draw(seed * 7919U + static_cast<std::uint32_t>(family));
    TouchCase c;
    c.name = std::string("random ") + chosen.name;
    c.radius_m = draw.between(0.002, 0.006);
    chosen.fill(c, draw);
    return c;
}

std::uint32_t seed_of_run() {
    static const std::uint32_t seed = [] {
        const char* set = std::getenv("HANDRAIL_SEED");
        return set != nullptr ? static_cast<std::uint32_t>(std::strtoul(set, nullptr, 10))
                              : static_cast<std::uint32_t>(std::random_device{}() % 1000000U);
    }();
    return seed;
}

}  // namespace handrail::test
