#include "haptic/drivers/found_device.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace udev_rule_test {

// The udev rule gives users without administrator rights access to devices. The rule must cover exactly the devices
// that the drivers look for.
TEST(UdevRule, names_every_device_that_a_driver_opens) {
    const std::string rule = test::content_of(test::project_root() / "haptic" / "drivers" / kUdevRule);
    ASSERT_FALSE(rule.empty());
    for (const char* id : {"\"0403\"", "\"cb48\"", "\"054c\"", "0ce6", "0df2", "05c4", "09cc", "054C:0CE6", "\"256f\"",
                           "\"046d\"", "\"1451\"", "\"2988\""})
        EXPECT_THAT(rule, testing::HasSubstr(id));
    EXPECT_LT(kUdevRule, "73-seat-late.rules") << "uaccess is carried out there";
    EXPECT_THAT(permission_advice(), testing::HasSubstr(std::string(kUdevRule)));
}

TEST(FoundDevices, are_found_by_name_in_any_letter_case_or_by_serial_number) {
    FoundDevice falcon;
    falcon.name = "falcon";
    falcon.serial = "F100";
    EXPECT_TRUE(is_meant(falcon, "Falcon"));
    EXPECT_TRUE(is_meant(falcon, "F100"));
    EXPECT_FALSE(is_meant(falcon, ""));
    EXPECT_FALSE(is_meant(falcon, "omega"));
    falcon.serial.clear();
    EXPECT_FALSE(is_meant(falcon, ""));
    for (const std::string& name : openable_device_names()) EXPECT_TRUE(find_device_spec(name)) << name;
}

TEST(OpenDevice, with_an_unknown_name_returns_one_sentence) {
    SteadyClock clock;
    const auto opened = open_device("harpsichord", "", clock, {});
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().sentence(), testing::HasSubstr("harpsichord"));
}

}  // namespace udev_rule_test
}  // namespace handrail
