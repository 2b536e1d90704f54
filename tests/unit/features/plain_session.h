// Provides the state on which the features of a session work. A test sets up this state directly, without a session, a
// servo or a clock.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/core/context/session_state.h"
#include "app/core/world/entering.h"
#include "haptic/compile/compile_haptic.h"
#include "tests/support/names.h"
#include "worlds/scene/building_bounds.h"

namespace handrail::test {

struct PlainSession : SessionState {
    explicit PlainSession(std::shared_ptr<const Scene> scene) : SessionState(Settings{}) {
        EnteringWorld entering = make_ready(std::move(scene));
        as_read = entering.file;
        world.scene = entering.scene;
        world.building_m = building_bounds_m(*world.scene);
        world.thing_of_mover = entering.thing_of_mover;
        haptic = compile_haptic(*world.scene, {});
        world.things.enter(*world.scene, *haptic, {}, 0.0);
        world.movers.enter(world.scene->movers);
        world.solids = std::move(entering.body);
        avatar.walker =
            std::make_unique<Walker>(*world.solids, walker_size(*world.scene, person.settings.walk.body_radius_m));
        avatar.walker->place(entering.feet_m);
        avatar.heading_rad = avatar.heading_goal_rad = entering.heading_rad;
        world.home_feet_m = avatar.feet_m();
        context.session_requests.set = [this](std::string_view key, const std::string& value, double) {
            const auto set = change_setting(person.settings, key, value);
            person.keys = KeyMap(person.settings.keys, person.settings.keyboard.hand);
            return set;
        };
    }
    // Returns what the features announced since the last call.
    std::vector<std::string> said() {
        std::vector<std::string> words;
        for (CueRequest& cue : cues.take())
            if (cue.kind == CueRequestKind::Say) words.push_back(std::move(cue.text));
        return words;
    }
    // Returns how often the features requested the sound since the last call of this function or of said().
    std::size_t heard(SoundKind kind) {
        const std::vector<CueRequest> requested = cues.take();
        return static_cast<std::size_t>(std::count_if(requested.begin(), requested.end(), [&](const CueRequest& cue) {
            return cue.kind == CueRequestKind::Play && cue.sound == kind;
        }));
    }
    void stand(const Vec3& feet_m) { avatar.walker->place(feet_m); }

    std::shared_ptr<const Scene> as_read;
    std::shared_ptr<const HapticScene> haptic;
};

}  // namespace handrail::test
