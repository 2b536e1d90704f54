// Tests that the terminal and the session describe devices in the same sentences.
#include "app/main/device_facts.h"

#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/support/spoken_language.h"

namespace handrail {
namespace device_facts_test {
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

FoundDevice falcon() {
    FoundDevice device;
    device.name = "falcon";
    device.model = "Novint Falcon";
    device.driver = "Handrail's own, through libusb";
    device.connection = "USB bus 1, device 7";
    device.firmware = "running";
    device.calibration = "homed";
    device.spec = *find_device_spec("falcon");
    device.rate_hz = 1000.0;
    return device;
}

TEST(DeviceFacts, give_purpose_reach_and_force_of_a_device_and_whether_it_was_ever_tested) {
    EXPECT_THAT(
        device_sentences(falcon()),
        ElementsAre("Novint Falcon, called falcon, on USB bus 1, device 7. It can push the hand in every direction.",
                    "Driver: Handrail's own, through libusb.", "Firmware: running.", "Calibration: homed.",
                    "It reaches 4 centimetres around its middle. It gives up to 3 newtons of force, and walls of up to "
                    "1000 newtons "
                    "per metre.",
                    "Its driver has been tested with an emulator, but not yet with a real device.",
                    "It is updated up to 1000 times a second.", "State: ready."));
    FoundDevice met = falcon();
    met.met_hardware = true;
    EXPECT_THAT(device_sentences(met), Contains("Its driver has been tested with a real device of this kind."));
    FoundDevice pad;
    pad.kind = DeviceKind::Cues;
    EXPECT_THAT(device_sentences(pad), Contains(HasSubstr("it cannot stop the hand")));
    const test::InLanguage german("de");
    EXPECT_THAT(device_sentences(falcon()), Contains(HasSubstr("noch nicht an einem echten Gerät")));
}

TEST(DeviceFacts, of_all_devices_end_with_those_that_are_always_available) {
    const std::vector<std::string> none = device_sentences(std::span<const FoundDevice>());
    ASSERT_EQ(none.size(), 2U);
    EXPECT_THAT(none[0], HasSubstr("No touch device was found."));
    EXPECT_THAT(none[1], HasSubstr("sim-t and sim-f"));
    const std::vector<FoundDevice> two{falcon(), falcon()};
    EXPECT_EQ(device_sentences(two).size(), 2 * device_sentences(falcon()).size() + 1);
}

}  // namespace device_facts_test
}  // namespace handrail
