#include "app/core/scenario/session_log.h"

#include "tests/support/box_scene.h"
#include "tests/support/names.h"

namespace handrail {
namespace session_log_test {

TEST(WordsInOrder, ignores_case_and_punctuation_but_not_order) {
    EXPECT_TRUE(words_in_order("North wall, plaster", "north wall plaster. 5 steps"));
    EXPECT_TRUE(words_in_order("stairs 12", "Stairs up, 12 steps"));
    EXPECT_FALSE(words_in_order("plaster wall", "North wall, plaster"));
    EXPECT_FALSE(words_in_order("wall", "walls"));
}

TEST(LineAmplitude, finds_a_sine_in_a_ramp_with_its_amplitude) {
    std::vector<double> samples;
    for (int i = 0; i < 3000; ++i) samples.push_back(0.001 * i + 0.05 * std::sin(2 * kPi * 60.0 * i * 1e-3));
    EXPECT_NEAR(line_amplitude(samples, 1e-3, 60.0, 60.0), 0.05, 0.001);
    EXPECT_LT(line_amplitude(samples, 1e-3, 100.0, 300.0), 1e-4);
    EXPECT_NEAR(line_amplitude(samples, 1e-3, 8.0, 300.0), 0.05, 0.001);
}

// Each kind of expectation must be able to fail. So each kind is checked twice on the same log, once with an
// expectation that is met and once with one that is not.
TEST(Failures, each_kind_of_expectation_passes_when_met_and_otherwise_fails_with_line_and_observation) {
    test::SceneBuilder b;
    const FeatureId wall = b.box({-1, 1, 0}, {1, 1.2, 2}, "north wall");
    SessionLog log;
    for (int i = 1; i <= 1000; ++i) {
        LoggedTick t;
        t.time_s = i * 1e-3;
        t.contact = i > 500;
        t.touched = wall;
        t.force_n = t.contact ? Vec3(0, -0.001 * (i - 500), 0) : Vec3(0.0);
        t.proxy_m = Vec3(0, 0.9, 1);
        t.radius_m = 0.1;
        t.hip_m = t.proxy_m;
        log.ticks.push_back(t);
    }
    SoundCue cue;
    cue.kind = SoundKind::Contact;
    cue.material = SoundClass::Plaster;
    cue.event_time_s = 0.5;
    log.sounds.push_back({0.51, cue, false});
    SoundCue tone;
    tone.kind = SoundKind::WallTone;
    for (int i = 0; i < 5; ++i) {
        tone.loudness = 0.1 * i;
        log.sounds.push_back({0.1 * i, tone, true});
    }
    LoggedLine line;
    line.time_s = 0.55;
    line.text = "North wall, plaster";
    log.lines.push_back(line);
    log.end_s = 1.0;

    const auto run = [&](Check check, auto&& fill) {
        Scenario s;
        s.file = "x.toml";
        Expectation e;
        e.check = check;
        e.line = 7;
        e.vector = Vec3(0.0);
        fill(e);
        s.expectations.push_back(e);
        return failures(s, log, b.scene());
    };
    const auto holds = [&](Check check, auto&& fill) {
        EXPECT_THAT(run(check, fill), testing::IsEmpty()) << static_cast<int>(check);
    };
    const auto fails = [&](Check check, auto&& fill) {
        const auto found = run(check, fill);
        ASSERT_EQ(found.size(), 1U) << static_cast<int>(check);
        EXPECT_THAT(found[0], testing::HasSubstr("x.toml line 7"));
    };
    holds(Check::Say, [](Expectation& e) { e.text = "north plaster"; });
    fails(Check::Say, [](Expectation& e) { e.text = "south"; });
    fails(Check::Say, [](Expectation& e) { e.text = "north", e.times = 2; });
    fails(Check::NotSay, [](Expectation& e) { e.text = "plaster"; });
    holds(Check::Sound, [](Expectation& e) { e.text = "contact", e.material = "plaster", e.high = 15; });
    fails(Check::Sound, [](Expectation& e) { e.text = "contact", e.high = 5; });
    fails(Check::Sound, [](Expectation& e) { e.text = "contact", e.high = 0; });
    holds(Check::Sound, [](Expectation& e) { e.text = "contact", e.high = -1; });
    fails(Check::Sound, [](Expectation& e) { e.text = "contact", e.material = "wood"; });
    fails(Check::NotSound, [](Expectation& e) { e.text = "contact"; });
    holds(Check::SoundRising, [](Expectation& e) { e.text = "wall tone"; });
    fails(Check::SoundRising, [](Expectation& e) { e.text = "contact"; });
    holds(Check::Force, [](Expectation& e) { e.low = 0, e.high = 0.5; });
    fails(Check::Force, [](Expectation& e) { e.low = 0, e.high = 0.4; });
    holds(Check::ForceStep, [](Expectation& e) { e.high = 0.00101; });
    fails(Check::ForceStep, [](Expectation& e) { e.high = 0.0009; });
    fails(Check::ForceBand, [](Expectation& e) { e.high = 0.0, e.from_hz = 1, e.to_hz = 10; });
    holds(Check::ForceSpike,
          [](Expectation& e) { e.high = 1.2, e.from.offset_s = 0.6, e.to.offset_s = 0.61, e.has_to = true; });
    fails(Check::ForceSpike, [](Expectation& e) { e.high = 1.2, e.from.offset_s = 0.6; });
    fails(Check::ForceSpike, [](Expectation& e) { e.high = 1.2, e.from.offset_s = 2.0; });
    holds(Check::ForceRising, [](Expectation&) {});
    holds(Check::SlideRatio, [](Expectation& e) {
        e.low = 0, e.high = 0.1, e.vector = {0, -1, 0}, e.from.offset_s = 0.6;
    });
    fails(Check::SlideRatio, [](Expectation& e) {
        e.low = 0.1, e.high = 0.2, e.vector = {0, -1, 0}, e.from.offset_s = 0.6;
    });
    fails(Check::SlideRatio, [](Expectation& e) {
        e.low = 0, e.high = 0.1, e.vector = {0, 1, 0}, e.from.offset_s = 0.6;
    });
    holds(Check::Distinct, [](Expectation&) {});
    fails(Check::NotDistinct, [](Expectation& e) { e.text = "wood and rubber"; });
    holds(Check::HipAt, [](Expectation& e) { e.vector = {0, 0.9, 1}, e.tolerance = 1e-6; });
    fails(Check::ProxyAt, [](Expectation& e) { e.vector = {0, 0.8, 1}, e.tolerance = 1e-6, e.always = false; });
    fails(Check::BodyAt, [](Expectation& e) { e.vector = {0, 1, 1}, e.tolerance = 0.1; });
    fails(Check::Heading, [](Expectation& e) { e.low = 90, e.tolerance = 1; });
    holds(Check::Penetration, [](Expectation& e) { e.high = 1e-9; });
    holds(Check::Touching, [](Expectation& e) { e.text = "north wall", e.always = false; });
    fails(Check::Touching, [](Expectation& e) { e.text = "north wall"; });
    fails(Check::Free, [](Expectation&) {});
    for (LoggedTick& t : log.ticks) t.force_n.z = 0.2 * std::sin(2.0 * kPi * 5.0 * t.time_s);
    holds(Check::StrongestLine,
          [](Expectation& e) { e.low = 4.8, e.high = 5.2, e.from_hz = 2, e.to_hz = 100, e.tolerance = 0.15; });
    fails(Check::StrongestLine,
          [](Expectation& e) { e.low = 4.8, e.high = 5.2, e.from_hz = 2, e.to_hz = 100, e.tolerance = 0.3; });
    fails(Check::StrongestLine,
          [](Expectation& e) { e.low = 9.0, e.high = 11.0, e.from_hz = 2, e.to_hz = 100, e.tolerance = 0.01; });
    log.ticks.back().proxy_m.y = 0.95;  // puts the proxy 5 cm into the wall
    fails(Check::Penetration, [](Expectation& e) { e.high = 0.04; });
    log.ticks.back().force_n = Vec3(0.0);
    fails(Check::ForceRising, [](Expectation&) {});
}

}  // namespace session_log_test
}  // namespace handrail
