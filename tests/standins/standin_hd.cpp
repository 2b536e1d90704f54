// Replaces 3D Systems' libHD in tests. The stand-in has the library's symbols, a thread that runs the callbacks, and
// one device with a simulated hand on it. Axes of the library: x right, y up, z towards the person; lengths in
// millimetres. Tests control the stand-in through the functions that begin with standin_.
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <mutex>
#include <thread>

namespace {

struct State {
    double position_mm[3]{}, velocity[3]{}, force[3]{}, push[3]{};
    double largest = 0.0;
    int ticks = 0;
    bool present = true, nan = false, output = false, disabled = false;
    unsigned calibration = 0x5000, error = 0;
    int uncalibrated_with_force = 0;
};
std::mutex mutex;
State state;
// Number of ticks after which the device is unplugged, counted from the start of the process; 0: never.
const int goes_after = [] {
    const char* ticks = std::getenv("HANDRAIL_STANDIN_GOES_AFTER");
    return ticks ? std::atoi(ticks) : 0;
}();
std::atomic<bool> blocks{false};
std::atomic<bool> running{false};
std::thread scheduler;
unsigned int (*callback)(void*) = nullptr;
void* callback_data = nullptr;

struct ErrorInfo {
    unsigned int code;
    int internal_code;
    unsigned int device;
};

}  // namespace

extern "C" {
unsigned int hdInitDevice(const char*) {
    const std::lock_guard lock(mutex);
    if (!state.present) state.error = 0x0302;
    return state.present ? 0 : 0xFFFFFFFFU;
}
void hdDisableDevice(unsigned int) {
    const std::lock_guard lock(mutex);
    state.disabled = true;
}
void hdMakeCurrentDevice(unsigned int) {}
void hdBeginFrame(unsigned int) {
    while (blocks) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}
void hdEndFrame(unsigned int) {
    const std::lock_guard lock(mutex);
    double square = 0.0;
    for (int i = 0; i < 3; ++i) {
        const double force = state.output ? state.force[i] : 0.0;
        square += force * force;
        state.velocity[i] += (force + state.push[i] - 8.0 * state.velocity[i]) * 1e-3 / 0.1;
        state.position_mm[i] += state.velocity[i] * 1e-3 * 1000.0;
    }
    if (state.calibration != 0x5000 && square > 0.0) ++state.uncalibrated_with_force;
    if (!(std::sqrt(square) <= state.largest)) state.largest = std::sqrt(square);
    if (++state.ticks == goes_after) state.present = false;
    if (!state.present) state.error = 0x0302;
}
void hdEnable(unsigned int what) {
    if (what == 0x4000) state.output = true;
}
void hdGetDoublev(unsigned int what, double* out) {
    const std::lock_guard lock(mutex);
    if (what == 0x2050) {
        for (int i = 0; i < 3; ++i) out[i] = state.position_mm[i];
        if (state.nan) out[1] = std::numeric_limits<double>::quiet_NaN();
    } else if (what == 0x2150) {
        for (int i = 0; i < 3; ++i) out[i] = 0.1 * (i + 1);
    } else if (what == 0x2603) {
        *out = 3.0;
    } else if (what == 0x2602) {
        *out = 0.35;
    }
}
void hdGetIntegerv(unsigned int what, int* out) { *out = what == 0x2000 ? 2 : 4; }
const char* hdGetString(unsigned int) { return "PHANTOM Omni"; }
void hdSetDoublev(unsigned int what, const double* in) {
    const std::lock_guard lock(mutex);
    if (what == 0x2700) std::memcpy(state.force, in, sizeof state.force);
}
ErrorInfo hdGetError() {
    const std::lock_guard lock(mutex);
    const ErrorInfo error{state.error, 0, 0};
    state.error = 0;
    return error;
}
unsigned int hdCheckCalibration() {
    const std::lock_guard lock(mutex);
    return state.calibration;
}
void hdUpdateCalibration(unsigned int style) {
    const std::lock_guard lock(mutex);
    if (style == 4) state.calibration = 0x5000;
}
unsigned long hdScheduleAsynchronous(unsigned int (*function)(void*), void* data, unsigned short) {
    callback_data = data;
    callback = function;
    running = true;
    scheduler = std::thread([] {
        while (running && callback(callback_data) == 1) std::this_thread::sleep_for(std::chrono::microseconds(200));
    });
    return 1;
}
#ifndef STANDIN_LACKS_UNSCHEDULE
void hdUnschedule(unsigned long) {}
#endif
void hdStartScheduler() {}
void hdStopScheduler() {
    running = false;
    if (scheduler.joinable()) scheduler.join();
}

void standin_reset() {
    const std::lock_guard lock(mutex);
    state = {};
    blocks = false;
}
void standin_present(int on) { state.present = on != 0; }
void standin_push(double x, double y, double z) {
    const std::lock_guard lock(mutex);
    state.push[0] = x;
    state.push[1] = y;
    state.push[2] = z;
}
void standin_place(double x, double y, double z) {
    const std::lock_guard lock(mutex);
    state.position_mm[0] = x;
    state.position_mm[1] = y;
    state.position_mm[2] = z;
}
void standin_nan(int on) {
    const std::lock_guard lock(mutex);
    state.nan = on != 0;
}
void standin_blocks(int on) { blocks = on != 0; }
void standin_calibration(unsigned value) {
    const std::lock_guard lock(mutex);
    state.calibration = value;
}
void standin_error(unsigned code) {
    const std::lock_guard lock(mutex);
    state.error = code;
}
void standin_read(double* position_mm, double* force, double* largest, int* ticks, int* disabled,
                  int* uncalibrated_with_force) {
    const std::lock_guard lock(mutex);
    std::memcpy(position_mm, state.position_mm, sizeof state.position_mm);
    std::memcpy(force, state.force, sizeof state.force);
    *largest = state.largest;
    *ticks = state.ticks;
    *disabled = state.disabled;
    *uncalibrated_with_force = state.uncalibrated_with_force;
}
}
