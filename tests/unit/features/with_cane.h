// Runs a walker with the virtual cane, on plain state without a session.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/core/walking/cane.h"
#include "app/core/walking/walking.h"
#include "tests/support/names.h"
#include "tests/unit/features/plain_session.h"

namespace handrail::test {

struct WithCane {
    static constexpr double kTick_s = 1.0 / 60.0;

    explicit WithCane(std::shared_ptr<const Scene> scene) : plain(std::move(scene)) {
        by_ear.where_am_i = [] { return std::string("here"); };
        walking.enter_world();
        cane.enter_world();
    }
    void take_out(settings::CaneTechnique technique) {
        plain.person.settings.cane.technique = technique;
        if (plain.avatar.cane_out) cane.act(Command::Cane, now_s);
        cane.act(Command::Cane, now_s);
    }
    void tick() {
        walking.tick(now_s += kTick_s, kTick_s);
        cane.tick(now_s, kTick_s);
        for (CueRequest& cue : plain.cues.take()) {
            if (cue.kind == CueRequestKind::Say) said.push_back(cue.text);
            if (cue.kind == CueRequestKind::Play && cue.sound == SoundKind::Contact) sounds.push_back(cue);
        }
    }
    void run(double seconds) {
        for (double t = 0.0; t < seconds; t += kTick_s) tick();
    }
    void walk(double metres) {
        const Vec3 from = plain.avatar.feet_m();
        keys.press(Command::Forward);
        for (int i = 0; i < 1200 && glm::length(plain.avatar.feet_m() - from) < metres; ++i) tick();
        keys.release(Command::Forward);
    }
    void stand(const Vec3& feet_m, double heading_rad) {
        walking.set_down(feet_m, heading_rad);
        run(0.1);
        said.clear();
        sounds.clear();
    }

    PlainSession plain;
    HeldKeys keys;
    ByEar by_ear{plain.context, plain.avatar, keys};
    Footing footing{plain.context, plain.avatar};
    Walking walking{plain.context, plain.avatar, keys, by_ear, footing};
    Cane cane{plain.context, plain.avatar, keys};
    double now_s = 0.0;
    std::vector<std::string> said;
    std::vector<CueRequest> sounds;
};

}  // namespace handrail::test
