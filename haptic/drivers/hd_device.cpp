#include "haptic/drivers/hd_device.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "haptic/drivers/force_packing.h"
#include "haptic/drivers/vendor_library.h"
#include "worlds/base/language.h"
#include "worlds/base/latest_value.h"
#include "worlds/base/text.h"

namespace handrail::drivers {
namespace {

using Handle = unsigned int;
using Enum = unsigned int;
struct ErrorInfo {
    unsigned int code;
    int internal_code;
    Handle device;
};

constexpr Handle kInvalid = 0xFFFFFFFFU;
constexpr Enum kButtonsParameter = 0x2000, kPosition = 0x2050, kGimbal = 0x2150, kModel = 0x2501,
               kCalibrationStyle = 0x2555, kStiffness = 0x2602, kMaxForce = 0x2603, kForce = 0x2700,
               kForceOutput = 0x4000, kForceClamping = 0x4001, kCalibrated = 0x5000,
               // Status of the calibration. Any other value means that the person calibrates the device by hand, for
               // example in the inkwell.
    kCalibrationNeedsUpdate = 0x5001;
constexpr unsigned short kPriority = 32767;
constexpr unsigned kFirstForceError = 0x0200, kWarmMotors = 0x0200, kLastForceError = 0x0204,
                   kFirstDeviceError = 0x0300, kLastDeviceError = 0x0304;
constexpr double kMetresPerMillimetre = 1e-3;

struct Functions {
    Handle (*init)(const char*);
    void (*disable_device)(Handle);
    void (*make_current)(Handle);
    void (*begin_frame)(Handle);
    void (*end_frame)(Handle);
    void (*enable)(Enum);
    void (*get_double)(Enum, double*);
    void (*get_integer)(Enum, int*);
    const char* (*get_string)(Enum);
    void (*set_double)(Enum, const double*);
    ErrorInfo (*get_error)();
    Enum (*check_calibration)();
    void (*update_calibration)(Enum);
    unsigned long (*schedule)(unsigned int (*)(void*), void*, unsigned short);
    void (*unschedule)(unsigned long);
    void (*start)();
    void (*stop)();
};

class HdDevice final : public device::HapticDevice {
public:
    HdDevice(VendorLibrary library, const Functions& call) : library_(std::move(library)), call_(call) {}
    ~HdDevice() override { HdDevice::close(); }

    const device::DeviceSpec& spec() const override { return spec_; }

    Result<void> open() override {
        handle_ = call_.init(nullptr);
        if (const ErrorInfo error = call_.get_error(); error.code != 0 || handle_ == kInvalid) {
            handle_ = kInvalid;
            return fail(phrase("drivers.hd_none"));
        }
        call_.make_current(handle_);
        name_model();
        call_.enable(kForceOutput);
        call_.enable(kForceClamping);
        call_.start();
        running_ = true;
        scheduled_ = call_.schedule([](void* self) { return static_cast<HdDevice*>(self)->tick(); }, this, kPriority);
        if (call_.get_error().code != 0) return fail(phrase("drivers.no_loop", {{"device", spec_.spoken_name()}}));
        return {};
    }

    device::DeviceSample read(double) noexcept override {
        const bool fresh = sample_.refresh();
        device::DeviceSample sample = sample_.read();
        sample.fresh = fresh;
        // lost_ must be read before hot_ and failed_, because the library's thread sets the reason before lost_.
        sample.connected = handle_ != kInvalid && !lost_.load(std::memory_order_acquire);
        sample.hot = hot_.load(std::memory_order_acquire);
        sample.failed = failed_.load(std::memory_order_acquire);
        return sample;
    }

    void write(const device::ForceCommand& command) noexcept override { force_.publish(command.force_n); }

    void close() noexcept override {
        if (handle_ == kInvalid) return;
        force_.publish(Vec3(0.0));
        ending_.store(true, std::memory_order_release);
        if (running_) {
            call_.stop();
            call_.unschedule(scheduled_);
        }
        call_.make_current(handle_);
        call_.begin_frame(handle_);
        constexpr double kNone[3]{};
        call_.set_double(kForce, kNone);
        call_.end_frame(handle_);
        call_.disable_device(handle_);
        handle_ = kInvalid;
        running_ = false;
    }

private:
    // Exchanges one force and one sample. Runs on the library's thread, between the begin and the end of a frame of the
    // library.
    unsigned int tick() noexcept {
        call_.begin_frame(handle_);
        Vec3 theirs{0.0};
        int buttons = 0;
        call_.get_double(kPosition, &theirs.x);
        call_.get_integer(kButtonsParameter, &buttons);
        Vec3 gimbal{0.0};
        call_.get_double(kGimbal, &gimbal.x);
        const Enum calibration = call_.check_calibration();
        if (calibration == kCalibrationNeedsUpdate) {
            int style = 0;
            call_.get_integer(kCalibrationStyle, &style);
            call_.update_calibration(static_cast<Enum>(style));
        }

        force_.refresh();
        const bool allowed =
            is_finite(theirs) && calibration == kCalibrated && !stopped_ && !ending_.load(std::memory_order_acquire);
        const Vec3 force = allowed ? held_to(force_.read(), spec_.peak_force_n) : Vec3(0.0);
        const double out[3]{force.x, force.z, -force.y};
        call_.set_double(kForce, out);
        call_.end_frame(handle_);

        device::DeviceSample sample;
        sample.position_m = Vec3(theirs.x, -theirs.z, theirs.y) * kMetresPerMillimetre;
        sample.buttons = static_cast<std::uint32_t>(buttons);
        if (is_finite(gimbal)) sample.gimbal_rad = gimbal;
        sample.homed = calibration == kCalibrated;
        sample_.publish(sample);
        for (ErrorInfo error = call_.get_error(); error.code != 0; error = call_.get_error()) {
            // The library has switched the motors off because they were too warm, too fast or too strong. They stay off
            // until the device is opened again.
            if (error.code >= kFirstForceError && error.code <= kLastForceError) {
                (error.code == kWarmMotors ? hot_ : failed_).store(true, std::memory_order_release);
                stopped_ = true;
            }
            if (error.code >= kFirstDeviceError && error.code <= kLastDeviceError)
                lost_.store(true, std::memory_order_release);
            if (stopped_) lost_.store(true, std::memory_order_release);
        }
        return ending_.load(std::memory_order_acquire) ? 0 : 1;
    }

    void name_model() {
        const char* stated = call_.get_string(kModel);
        const std::string model = lower_ascii(stated ? stated : "");
        const char* row = model.find("premium") != std::string::npos   ? "phantom-premium"
                          : model.find("desktop") != std::string::npos ? "phantom-desktop"
                          : model.find("omni") != std::string::npos    ? "omni"
                                                                       : "touch";
        spec_ = *device::find_device_spec(row);
        double value = 0.0;
        call_.get_double(kMaxForce, &value);
        if (value > 0.0 && std::isfinite(value)) spec_.peak_force_n = std::min(spec_.peak_force_n, value);
        value = 0.0;
        call_.get_double(kStiffness, &value);
        if (value > 0.0 && std::isfinite(value))
            // Converts the stiffness, which the library states per mm.
            spec_.rated_stiffness_n_per_m = std::min(spec_.rated_stiffness_n_per_m, value * 1000.0);
        while (call_.get_error().code != 0) {
        }
    }

    VendorLibrary library_;
    Functions call_;
    device::DeviceSpec spec_ = *device::find_device_spec("touch");
    Handle handle_ = kInvalid;
    unsigned long scheduled_ = 0;
    bool running_ = false;
    bool stopped_ = false;  // used by the library's thread only
    std::atomic<bool> ending_{false}, lost_{false}, hot_{false}, failed_{false};
    LatestValue<Vec3> force_{Vec3(0.0)};        // from the owner to the library's thread
    LatestValue<device::DeviceSample> sample_;  // from the library's thread to the owner
};

}  // namespace

Result<std::unique_ptr<device::HapticDevice>> open_hd_device(const std::string& path) {
    auto library = path.empty() ? VendorLibrary::load({"libHD.so", "libHD.so.3.4", "libHD.so.3.0"}, "3D Systems")
                                : VendorLibrary::load({path}, "3D Systems");
    if (!library) return tl::unexpected(library.error());
    Functions call{};
    const auto complete = library->get("hdInitDevice", call.init)
                              .get("hdDisableDevice", call.disable_device)
                              .get("hdMakeCurrentDevice", call.make_current)
                              .get("hdBeginFrame", call.begin_frame)
                              .get("hdEndFrame", call.end_frame)
                              .get("hdEnable", call.enable)
                              .get("hdGetDoublev", call.get_double)
                              .get("hdGetIntegerv", call.get_integer)
                              .get("hdGetString", call.get_string)
                              .get("hdSetDoublev", call.set_double)
                              .get("hdGetError", call.get_error)
                              .get("hdCheckCalibration", call.check_calibration)
                              .get("hdUpdateCalibration", call.update_calibration)
                              .get("hdScheduleAsynchronous", call.schedule)
                              .get("hdUnschedule", call.unschedule)
                              .get("hdStartScheduler", call.start)
                              .get("hdStopScheduler", call.stop)
                              .complete();
    if (!complete) return tl::unexpected(complete.error());
    auto device = std::make_unique<HdDevice>(std::move(*library), call);
    if (const auto opened = device->open(); !opened) return tl::unexpected(opened.error());
    return std::unique_ptr<device::HapticDevice>(std::move(device));
}

}  // namespace handrail::drivers
