#include "haptic/drivers/hand_guard.h"

#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

#include "haptic/drivers/found_device.h"
#include "haptic/drivers/guard_permissions.h"
#include "haptic/drivers/haply_device.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/drivers/guard_rig.h"

namespace handrail {
namespace hand_guard_test {

using namespace std::chrono_literals;
using test::tick_until;

// Records what happens to a device, in order, and contains instructions for its behaviour.
struct Life {
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<Vec3> forces;
    int opened = 0, closed = 0;
    bool connected = true, refuse = false, blocked = false;

    template <class Condition>
    bool wait(Condition&& condition) {
        std::unique_lock lock(mutex);
        return changed.wait_for(lock, std::chrono::duration<double>(test::kPatience_s), condition);
    }
};

class RecordingDevice final : public HapticDevice {
public:
    explicit RecordingDevice(Life& life) : life_(life) {}
    const DeviceSpec& spec() const override { return *find_device_spec("falcon"); }
    Result<void> open() override { return {}; }
    DeviceSample read(double) noexcept override {
        std::unique_lock lock(life_.mutex);
        life_.changed.wait(lock, [this] { return !life_.blocked; });
        DeviceSample sample;
        sample.position_m = Vec3(0.001 * static_cast<double>(life_.forces.size()));
        sample.connected = life_.connected;
        return sample;
    }
    void write(const ForceCommand& command) noexcept override {
        const std::lock_guard lock(life_.mutex);
        life_.forces.push_back(command.force_n);
        life_.changed.notify_all();
    }
    void close() noexcept override {
        const std::lock_guard lock(life_.mutex);
        ++life_.closed;
        life_.changed.notify_all();
    }

private:
    Life& life_;
};

// A guard on a separate thread. The test acts as the program.
struct Guard : test::GuardEnds {
    Life life;
    HandMailbox mailbox;
    int wake = ::eventfd(0, EFD_NONBLOCK);
    std::atomic<bool> stuck{false};
    std::atomic<int> status{-1};
    std::thread thread;

    ~Guard() {
        leave();
        if (thread.joinable()) thread.join();
        ::close(wake);
    }
    void start() {
        thread = std::thread([this] {
            status = guard_hand(
                mailbox, wake, guards(),
                [this](const std::function<void(const std::string&)>& report) -> Result<std::unique_ptr<HapticDevice>> {
                    const std::lock_guard lock(life.mutex);
                    if (life.refuse) return fail("It is not plugged in.");
                    ++life.opened;
                    life.changed.notify_all();
                    report("Waking it.");
                    return std::unique_ptr<HapticDevice>(std::make_unique<RecordingDevice>(life));
                },
                [this] { stuck = true; });
        });
    }
    void command(const Vec3& force_n) {
        mailbox.command.publish({force_n});
        test::signal_event(wake);
    }
};

TEST(HandGuard, reports_its_status_and_exchanges_each_force_for_a_sample) {
    Guard guard;
    guard.start();
    EXPECT_EQ(guard.message(), "nWaking it.");
    EXPECT_EQ(guard.message(), "r");
    guard.command({1.0, 2.0, 3.0});
    ASSERT_TRUE(
        guard.life.wait([&] { return !guard.life.forces.empty() && guard.life.forces.back() == Vec3(1.0, 2.0, 3.0); }));
    EXPECT_TRUE(test::eventually([&] { return guard.mailbox.answer.refresh(); }));
    EXPECT_GT(guard.mailbox.answer.read().position_m.x, 0.0);
}

TEST(HandGuard, zeroes_the_force_when_the_program_stops_sending_commands) {
    Guard guard;
    guard.start();
    guard.command({0.0, 2.0, 0.0});
    ASSERT_TRUE(
        guard.life.wait([&] { return !guard.life.forces.empty() && guard.life.forces.back() == Vec3(0.0, 2.0, 0.0); }));
    ASSERT_TRUE(guard.life.wait([&] { return guard.life.forces.back() == Vec3(0.0); }));
    // The guard must set the force to zero at the first exchange after the old force.
    const std::lock_guard lock(guard.life.mutex);
    const auto last_force = std::find_if(guard.life.forces.rbegin(), guard.life.forces.rend(),
                                         [](const Vec3& f) { return f != Vec3(0.0); });
    EXPECT_LE(last_force - guard.life.forces.rbegin(), 2);
    EXPECT_EQ(std::count(guard.life.forces.begin(), guard.life.forces.end(), Vec3(0.0, 2.0, 0.0)), 1);
}

TEST(HandGuard, releases_the_device_when_the_program_is_gone) {
    Guard guard;
    guard.start();
    guard.command({0.0, 2.0, 0.0});
    ASSERT_TRUE(guard.life.wait([&] { return !guard.life.forces.empty(); }));
    guard.leave();
    ASSERT_TRUE(guard.life.wait([&] { return guard.life.closed == 1; }));
    guard.thread.join();
    EXPECT_EQ(guard.status, 0);
}

TEST(HandGuard, searches_for_an_unplugged_device_until_it_returns) {
    Guard guard;
    guard.start();
    ASSERT_EQ(guard.message(), "nWaking it.");
    ASSERT_EQ(guard.message(), "r");
    {
        const std::lock_guard lock(guard.life.mutex);
        guard.life.connected = false;
        guard.life.refuse = true;
    }
    guard.command({0.0, 2.0, 0.0});
    ASSERT_TRUE(guard.life.wait([&] { return guard.life.closed == 1; }));
    EXPECT_TRUE(
        test::eventually([&] { return guard.mailbox.answer.refresh() && !guard.mailbox.answer.read().connected; }));
    {
        const std::lock_guard lock(guard.life.mutex);
        guard.life.connected = true;
        guard.life.refuse = false;
    }
    ASSERT_TRUE(guard.life.wait([&] { return guard.life.opened == 2; }));
    EXPECT_TRUE(test::eventually([&] {
        guard.command(Vec3(0.0));
        return guard.mailbox.answer.refresh() && guard.mailbox.answer.read().connected;
    }));
}

TEST(HandGuard, notices_a_driver_call_that_does_not_return) {
    Guard guard;
    {
        const std::lock_guard lock(guard.life.mutex);
        guard.life.blocked = true;
    }
    guard.start();
    guard.command({0.0, 2.0, 0.0});
    EXPECT_TRUE(test::eventually([&] { return guard.stuck.load(); }));
    const std::lock_guard lock(guard.life.mutex);
    guard.life.blocked = false;
    guard.life.changed.notify_all();
}

TEST(HandGuard, reports_why_there_is_no_device) {
    Guard guard;
    guard.life.refuse = true;
    guard.start();
    EXPECT_EQ(guard.message(), "fIt is not plugged in.");
    guard.thread.join();
    EXPECT_EQ(guard.status, 1);
}

TEST(GuardedDevice, reports_in_one_sentence_that_its_guard_is_missing_or_has_ended) {
    GuardedDevice without(*find_device_spec("falcon"), "", {});
    ASSERT_FALSE(without.open());
    EXPECT_THAT(without.open().error().sentence(), testing::HasSubstr("handrail-guard"));
    EXPECT_FALSE(without.read(0.0).connected);
    without.write({Vec3(1.0)});
    GuardedDevice other(*find_device_spec("falcon"), "/bin/true", {});
    const auto opened = other.open();
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().sentence(), testing::HasSubstr("ended unexpectedly"));
}

TEST(GuardedDevice, receives_guard_messages_in_the_language_of_the_program) {
    const test::InLanguage german("de");
    GuardedDevice absent(*find_device_spec("falcon"), test::built_program("standin_guard"), {"absent"});
    const auto opened = absent.open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().sentence(), "Der Falcon ist nicht angesteckt.");
}

TEST(GuardedDevice, receives_the_persons_custom_texts_from_its_guard) {
    const test::TemporaryFolder folder;
    folder.write("de.toml", "[drivers]\nno_falcon = \"Kein Falcon da.\"\n");
    const test::InLanguage own("de", folder.path());
    GuardedDevice absent(*find_device_spec("falcon"), test::built_program("standin_guard"), {"absent"});
    const auto opened = absent.open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().sentence(), "Kein Falcon da.");
}

TEST(GuardedDevice, exchanges_samples_with_a_separate_process) {
    GuardedDevice device(*find_device_spec("falcon"), test::built_program("standin_guard"), {"echo"});
    const auto opened = device.open();
    ASSERT_TRUE(opened) << opened.error().sentence();
    EXPECT_THAT(device.take_news(), testing::ElementsAre("Waking it."));
    EXPECT_TRUE(tick_until(
        device, [](const DeviceSample& sample) { return sample.fresh && sample.position_m == Vec3(0.0, 0.002, 0.0); }));
    device.close();
    EXPECT_FALSE(device.read(0.0).connected);
    ASSERT_TRUE(device.open()) << "and again";
    EXPECT_TRUE(tick_until(device, [](const DeviceSample& sample) { return sample.fresh; }));
}

TEST(GuardedDevice, is_confined_so_that_its_driver_reaches_no_file_socket_program_or_process) {
#if defined(HANDRAIL_SANITIZED)
    GTEST_SKIP() << "a sanitizer needs some of these";
#endif
    if (confinement_offered().landlock == 0) GTEST_SKIP() << "this kernel offers no Landlock";
    GuardedDevice device(*find_device_spec("falcon"), test::built_program("standin_guard"), {"pries"});
    ASSERT_TRUE(device.open());
    EXPECT_THAT(device.take_news(),
                testing::ElementsAre(fmt::format("file {}, socket {}, internet {}, exec {}, parent {}", EACCES, EPERM,
                                                 EPERM, EPERM, EPERM)));
    EXPECT_TRUE(tick_until(device, [](const DeviceSample& sample) { return sample.fresh; })) << "and still drives";
}

TEST(GuardPermissions, are_exactly_those_that_each_driver_needs) {
    const auto writes = [](const char* device) { return guard_permissions(device).read_and_write; };
    using testing::Contains;
    using testing::ElementsAre;
    using testing::Not;
    EXPECT_THAT(writes("falcon"), ElementsAre("/dev/bus/usb"));
    EXPECT_THAT(writes("force-stick"), ElementsAre("/dev/input"));
    EXPECT_THAT(writes("inverse3"), ElementsAre());
    EXPECT_THAT(guard_permissions("inverse3").tcp_ports, ElementsAre(kHaplyPort));
    EXPECT_THAT(writes("omega"), Contains("/dev/bus/usb"));
    EXPECT_THAT(writes("touch"), Contains("/dev"));
    for (const std::string& device : openable_device_names()) {
        const Permissions permissions = guard_permissions(device);
        EXPECT_EQ(permissions.calls, Calls::Drive) << device;
        EXPECT_FALSE(permissions.unix_sockets) << device;
        EXPECT_EQ(permissions.any_internet, is_found_only_by_opening(device)) << device;
        EXPECT_EQ(permissions.tcp_ports.empty(), device != "inverse3") << device;
        EXPECT_EQ(permissions.device_events, device != "inverse3") << device;
        EXPECT_THAT(permissions.read, Not(Contains(std::filesystem::path(std::getenv("HOME"))))) << device;
        for (const auto& path : permissions.read) EXPECT_NE(path, "/") << device;
    }
}

// A person's environment contains keys of the person and addresses of other programs.
TEST(GuardedDevice, passes_only_the_environment_variables_that_drivers_need) {
    const std::map<std::string, std::string> hidden{{"SSH_AUTH_SOCK", "/run/agent"},
                                                    {"DBUS_SESSION_BUS_ADDRESS", "unix:path=/run/bus"},
                                                    {"GTDD_HOME_OF_MINE", "x"},
                                                    {"A_TOKEN", "secret"}},
        kept{{"GTDD_HOME", "/opt/touch"}, {"OH_SDK_BASE", "/opt/haptics"}, {"HANDRAIL_FALCON_FIRMWARE", "/f.bin"}};
    for (const auto* variables : {&hidden, &kept})
        for (const auto& [name, value] : *variables) ::setenv(name.c_str(), value.c_str(), 1);
    GuardedDevice device(*find_device_spec("falcon"), test::built_program("standin_guard"), {"echo"});
    const auto opened = device.open();
    for (const auto* variables : {&hidden, &kept})
        for (const auto& [name, value] : *variables) ::unsetenv(name.c_str());
    ASSERT_TRUE(opened) << opened.error().message;
    for (const pid_t guard : {device.guard_process(), device.relief_process()}) {
        const std::string environment = std::string(1, '\0') + test::content_of(fmt::format("/proc/{}/environ", guard));
        const auto has = [&](const std::string& name, const std::string& value) {
            return environment.find(fmt::format("{}{}={}{}", '\0', name, value, '\0')) != std::string::npos;
        };
        for (const auto& [name, value] : hidden) EXPECT_FALSE(has(name, value)) << name;
        for (const auto& [name, value] : kept) EXPECT_TRUE(has(name, value)) << name;
    }
}

TEST(GuardedDevice, counts_as_unplugged_when_its_guard_dies_or_exits_because_of_a_blocked_driver) {
    for (const char* behaviour : {"dies", "blocks"}) {
        GuardedDevice device(*find_device_spec("falcon"), test::built_program("standin_guard"), {behaviour});
        ASSERT_TRUE(device.open());
        EXPECT_TRUE(tick_until(device, [](const DeviceSample& sample) { return sample.fresh; })) << behaviour;
        EXPECT_TRUE(tick_until(device, [](const DeviceSample& sample) { return !sample.connected; })) << behaviour;
    }
}

TEST(GuardedDevice, passes_invalid_positions_on_to_the_servo_for_judgement) {
    GuardedDevice device(*find_device_spec("falcon"), test::built_program("standin_guard"), {"nan"});
    ASSERT_TRUE(device.open());
    EXPECT_TRUE(
        tick_until(device, [](const DeviceSample& sample) { return sample.fresh && !is_finite(sample.position_m); }));
}

}  // namespace hand_guard_test
}  // namespace handrail
