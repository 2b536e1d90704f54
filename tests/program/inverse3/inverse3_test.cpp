// Tests the Inverse3, the only device that does not appear on a bus. `handrail devices` queries the maker's service; in
// this test, a stand-in listens on the port of that service.
#include "haptic/drivers/haply_device.h"

#include <nlohmann/json.hpp>

#include "tests/emulators/haply_service.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"

namespace handrail::test {
namespace inverse3_test {

nlohmann::json inverse3_of(StandInService& service, Mood mood) {
    service.mood = mood;
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {"devices", "--json"};
    const ProgramRun run = run_program(call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    const auto json = nlohmann::json::parse(run.out);
    for (const auto& device : json["devices"])
        if (device["name"] == "inverse3") return device;
    ADD_FAILURE() << run.out << run.err;
    return nullptr;
}

TEST(Inverse3Facts, are_all_available_as_data) {
    for (const bool calibrated : {true, false}) {
        std::optional<StandInService> service;
        try {
            service.emplace(true, kHaplyPort);
        } catch (const std::exception& taken) {
            GTEST_SKIP() << "port " << kHaplyPort << " is in use here: " << taken.what();
        }
        const nlohmann::json device = inverse3_of(*service, calibrated ? Mood::Sound : Mood::Uncalibrated);
        ASSERT_TRUE(device.is_object());
        EXPECT_EQ(device["model"], "Haply Inverse3");
        EXPECT_EQ(device["serial"], "04BA");
        EXPECT_EQ(device["firmware"], "2.7");
        EXPECT_EQ(device["connection"], "127.0.0.1, port 10001");
        EXPECT_EQ(device["kind"], "force");
        EXPECT_EQ(device["workspace_radius_m"], 0.1);
        EXPECT_EQ(device["force_limit_n"], 3.0);
        EXPECT_EQ(device["stiffness_limit_n_per_m"], 500.0);
        EXPECT_EQ(device["rate_hz"], 1000.0);
        EXPECT_EQ(device["state"], calibrated ? "ready" : "needs calibration");
        EXPECT_EQ(device["calibration"].get<std::string>().starts_with("not "), !calibrated);
        EXPECT_EQ(service->messages, 1) << "asking for the facts asks for no force but the zero on leaving";
        const std::lock_guard guard(service->lock);
        EXPECT_EQ(service->largest, 0.0);
    }
}

}  // namespace inverse3_test
}  // namespace handrail::test
