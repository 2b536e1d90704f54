// A real device as the servo sees it: the guard process holds it, this holds the guard. read() and write() are a copy in shared memory and at
// most one system call that does not wait, so the servo rule holds whatever a driver does: about 1 us each.
// The force is felt one exchange after write(), as DeviceSpec::delay_s says. App thread: construction, open(), take_news(), destruction.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "haptic/device/haptic_device.h"
#include "haptic/drivers/hand_mailbox.h"

namespace handrail {

class GuardedDevice final : public HapticDevice {
public:
    // `guard_program` is started by open() with three descriptors, the language spoken by then and the folder of its own file, and `arguments`.
    GuardedDevice(const DeviceSpec& spec, std::filesystem::path guard_program, std::vector<std::string> arguments);
    ~GuardedDevice() override;
    GuardedDevice(const GuardedDevice&) = delete;
    GuardedDevice& operator=(const GuardedDevice&) = delete;

    const DeviceSpec& spec() const override { return spec_; }
    // Starts the guard and waits until it holds the device, at most kOpenS: firmware may have to be sent. Fails in the guard's own sentence.
    // Any one thread until it returns; nothing to do when it is open already.
    Result<void> open() override;
    DeviceSample read(double now_s) noexcept override;
    void write(const ForceCommand& command) noexcept override;
    // Lets the guard zero the force and end; waits for it at most kEndS.
    void close() noexcept override;

    // Any thread: an open() that waits fails at once, or the next one does.
    void give_up() noexcept { given_up_.store(true, std::memory_order_release); }
    // Told each of the guard's sentences while open() waits, on the thread that called it; take_news() has them too.
    void tell_while_opening(std::function<void(const std::string&)> tell) { tell_ = std::move(tell); }
    // What the guard told since the last call, in sentences: waking, plugged in again.
    std::vector<std::string> take_news();
    pid_t guard_process() const { return guard_; }
    // App thread, while it is open: the guard is gone, by a driver that hung or by somebody's hand, and will not look for its device again.
    bool guard_ended() const noexcept { return life_fd_ >= 0 && !guard_lives(); }

    static constexpr double kOpenS = 30.0;
    static constexpr double kEndS = 1.0;

private:
    bool guard_lives() const noexcept;
    Result<void> start_guard();

    DeviceSpec spec_;
    std::filesystem::path guard_program_;
    std::vector<std::string> arguments_;
    HandMailbox* mailbox_ = nullptr;
    int wake_fd_ = -1, life_fd_ = -1;
    pid_t guard_ = -1;
    std::atomic<bool> given_up_{false};
    std::vector<std::string> news_;  // app thread
    std::function<void(const std::string&)> tell_;
    // Servo thread.
    DeviceSample last_;
};

// Where the guard's program lies: beside the running one, or in ../libexec/handrail. Empty when it is in neither.
std::filesystem::path find_guard_program();

}  // namespace handrail
