// Implements the servo's view of a real device. The guard process holds the device, and GuardedDevice controls the
// guard. Each call of read() or write() copies a value in shared memory and makes at most one system call that does not
// wait, about 1 us. The servo thread thus never waits, whatever a driver does. The hand feels a force one exchange
// after write(), as DeviceSpec::delay_s says. App thread: construction, open(), take_news(), destruction. While the
// device is open, a separate thread checks both guards every 10 ms, even if the app hangs. That thread replaces a
// second guard that died or froze, and kills a first guard that froze.
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
    // `arguments` are the device's name and, if it has one, its serial number. open() starts `guard_program` twice (see
    // guard_process.h). The first process holds the device. The second removes the force if the first fails.
    GuardedDevice(const device::DeviceSpec& spec, std::filesystem::path guard_program,
                  std::vector<std::string> arguments);
    ~GuardedDevice() override;
    GuardedDevice(const GuardedDevice&) = delete;
    GuardedDevice& operator=(const GuardedDevice&) = delete;

    const device::DeviceSpec& spec() const override { return spec_; }
    // Starts the guard and waits until the guard has opened the device. The call waits at most kOpenS, because firmware
    // may have to be sent. On failure it returns the guard's own sentence. Any thread may call open(), but only one
    // until it returns. Does nothing if the device is already open.
    Result<void> open() override;
    device::DeviceSample read(double now_s) noexcept override;
    void write(const device::ForceCommand& command) noexcept override;
    // Makes the guard set the force to zero and end, and waits for the guard at most kEndS. If the guard does not end,
    // or had ended while the device was open, the call waits at most kZeroS more for the second guard. Afterwards
    // may_push() says whether the device may still push.
    void close() noexcept override;

    // Makes a waiting open() fail at once. If none is waiting, makes the next open() fail. Any thread.
    void give_up() noexcept { given_up_.store(true, std::memory_order_release); }
    // While open() waits, it passes each of the guard's sentences to `report`, on the thread that called open().
    // take_news() returns these sentences, too.
    void report_while_opening(std::function<void(const std::string&)> report) { report_ = std::move(report); }
    // Returns the guard's sentences since the last call, for example that the device starts or was plugged in again.
    std::vector<std::string> take_news();
    pid_t guard_process() const { return guard_; }
    pid_t relief_process() const;
    // App thread, while the device is open. Returns true if the guard has ended, because its driver hung or somebody
    // killed it, and will not look for its device again. The second guard has then released the device too, so another
    // process may open it.
    bool guard_ended() const noexcept;
    // App thread, after closing. Returns true if the process that held the device failed, and no process could make
    // sure that the force is zero.
    bool may_push() const noexcept { return may_push_; }
    // App thread, after open(). Returns sentences about the protections that this machine denies to the guards; empty
    // if it denies none.
    std::vector<std::string> unprotected() const;

    static constexpr double kOpenS = 30.0;
    static constexpr double kEndS = 1.0;
    static constexpr double kZeroS = 3.0;
    // Number of second guards that may be started, one after the other, to replace failed ones. Once a second guard has
    // lived for kProvenLooks checks, the same number may be started again.
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
    int life_fd_ = -1, relief_life_fd_ = -1;  // sockets to the first guard and to the second guard
    // Process descriptor of the first guard. It becomes readable when the guard has ended.
    int guard_fd_ = -1;
    pid_t guard_ = -1, relief_ = -1;
    mutable std::mutex mutex_;  // protects relief_, relief_life_fd_ and news_ while watch_ runs
    std::jthread watch_;
    int reliefs_left_ = 0;  // how many more second guards may be started as replacements
    bool may_push_ = false, may_push_reported_ = false;
    double zeroing_since_s_ = 0.0;  // when the second guard began to be late with the zero; app thread
    std::string why_not_zero_;
    std::atomic<bool> given_up_{false};
    std::vector<std::string> news_;
    std::function<void(const std::string&)> report_;
    // The sample that read() returned last. Only the servo thread uses it.
    device::DeviceSample last_;
};

// Finds the guard's program, next to the running program or in ../libexec/handrail. Returns an empty path if it is in
// neither folder.
std::filesystem::path find_guard_program();

}  // namespace handrail::drivers
