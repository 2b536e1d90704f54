// A real device as the servo sees it: the guard process holds it, this holds the guard. read() and write() are a copy
// in shared memory and at most one system call that does not wait, so the servo rule holds whatever a driver does:
// about 1 us each. The force is felt one exchange after write(), as DeviceSpec::delay_s says. App thread: construction,
// open(), take_news(), destruction. While it is open, a thread of its own looks at both guards every 10 ms, whatever
// the app does: it replaces a second guard that died or stands still, and ends a first one that stands still.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "haptic/device/haptic_device.h"
#include "haptic/drivers/hand_mailbox.h"

namespace handrail {

class GuardedDevice final : public HapticDevice {
public:
    // `guard_program` is started by open() twice (see guard_process.h): to hold the device, and to take its force away
    // should the first fail. `arguments`: the device's name, and its serial number where it has one.
    GuardedDevice(const DeviceSpec& spec, std::filesystem::path guard_program, std::vector<std::string> arguments);
    ~GuardedDevice() override;
    GuardedDevice(const GuardedDevice&) = delete;
    GuardedDevice& operator=(const GuardedDevice&) = delete;

    const DeviceSpec& spec() const override { return spec_; }
    // Starts the guard and waits until it holds the device, at most kOpenS: firmware may have to be sent. Fails in the
    // guard's own sentence. Any one thread until it returns; nothing to do when it is open already.
    Result<void> open() override;
    DeviceSample read(double now_s) noexcept override;
    void write(const ForceCommand& command) noexcept override;
    // Lets the guard zero the force and end; waits for it at most kEndS. Where it does not end, or ended with the
    // device open, waits for the second guard at most kZeroS more. Whether the device may push after that, may_push()
    // says.
    void close() noexcept override;

    // Any thread: an open() that waits fails at once, or the next one does.
    void give_up() noexcept { given_up_.store(true, std::memory_order_release); }
    // Told each of the guard's sentences while open() waits, on the thread that called it; take_news() has them too.
    void tell_while_opening(std::function<void(const std::string&)> tell) { tell_ = std::move(tell); }
    // What the guard told since the last call, in sentences: waking, plugged in again.
    std::vector<std::string> take_news();
    pid_t guard_process() const { return guard_; }
    pid_t relief_process() const;
    // App thread, while it is open: the guard is gone, by a driver that hung or by somebody's hand, and will not look
    // for its device again; the second guard has let go of the device too, so another one may open it.
    bool guard_ended() const noexcept;
    // App thread, once it is closed: what held the device failed, and nobody could make sure that its force is zero.
    bool may_push() const noexcept { return may_push_; }
    // App thread, after open(): in sentences, what neither guard may do on this machine that would keep them at their
    // work. Empty: nothing.
    std::vector<std::string> unprotected() const;

    static constexpr double kOpenS = 30.0;
    static constexpr double kEndS = 1.0;
    static constexpr double kZeroS = 3.0;
    // Of second guards that are started for one that failed, one after the other. One that lives for kProvenLooks looks
    // starts the count anew.
    static constexpr int kMostReliefs = 3;
    static constexpr int kProvenLooks = 1000;

private:
    bool guard_lives() const noexcept;
    bool relief_lives() const noexcept;
    DeviceLoss loss() const noexcept;
    Result<void> start_guards();
    Result<void> start_relief();
    Result<void> start(const char* role, int third_fd, int& life_fd, pid_t& process);
    Result<void> wait_for_ready(int life_fd, double deadline_s);
    void end_process(pid_t& process, double seconds) noexcept;
    void await_zero() noexcept;
    void watch_guards(const std::stop_token& end);
    void replace_relief();
    void notice_long_zeroing();

    DeviceSpec spec_;
    std::filesystem::path guard_program_;
    std::vector<std::string> arguments_;
    HandMailbox* mailbox_ = nullptr;
    int memory_fd_ = -1, wake_fd_ = -1;
    int life_fd_ = -1, relief_life_fd_ = -1;  // sockets to the guard and to the second one
    int guard_fd_ = -1;                       // of the guard's process; readable when it has ended
    pid_t guard_ = -1, relief_ = -1;
    mutable std::mutex mutex_;  // of relief_, relief_life_fd_ and news_ while watch_ runs
    std::jthread watch_;
    int reliefs_left_ = 0;  // to be started in the place of one that failed
    bool may_push_ = false, told_may_push_ = false;
    double zeroing_since_s_ = 0.0;  // app thread
    std::string why_not_zero_;
    std::atomic<bool> given_up_{false};
    std::vector<std::string> news_;
    std::function<void(const std::string&)> tell_;
    // Servo thread.
    DeviceSample last_;
};

// Where the guard's program lies: beside the running one, or in ../libexec/handrail. Empty when it is in neither.
std::filesystem::path find_guard_program();

}  // namespace handrail
