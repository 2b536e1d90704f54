// Measures the cost of a tick while a hand moves about in one kind of effect, liquid or soft patch. Under callgrind,
// effect_costs.sh counts instructions; otherwise the program prints nanoseconds. If the command line names no kind,
// `effect_costs` runs each kind once, briefly.
#include <chrono>
#include <iostream>

#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"

namespace handrail::test {
namespace {

const Aabb kPlace{Vec3(-0.05), Vec3(0.05)};

LiquidVolume pool() {
    LiquidVolume liquid;
    for (int side = 0; side < 6; ++side) {
        Vec3 normal(0.0);
        normal[side / 2] = side % 2 == 0 ? 1.0 : -1.0;
        liquid.planes.push_back({normal, 0.05});
    }
    liquid.hidden.assign(6, true);
    liquid.hidden[4] = false;
    return liquid;
}

SoftPatch patch(bool plastic) {
    SoftPatch soft;
    soft.corner_m = Vec3(-0.05, -0.05, 0.01);
    soft.size_u_m = soft.size_v_m = 0.1;
    soft.depth_m = 0.05;
    soft.plastic = plastic;
    return soft;
}

struct Kind {
    std::string_view name;
    void (*add)(HapticSceneBuilder&);
};

template <class Law>
void add_law(HapticSceneBuilder& builder, Law law, const Aabb& place = kPlace) {
    EffectVolume effect;
    effect.region = place;
    effect.law = std::move(law);
    builder.add_effect(std::move(effect));
}

constexpr std::array kKinds{
    Kind{"nothing", [](HapticSceneBuilder&) {}},
    Kind{"elsewhere",
         [](HapticSceneBuilder& b) {
             add_law(b, FlyPaperLaw{}, {Vec3(5.0), Vec3(6.0)});
         }},
    Kind{"magnet", [](HapticSceneBuilder& b) { add_law(b, MagnetLaw{{{Vec3(0.0)}}}); }},
    Kind{"detent", [](HapticSceneBuilder& b) { add_law(b, DetentLaw{}); }},
    Kind{"button", [](HapticSceneBuilder& b) { add_law(b, ButtonLaw{}); }},
    Kind{"fly-paper", [](HapticSceneBuilder& b) { add_law(b, FlyPaperLaw{}); }},
    Kind{"inertia", [](HapticSceneBuilder& b) { add_law(b, InertiaLaw{}); }},
    Kind{"force", [](HapticSceneBuilder& b) { add_law(b, ForceLaw{}); }},
    Kind{"vibration", [](HapticSceneBuilder& b) { add_law(b, VibrationLaw{}); }},
    Kind{"drag",
         [](HapticSceneBuilder& b) {
             LiquidVolume liquid = pool();
             liquid.viscosity_ns_per_m = 4.0;
             b.add_liquid(liquid, kPlace);
         }},
    Kind{"drag-buoyancy-film-flow",
         [](HapticSceneBuilder& b) {
             LiquidVolume liquid = pool();
             liquid.viscosity_ns_per_m = 4.0;
             liquid.buoyancy_n = liquid.film_n = 0.3;
             liquid.flow_hand_m_per_s = Vec3(0.1, 0, 0);
             b.add_liquid(liquid, kPlace);
         }},
    Kind{"cushion", [](HapticSceneBuilder& b) { b.add_soft(patch(false)); }},
    Kind{"clay", [](HapticSceneBuilder& b) { b.add_soft(patch(true)); }},
    Kind{"sixteen-magnets",
         [](HapticSceneBuilder& b) {
             for (int i = 0; i < 16; ++i) add_law(b, MagnetLaw{{{Vec3(0.0)}}});
         }},
};

// callgrind starts and stops counting at this function, which it finds by its name. The function must contain nothing
// else.
[[gnu::noinline]] double measured_ticks(const HapticScene& scene, TouchState& state, const std::vector<Vec3>& goals) {
    double checksum = 0.0;
    for (const Vec3& goal : goals) checksum += touch_tick(state, scene, TouchTuning{}, goal, 1e-3).force_n.x;
    return checksum;
}

int run(std::string_view wanted, int ticks) {
    std::vector<Vec3> goals;
    for (int i = 0; i < ticks; ++i) {
        const double t = 2.0 * kPi * i / 4000.0;
        goals.emplace_back(0.03 * std::sin(3 * t), 0.03 * std::cos(2 * t), 0.03 * std::sin(5 * t + 1));
    }
    bool any = false;
    for (const Kind& kind : kKinds) {
        if (!wanted.empty() && kind.name != wanted) continue;
        any = true;
        HapticSceneBuilder builder;
        kind.add(builder);
        const auto scene = builder.build();
        TouchState state;
        const auto begin = std::chrono::steady_clock::now();
        const double checksum = measured_ticks(*scene, state, goals);
        const double ns =
            std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count() / ticks;
        std::cout << fmt::format("{:24} {:8.0f} ns a tick, checksum {}\n", kind.name, ns, checksum);
    }
    if (!any) std::cerr << "There is no such kind.\n";
    return any ? 0 : 1;
}

}  // namespace
}  // namespace handrail::test

int main(int argc, char** argv) {
    return handrail::test::run(argc > 1 ? argv[1] : "", argc > 2 ? std::atoi(argv[2]) : 400);
}
