// The Novint Falcon: wakes it (firmware), watches it home, and exchanges one force against one position at a time.
// Whoever owns it calls from one thread. read() waits for the answer to the force that write() sent, at most
// kAnswerDeadlineS, and its USB calls allocate; so on a live device it belongs into the guard process (hand_guard.h),
// never on the servo thread. No force before all three legs are homed, after 20 ms without an answer, or at a place the
// legs cannot be; never above the spec's peak.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "haptic/device/haptic_device.h"
#include "haptic/drivers/byte_link.h"
#include "haptic/drivers/falcon_protocol.h"
#include "worlds/base/clock.h"

namespace handrail {

struct FalconOptions {
    std::vector<std::filesystem::path> firmware_files;  // tried in this order; needed only when none runs yet
    // Nobody has published the true figure; 10,000 is what the open driver takes. Sources differ by a factor of four.
    double counts_per_nm = 10000.0;
    std::function<void(const std::string&)> tell;  // what goes on while it is woken, in sentences; may be empty
};

// What stands where people put it: HANDRAIL_FALCON_FIRMWARE, the person's data folder, the machine's,
// /lib/firmware/novint, libnifalcon's.
std::vector<std::filesystem::path> falcon_firmware_files();
// True for a file that is a whole boot image.
bool falcon_firmware_is_sound(const std::filesystem::path& file);
// Where to put the file, for a sentence: the first of the folders.
std::filesystem::path falcon_firmware_folder();

class FalconDevice final : public HapticDevice {
public:
    static constexpr double kAnswerDeadlineS = 0.005;
    static constexpr double kZeroAfterSilenceS = 0.020;
    static constexpr int kUploadTries = 3;
    // A leg that keeps its very count while another turns by so much (about 5 mm of the grip) is stuck: no hand is that
    // still. Over a few answers, so that no two of them can agree by chance.
    static constexpr int kStuckCounts = 150;
    static constexpr int kStuckAnswers = 10;
    // Three encoders for three directions leave nothing to check against, and a hand may well draw a few millimetres of
    // line along which one leg stands still. So suspicion first costs force and not a fault: from kSuspectCounts (about
    // 2 mm) on it goes down, at kDistrustCounts it is gone, and it is back over 20 answers once the leg moves by a
    // single count. A movement that would turn the stuck leg alone shows nothing at all.
    static constexpr int kSuspectCounts = 50;
    static constexpr int kDistrustCounts = 100;
    static constexpr double kTrustPerAnswer = 0.05;

    // The clock outlives it.
    FalconDevice(std::unique_ptr<ByteLink> link, Clock& clock, FalconOptions options = {});
    ~FalconDevice() override;

    const DeviceSpec& spec() const override { return spec_; }
    // Up to a few seconds when the firmware must be sent. Fails in a sentence.
    Result<void> open() override;
    DeviceSample read(double now_s) noexcept override;
    void write(const ForceCommand& command) noexcept override;
    void close() noexcept override;

    bool firmware_was_running() const { return firmware_was_running_; }
    std::uint8_t homed_legs() const { return status_.homed_legs; }
    std::uint64_t skipped_bytes() const { return reader_.skipped(); }
    // A look without waking it: true if a firmware answers. Sends no force and no firmware.
    bool answers();

private:
    bool run_mode() noexcept;
    bool wait_for_answer(double deadline_s) noexcept;
    void send(const std::array<int, 3>& motors) noexcept;
    bool says_hello() noexcept;
    Result<void> upload(std::span<const std::uint8_t> image);
    void tell(const std::string& sentence) const;
    bool echoed(std::span<const std::uint8_t> sent, double deadline_s) noexcept;
    std::size_t take(std::span<std::uint8_t> room, double deadline_s) noexcept;
    void forget_place() noexcept;
    bool is_stuck(const std::array<int, 3>& encoders) noexcept;

    DeviceSpec spec_;
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
    Vec3 grip_m_{0.0}, leg_angles_rad_{0.0};  // Falcon axes, of the last answer
    struct Stillness {
        int count = 0;
        int answers = 0;  // that showed it unchanged
        std::array<int, 3> others_low{}, others_high{};
    };
    double trust_ = 1.0;  // share of the force that a leg's stillness leaves
    bool watches_legs_ = false;
    std::array<Stillness, 3> stillness_{};
};

}  // namespace handrail
