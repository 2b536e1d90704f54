// Drives the Novint Falcon. The driver sends the Falcon its firmware, waits until the legs are homed, and exchanges one
// force against one position at a time. All calls come from one thread. read() waits for the answer to the force that
// write() sent, at most kAnswerDeadlineS, and its USB calls allocate. With a real Falcon the driver therefore belongs
// in the guard process (hand_guard.h), never on the servo thread. It gives no force before all three legs are homed,
// after 20 ms without an answer, or at a position that the legs cannot reach. It never gives more than the peak force
// of the DeviceSpec.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "haptic/device/haptic_device.h"
#include "haptic/drivers/byte_link.h"
#include "haptic/drivers/falcon_protocol.h"
#include "worlds/base/clock.h"

namespace handrail::drivers {

struct FalconOptions {
    // Firmware files, tried in this order. They are needed only if no firmware runs on the device yet.
    std::vector<std::filesystem::path> firmware_files;
    // Motor counts per newton metre. The true figure is unpublished, and sources differ by a factor of four. The open
    // driver uses 10,000.
    double counts_per_nm = 10000.0;
    // Receives progress sentences while the device starts; may be empty.
    std::function<void(const std::string&)> report;
};

// Returns the usual paths of the firmware file: HANDRAIL_FALCON_FIRMWARE, the person's data folder, the machine's data
// folders, /lib/firmware/novint, and libnifalcon's folder.
std::vector<std::filesystem::path> falcon_firmware_files();
// Returns true if the file is a complete boot image.
bool falcon_firmware_is_sound(const std::filesystem::path& file);
// Returns the folder where a person should put the firmware file, which sentences for the person name. It is the folder
// of the first path that falcon_firmware_files() returns.
std::filesystem::path falcon_firmware_folder();

class FalconDevice final : public device::HapticDevice {
public:
    static constexpr double kAnswerDeadlineS = 0.005;
    static constexpr double kZeroAfterSilenceS = 0.020;
    static constexpr int kUploadTries = 3;
    // A leg is stuck if its count does not change while another leg turns by kStuckCounts (about 5 mm of the grip),
    // because no hand keeps a leg that still. Several answers must confirm this, so that two equal counts by chance are
    // not enough.
    static constexpr int kStuckCounts = 150;
    static constexpr int kStuckAnswers = 10;
    // Three encoders measure three directions, so there is no redundancy to check them against. A hand may well move a
    // few millimetres along a line on which one leg stands still. If a leg seems stuck, the driver therefore reduces
    // the force before it raises a fault. From kSuspectCounts (about 2 mm) on the force falls, and at kDistrustCounts
    // it is zero. The force returns over 20 answers once the leg moves by a single count. If a movement turns only the
    // stuck leg, the driver cannot notice the fault.
    static constexpr int kSuspectCounts = 50;
    static constexpr int kDistrustCounts = 100;
    static constexpr double kTrustPerAnswer = 0.05;

    // The clock must outlive the device.
    FalconDevice(std::unique_ptr<ByteLink> link, Clock& clock, FalconOptions options = {});
    ~FalconDevice() override;

    const device::DeviceSpec& spec() const override { return spec_; }
    // Takes up to a few seconds if the firmware must be sent. Each error is a sentence for the person.
    Result<void> open() override;
    device::DeviceSample read(double now_s) noexcept override;
    void write(const device::ForceCommand& command) noexcept override;
    void close() noexcept override;

    bool firmware_was_running() const { return firmware_was_running_; }
    std::uint8_t homed_legs() const { return status_.homed_legs; }
    std::uint64_t skipped_bytes() const { return reader_.skipped(); }
    // Returns true if the firmware runs and answers, without starting the device. Sends no force and no firmware.
    bool answers();

private:
    bool run_mode() noexcept;
    bool wait_for_answer(double deadline_s) noexcept;
    void send(const std::array<int, 3>& motors) noexcept;
    bool says_hello() noexcept;
    Result<void> upload(std::span<const std::uint8_t> image);
    void report(const std::string& sentence) const;
    bool echoed(std::span<const std::uint8_t> sent, double deadline_s) noexcept;
    std::size_t take(std::span<std::uint8_t> room, double deadline_s) noexcept;
    void forget_place() noexcept;
    bool is_stuck(const std::array<int, 3>& encoders) noexcept;

    device::DeviceSpec spec_;
    std::unique_ptr<ByteLink> link_;
    Clock& clock_;
    FalconOptions options_;
    FalconFrameReader reader_;
    FalconStatus status_;
    bool lost_ = false;
    bool firmware_was_running_ = false;
    int in_flight_ = 0;
    double answered_s_ = 0.0;
    bool knows_place_ = false;
    Vec3 grip_m_{0.0}, leg_angles_rad_{0.0};  // values of the last answer, Falcon axes
    struct Stillness {
        int count = 0;
        int answers = 0;  // number of answers in a row with an unchanged count
        std::array<int, 3> others_low{}, others_high{};
    };
    double trust_ = 1.0;  // factor for the force, less than 1 while a leg is suspected to be stuck
    bool watches_legs_ = false;
    std::array<Stillness, 3> stillness_{};
};

}  // namespace handrail::drivers
