// Replays every hard case through the touch renderer. Prints the results as exact numbers, so that builds can be
// compared.
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/touch_worlds.h"

namespace {

using namespace handrail;

// Adds the bits of `v` to an FNV-1a hash.
void mix(std::uint64_t& hash, const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) {
        std::uint64_t bits = 0;
        const double value = v[axis];
        std::memcpy(&bits, &value, sizeof bits);
        for (int byte = 0; byte < 8; ++byte) hash = (hash ^ ((bits >> (8 * byte)) & 0xff)) * 0x100000001b3ULL;
    }
}

}  // namespace

int main() {
    for (const handrail::test::TouchCase& c : handrail::test::hard_cases()) {
        for (const double scale : {1.0, 12.0}) {
            const auto scene = c.world.scene();
            TouchState state;
            TouchTuning tuning;
            tuning.radius_m = c.radius_m;
            tuning.world_m_per_hand_m = scale;
            tuning.damping_ns_per_m = 5.0;
            tuning.default_friction_static = 0.35;
            tuning.default_friction_kinetic = 0.3;
            tuning.passivity_guard = true;
            std::uint64_t hash = 0xcbf29ce484222325ULL;
            for (std::size_t i = 0; i < c.goals_m.size(); ++i) {
                const TouchResult r = touch_tick(state, *scene, tuning, c.goals_m[i], 1e-3);
                mix(hash, r.proxy_m);
                mix(hash, r.force_n);
                if (i % 200 == 0)
                    std::printf("%s %g %zu %a %a %a %a %a %a\n", c.name.c_str(), scale, i, r.proxy_m.x, r.proxy_m.y,
                                r.proxy_m.z, r.force_n.x, r.force_n.y, r.force_n.z);
            }
            std::printf("%s %g %016llx\n", c.name.c_str(), scale, static_cast<unsigned long long>(hash));
        }
    }
    return 0;
}
