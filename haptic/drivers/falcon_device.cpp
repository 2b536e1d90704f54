#include "haptic/drivers/falcon_device.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "haptic/drivers/falcon_kinematics.h"
#include "haptic/drivers/force_packing.h"
#include "worlds/base/contract.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/patience.h"

namespace handrail::drivers {
namespace fs = std::filesystem;
namespace {

// Numbers of the requests that the serial chip (FTDI FT232) understands.
constexpr std::uint8_t kReset = 0, kModemLines = 1, kFlow = 2, kBaud = 3, kFormat = 4, kLatency = 9;
constexpr std::uint16_t kPurgeIn = 1, kPurgeOut = 2;
constexpr std::uint16_t kDtrHigh = 0x0101, kDtrLow = 0x0100, kRtsLow = 0x0200;
constexpr std::uint16_t kBaud9600 = 0x4138, kBaudLoading = 0x0015, kBaudRunning = 0x0002;
constexpr std::uint16_t kEightBits = 8;

constexpr std::size_t kPacketBytes = 64, kStatusBytes = 2, kPieceBytes = 62;
constexpr double kWriteDeadlineS = 0.005;
// Time limit for each piece of the firmware. A piece of 62 bytes takes 4 ms to the device and back, and the chip may
// hold it for 16 ms.
constexpr double kLoadingDeadlineS = 0.25;
constexpr double kHelloDeadlineS = 0.030;
constexpr int kHelloTries = 100;
constexpr int kPokes = 5, kPokesAfterUpload = 25;
constexpr double kPokeDeadlineS = 0.020;
// Share of the peak force that the driver uses. The hand moves on between the moment for which the torques were
// computed and the moment when they act. At 0.2 m/s and 2 ms the force is therefore wrong by 1 %.
constexpr double kShareOfPeak = 0.95;
constexpr std::size_t kLargestImage = 1 << 17;  // size of the processor's memory in bytes

Result<std::string> read_firmware(const fs::path& file) {
    auto content = read_whole_file(file, kLargestImage);
    if (!content) return content;
    const auto sound =
        check_falcon_firmware({reinterpret_cast<const std::uint8_t*>(content->data()), content->size()}, file.string());
    if (!sound) return tl::unexpected(sound.error());
    return content;
}

}  // namespace

fs::path falcon_firmware_folder() {
    // Relative paths are ignored, so that firmware is never loaded from the current folder.
    const char* data = std::getenv("XDG_DATA_HOME");
    if (data && data[0] == '/') return fs::path(data) / "handrail" / "falcon";
    const char* home = std::getenv("HOME");
    if (home && home[0] == '/') return fs::path(home) / ".local" / "share" / "handrail" / "falcon";
    return "/usr/local/share/handrail/falcon";
}

std::vector<fs::path> falcon_firmware_files() {
    std::vector<fs::path> files;
    if (const char* named = std::getenv("HANDRAIL_FALCON_FIRMWARE"); named && *named) files.emplace_back(named);
    for (const fs::path& folder :
         {falcon_firmware_folder(), fs::path("/usr/local/share/handrail/falcon"),
          fs::path("/usr/share/handrail/falcon"), fs::path("/lib/firmware/novint"),
          fs::path("/usr/local/share/libnifalcon/firmware"), fs::path("/usr/share/libnifalcon/firmware")}) {
        std::vector<fs::path> here;
        std::error_code ec;
        for (auto it = fs::directory_iterator(folder, ec); !ec && it != fs::directory_iterator(); it.increment(ec))
            if (it->path().extension() == ".bin") here.push_back(it->path());
        std::sort(here.begin(), here.end());
        files.insert(files.end(), here.begin(), here.end());
    }
    return files;
}

bool falcon_firmware_is_sound(const fs::path& file) { return read_firmware(file).has_value(); }

FalconDevice::FalconDevice(std::unique_ptr<ByteLink> link, Clock& clock, FalconOptions options)
    : spec_(*device::find_device_spec("falcon")), link_(std::move(link)), clock_(clock), options_(std::move(options)) {
    contract_pre(link_);
}

FalconDevice::~FalconDevice() { FalconDevice::close(); }

bool FalconDevice::run_mode() noexcept {
    reader_.clear();
    in_flight_ = 0;
    return link_->control(kLatency, 1) && link_->control(kBaud, kBaudRunning) && link_->control(kReset, kPurgeIn) &&
           link_->control(kReset, kPurgeOut);
}

// Reads one packet into `room`, without the two status bytes that the chip puts in front. Returns the number of bytes,
// or 0 if no packet came by the deadline.
std::size_t FalconDevice::take(std::span<std::uint8_t> room, double deadline_s) noexcept {
    std::array<std::uint8_t, kPacketBytes> packet;
    for (;;) {
        const double left_s = deadline_s - clock_.now_s();
        const int bytes = lost_ ? ByteLink::kLost : link_->read(packet, std::max(left_s, 0.0));
        if (bytes == ByteLink::kLost) {
            lost_ = true;
            return 0;
        }
        if (bytes > static_cast<int>(kStatusBytes)) {
            const std::size_t payload = std::min(static_cast<std::size_t>(bytes) - kStatusBytes, room.size());
            std::copy_n(packet.begin() + kStatusBytes, payload, room.begin());
            return payload;
        }
        if (left_s <= 0.0) return 0;
    }
}

void FalconDevice::send(const std::array<int, 3>& motors) noexcept {
    if (lost_) return;
    const bool ready = status_.homed_legs == 7;
    const FalconFrame frame = pack_falcon_command({motors, ready, false, !ready, true});
    const int taken = link_->write(frame, kWriteDeadlineS);
    if (taken == ByteLink::kLost) {
        lost_ = true;
    } else if (taken < static_cast<int>(frame.size())) {
        // Clears the chip's buffer, because the first half of this frame must not be joined to the next frame.
        link_->control(kReset, kPurgeOut);
    } else {
        ++in_flight_;
    }
}

// Reads until every frame in flight is answered or the time is up, and keeps the newest answer. If more than one frame
// is in flight, an earlier answer was late, so the function reads it now. Returns true if an answer arrived.
bool FalconDevice::wait_for_answer(double deadline_s) noexcept {
    bool answered = false;
    std::array<std::uint8_t, kPieceBytes> bytes;
    for (;;) {
        while (const auto status = reader_.next()) {
            status_ = *status;
            answered = true;
            if (in_flight_ > 0) --in_flight_;
        }
        if (answered && in_flight_ == 0) return true;
        const std::size_t got = take(bytes, deadline_s);
        if (got == 0) break;
        reader_.push({bytes.data(), got});
    }
    // Drops the unfinished answer and the answers that did not come in time. The rest of a late answer must never be
    // joined to the next answer.
    in_flight_ = 0;
    reader_.clear();
    return answered && !lost_;
}

bool FalconDevice::answers() {
    if (!run_mode()) return false;
    for (int poke = 0; poke < kPokes && !lost_; ++poke) {
        send({0, 0, 0});
        if (wait_for_answer(clock_.now_s() + kPokeDeadlineS)) return true;
    }
    return false;
}

bool FalconDevice::says_hello() noexcept {
    static constexpr std::array<std::uint8_t, 3> kHello{0x0a, 0x43, 0x0d};
    static constexpr std::array<std::uint8_t, 4> kAnswer{0x0a, 0x44, 0x2c, 0x0d};
    if (!(link_->control(kReset, kPurgeIn) && link_->control(kReset, kPurgeOut) && link_->control(kLatency, 16) &&
          link_->control(kBaud, kBaud9600) && link_->control(kFormat, kEightBits) && link_->control(kFlow, 0) &&
          link_->control(kModemLines, kRtsLow) && link_->control(kModemLines, kDtrLow) &&
          link_->control(kModemLines, kDtrHigh)))
        return false;
    std::array<std::uint8_t, kPieceBytes> heard{};
    std::size_t size = 0;
    for (int i = 0; i < kHelloTries && !lost_; ++i) {
        if (link_->write(kHello, kLoadingDeadlineS) == ByteLink::kLost) lost_ = true;
        const double deadline_s = clock_.now_s() + kHelloDeadlineS;
        while (const std::size_t got = take(std::span(heard).subspan(size), deadline_s)) {
            size += got;
            if (std::search(heard.begin(), heard.begin() + static_cast<std::ptrdiff_t>(size), kAnswer.begin(),
                            kAnswer.end()) != heard.begin() + static_cast<std::ptrdiff_t>(size))
                return true;
            if (size == heard.size()) size = 0;
        }
    }
    return false;
}

bool FalconDevice::echoed(std::span<const std::uint8_t> sent, double deadline_s) noexcept {
    std::array<std::uint8_t, kPieceBytes> bytes;
    std::size_t compared = 0;
    while (compared < sent.size()) {
        const std::size_t got = take(bytes, deadline_s);
        if (got == 0 || got > sent.size() - compared) return false;
        if (!std::equal(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(got),
                        sent.begin() + static_cast<std::ptrdiff_t>(compared)))
            return false;
        compared += got;
    }
    return true;
}

Result<void> FalconDevice::upload(std::span<const std::uint8_t> image) {
    if (!says_hello()) return fail(phrase("drivers.falcon_silent"));
    static constexpr std::array<std::uint8_t, 1> kMeasureSpeed{0x41};
    if (!link_->control(kModemLines, kDtrLow) || !link_->control(kBaud, kBaudLoading) ||
        link_->write(kMeasureSpeed, kLoadingDeadlineS) != 1 ||
        !echoed(kMeasureSpeed, clock_.now_s() + kLoadingDeadlineS))
        return fail(phrase("drivers.falcon_speed"));
    Patience patience(clock_.now_s());
    for (std::size_t at = 0; at < image.size(); at += kPieceBytes) {
        if (patience.due(clock_.now_s()))
            report(phrase("drivers.falcon_sending", {{"percent", static_cast<int>(100 * at / image.size())}}));
        const auto piece = image.subspan(at, std::min(kPieceBytes, image.size() - at));
        if (link_->write(piece, kLoadingDeadlineS) != static_cast<int>(piece.size()) ||
            !echoed(piece, clock_.now_s() + kLoadingDeadlineS))
            return fail(phrase("drivers.falcon_upload", {{"byte", at}, {"bytes", image.size()}}));
    }
    if (!run_mode()) return fail(phrase("drivers.falcon_unplugged"));
    for (int poke = 0; poke < kPokesAfterUpload && !lost_; ++poke) {
        send({0, 0, 0});
        if (wait_for_answer(clock_.now_s() + kPokeDeadlineS)) return {};
    }
    return fail(phrase("drivers.falcon_asleep"));
}

void FalconDevice::report(const std::string& sentence) const {
    if (options_.report) options_.report(sentence);
}

Result<void> FalconDevice::open() {
    forget_place();
    status_ = {};
    lost_ = !link_->control(kReset, kPurgeIn);
    if (lost_) return fail(phrase("drivers.falcon_deaf"));
    firmware_was_running_ = answers();
    if (!firmware_was_running_) {
        Error refused;
        std::string image;
        for (const fs::path& file : options_.firmware_files) {
            if (auto read = read_firmware(file)) {
                image = std::move(*read);
                break;
            } else {
                refused = read.error();
            }
        }
        if (image.empty() && !refused.message.empty()) return tl::unexpected(refused);
        if (image.empty())
            return fail(phrase("drivers.falcon_needs_firmware", {{"folder", falcon_firmware_folder().string()}}));
        Result<void> done = fail("");
        for (int attempt = 1; attempt <= kUploadTries && !done && !lost_; ++attempt) {
            report(attempt == 1 ? phrase("drivers.falcon_waking") : phrase("drivers.falcon_try", {{"n", attempt}}));
            done = upload({reinterpret_cast<const std::uint8_t*>(image.data()), image.size()});
        }
        if (!done) return done;
    }
    answered_s_ = clock_.now_s();
    report(phrase(status_.homed_legs == 7 ? "drivers.falcon_ready" : "drivers.falcon_awake"));
    return {};
}

void FalconDevice::forget_place() noexcept {
    knows_place_ = false;
    watches_legs_ = false;
}

bool FalconDevice::is_stuck(const std::array<int, 3>& encoders) noexcept {
    int farthest = 0;  // how far another leg has turned while one leg stood still
    for (std::size_t leg = 0; leg < 3; ++leg) {
        Stillness& still = stillness_[leg];
        if (!watches_legs_ || encoders[leg] != still.count) {
            still = {encoders[leg], 0, encoders, encoders};
            continue;
        }
        ++still.answers;
        for (std::size_t other = 0; other < 3; ++other) {
            still.others_low[other] = std::min(still.others_low[other], encoders[other]);
            still.others_high[other] = std::max(still.others_high[other], encoders[other]);
            if (still.answers >= kStuckAnswers)
                farthest = std::max(farthest, still.others_high[other] - still.others_low[other]);
        }
    }
    watches_legs_ = true;
    const double left =
        std::clamp(static_cast<double>(kDistrustCounts - farthest) / (kDistrustCounts - kSuspectCounts), 0.0, 1.0);
    trust_ = std::min(left, trust_ + kTrustPerAnswer);
    return farthest > kStuckCounts;
}

device::DeviceSample FalconDevice::read(double) noexcept {
    device::DeviceSample sample;
    sample.fresh = false;
    if (in_flight_ == 0) send({0, 0, 0});
    const bool answered = wait_for_answer(clock_.now_s() + kAnswerDeadlineS);
    sample.connected = !lost_;
    if (knows_place_) sample.position_m = falcon_to_device(grip_m_);
    if (lost_ || !answered) {
        if (lost_) forget_place();
        return sample;
    }
    answered_s_ = clock_.now_s();
    sample.fresh = true;
    sample.buttons = status_.buttons;
    sample.homed = status_.homed_legs == 7;
    sample.homed_legs = status_.homed_legs;
    // The counts are not valid yet and jump once all legs are homed, so the driver does not use them.
    if (!sample.homed) {
        forget_place();
        sample.position_m = Vec3(0.0);
        return sample;
    }
    const Vec3 angles{falcon_leg_angle_rad(status_.encoders[0]), falcon_leg_angle_rad(status_.encoders[1]),
                      falcon_leg_angle_rad(status_.encoders[2])};
    const auto grip = falcon_forward(angles, knows_place_ ? grip_m_ : Vec3(0.0, 0.0, 0.12));
    if (is_stuck(status_.encoders) || !grip) {
        knows_place_ = false;
        sample.position_m = Vec3(std::numeric_limits<double>::quiet_NaN());
        return sample;
    }
    knows_place_ = true;
    grip_m_ = *grip;
    leg_angles_rad_ = angles;
    sample.position_m = falcon_to_device(*grip);
    return sample;
}

void FalconDevice::write(const device::ForceCommand& command) noexcept {
    std::array<int, 3> motors{};
    if (knows_place_ && clock_.now_s() - answered_s_ < kZeroAfterSilenceS) {
        const Vec3 force_n = held_to(command.force_n, kShareOfPeak * spec_.peak_force_n) * trust_;
        if (const auto torques = falcon_torques(grip_m_, leg_angles_rad_, turn_device_to_falcon(force_n)))
            motors = falcon_motor_counts(*torques, options_.counts_per_nm);
    }
    send(motors);
}

void FalconDevice::close() noexcept {
    // Sends the zero force three times, because a frame may be lost on the way and the firmware may hold the last force
    // for ever.
    for (int i = 0; i < 3 && !lost_; ++i) {
        send({0, 0, 0});
        wait_for_answer(clock_.now_s() + kAnswerDeadlineS);
    }
    forget_place();
    lost_ = true;
}

}  // namespace handrail::drivers
