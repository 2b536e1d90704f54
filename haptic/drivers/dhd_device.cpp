#include "haptic/drivers/dhd_device.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "haptic/drivers/force_packing.h"
#include "haptic/drivers/vendor_library.h"
#include "worlds/base/language.h"

namespace handrail::drivers {
namespace {

constexpr char kDefaultDevice = -1;
constexpr int kButtons = 8;
// After this time without a force command, in units of 10 ms, the device brakes automatically.
constexpr std::uint8_t kWatchdogTens = 2;

struct Model {
    int code;
    const char* spec;
};
constexpr std::array kModels{Model{33, "omega"},   Model{34, "omega"},   Model{35, "omega"},   Model{36, "omega"},
                             Model{37, "omega"},   Model{63, "delta"},   Model{104, "sigma"},  Model{105, "sigma"},
                             Model{206, "sigma"},  Model{108, "lambda"}, Model{109, "lambda"}, Model{131, "lambda"},
                             Model{132, "lambda"}, Model{203, "lambda"}, Model{60, "falcon"}};

struct Functions {
    int (*count)();
    int (*open)();
    int (*close)(char);
    int (*type)(char);
    int (*enable_force)(unsigned char, char);
    int (*position)(double*, double*, double*, char);
    int (*set_force)(double, double, double, char);
    int (*button)(int, char);
    int (*stop)(char);
    int (*max_force)(double, char);
    int (*watchdog)(unsigned char, char);
};

class DhdDevice final : public device::HapticDevice {
public:
    DhdDevice(VendorLibrary library, const Functions& call) : library_(std::move(library)), call_(call) {}
    ~DhdDevice() override { DhdDevice::close(); }

    const device::DeviceSpec& spec() const override { return spec_; }

    Result<void> open() override {
        if (call_.count() <= 0) return fail(phrase("drivers.dhd_none"));
        if (call_.open() < 0) return fail(phrase("drivers.dhd_in_use"));
        open_ = true;
        const int code = call_.type(kDefaultDevice);
        const auto model = std::find_if(kModels.begin(), kModels.end(), [&](const Model& m) { return m.code == code; });
        if (model == kModels.end()) return fail(phrase("drivers.dhd_unknown", {{"type", code}}));
        spec_ = *device::find_device_spec(model->spec);
        call_.max_force(spec_.peak_force_n, kDefaultDevice);
        call_.watchdog(kWatchdogTens, kDefaultDevice);
        if (call_.enable_force(1, kDefaultDevice) < 0)
            return fail(phrase("drivers.no_motors", {{"device", spec_.spoken_name()}}));
        return {};
    }

    device::DeviceSample read(double) noexcept override {
        device::DeviceSample sample;
        Vec3 theirs{0.0};
        sample.connected = open_ && call_.position(&theirs.x, &theirs.y, &theirs.z, kDefaultDevice) >= 0;
        sample.fresh = sample.connected;
        sample.position_m = {theirs.y, -theirs.x, theirs.z};
        believed_ = sample.connected && is_finite(theirs);
        for (int i = 0; sample.connected && i < kButtons; ++i)
            if (call_.button(i, kDefaultDevice) > 0) sample.buttons |= 1U << i;
        return sample;
    }

    // After the device reported an impossible position, the force is zero until it reports a possible one.
    void write(const device::ForceCommand& command) noexcept override {
        if (!open_) return;
        const Vec3 force = believed_ ? held_to(command.force_n, spec_.peak_force_n) : Vec3(0.0);
        call_.set_force(-force.y, force.x, force.z, kDefaultDevice);
    }

    void close() noexcept override {
        if (!open_) return;
        call_.set_force(0.0, 0.0, 0.0, kDefaultDevice);
        call_.stop(kDefaultDevice);
        call_.close(kDefaultDevice);
        open_ = false;
    }

private:
    VendorLibrary library_;
    Functions call_;
    device::DeviceSpec spec_ = *device::find_device_spec("omega");
    bool open_ = false, believed_ = false;
};

}  // namespace

Result<std::unique_ptr<device::HapticDevice>> open_dhd_device(const std::string& path) {
    auto library = path.empty() ? VendorLibrary::load({"libdhd.so.3", "libdhd.so"}, "Force Dimension")
                                : VendorLibrary::load({path}, "Force Dimension");
    if (!library) return tl::unexpected(library.error());
    Functions call{};
    const auto complete = library->get("dhdGetDeviceCount", call.count)
                              .get("dhdOpen", call.open)
                              .get("dhdClose", call.close)
                              .get("dhdGetSystemType", call.type)
                              .get("dhdEnableForce", call.enable_force)
                              .get("dhdGetPosition", call.position)
                              .get("dhdSetForce", call.set_force)
                              .get("dhdGetButton", call.button)
                              .get("dhdStop", call.stop)
                              .get("dhdSetMaxForce", call.max_force)
                              .get("dhdSetWatchdog", call.watchdog)
                              .complete();
    if (!complete) return tl::unexpected(complete.error());
    auto device = std::make_unique<DhdDevice>(std::move(*library), call);
    if (const auto opened = device->open(); !opened) return tl::unexpected(opened.error());
    return std::unique_ptr<device::HapticDevice>(std::move(device));
}

}  // namespace handrail::drivers
