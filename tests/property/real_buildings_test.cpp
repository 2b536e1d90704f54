// Tests hands in buildings. The hand never enters a solid, and proxy and walker pass every door that the world file
// declares. Real buildings take part if the folder HANDRAIL_REAL_WORLDS contains them. With HANDRAIL_LONG_WALKS=1, each
// building gets 200,000 ticks.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "haptic/compile/compile_haptic.h"
#include "haptic/render/touch.h"
#include "tests/property/stiff_proxy.h"
#include "tests/support/direction_through.h"
#include "tests/support/known_buildings.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "worlds/geometry/box_index.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace real_buildings_test {

// An independent judge, which uses only the planes of the solids near a place.
class Solids {
public:
    explicit Solids(const Scene& scene) : scene_(scene), boxes_(boxes_of(scene)) {}

    // Returns the depth of a place in the solid that contains the place most deeply; 0 or less if the place is in no
    // solid.
    double depth_m(const Vec3& at_m) const {
        boxes_.find({at_m, at_m}, near_);
        double deepest = -1.0;
        for (const std::uint32_t i : near_) {
            double out = -1e9;
            for (const Plane& plane : scene_.solids[i].shape.planes) out = std::max(out, signed_distance(plane, at_m));
            deepest = std::max(deepest, -out);
        }
        return deepest;
    }

private:
    static std::vector<Aabb> boxes_of(const Scene& scene) {
        std::vector<Aabb> boxes(scene.solids.size());
        for (std::size_t i = 0; i < boxes.size(); ++i)
            if (scene.solids[i].role == SolidRole::Solid || scene.solids[i].role == SolidRole::Mover)
                boxes[i] = scene.solids[i].shape.bounds_m;
        return boxes;
    }

    const Scene& scene_;
    BoxIndex boxes_;
    mutable std::vector<std::uint32_t> near_;
};

struct Building {
    std::string name;
    std::size_t doors = 0;
    std::shared_ptr<const Scene> scene;
};

// Returns places in the rooms that the world file states. If the file states no rooms, returns the starts.
std::vector<Vec3> places_in(const Scene& scene) {
    std::vector<Vec3> places_m;
    if (scene.stated)
        for (const StatedRoom& room : scene.stated->rooms) places_m.push_back(room.at_m);
    if (places_m.empty())
        for (const Start& start : scene.starts) places_m.push_back(start.feet_m);
    return places_m;
}

void read_buildings(std::vector<Building>& buildings) {
    const test::TemporaryFolder folder;
    for (const test::KnownBuilding& known : test::known_buildings(folder)) {
        Result<Scene> scene = read_world(known.file);
        ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
        buildings.push_back(
            {known.file.filename().string(), known.doors, std::make_shared<const Scene>(std::move(*scene))});
    }
}

// A hand at 1 m/s starts in one room after the other. Most of the time it presses on the surface that it has met.
TEST(RealBuildings, never_let_a_hand_into_a_solid) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "unit_osm starts the threads that read OpenStreetMap";
    const int ticks = std::getenv("HANDRAIL_LONG_WALKS") ? 200'000 : 20'000;
    std::vector<Building> buildings;
    ASSERT_NO_FATAL_FAILURE(read_buildings(buildings));
    for (const auto& [name, doors, scene] : buildings) {
        const auto haptic = compile_haptic(*scene, MaterialSource::KeysOnly);
        const Solids solids(*scene);
        const std::vector<Vec3> places_m = places_in(*scene);
        ASSERT_FALSE(places_m.empty()) << name;
        const TouchTuning tuning = test::stiff_proxy(0.005);
        TouchState state;
        std::mt19937 random(20261124);
        const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
        Vec3 proxy{0.0}, hand{0.0}, direction{1, 0, 0};
        Vec3 normal{0.0};  // normal of the touched surface; zero: no surface is touched
        int touching = 0, left = 0;
        std::size_t room = 0;
        for (int i = 0; i < ticks; ++i) {
            if (i % 4000 == 0) {
                // Finds the next place that has free air above it.
                std::size_t looked = 0;
                do {
                    ASSERT_LT(looked++, places_m.size()) << name << ": no place is free";
                    room = (room + 1) % places_m.size();
                    proxy = hand = places_m[room] + Vec3(0, 0, 0.2);
                } while (solids.depth_m(proxy) > -0.02 && solids.depth_m(proxy) != -1.0);
                state.reset();
            }
            if (--left <= 0) {
                direction = glm::normalize(Vec3(2 * unit() - 1, 2 * unit() - 1, 1.4 * unit() - 1.0) + Vec3(1e-6));
                // Three of four directions keep to the touched surface and press on it.
                if (normal != Vec3(0.0) && random() % 4 != 0)
                    direction -= normal * (glm::dot(direction, normal) + 0.3 * glm::length(direction));
                left = 200 + static_cast<int>(800 * unit());
            }
            hand += direction * 1e-3;
            if (const double away = glm::length(hand - proxy); away > 0.01)
                hand = proxy + (hand - proxy) * (0.01 / away);
            const TouchResult felt = touch_tick(state, *haptic, tuning, hand, 1e-3);
            proxy = felt.proxy_m;
            if (felt.contacts.ghosted) continue;
            touching += felt.contacts.count > 0 ? 1 : 0;
            normal = Vec3(0.0);
            if (felt.contacts.count > 0) normal = felt.contacts.contacts[felt.contacts.strongest].normal;
            ASSERT_LE(solids.depth_m(proxy), 1e-6)
                << name << ", tick " << i << ": " << proxy.x << " " << proxy.y << " " << proxy.z;
        }
        EXPECT_GT(touching, ticks / 10) << name;
    }
}

// Returns whether a proxy passes from one point to the other. At the scale "Room" the proxy has a radius of 0.1 m in
// the building, like a fist.
bool proxy_passes(const HapticScene& haptic, const Vec3& from_m, const Vec3& to_m) {
    TouchState state;
    const TouchTuning tuning = test::stiff_proxy(0.1);
    Vec3 proxy = from_m;
    const int steps = static_cast<int>(glm::length(to_m - from_m) / 2e-3);
    for (int i = 0; i <= steps + 200; ++i) {
        const Vec3 wanted = from_m + (to_m - from_m) * std::min(1.0, static_cast<double>(i) / steps);
        proxy = touch_tick(state, haptic, tuning, wanted, 1e-3).proxy_m;
    }
    return glm::length(proxy - to_m) < 0.02;
}

// Returns whether a walker passes. It tests points of a body of 0.5 by 0.3 m, 1.7 m tall.
bool walker_passes(const Solids& solids, const Vec3& middle_m, const Vec3& way) {
    const Vec3 across = glm::cross(Vec3(0, 0, 1), way);
    for (double along = -0.45; along <= 0.45; along += 0.05)
        for (const double side : {-0.24, -0.12, 0.0, 0.12, 0.24})
            for (double z = 0.3; z <= 1.75; z += 0.145)
                if (solids.depth_m(middle_m + way * along + across * side + Vec3(0, 0, z)) > 1e-3) return false;
    return true;
}

TEST(RealBuildings, let_body_and_hand_through_every_open_door_of_the_file) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "unit_osm starts the threads that read OpenStreetMap";
    std::vector<Building> buildings;
    ASSERT_NO_FATAL_FAILURE(read_buildings(buildings));
    for (const auto& [name, known_doors, scene] : buildings) {
        // All door leaves are removed, so any obstacle that the proxy still meets is a wall.
        Scene open = *scene;
        std::erase_if(open.solids, [](const Solid& solid) { return solid.role == SolidRole::Mover; });
        open.movers.clear();
        const auto haptic = compile_haptic(open, MaterialSource::KeysOnly);
        const Solids solids(open);
        const std::vector<test::DoorToPass> doors = test::doors_to_pass(*scene);
        int shut_to_walker = 0, shut_to_proxy = 0;
        std::string shut;
        for (const auto& [portal, way] : doors) {
            const bool body = walker_passes(solids, portal->place_m, way);
            bool proxy = false;
            for (const double z : {1.0, 1.3, 1.6}) {
                const Vec3 middle = portal->place_m + Vec3(0, 0, z);
                proxy = proxy || proxy_passes(*haptic, middle - way * 0.5, middle + way * 0.5);
            }
            shut_to_walker += body ? 0 : 1;
            shut_to_proxy += proxy ? 0 : 1;
            if (!body || !proxy) shut += " " + portal->name + "/" + std::to_string(portal->source.line);
        }
        std::cout << name << ": " << doors.size() << " doors, shut to a body " << shut_to_walker << ", to a ball "
                  << shut_to_proxy << "\n";
        EXPECT_EQ(doors.size(), known_doors) << name;
        EXPECT_EQ(shut_to_proxy, 0) << name << ":" << shut;
        EXPECT_EQ(shut_to_walker, 0) << name << ":" << shut;
    }
}

}  // namespace real_buildings_test
}  // namespace handrail
