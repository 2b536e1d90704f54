#include "haptic/drivers/ff_link.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/vec.h"

namespace handrail::drivers {
namespace {

constexpr std::size_t kBitsPerByte = 8;

template <std::size_t Bits>
struct BitSet {
    std::array<unsigned char, Bits / kBitsPerByte + 1> bytes{};
    bool has(std::size_t bit) const { return (bytes[bit / kBitsPerByte] >> (bit % kBitsPerByte) & 1) != 0; }
};

double share(double value) noexcept { return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0; }

class EvdevLink final : public FfLink {
public:
    explicit EvdevLink(int fd) : fd_(fd) {
        BitSet<FF_MAX> forces;
        if (::ioctl(fd_, EVIOCGBIT(EV_FF, sizeof forces.bytes), forces.bytes.data()) >= 0) {
            abilities_.rumble = forces.has(FF_RUMBLE);
            abilities_.constant = forces.has(FF_CONSTANT);
            abilities_.gain = forces.has(FF_GAIN);
        }
        abilities_.stick = read_axis(ABS_X, x_) && read_axis(ABS_Y, y_);
        place();
    }
    ~EvdevLink() override {
        stop();
        if (effect_.id >= 0) ::ioctl(fd_, EVIOCRMFF, static_cast<long>(effect_.id));
        ::close(fd_);
    }
    EvdevLink(const EvdevLink&) = delete;
    EvdevLink& operator=(const EvdevLink&) = delete;

    FfAbilities abilities() const override { return abilities_; }

    bool rumble(double strong, double weak) noexcept override {
        effect_.type = FF_RUMBLE;
        effect_.u = {};
        effect_.u.rumble.strong_magnitude = static_cast<std::uint16_t>(std::lround(share(strong) * 0xffff));
        effect_.u.rumble.weak_magnitude = static_cast<std::uint16_t>(std::lround(share(weak) * 0xffff));
        return upload_and_play();
    }
    bool constant(double level, double towards_rad) noexcept override {
        effect_.type = FF_CONSTANT;
        effect_.u = {};
        effect_.u.constant.level = static_cast<std::int16_t>(std::lround(share(level) * 0x7fff));
        const double turns = std::isfinite(towards_rad) ? towards_rad / (2.0 * kPi) : 0.0;
        effect_.direction = static_cast<std::uint16_t>(std::lround((turns - std::floor(turns)) * 65536.0) & 0xffff);
        return upload_and_play();
    }
    bool stop() noexcept override {
        return effect_.id < 0 || write_event(EV_FF, static_cast<std::uint16_t>(effect_.id), 0);
    }
    bool gain(double wanted) noexcept override {
        return write_event(EV_FF, FF_GAIN, static_cast<int>(std::lround(share(wanted) * 0xffff)));
    }

    bool poll(Stick& stick) noexcept override {
        std::array<input_event, 32> events;
        ssize_t size = 0;
        while ((size = ::read(fd_, events.data(), sizeof events)) > 0)
            for (std::size_t i = 0; i < static_cast<std::size_t>(size) / sizeof(input_event); ++i) {
                const input_event& event = events[i];
                if (event.type == EV_ABS && event.code == ABS_X) x_.value = event.value;
                else if (event.type == EV_ABS && event.code == ABS_Y) y_.value = event.value;
                else if (event.type == EV_KEY && event.code >= BTN_JOYSTICK && event.code < BTN_JOYSTICK + 32) {
                    const std::uint32_t bit = 1U << (event.code - BTN_JOYSTICK);
                    stick_.buttons = event.value ? stick_.buttons | bit : stick_.buttons & ~bit;
                }
            }
        place();
        stick = stick_;
        return size != 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
    }

private:
    bool read_axis(int code, input_absinfo& axis) {
        return ::ioctl(fd_, EVIOCGABS(static_cast<unsigned>(code)), &axis) >= 0 && axis.maximum > axis.minimum;
    }

    void place() noexcept {
        const auto centred = [](const input_absinfo& axis) {
            const double reach = 0.5 * (static_cast<double>(axis.maximum) - axis.minimum);
            return reach > 0.0 ? std::clamp((axis.value - axis.minimum) / reach - 1.0, -1.0, 1.0) : 0.0;
        };
        stick_.x = centred(x_);
        stick_.y = centred(y_);
    }
    bool upload_and_play() noexcept {
        const bool is_new = effect_.id < 0;
        effect_.replay.length = 0;  // 0: the effect lasts until it is replaced or stopped
        if (::ioctl(fd_, EVIOCSFF, &effect_) < 0) return false;
        return !is_new || write_event(EV_FF, static_cast<std::uint16_t>(effect_.id), 1);
    }
    bool write_event(std::uint16_t type, std::uint16_t code, int value) noexcept {
        input_event event{};
        event.type = type;
        event.code = code;
        event.value = value;
        return ::write(fd_, &event, sizeof event) == static_cast<ssize_t>(sizeof event);
    }

    int fd_;
    FfAbilities abilities_;
    ff_effect effect_ = [] {
        ff_effect none{};
        none.id = -1;
        return none;
    }();
    input_absinfo x_{}, y_{};
    Stick stick_;
};

}  // namespace

std::vector<FfDeviceInfo> list_ff_devices(const std::string& folder) {
    std::vector<FfDeviceInfo> found;
    std::error_code ec;
    for (auto it = std::filesystem::directory_iterator(folder, ec); !ec && it != std::filesystem::directory_iterator();
         it.increment(ec)) {
        FfDeviceInfo info;
        info.path = it->path().string();
        if (!it->path().filename().string().starts_with("event")) continue;
        const int fd = ::open(info.path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
        // Skips nodes that this process may not open, such as keyboards. The system's udev rule gives game pads to the
        // person at the seat.
        if (fd < 0) continue;
        std::array<char, 128> name{};
        if (::ioctl(fd, EVIOCGNAME(sizeof name), name.data()) > 0) info.name = name.data();
        const EvdevLink link(fd);
        info.abilities = link.abilities();
        if (info.abilities.rumble || info.abilities.constant) found.push_back(std::move(info));
    }
    std::sort(found.begin(), found.end(), [](const FfDeviceInfo& a, const FfDeviceInfo& b) { return a.path < b.path; });
    return found;
}

Result<std::unique_ptr<FfLink>> open_ff_link(const std::string& path) {
    const int fd = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0) return fail(phrase("drivers.cannot_open_why", {{"device", path}, {"reason", reason_of(errno)}}));
    return std::unique_ptr<FfLink>(std::make_unique<EvdevLink>(fd));
}

}  // namespace handrail::drivers
