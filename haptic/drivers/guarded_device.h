// A real device as the servo sees it: the guard process holds the device, and this class controls the guard. read() and
// write() are a copy in shared memory and at most one system call that does not wait. The servo thread thus never
// waits, whatever a driver does; each call takes about 1 us. The force is felt one exchange after write(), as
// DeviceSpec::delay_s says. App thread: construction, open(), take_news(), destruction. While it is open, a separate
// thread checks both guards every 10 ms, whatever the app does. It replaces a second guard that died or froze, and
// kills a first one that froze.
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

namespace handrail::drivers {

class GuardedDevice final : public device::HapticDevice {
public:
    // open() starts `guard_program` twice (see guard_process.h): once to hold the device, once to take its force away
    // if the first one fails. `arguments`: the device's name, and its serial number if it has one.
    GuardedDevice(const device::DeviceSpec& spec, std::filesystem::path guard_program,
                  std::vector<std::string> arguments);
    ~GuardedDevice() override;
    GuardedDevice(const GuardedDevice&) = delete;
    GuardedDevice& operator=(const GuardedDevice&) = delete;

    const device::DeviceSpec& spec() const override { return spec_; }
    // Starts the guard and waits until it holds the device, at most kOpenS, because firmware may have to be sent. On
    // failure it returns the guard's own sentence. Any single thread until it returns; does nothing if it is open
    // already.
    Result<void> open() override;
    device::DeviceSample read(double now_s) noexcept override;
    void write(const device::ForceCommand& command) noexcept override;
    // Lets the guard zero the force and end; waits for it at most kEndS. If the guard does not end, or ended with the
    // device open, waits for the second guard at most kZeroS more. Afterwards may_push() says whether the device may
    // still push.
    void close() noexcept override;

    // Any thread: makes a waiting open() fail at once, or else the next one.
    void give_up() noexcept { given_up_.store(true, std::memory_order_release); }
    // `tell` gets each of the guard's sentences while open() waits, on the thread that called it; take_news() returns
    // them too.
    void tell_while_opening(std::function<void(const std::string&)> tell) { tell_ = std::move(tell); }
    // The guard's sentences since the last call, for example that the device starts or was plugged in again.
    std::vector<std::string> take_news();
    pid_t guard_process() const { return guard_; }
    pid_t relief_process() const;
    // App thread, while it is open: true if the guard has gone, because of a driver that hung or because it was killed,
    // and will not look for its device again. The second guard has released the device too, so another process may open
    // it.
    bool guard_ended() const noexcept;
    // App thread, after closing: the process that held the device failed, and no process could make sure that the force
    // is zero.
    bool may_push() const noexcept { return may_push_; }
    // App thread, after open(): says in sentences which protections this machine denies to the guards. Empty: none.
    std::vector<std::string> unprotected() const;

    static constexpr double kOpenS = 30.0;
    static constexpr double kEndS = 1.0;
    static constexpr double kZeroS = 3.0;
    // Most second guards that are started one after the other for failed ones. After one lives for kProvenLooks looks,
    // the count starts again.
    static constexpr int kMostReliefs = 3;
    static constexpr int kProvenLooks = 1000;

private:
    bool guard_lives() const noexcept;
    bool relief_lives() const noexcept;
    device::DeviceLoss loss() const noexcept;
    Result<void> start_guards();
    Result<void> start_relief();
    Result<void> start(const char* role, int third_fd, int& life_fd, pid_t& process);
    Result<void> wait_for_ready(int life_fd, double deadline_s);
    void end_process(pid_t& process, double seconds) noexcept;
    void await_zero() noexcept;
    void watch_guards(const std::stop_token& end);
    void replace_relief();
    void notice_long_zeroing();

    device::DeviceSpec spec_;
    std::filesystem::path guard_program_;
    std::vector<std::string> arguments_;
    HandMailbox* mailbox_ = nullptr;
    int memory_fd_ = -1, wake_fd_ = -1;
    int life_fd_ = -1, relief_life_fd_ = -1;  // sockets to the guard and to the second guard
    int guard_fd_ = -1;                       // process descriptor of the guard; readable after it has ended
    pid_t guard_ = -1, relief_ = -1;
    mutable std::mutex mutex_;  // protects relief_, relief_life_fd_ and news_ while watch_ runs
    std::jthread watch_;
    int reliefs_left_ = 0;  // second guards that may still be started for failed ones
    bool may_push_ = false, told_may_push_ = false;
    double zeroing_since_s_ = 0.0;  // app thread
    std::string why_not_zero_;
    std::atomic<bool> given_up_{false};
    std::vector<std::string> news_;
    std::function<void(const std::string&)> tell_;
    // Used by the servo thread only.
    device::DeviceSample last_;
};

// Finds the guard's program, next to the running one or in ../libexec/handrail. Empty if it is in neither.
std::filesystem::path find_guard_program();

}  // namespace handrail::drivers
