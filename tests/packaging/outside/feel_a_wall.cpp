// Presses the hand a tenth of a millimetre deep into a wall of a world. The hand begins a metre above the ground at a
// start and moves east by half a millimetre a tick until something stops the proxy. Then the program prints the force
// in newtons.
#include <cstdio>

#include "haptic/compile/compile_haptic.h"
#include "haptic/render/touch.h"
#include "worlds/readers/reader.h"

int main(int count, char** words) {
    using namespace handrail;
    const Result<Scene> world = readers::read_world(count == 2 ? words[1] : "");
    if (!world || world->starts.empty()) {
        std::puts(world ? "This world names no place to start." : world.error().sentence().c_str());
        return 1;
    }
    const auto felt = compile::compile_haptic(*world, compile::MaterialSource::Library);
    render::TouchState state;
    Vec3 hand_m = world->starts.front().feet_m + Vec3(0.0, 0.0, 1.0);
    render::TouchResult touch;
    while (touch.contacts.count == 0) {
        hand_m.x += 0.0005;
        touch = render::touch_tick(state, *felt, render::TouchTuning{}, hand_m, 1e-3);
    }
    hand_m.x = touch.proxy_m.x + 0.0001;
    for (int tick = 0; tick < 2000; ++tick)
        touch = render::touch_tick(state, *felt, render::TouchTuning{}, hand_m, 1e-3);
    std::printf("%.17g\n", glm::length(touch.force_n));
}
