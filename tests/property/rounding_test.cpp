// Tests that rounded edges are exact at edges and corners, and leave surfaces next to them unchanged. If solids are
// flush there is no groove, and no edge gives energy. The tests use random worlds and print their seeds.
#include <iostream>

#include "haptic/compile/compile_haptic.h"
#include "tests/property/closed_loops.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/touch_worlds.h"
#include "worlds/geometry/clip.h"
#include "worlds/scene/surfaces.h"

namespace handrail::test {
namespace rounding_test {

constexpr double kRounding_m = 0.04;

std::vector<Plane> box_planes(const Vec3& low, const Vec3& high) {
    std::vector<Plane> planes;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 n(0.0);
        n[axis] = 1.0;
        planes.push_back({n, high[axis]});
        planes.push_back({-n, -low[axis]});
    }
    return planes;
}

Plane moved(const Plane& plane, const Motion& motion) {
    const Vec3 normal = motion.turn * plane.normal;
    return {normal, glm::dot(normal, motion(plane.normal * plane.offset_m))};
}

// Solids in the form that a reader gives them, including which faces cover which.
class Building {
public:
    void add(std::vector<Plane> planes, const Motion& motion = {}) {
        for (Plane& plane : planes) plane = moved(plane, motion);
        BuiltSolid built = solid_from_planes(planes, motion.shift_m, 20.0, {1e-9, 1e-8});
        if (built.fault != SolidFault::None || built.was_inside_out) return;
        Solid solid;
        solid.shape = std::move(built.solid);
        solid.face_materials.assign(solid.shape.planes.size(), kDefaultMaterial);
        scene.solids.push_back(std::move(solid));
    }
    void finish() {
        scene.materials.emplace_back();
        std::vector<std::vector<FaceLook>> looks;
        for (const Solid& solid : scene.solids) looks.emplace_back(solid.shape.planes.size(), 1);
        derive_surfaces(scene, looks, 1.0);
    }
    bool inside(const Vec3& p, double grow_m) const {
        return std::any_of(scene.solids.begin(), scene.solids.end(),
                           [&](const Solid& s) { return contains(s.shape, p, grow_m); });
    }
    std::shared_ptr<const HapticScene> compiled(double rounding_m, RoundingReport* report = nullptr) const {
        CompileOptions options;
        options.edge_rounding_m = rounding_m;
        CompileReport done;
        auto haptic = compile_haptic(scene, options, &done);
        if (report) *report += done.rounding;
        return haptic;
    }

    Scene scene;
};

double distance(const HapticScene& scene, const Vec3& p) {
    double nearest = 1e9;
    for (std::uint32_t i = 0; i < scene.obstacles.size(); ++i)
        nearest = std::min(nearest, scene.closest(i, p - scene.origin_m).distance_m);
    return nearest;
}

// Returns one convex block that is cut into many pieces. A hand can touch only the faces of the block.
Building cut_block(std::mt19937& random) {
    std::vector<Plane> block = box_planes(Vec3(-0.5 - unit(random)), Vec3(0.5 + unit(random)));
    for (int i = static_cast<int>(random() % 4); i > 0; --i) {
        const Vec3 n = glm::normalize(Vec3(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5));
        block.push_back({n, 0.4 + 0.3 * unit(random)});
    }
    std::vector<std::vector<Plane>> pieces{block};
    const int cuts = 1 + static_cast<int>(random() % 3);
    for (int i = 0; i < cuts; ++i) {
        Vec3 n(0.0);
        if (random() % 2 == 0) n[static_cast<int>(random() % 3)] = 1.0;
        else n = glm::normalize(Vec3(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5));
        const Plane cut{n, 0.4 * (unit(random) - 0.5)};
        std::vector<std::vector<Plane>> next;
        for (const std::vector<Plane>& piece : pieces) {
            if (pieces.size() > 1 && random() % 4 == 0) {
                next.push_back(piece);
                continue;
            }
            next.push_back(piece);
            next.back().push_back(cut);
            next.push_back(piece);
            next.back().push_back({-cut.normal, -cut.offset_m});
        }
        pieces = std::move(next);
    }
    const Motion motion = random() % 3 == 0 ? Motion{} : random_turn(random);
    Building building;
    for (const std::vector<Plane>& piece : pieces) building.add(piece, motion);
    building.finish();
    return building;
}

// Returns boxes on an uneven grid, some joined to larger ones. They are flush and cover each other in every way: partly
// and wholly, in T-joints, windmills and inner corners.
Building blocks(std::mt19937& random) {
    constexpr int kCells = 4;
    std::array<std::array<double, kCells + 1>, 3> at{};
    for (auto& axis : at)
        for (int i = 1; i <= kCells; ++i)
            axis[static_cast<std::size_t>(i)] = axis[static_cast<std::size_t>(i) - 1] + 0.15 + 0.5 * unit(random);
    std::array<std::array<std::array<bool, kCells>, kCells>, kCells> taken{};
    const Motion motion = random() % 2 == 0 ? Motion{} : random_turn(random);
    Building building;
    for (int attempt = 0; attempt < 40; ++attempt) {
        std::array<int, 3> low{}, high{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = static_cast<int>(random() % kCells);
            high[axis] = std::min(kCells, low[axis] + 1 + static_cast<int>(random() % 3));
        }
        bool is_free = true;
        const auto each = [&](auto&& act) {
            for (int x = low[0]; x < high[0]; ++x)
                for (int y = low[1]; y < high[1]; ++y)
                    for (int z = low[2]; z < high[2]; ++z)
                        act(taken[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)]
                                 [static_cast<std::size_t>(z)]);
        };
        each([&](const bool& cell) { is_free = is_free && !cell; });
        if (!is_free) continue;
        each([](bool& cell) { cell = true; });
        const auto place = [&](const std::array<int, 3>& i) {
            return Vec3(at[0][static_cast<std::size_t>(i[0])], at[1][static_cast<std::size_t>(i[1])],
                        at[2][static_cast<std::size_t>(i[2])]) -
                   Vec3(0.8);
        };
        building.add(box_planes(place(low), place(high)), motion);
    }
    building.finish();
    return building;
}

// Returns whether a ball of this radius inside the building would touch the surface at `p` from inside. It samples
// points on the ball.
bool sphere_reaches(const Building& building, const Vec3& p, const Vec3& normal, double radius_m) {
    constexpr int kPlaces = 120;
    const Vec3 middle = p - normal * radius_m;
    if (!building.inside(middle, 1e-9)) return false;
    for (int k = 0; k < kPlaces; ++k) {  // sample points along a spiral over the sphere
        const double z = 1.0 - 2.0 * (k + 0.5) / kPlaces, angle = 2.399963 * k, out = std::sqrt(1.0 - z * z);
        if (!building.inside(middle + Vec3(out * std::cos(angle), out * std::sin(angle), z) * (0.999 * radius_m), 1e-9))
            return false;
    }
    return true;
}

struct Place {
    Vec3 at_m{0.0}, normal{0.0};
};

// Returns a random place on a face that no other solid covers.
std::optional<Place> exposed_place(const Building& building, std::mt19937& random) {
    const Solid& solid = building.scene.solids[random() % building.scene.solids.size()];
    const std::size_t face = random() % solid.shape.faces.size();
    const std::vector<Vec3>& corners = solid.shape.faces[face].points_m;
    const std::size_t k = 1 + random() % (corners.size() - 2);
    double a = unit(random), b = unit(random);
    if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
    // Every other place is close to an edge, where a wrong rounding would leave a groove.
    if (random() % 2 == 0) a *= 0.1 * unit(random);
    const Place place{corners[0] + (corners[k] - corners[0]) * a + (corners[k + 1] - corners[0]) * b,
                      solid.shape.planes[face].normal};
    if (building.inside(place.at_m + place.normal * 1e-6, 0.0)) return std::nullopt;
    return place;
}

void expect_flush_and_within(const Building& building, std::uint32_t seed, std::size_t& rounded, std::size_t& sharp) {
    if (building.scene.solids.empty()) return;
    RoundingReport report;
    const auto felt = building.compiled(kRounding_m, &report), filed = building.compiled(0.0);
    rounded += report.rounded;
    sharp += report.too_thin + report.at_seams;
    std::mt19937 random(seed);
    for (int i = 0; i < 150; ++i) {
        const std::optional<Place> place = exposed_place(building, random);
        if (!place) continue;
        const double off = distance(*felt, place->at_m);
        ASSERT_GE(off, -2e-5) << "seed " << seed << ": sticks out";
        // A ball as large as the rounding must be able to touch the place. In an inner corner it cannot, because there
        // it touches both sides farther out. The place must also be a little farther than the radius from all edges.
        // Either solid may round an edge between them, and both may round a corner.
        const bool touchable = distance(*filed, place->at_m + place->normal * kRounding_m) >= kRounding_m - 1e-9;
        if (touchable && sphere_reaches(building, place->at_m, place->normal, 1.45 * kRounding_m)) {
            ASSERT_LE(off, 1e-4) << "seed " << seed << ": a groove at " << place->at_m.x << ' ' << place->at_m.y << ' '
                                 << place->at_m.z;
        }
        const Vec3 above =
            place->at_m + place->normal * (0.05 * unit(random)) + Vec3(unit(random), unit(random), unit(random)) * 0.02;
        if (const double sharp_distance = distance(*filed, above); sharp_distance > 0.0) {
            ASSERT_GE(distance(*felt, above), sharp_distance - 2e-5) << "seed " << seed << ": sticks out into the air";
        }
    }
}

TEST(Rounding, of_blocks_cut_into_pieces_opens_no_groove_and_adds_no_material) {
    std::size_t rounded = 0, sharp = 0;
    for (int i = 0; i < scaled(150); ++i) {
        const std::uint32_t seed = seed_of_run() + static_cast<std::uint32_t>(i);
        std::mt19937 random(seed);
        expect_flush_and_within(cut_block(random), seed, rounded, sharp);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(rounded, 0U);
    std::cout << "    " << rounded << " pieces rounded, " << sharp << " sharp\n";
}

TEST(Rounding, of_boxes_joined_in_every_way_opens_no_groove_and_adds_no_material) {
    std::size_t rounded = 0, sharp = 0;
    for (int i = 0; i < scaled(300); ++i) {
        const std::uint32_t seed = seed_of_run() + static_cast<std::uint32_t>(i);
        std::mt19937 random(seed);
        expect_flush_and_within(blocks(random), seed, rounded, sharp);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(5 * rounded, sharp) << "however tangled";
    std::cout << "    " << rounded << " boxes rounded, " << sharp << " sharp\n";
}

TEST(Rounding, is_not_felt_if_a_pressed_proxy_slides_over_flush_seams) {
    constexpr double kProxy_m = kRounding_m;
    int slides = 0;
    double worst_n = 0.0;
    for (int i = 0; i < scaled(120); ++i) {
        const std::uint32_t seed = seed_of_run() + static_cast<std::uint32_t>(i);
        std::mt19937 random(seed);
        const Building building = blocks(random);
        const auto felt = building.compiled(kRounding_m), filed = building.compiled(0.0);
        for (int attempt = 0; attempt < 60; ++attempt) {
            const std::optional<Place> from = exposed_place(building, random), to = exposed_place(building, random);
            if (!from || !to || glm::dot(from->normal, to->normal) < 1.0 - 1e-9) continue;
            if (std::abs(glm::dot(from->normal, to->at_m - from->at_m)) > 1e-9 ||
                glm::length(to->at_m - from->at_m) < 0.2)
                continue;
            bool level = true;
            for (int k = 0; k <= 30 && level; ++k) {
                const Vec3 p = from->at_m + (to->at_m - from->at_m) * (k / 30.0);
                level = sphere_reaches(building, p, from->normal, 1.5 * kRounding_m) &&
                        !building.inside(p + from->normal * (2.0 * kProxy_m), 1.5 * kProxy_m);
            }
            if (!level) continue;
            ++slides;
            const Vec3 deep = from->normal * (0.5 * kProxy_m), high = from->normal * (2.0 * kProxy_m);
            const std::vector<Vec3> goals =
                hand_path({from->at_m + high, from->at_m - deep, to->at_m - deep, to->at_m + high}, 0.5);
            std::vector<Vec3> forces;
            replay(*filed, goals, {}, uncapped_tuning(kProxy_m),
                   [&](std::size_t, const Vec3&, const TouchResult& r, const ProxySolver&) {
                       forces.push_back(r.force_n);
                   });
            replay(*felt, goals, {}, uncapped_tuning(kProxy_m),
                   [&](std::size_t tick, const Vec3&, const TouchResult& r, const ProxySolver&) {
                       worst_n = std::max(worst_n, glm::length(r.force_n - forces[tick]));
                   });
            ASSERT_LE(worst_n, 0.02) << "seed " << seed << " (a micrometre is 0.001 N)";
        }
    }
    EXPECT_GT(slides, 0);
    std::cout << "    " << slides << " slides, force at most " << worst_n << " N from that on the sharp solids\n";
}

TEST(Rounding, of_random_brushes_is_exact_and_supports_the_solid) {
    for (int i = 0; i < scaled(200); ++i) {
        const std::uint32_t seed = seed_of_run() + static_cast<std::uint32_t>(i);
        std::mt19937 random(seed);
        std::vector<Plane> planes = box_planes(Vec3(-0.3 - 0.2 * unit(random)), Vec3(0.3 + 0.2 * unit(random)));
        if (i % 3 != 0) planes.push_back({glm::normalize(Vec3(unit(random), unit(random), unit(random))), 0.3});
        const Motion motion = i % 2 == 0 ? Motion{} : random_turn(random);
        Building building;
        building.add(planes, motion);
        building.finish();
        const auto felt = building.compiled(kRounding_m);
        ASSERT_EQ(felt->obstacles.size(), 1U);
        const double radius = felt->rounding_m(felt->obstacles[0]);
        if (radius == 0.0) continue;
        std::vector<Plane> core = building.scene.solids[0].shape.planes;
        for (Plane& plane : core) plane.offset_m -= radius;
        for (int k = 0; k < 60; ++k) {
            const Vec3 p = (Vec3(unit(random), unit(random), unit(random)) - 0.5) * 1.6 + motion.shift_m;
            const Nearest expected = nearest_on_solid(core, LVec(p));
            const ClosestPoint found = felt->closest(0, p - felt->origin_m);
            if (expected.distance > 1e-9L) {
                ASSERT_NEAR(found.distance_m, static_cast<double>(expected.distance) - radius, 1e-12)
                    << "seed " << seed;
                ASSERT_LE(
                    glm::length(found.normal - Vec3(LVec(p) - expected.point) / static_cast<double>(expected.distance)),
                    1e-9)
                    << "seed " << seed;
            }
            ASSERT_NEAR(glm::length(found.normal), 1.0, 1e-12);
            // The plane must bound the whole rounded solid.
            const Vec3 q = (Vec3(unit(random), unit(random), unit(random)) - 0.5) + motion.shift_m;
            const ClosestPoint other = felt->closest(0, q - felt->origin_m);
            ASSERT_LE(glm::dot(found.normal, other.point_m - found.point_m), 1e-12) << "seed " << seed;
        }
    }
}

std::shared_ptr<const HapticScene> rounded_box(double rounding_m) {
    Building building;
    building.add(box_planes({-0.3, -0.2, -0.1}, {0.1, 0.25, 0.2}));
    building.finish();
    return building.compiled(rounding_m);
}

TEST(Rounding,
     gives_the_force_of_a_rounded_box_round_its_edges_and_corners_and_that_of_the_sharp_one_bit_for_bit_on_its_faces) {
    constexpr double kSmall_m = 0.02;
    const auto felt = rounded_box(kSmall_m), filed = rounded_box(0.0);
    const Aabb core{{-0.3 + kSmall_m, -0.2 + kSmall_m, -0.1 + kSmall_m},
                    {0.1 - kSmall_m, 0.25 - kSmall_m, 0.2 - kSmall_m}};
    // The hand moves over an edge, then over a corner, pressed 3 mm deep with a proxy of 5 mm.
    TouchState state;
    const TouchTuning tuning = uncapped_tuning(0.005);
    double worst = 0.0;
    int round_edge = 0, round_corner = 0;
    for (int k = 0; k <= 4000; ++k) {
        const double turn = 0.5 * kPi * (k % 2001) / 2000.0;
        const Vec3 way = k <= 2000 ? Vec3(std::cos(turn), 0.0, std::sin(turn))
                                   : glm::normalize(Vec3(std::cos(turn), std::sin(turn), 0.8));
        const Vec3 corner = k <= 2000 ? Vec3(core.max_m.x, 0.0, core.max_m.z) : core.max_m;
        const Vec3 goal = corner + way * (kSmall_m + 0.005 - 0.003);
        if (k == 2001) state.reset();
        if (k == 0 || k == 2001) touch_tick(state, *felt, tuning, corner + way * (kSmall_m + 0.02), 1e-3);
        const TouchResult r = touch_tick(state, *felt, tuning, goal, 1e-3);
        ASSERT_EQ(r.contacts.count, 1);
        worst = std::max(worst, glm::length(r.force_n - way * 3.0));
        ++(k <= 2000 ? round_edge : round_corner);
    }
    EXPECT_LE(worst, 1e-5) << "3 N towards the ball from the edge's axis or the corner's middle";
    EXPECT_GT(std::min(round_edge, round_corner), 1000);
    for (int face = 0; face < 6; ++face) {
        Vec3 way(0.0);
        way[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
        const Vec3 middle(-0.07, 0.031, 0.0413);
        TouchState one, two;
        for (int k = 0; k < 200; ++k) {
            Vec3 goal = middle + Vec3(k * 1e-4, k * 7e-5, -k * 3e-5);
            goal[face / 2] = (face % 2 == 0 ? filed->boxes[0].max_m : filed->boxes[0].min_m)[face / 2];
            goal += way * (0.01 - k * 1e-4);
            const TouchResult a = touch_tick(one, *filed, tuning, goal, 1e-3),
                              b = touch_tick(two, *felt, tuning, goal, 1e-3);
            ASSERT_EQ(a.force_n, b.force_n);
            ASSERT_EQ(a.proxy_m, b.proxy_m);
        }
    }
}

TEST(Rounding, gives_no_energy_over_random_closed_loops) {  // invariant I11
    double worst_j = -1.0;
    for (int i = 0; i < scaled(60); ++i) {
        const std::uint32_t seed = seed_of_run() + static_cast<std::uint32_t>(i);
        std::mt19937 random(seed);
        const Motion motion = i % 2 == 0 ? Motion{} : random_turn(random);
        Building building;
        building.add(box_planes({-0.3, -0.3, -0.3}, {0.02, 0.3, 0.0}), motion);
        if (i % 3 == 0)
            building.add(box_planes({0.02, -0.3, -0.3}, {0.04 + 0.1 * unit(random), 0.1 * unit(random), 0.0}), motion);
        building.finish();
        const auto felt = building.compiled(0.005 + 0.015 * unit(random));
        std::vector<Vec3> loop_m = closed_loop(random, {0.02, 0.0, 0.02}, {0.05, 0.05, 0.05}, 4.0);
        for (Vec3& goal : loop_m) goal = motion(goal);
        const auto goals = begun_in_the_open(*felt, std::move(loop_m));
        const Loop loop = run(*felt, goals, uncapped_tuning(0.006));
        worst_j = std::max(worst_j, loop.energy_j);
        EXPECT_LE(loop.energy_j, loop.allowed_j) << "seed " << seed;
    }
    std::cout << "    worst loop gives " << 1e6 * worst_j << " uJ\n";
}

TEST(Rounding, of_a_moving_thing_has_the_same_size_for_the_hand_at_every_scale) {
    Building model;
    model.add(box_planes(Vec3(-0.05), Vec3(0.05)));
    model.finish();
    Building room;
    room.finish();
    room.scene.features.emplace_back();
    for (const double scale : {0.8, 1.0, 3.0}) {
        PlacedModel placed;
        placed.feature = FeatureId{0};
        placed.model = std::make_shared<Scene>(model.scene);
        placed.at.scale = scale;
        placed.at.position_m = Vec3(1.0, 2.0, 3.0);
        room.scene.placed.assign(1, placed);
        const auto felt = room.compiled(0.01);
        ASSERT_EQ(felt->bodies.size(), 1U);
        // The body moves while the proxy presses against its edge. The force stays perpendicular to the axis of the
        // rounded edge.
        TouchState state;
        Placement at = placed.at;
        for (int k = 0; k < 400; ++k) {
            at.position_m.x = 1.0 + (k > 100 ? 2e-5 * (k - 100) : 0.0);
            const BodyPose pose{at, true};
            const Vec3 axis = at.position_m + Vec3(0.05 * scale - 0.01, 0.0, 0.05 * scale - 0.01),
                       way = glm::normalize(Vec3(1, 0, 1));
            const Vec3 goal = axis + way * (0.01 + 0.005 + (k < 50 ? 0.01 - k * 2e-4 : 0.0) - 0.002);
            const TouchResult r = touch_tick(state, *felt, uncapped_tuning(0.005), goal, 1e-3, Vec3(0.0),
                                             {std::span(&pose, 1), static_cast<std::uint64_t>(k + 1)});
            if (k <= 60) continue;
            ASSERT_LE(glm::length(r.force_n - way * 2.0), 1e-4) << "scale " << scale << " tick " << k;
        }
    }
}

}  // namespace rounding_test
}  // namespace handrail::test
