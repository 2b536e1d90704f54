// Compares Handrail's interface with that of the plugin that Handrail succeeds, line by line of the list in
// docs/developer/adding.md, and calls every function of the list.
#include <algorithm>
#include <functional>
#include <regex>

#include "haptic/compile/compile_haptic.h"
#include "haptic/device/simulated_device.h"
#include "haptic/render/effect_volume.h"
#include "haptic/servo/servo_loop.h"
#include "haptic/servo/workspace_mover.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/unit/docs/table_rows.h"
#include "worlds/base/clock.h"

namespace handrail {
namespace parity_test {

// A hand in virtual time, in a room with one wall in the north.
struct Demo {
    VirtualClock clock;
    std::shared_ptr<SimulatedHand> hand = std::make_shared<SimulatedHand>();
    std::unique_ptr<ServoLoop> loop =
        std::make_unique<ServoLoop>(std::make_unique<SimulatedDevice>(*find_device_spec("sim-t"), hand), clock);
    test::SceneBuilder builder;
    std::shared_ptr<const HapticScene> haptic;
    ServoTuning tuning;
    WorkspacePose pose;
    FeatureId wall;

    Demo() {
        wall = builder.box({-5.0, 1.2, -5.0}, {5.0, 2.0, 5.0}, "north wall", SolidRole::Solid, "concrete",
                           FeatureKind::Wall);
        haptic = compile_haptic(builder.scene(), exploring(0.0));
        tuning.touch.world_m_per_hand_m = 60.0;
        tuning.touch.radius_m = 0.12;
        tuning.touch.rated_stiffness_n_per_m = 400.0;
    }
    // Makes the calls in the plugin's order: build and validate, add the meshes, start.
    void begin() {
        ASSERT_TRUE(loop->open());
        loop->set_scene(haptic);
        loop->set_tuning(tuning);
        loop->set_pose(pose);
    }
    void put(const Vec3& at_m, std::uint32_t buttons = 0, const Vec3& gimbal_rad = Vec3(0.0)) {
        HandCommand command;
        command.mode = HandMode::Move;
        command.target_m = at_m;
        command.speed_m_per_s = 0.1;
        command.buttons = buttons;
        command.gimbal_rad = gimbal_rad;
        hand->command.publish(command);
    }
    const ToolState& run(double seconds) {
        for (const double until_s = clock.now_s() + seconds; clock.now_s() < until_s;) {
            clock.advance_s(1e-3);
            loop->step();
        }
        return loop->tool();
    }
    // Switches the force on and presses the hand 3 mm deep into the wall.
    const ToolState& press() {
        begin();
        put({0.0, 0.01, 0.0});
        run(1.5);
        put({0.0, 0.021, 0.0});
        return run(1.5);
    }
};

struct Row {
    std::string original;
    std::function<void()> call;
};

const std::vector<Row>& rows() {
    static const std::vector<Row> kRows{
        {"getValidConstruction()",
         [] {
             Demo demo;
             EXPECT_TRUE(demo.loop->open());
             // A missing device. Opening it fails with the reason in a sentence.
             struct Absent final : HapticDevice {
                 const DeviceSpec& spec() const override { return *find_device_spec("touch"); }
                 Result<void> open() override { return fail("No device of 3D Systems answers."); }
                 DeviceSample read(double) noexcept override { return {}; }
                 void write(const ForceCommand&) noexcept override {}
                 void close() noexcept override {}
             };
             ServoLoop absent(std::make_unique<Absent>(), demo.clock);
             const auto opened = absent.open();
             ASSERT_FALSE(opened);
             EXPECT_EQ(opened.error().sentence(), "No device of 3D Systems answers.");
         }},
        {"SetMeshList(list)",
         [] {
             Demo demo;
             demo.begin();
             EXPECT_EQ(demo.run(0.01).scene_generation, demo.haptic->generation);
         }},
        {"start()",
         [] {
             Demo demo;
             SteadyClock real;
             ServoLoop loop(std::make_unique<SimulatedDevice>(*find_device_spec("sim-t"), demo.hand), real);
             ASSERT_TRUE(loop.open());
             loop.start();
             while (loop.tool().ticks < 3) real.sleep_until_s(real.now_s() + 1e-3);
             loop.stop();
         }},
        {"stop()",
         [] {
             Demo demo;
             EXPECT_GT(glm::length(demo.press().force_n), 0.5);
             demo.loop->request_stop();
             for (int i = 0; i < 200; ++i) {
                 demo.clock.advance_s(1e-3);
                 if (!demo.loop->step()) break;
             }
             demo.loop->stop();
             EXPECT_EQ(demo.loop->tool().force_n, Vec3(0.0));
         }},
        {"setWorkspacePosition(x, y, z)",
         [] {
             Demo demo;
             demo.pose.origin_m = Vec3(1.0, -2.0, 3.0);
             demo.begin();
             EXPECT_EQ(demo.run(0.01).hip_m, Vec3(1.0, -2.0, 3.0));
         }},
        {"rotateWorkspace(angle, x, y, z)",
         [] {
             Demo demo;
             demo.pose.heading_rad = kPi / 2.0;
             demo.begin();
             demo.put({0.0, 0.01, 0.0});
             EXPECT_LT(glm::length(demo.run(0.5).hip_m - Vec3(0.6, 0.0, 0.0)), 1e-9) << "forward is east";
         }},
        {"getStylusPosition()",
         [] {
             Demo demo;
             const ToolState& tool = demo.press();
             EXPECT_LT(glm::length(tool.hip_m - Vec3(0.0, 1.26, 0.0)), 1e-9);
             EXPECT_LT(glm::length(tool.proxy_m - Vec3(0.0, 1.08, 0.0)), 1e-6)
                 << "the ball in front of the wall, which the original did not have";
         }},
        {"getGimbalAngles()",
         [] {
             Demo demo;
             demo.begin();
             demo.put(Vec3(0.0), 0, {0.1, -0.2, 0.3});
             EXPECT_EQ(demo.run(0.01).gimbal_rad, Vec3(0.1, -0.2, 0.3));
         }},
        {"getStylusSwitch()",
         [] {
             Demo demo;
             demo.begin();
             EXPECT_EQ(demo.run(0.01).buttons, 0U);
             demo.put(Vec3(0.0), 5);
             EXPECT_EQ(demo.run(0.01).buttons, 5U) << "the first and the third";
         }},
        {"isCollision()",
         [] {
             Demo demo;
             const ToolState& tool = demo.press();
             ASSERT_EQ(tool.contacts.count, 1);
             const Contact& contact = tool.contacts.contacts[0];
             EXPECT_EQ(contact.feature, demo.wall);
             EXPECT_EQ(demo.builder.scene().material(contact.material).name, "concrete");
             EXPECT_NEAR(glm::length(tool.force_n), 1.2, 0.01) << "3 mm at 400 N/m";
             demo.put(Vec3(0.0));
             EXPECT_EQ(demo.run(0.5).contacts.count, 0);
         }},
        {"getDynamicForceList()",
         [] {
             Demo demo;
             const ToolState& tool = demo.press();
             Vec3 sum{0.0};
             for (std::size_t i = 0; i < tool.contacts.count; ++i) {
                 EXPECT_EQ(tool.contacts.contacts[i].feature, demo.wall);
                 sum += tool.force_n * tool.contacts.contacts[i].share;
             }
             EXPECT_LT(glm::length(sum - tool.force_n), 1e-12);
             bool reported = false;
             demo.loop->events().consume_all([&](const ContactEvent& event) {
                 reported |= event.kind == ContactEventKind::Begin && event.feature == demo.wall;
             });
             EXPECT_TRUE(reported);
         }},
        {"setForcesOn(bool)",
         [] {
             Demo demo;
             EXPECT_GT(glm::length(demo.press().force_n), 1.1);
             demo.tuning.forces_on = false;
             demo.loop->set_tuning(demo.tuning);
             const double half_faded = glm::length(demo.run(0.04).force_n);
             EXPECT_GT(half_faded, 0.1) << "it fades";
             EXPECT_LT(half_faded, 1.1);
             EXPECT_EQ(demo.run(0.1).force_n, Vec3(0.0));
             demo.tuning.forces_on = true;
             demo.loop->set_tuning(demo.tuning);
             EXPECT_NEAR(demo.run(0.5).force_gain, 0.5, 0.02) << "and ramps in over a second";
         }},
        {"class iPhantom",
         [] {
             Demo demo;
             EXPECT_EQ(demo.loop->device_spec().name, "sim-t");
         }},
        {"class csPhantom",
         [] {
             Demo demo;
             SimulatedDevice device(*find_device_spec("sim-t"), demo.hand);
             HapticDevice& seam = device;
             ASSERT_TRUE(seam.open());
             seam.write({Vec3(0.1, 0.0, 0.0)});
             EXPECT_TRUE(seam.read(0.0).connected);
             seam.close();
         }},
        {"class World",
         [] {
             Demo demo;
             EXPECT_GE(demo.haptic->obstacles.size(), 1U);
         }},
        {"classes Octree, etOctTree, Node",
         [] {
             HapticSceneBuilder builder;
             for (int i = 0; i < 100; ++i) builder.add_box({Vec3(i, 0.0, 0.0), Vec3(i + 0.5, 1.0, 1.0)});
             std::vector<std::uint32_t> near;
             builder.build()->obstacle_bvh.within({40.25, 0.5, 0.5}, 0.4,
                                                  [&](std::uint32_t item, double&) { near.push_back(item); });
             EXPECT_EQ(near, std::vector<std::uint32_t>{40}) << "only the box that is there";
         }},
        {"class etObject",
         [] {
             HapticSceneBuilder shape, builder;
             shape.add_box({Vec3(-0.1), Vec3(0.1)});
             EXPECT_TRUE(builder.add_body(FeatureId{3}, shape.build(), Placement{}));
             EXPECT_EQ(builder.build()->bodies.size(), 1U);
         }},
        {"class etHapticTrisurface",
         [] {
             HapticSceneBuilder builder;
             builder.add_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
             EXPECT_EQ(builder.build()->obstacles.size(), 1U);
         }},
        {"classes etBox, etSphere, etCylinder",
         [] {
             HapticSceneBuilder builder;
             builder.add_box({Vec3(0.0), Vec3(1.0)});
             builder.add_sphere({Vec3(3.0, 0.0, 0.0), 0.5});
             CylinderShape cylinder;
             cylinder.height_m = 1.0;
             cylinder.radius_m = 0.2;
             builder.add_cylinder(cylinder);
             EXPECT_EQ(builder.build()->obstacles.size(), 3U);
         }},
        {"classes gstForceField, ForceField",
         [] {
             HapticSceneBuilder builder;
             EffectVolume wind;
             wind.region = SphereRegion{Vec3(0.0), 1.0};
             wind.law = ForceLaw{};
             EXPECT_TRUE(builder.add_effect(wind));
             EXPECT_EQ(builder.build()->effects.size(), 1U);
         }},
    };
    return kRows;
}

TEST(ParityWithTheOriginal, every_line_of_the_list_has_a_test_here_and_names_an_existing_file) {
    // Matches a line such as "- `start()`: `ServoLoop::start` (`haptic/servo/servo_loop.h`)".
    static const std::regex kLine(R"re(- (.+?): .* \(`([^`]+)`\))re");
    std::vector<std::string> listed, called;
    for (const std::string& line : test::list_items("developer/adding.md", "## The original's interface and ours")) {
        std::smatch parts;
        ASSERT_TRUE(std::regex_match(line, parts, kLine)) << line;
        std::string original = parts[1];
        original.erase(std::remove(original.begin(), original.end(), '`'), original.end());
        listed.push_back(original);
        EXPECT_TRUE(std::filesystem::exists(test::project_root() / parts[2].str())) << line;
    }
    for (const Row& row : rows()) called.push_back(row.original);
    EXPECT_EQ(listed, called);
    for (const Row& row : rows()) {
        SCOPED_TRACE(row.original);
        row.call();
    }
}

}  // namespace parity_test
}  // namespace handrail
