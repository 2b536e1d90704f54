// Replaces Force Dimension's libdhd in tests. The stand-in has the library's symbols and sign conventions, and one
// device with a simulated hand on it. Axes of the library: x towards the person, y right, z up. Tests control the
// stand-in through the functions that begin with standin_.
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

namespace {

struct State {
    int devices = 1, type = 33;
    double position[3]{}, velocity[3]{}, force[3]{}, push[3]{};
    double largest = 0.0;
    bool nan = false, open = false, motors = false;
    double max_force = 0.0;
    int watchdog = 0;
};
State state;
std::atomic<bool> blocks{false};

}  // namespace

extern "C" {
int dhdGetDeviceCount() { return state.devices; }
int dhdOpen() {
    state.open = true;
    return 0;
}
int dhdClose(char) {
    state.open = false;
    return 0;
}
int dhdGetSystemType(char) { return state.type; }
int dhdEnableForce(unsigned char on, char) {
    state.motors = on != 0;
    return 0;
}
int dhdGetPosition(double* x, double* y, double* z, char) {
    while (blocks) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    *x = state.nan ? std::numeric_limits<double>::quiet_NaN() : state.position[0];
    *y = state.position[1];
    *z = state.position[2];
    return state.open ? 0 : -1;
}
#ifndef STANDIN_LACKS_SET_FORCE
// Also moves the simulated hand for a millisecond. The hand has a mass of 0.1 kg and a damping of 8 Ns/m.
int dhdSetForce(double x, double y, double z, char) {
    const double force[3]{x, y, z};
    for (int i = 0; i < 3; ++i) {
        state.force[i] = state.motors ? force[i] : 0.0;
        state.velocity[i] += (state.force[i] + state.push[i] - 8.0 * state.velocity[i]) * 1e-3 / 0.1;
        state.position[i] += state.velocity[i] * 1e-3;
    }
    const double newtons = std::sqrt(x * x + y * y + z * z);
    if (!(newtons <= state.largest)) state.largest = newtons;
    return 0;
}
#endif
int dhdGetButton(int index, char) { return index == 1 ? 1 : 0; }
int dhdStop(char) {
    for (double& f : state.force) f = 0.0;
    return 0;
}
int dhdSetMaxForce(double newtons, char) {
    state.max_force = newtons;
    return 0;
}
int dhdSetWatchdog(unsigned char tens, char) {
    state.watchdog = tens;
    return 0;
}

void standin_reset() {
    state = {};
    blocks = false;
}
void standin_push(double x, double y, double z) {
    state.push[0] = x;
    state.push[1] = y;
    state.push[2] = z;
}
void standin_devices(int count, int type) {
    state.devices = count;
    state.type = type;
}
void standin_nan(int on) { state.nan = on != 0; }
void standin_blocks(int on) { blocks = on != 0; }
void standin_place(double x, double y, double z) {
    state.position[0] = x;
    state.position[1] = y;
    state.position[2] = z;
}
void standin_read(double* position, double* force, double* largest, int* open, int* watchdog) {
    for (int i = 0; i < 3; ++i) {
        position[i] = state.position[i];
        force[i] = state.force[i];
    }
    *largest = state.largest;
    *open = state.open;
    *watchdog = state.watchdog;
}
}
