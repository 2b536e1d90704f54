// Stands in for handrail-guard and simulates a device, so that tests of the main program need no hardware.
// It starts like handrail-guard.
// The device's name selects its behaviour:
// - echo
// - blocks (after 20 exchanges)
// - nan
// - dies
// - absent
// - stubborn (the force cannot be set to zero)
// - pries (its driver tries to reach forbidden resources and reports which of them it reached)
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <thread>

#include "haptic/drivers/guard_process.h"
#include "tests/support/names.h"
#include "worlds/base/language.h"

namespace {

class NumbersDevice final : public handrail::HapticDevice {
public:
    explicit NumbersDevice(std::string behaviour) : behaviour_(std::move(behaviour)) {}
    const handrail::DeviceSpec& spec() const override { return *handrail::find_device_spec("falcon"); }
    handrail::Result<void> open() override { return {}; }
    handrail::DeviceSample read(double) noexcept override {
        handrail::DeviceSample sample;
        sample.position_m = 0.001 * force_n_;
        if (++exchanges_ < 20) return sample;
        if (behaviour_ == "nan") sample.position_m.x = std::nan("");
        if (behaviour_ == "dies") std::abort();
        while (behaviour_ == "blocks") std::this_thread::sleep_for(std::chrono::seconds(1));
        return sample;
    }
    void write(const handrail::ForceCommand& command) noexcept override { force_n_ = command.force_n; }
    void close() noexcept override {}

private:
    std::string behaviour_;
    handrail::Vec3 force_n_{0.0};
    int exchanges_ = 0;
};

// Tries to reach what a hijacked driver would try to reach. Returns the error number of each attempt; 0 means that the
// attempt succeeded.
std::string reached_by_prying() {
    const auto error_of = [](int result) { return result < 0 ? errno : 0; };
    const int file = error_of(::open("/etc/passwd", O_RDONLY | O_CLOEXEC));
    const int socket = error_of(::socket(AF_UNIX, SOCK_STREAM, 0));
    const int internet = error_of(::socket(AF_INET, SOCK_STREAM, 0));
    char program[] = "/bin/true";
    char* const arguments[] = {program, nullptr};
    const int exec = error_of(::execv(program, arguments));
    const int parent = error_of(::kill(::getppid(), 0));
    return fmt::format("file {}, socket {}, internet {}, exec {}, parent {}", file, socket, internet, exec, parent);
}

}  // namespace

int main(int argc, char** argv) {
    const handrail::NamedDevices devices{
        [](const std::string& name, const std::string&, const std::function<void(const std::string&)>& report)
            -> handrail::Result<std::unique_ptr<handrail::HapticDevice>> {
            if (name == "absent") return handrail::fail(handrail::phrase("drivers.no_falcon"));
            report(name == "pries" ? reached_by_prying() : "Waking it.");
            return std::unique_ptr<handrail::HapticDevice>(std::make_unique<NumbersDevice>(name));
        },
        [](const std::string& name, const std::string&) -> handrail::Result<void> {
            if (name == "stubborn") return handrail::fail(handrail::phrase("drivers.no_falcon"));
            return {};
        },
        [](const std::string&) {
            handrail::Permissions permissions;
            permissions.calls = handrail::Calls::Drive;
            return permissions;
        },
    };
    return handrail::guard_process(argc, argv, devices);
}
