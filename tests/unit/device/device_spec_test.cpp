#include "haptic/device/device_spec.h"

#include <set>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/spoken_language.h"

namespace handrail {
namespace device_spec_test {

TEST(DeviceSpec, rows_have_unique_lower_case_names_and_plausible_facts) {
    std::set<std::string_view> seen;
    for (const DeviceSpec& spec : device_specs()) {
        SCOPED_TRACE(spec.name);
        EXPECT_TRUE(seen.insert(spec.name).second);
        EXPECT_FALSE(spec.spoken_name().empty());
        for (const char c : spec.name) EXPECT_FALSE(c >= 'A' && c <= 'Z');
        EXPECT_GT(spec.peak_force_n, 0.0);
        EXPECT_GT(spec.rated_stiffness_n_per_m, 0.0);
        EXPECT_GT(spec.workspace_radius_m, 0.0);
        EXPECT_GE(spec.delay_s, 0.0);
        EXPECT_GE(spec.min_rate_hz, 0.0);
    }
    EXPECT_EQ(device_names().size(), device_specs().size());
}

TEST(DeviceNames, exist_in_every_language_and_only_for_real_devices) {
    for (const LanguageName& language : bundled_languages()) {
        const test::InLanguage spoken(language.code);
        for (const DeviceSpec& spec : device_specs())
            EXPECT_TRUE(has_phrase("device_name." + std::string(spec.name))) << language.code << ": " << spec.name;
        for (const auto& [key, text] : bundled_texts(language.code)) {
            if (!key.starts_with("device_name.")) continue;
            EXPECT_NE(find_device_spec(key.substr(12)), nullptr) << language.code << ": " << key;
        }
    }
}

TEST(DeviceSpec, is_found_in_any_letter_case_and_unknown_names_are_refused) {
    ASSERT_NE(find_device_spec("SIM-T"), nullptr);
    EXPECT_EQ(find_device_spec("Sim-T"), find_device_spec("sim-t"));
    EXPECT_EQ(find_device_spec("sim"), nullptr);
    EXPECT_EQ(find_device_spec(""), nullptr);
    EXPECT_EQ(find_device_spec("ideal"), &ideal_device_spec());
}

TEST(DeviceSpec, simulated_models_carry_the_published_profiles) {
    const DeviceSpec& touch = *find_device_spec("sim-t");
    EXPECT_EQ(touch.peak_force_n, 3.3);
    EXPECT_EQ(touch.rated_stiffness_n_per_m, 400.0);
    EXPECT_EQ(touch.workspace_radius_m, 0.075);
    const DeviceSpec& falcon = *find_device_spec("sim-f");
    EXPECT_EQ(falcon.peak_force_n, 8.0);
    EXPECT_EQ(falcon.rated_stiffness_n_per_m, 3000.0);
    EXPECT_EQ(falcon.workspace_radius_m, 0.04);
    EXPECT_EQ(falcon.min_rate_hz, 600.0);
}

TEST(DeviceSpec, an_uncalibrated_falcon_is_limited_to_three_newtons) {
    const DeviceSpec& falcon = *find_device_spec("falcon");
    EXPECT_EQ(falcon.peak_force_n, 3.0);
    EXPECT_EQ(falcon.rated_stiffness_n_per_m, 1000.0);
    EXPECT_EQ(falcon.min_rate_hz, 300.0);
}

TEST(EffectiveStiffness, plaster_on_the_simulated_touch_is_300_newtons_per_metre) {
    EXPECT_DOUBLE_EQ(0.75 * effective_stiffness_n_per_m(*find_device_spec("sim-t"), 1e-3, 5.0), 300.0);
}

TEST(EffectiveStiffness, follows_delay_damping_and_measured_period_below_the_rating) {
    const DeviceSpec& falcon = *find_device_spec("sim-f");
    // The effective damping is b_eff = 0.2 + 1 + 0.7 * 5 = 4.7. The default wall has 0.8 of the effective stiffness:
    // 0.5 * 4.7 / 1.5 ms = 1566.7 N/m.
    EXPECT_NEAR(0.8 * effective_stiffness_n_per_m(falcon, 1e-3, 5.0), 1566.67, 0.01);
    // With T = 2 ms, the wall has 0.5 * 4.7 / 2 ms = 1175 N/m.
    EXPECT_NEAR(0.8 * effective_stiffness_n_per_m(falcon, 2e-3, 5.0), 1175.0, 1e-9);
    // Without added damping, b_eff = 1.2 and the wall has 0.5 * 1.2 / 1.5 ms = 400 N/m.
    EXPECT_NEAR(0.8 * effective_stiffness_n_per_m(falcon, 1e-3, 0.0), 400.0, 1e-9);
    DeviceSpec slow = falcon;
    slow.delay_s = 2e-3;  // the wall then has 0.5 * 4.7 / 2.5 ms = 940 N/m
    EXPECT_NEAR(0.8 * effective_stiffness_n_per_m(slow, 1e-3, 5.0), 940.0, 1e-9);
}

TEST(EffectiveStiffness, never_exceeds_the_rating) {
    for (const DeviceSpec& spec : device_specs())
        for (const double period_s : {1e-6, 2.5e-4, 1e-3, 1e-2})
            for (const double damping : {0.0, 5.0, 100.0})
                EXPECT_LE(effective_stiffness_n_per_m(spec, period_s, damping), spec.rated_stiffness_n_per_m)
                    << spec.name;
}

}  // namespace device_spec_test
}  // namespace handrail
