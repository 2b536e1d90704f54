// Tests closed meshes that are not convex: the hand never enters them, and it comes out if it begins inside one.
#include <gtest/gtest.h>

#include <random>

#include "haptic/compile/compile_haptic.h"
#include "haptic/render/touch.h"
#include "tests/property/stiff_proxy.h"
#include "tests/support/block_mesh.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "worlds/geometry/clip.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace closed_mesh_touch_test {

struct Mesh {
    test::BlockMesh mesh;
    std::shared_ptr<const HapticScene> haptic;
};

// The scene also has a crate far away, so that neither mesh is the only one.
Mesh touched(const std::set<test::Block>& blocks, double turn) {
    Mesh made;
    made.mesh = test::block_mesh(blocks, [&](const Vec3& p) {
        return 0.1 *
               Vec3(p.x * std::cos(turn) - p.z * std::sin(turn), p.y, p.x * std::sin(turn) + p.z * std::cos(turn));
    });
    const test::BlockMesh crate = test::block_mesh({{0, 0, 0}}, [](const Vec3& p) { return Vec3(20, 0, 0) + p; });
    const Result<Scene> scene = read_stl(made.mesh.stl("thing") + crate.stl("crate"), "things.stl");
    EXPECT_TRUE(scene.has_value());
    if (scene) made.haptic = compile_haptic(*scene, MaterialSource::KeysOnly);
    return made;
}

std::vector<Mesh> meshes() {
    return {touched(test::table_blocks(), 0.0), touched(test::horseshoe_blocks(5, 3), 0.4),
            touched(test::hollow_blocks(4), 0.2)};
}

TEST(ClosedMeshes, are_never_entered_by_a_hand_that_presses_on_them) {
    std::mt19937 random(20261125);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (const Mesh& world : meshes()) {
        Aabb box;
        for (const Vec3& p : world.mesh.points_m) box.include(p);
        box = grown(box, 0.1);
        const TouchTuning tuning = test::stiff_proxy(0.005);
        TouchState state;
        Vec3 proxy = box.min_m, hand = proxy, direction{1, 0, 0}, normal{0.0};
        int touching = 0, left = 0;
        const int ticks = test::scaled(20'000);
        for (int i = 0; i < ticks; ++i) {
            if (--left <= 0) {
                // Aims at a random place of the mesh, or along the touched surface while pressing on it. The numbers
                // are drawn in separate statements, because compilers evaluate arguments in different orders.
                const double z = unit(), y = unit(), x = unit();
                const Vec3 aim = box.min_m + box.size_m() * Vec3(x, y, z);
                direction = glm::normalize(aim - proxy + Vec3(1e-6));
                if (normal != Vec3(0.0) && random() % 3 != 0)
                    direction -= normal * (glm::dot(direction, normal) + 0.3 * glm::length(direction));
                left = 100 + static_cast<int>(300 * unit());
            }
            hand += direction * 1e-3;
            hand = glm::clamp(hand, box.min_m, box.max_m);
            if (const double away = glm::length(hand - proxy); away > 0.01)
                hand = proxy + (hand - proxy) * (0.01 / away);
            const TouchResult felt = touch_tick(state, *world.haptic, tuning, hand, 1e-3);
            proxy = felt.proxy_m;
            touching += felt.contacts.count > 0 ? 1 : 0;
            normal = felt.contacts.count > 0 ? felt.contacts.contacts[felt.contacts.strongest].normal : Vec3(0.0);
            ASSERT_FALSE(world.mesh.holds(proxy)) << i << ": " << proxy.x << " " << proxy.y << " " << proxy.z;
        }
        EXPECT_GT(touching, ticks / 20) << "the first strokes only come to it, which counts where few are made";
    }
}

TEST(ClosedMeshes, release_a_hand_that_started_inside_and_do_not_let_it_back_in) {
    for (const Mesh& world : meshes()) {
        // The hand starts in the middle of the first block and leaves the mesh through the nearest side, to a place far
        // away.
        const test::BlockMesh& mesh = world.mesh;
        Vec3 within(0.0);
        bool found = false;
        std::mt19937 random(7);
        const auto part = [&] { return static_cast<double>(random() % 1000) / 1000.0; };
        Aabb box;
        for (const Vec3& p : mesh.points_m) box.include(p);
        while (!found) {
            const double z = part(), y = part(), x = part();
            within = box.min_m + box.size_m() * Vec3(x, y, z);
            found = mesh.holds(within) && mesh.distance_m(within) > 0.01;
        }
        const Vec3 away = box.max_m + Vec3(0.3);
        TouchState state;
        const TouchTuning tuning = test::stiff_proxy(0.005);
        const Vec3 way = (away - within) / 2000.0;
        Vec3 proxy = within;
        for (int i = 0; i <= 2500; ++i)
            proxy = touch_tick(state, *world.haptic, tuning, within + way * double(std::min(i, 2000)), 1e-3).proxy_m;
        EXPECT_LT(glm::length(proxy - away), 0.02) << "out";
        for (int i = 0; i <= 2500; ++i)
            proxy = touch_tick(state, *world.haptic, tuning, away - way * double(std::min(i, 2000)), 1e-3).proxy_m;
        EXPECT_FALSE(mesh.holds(proxy)) << "not back in";
    }
}

}  // namespace closed_mesh_touch_test
}  // namespace handrail
