// A guard process with a device made of numbers, so that the program's side can be tried without any hardware. Started like handrail-guard;
// the name says how the device behaves: echo, blocks (after 20 exchanges), nan, dies, absent.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <thread>

#include "haptic/drivers/hand_guard.h"
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

}  // namespace

int main(int argc, char** argv) {
    if (argc < 7) return 2;
    return handrail::run_guard_process(std::atoi(argv[1]), std::atoi(argv[2]), std::atoi(argv[3]),
                                       [&](const std::function<void(const std::string&)>& tell) -> handrail::Result<std::unique_ptr<handrail::HapticDevice>> {
                                           (void)handrail::speak_language(argv[4], argv[5]);
                                           if (std::string(argv[6]) == "absent") return handrail::fail(handrail::phrase("drivers.no_falcon"));
                                           tell("Waking it.");
                                           return std::unique_ptr<handrail::HapticDevice>(std::make_unique<NumbersDevice>(argv[6]));
                                       });
}
