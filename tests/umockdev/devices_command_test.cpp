// Runs `handrail devices` with every supported kind of device. The command must report each fact as data, and as text
// that a voice can read aloud.
#include <map>
#include <nlohmann/json.hpp>

#include "haptic/drivers/found_device.h"
#include "tests/emulators/usb_function.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/umockdev/mock_hidraw.h"
#include "tests/umockdev/mock_stick.h"
#include "tests/umockdev/mock_usb.h"

namespace handrail {
namespace devices_command_test {

using testing::HasSubstr;
using testing::MatchesRegex;

using ByName = std::map<std::string, nlohmann::json>;

ByName by_name_of(const nlohmann::json& json) {
    ByName by_name;
    for (const auto& device : json["devices"]) by_name[device["name"].get<std::string>()] = device;
    return by_name;
}

// Checks that every fact that a user may query is present. A fact that the device does not have must be null.
void expect_every_fact(const ByName& by_name) {
    for (const auto& [name, device] : by_name) {
        SCOPED_TRACE(name);
        for (const char* key : {"model", "kind", "driver", "connection", "calibration", "state"})
            EXPECT_FALSE(device.at(key).get<std::string>().empty()) << key;
        for (const char* key : {"serial", "firmware", "problem"})
            EXPECT_TRUE(device.at(key).is_null() || !device.at(key).get<std::string>().empty()) << key;
        EXPECT_GT(device.at("rate_hz").get<double>(), 0.0);
        EXPECT_EQ(device.at("usable").get<bool>(), device.at("problem").is_null());
        for (const char* key : {"workspace_radius_m", "force_limit_n", "stiffness_limit_n_per_m", "slowest_rate_hz"}) {
            if (device.at("kind") == "force") EXPECT_GT(device.at(key).get<double>(), 0.0) << key;
            else EXPECT_TRUE(device.at(key).is_null()) << key << ": it pushes nobody";
        }
    }
}

class DevicesCommand : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(umockdev_in_mock_environment()) << "this program needs LD_PRELOAD=libumockdev-preload.so.0";
    }

public:
    static std::string out_of(std::vector<std::string> arguments) {
        test::ProgramCall call;
        call.program = test::built_program("handrail");
        call.arguments = std::move(arguments);
        const test::ProgramRun run = test::run_program(call);
        EXPECT_EQ(run.exit_status, 0) << run.err;
        return run.out;
    }

protected:
    struct Bed {
        UMockdevTestbed* bed = umockdev_testbed_new();
        ~Bed() { g_object_unref(bed); }
    } bed_;
    // One device of each kind that the program finds on a bus.
    test::MockFalconBus falcon_{bed_.bed};
    test::PadEmulator pad_{true, false};
    test::PuckEmulator puck_, vendor_;
    test::HidOnUsb omega_function_{vendor_, 0x1451, 0x0403, "omega.3"},
        touch_function_{vendor_, 0x2988, 0x0304, "Touch"};
    test::MockUsbDevice omega_{bed_.bed, omega_function_, 30}, touch_{bed_.bed, touch_function_, 31};
    test::MockHidraw pad_node_{bed_.bed, pad_, {0, false, 0x054c, 0x0ce6, "DualSense Wireless Controller"}};
    test::MockHidraw puck_node_{bed_.bed, puck_, {2, false, 0x046d, 0xc626, "SpaceNavigator"}};
    test::MockStick stick_{bed_.bed, true};
};

TEST_F(DevicesCommand, lists_every_fact_of_every_device_as_data) {
    {
        const std::lock_guard guard(falcon_.lock);
        falcon_.falcon.stage = test::FalconEmulator::Stage::Running;
        falcon_.falcon.frames_until_homed = 1'000'000;
    }
    const auto json = nlohmann::json::parse(out_of({"devices", "--json"}));
    ByName by_name = by_name_of(json);
    for (const char* name : {"falcon", "omega", "touch", "dualsense", "spacemouse", "force-stick"})
        ASSERT_TRUE(by_name.contains(name)) << name << "\n" << json.dump(1);
    expect_every_fact(by_name);
    EXPECT_EQ(by_name["falcon"]["state"], "needs calibration");
    EXPECT_EQ(by_name["falcon"]["firmware"], "running");
    EXPECT_EQ(by_name["dualsense"]["state"], "ready");
    EXPECT_EQ(by_name["dualsense"]["firmware"], "2.24");
    EXPECT_EQ(by_name["force-stick"]["model"], "Test Stick");
    EXPECT_EQ(by_name["force-stick"]["force_limit_n"], 3.0);
    EXPECT_EQ(by_name["omega"]["state"], "cannot be used yet");
    EXPECT_THAT(by_name["omega"]["problem"].get<std::string>(), HasSubstr("libdhd"));
    EXPECT_THAT(by_name["touch"]["problem"].get<std::string>(), HasSubstr("libHD"));
    EXPECT_THAT(by_name["omega"]["model"].get<std::string>(), HasSubstr("omega"));
    EXPECT_EQ(json["udev_rule"], kUdevRule);
}

// Pads of other kinds: a DualShock 4, a DualSense over Bluetooth, and a pad that only rumbles.
TEST(DevicesCommandPads, lists_every_fact_of_pads) {
    UMockdevTestbed* bed = umockdev_testbed_new();
    {
        test::PadEmulator shock{false, false}, wireless{true, true};
        test::MockHidraw shock_node{bed, shock, {0, false, 0x054c, 0x09cc, "Wireless Controller"}};
        test::MockHidraw wireless_node{bed, wireless, {1, true, 0x054c, 0x0ce6, "DualSense Wireless Controller"}};
        test::MockStick rumbling{bed, false};
        const auto json = nlohmann::json::parse(DevicesCommand::out_of({"devices", "--json"}));
        ByName by_name = by_name_of(json);
        ASSERT_EQ(by_name.size(), 3U) << json.dump(1);
        expect_every_fact(by_name);
        for (const auto& [name, device] : by_name) EXPECT_NE(device.at("kind"), "force") << name;
        EXPECT_THAT(by_name.at("dualsense").at("connection").get<std::string>(), HasSubstr("Bluetooth"));
    }
    g_object_unref(bed);
}

// The output must consist of whole sentences without tables, signs or brackets, because a voice reads it aloud.
TEST_F(DevicesCommand, lists_devices_in_words_that_a_voice_can_read) {
    const std::string words = out_of({"devices"});
    for (const char* part :
         {"Novint Falcon", "DualSense", "SpaceNavigator", "Test Stick", "omega", "Touch", "State: ready."})
        EXPECT_THAT(words, HasSubstr(part));
    std::istringstream lines(words);
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        EXPECT_THAT(line, MatchesRegex(".*[.]")) << "a sentence ends";
        for (const char sign : std::string_view("{}[]|<>=*\t")) EXPECT_EQ(line.find(sign), std::string::npos) << line;
    }
    EXPECT_GT(count, 20);
}

}  // namespace devices_command_test
}  // namespace handrail
