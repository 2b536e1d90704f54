// Measures the cost of the engine. Asserts no cost, because machines differ, but prints the numbers of docs/results.md.
#include <algorithm>
#include <chrono>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/dynamics/rig.h"

namespace handrail::test {
namespace cost_test {

double now_us() {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> v) {
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
}

TEST(DynamicsCost, prints_the_cost_of_a_step) {
    for (const std::uint32_t bodies : {1U, 20U, 100U}) {
        DynamicsSceneBuilder builder;
        for (int x = -10; x < 10; ++x)
            for (int y = -10; y < 10; ++y) builder.add_fixed_box({Vec3(x, y, -0.5), Vec3(x + 1, y + 1, 0)});
        BodyNature nature;
        for (std::uint32_t i = 0; i < bodies; ++i) {
            const DynamicsPiece piece = i % 2 ? ball_of(0.1) : box_of(0.1);
            ASSERT_EQ(builder.add_body(std::span(&piece, 1), FeatureId{5 + i}, i,
                                       {Vec3(0.3 * (i % 10) - 1.5, 0.3 * (i / 10) - 1.5, 0.12), {}, 1.0}, nature),
                      BodyFault::None);
        }
        const double before = now_us();
        Dynamics engine(builder.build());
        const double built = now_us() - before;
        DynamicsFrame frame;
        std::vector<BodyEvent> events;
        std::vector<double> took;
        std::uint32_t awake = 0;
        for (int i = 0; i < scaled(480); ++i) {
            for (std::uint32_t b = 0; b < bodies; ++b) {  // the pushes prevent the bodies from falling asleep
                HandPush push;
                push.time_s = engine.time_s();
                push.dt_s = Dynamics::kStep_s;
                push.body = b;
                push.game = 1;
                push.force_n = Vec3(i / 60 % 2 ? 6.0 : -6.0, 0, 0);
                engine.push(0, push);
            }
            const double start = now_us();
            engine.step(frame, events);
            took.push_back(now_us() - start);
            awake = frame.awake;
            events.clear();
        }
        EXPECT_EQ(awake, bodies);
        std::printf(
            "step with %u awake bodies on 400 tiles: median %.0f us, worst %.0f us; building the world %.1f ms\n",
            bodies, median(took), *std::max_element(took.begin(), took.end()), built / 1e3);
    }
}

TEST(DynamicsCost, prints_the_cost_of_the_hand_model) {
    for (const int contacts : {0, 1, 4, 12}) {
        RigidBodyState word;
        word.body = 0;
        word.inertia_kg_m2 = Vec3(0.1);
        word.gravity_m_per_s2 = Vec3(0, 0, -9.81);
        for (int i = 0; i < contacts; ++i) {
            ContactPlane& plane = word.planes[static_cast<std::size_t>(i)];
            plane.own_m = Vec3(i % 2 ? 0.2 : -0.2, i / 2 % 2 ? 0.2 : -0.2, -0.2 + 0.1 * (i / 4));
            plane.offset_m = 0.1 * (i / 4);
            plane.friction = 0.4;
        }
        word.count = static_cast<std::uint8_t>(contacts);
        word.at.position_m = Vec3(0, 0, 0.2);
        BodyModel body;
        body.begin(word, {0.0, word.at, Vec3(0.0), Vec3(0.0)});
        std::vector<double> took;
        for (int i = 0; i < 200; ++i) {
            const double start = now_us();
            for (int k = 0; k < 50; ++k) body.tick(Vec3(1, 0.5, 0), Vec3(0, 0, 0.01), 1e-3);
            took.push_back((now_us() - start) / 50.0);
        }
        EXPECT_TRUE(is_finite(body.state().at.position_m));
        std::printf("tick of a held body with %d contacts: median %.2f us\n", contacts, median(took));
    }
}

}  // namespace cost_test
}  // namespace handrail::test
