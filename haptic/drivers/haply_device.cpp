#include "haptic/drivers/haply_device.h"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "haptic/drivers/force_packing.h"
#include "worlds/base/language.h"

namespace handrail::drivers {
namespace {

namespace beast = boost::beast;
namespace websocket = beast::websocket;
using Tcp = boost::asio::ip::tcp;
using Json = nlohmann::json;

constexpr double kOpenDeadlineS = 2.0;
constexpr double kAnswerDeadlineS = 0.005;
constexpr double kZeroAfterSilenceS = 0.020;
constexpr std::size_t kLargestMessage = 1 << 20;

std::chrono::nanoseconds duration(double seconds) {
    return std::chrono::nanoseconds(static_cast<std::int64_t>(std::max(seconds, 0.0) * 1e9));
}

const Json* member(const Json& json, const char* name) {
    if (!json.is_object()) return nullptr;
    const auto found = json.find(name);
    return found == json.end() ? nullptr : &*found;
}

bool number(const Json& json, const char* name, double& value) {
    const Json* found = member(json, name);
    if (!found || !found->is_number()) return false;
    value = found->get<double>();
    return std::isfinite(value);
}

std::string force_message(const std::string& device_id, const Vec3& force_n) {
    return Json{{"inverse3",
                 Json::array({Json{
                     {"device_id", device_id},
                     {"commands",
                      {{"set_cursor_force", {{"values", {{"x", force_n.x}, {"y", force_n.y}, {"z", force_n.z}}}}}}}}})}}
        .dump(-1, ' ', true, Json::error_handler_t::replace);
}

// Returns the firmware version, such as "2.1", from the device information of the first message. Returns an empty
// string if that information contains no version.
std::string firmware_of(const Json& device) {
    const Json* config = member(device, "config");
    const Json* info = config ? member(*config, "device_info") : nullptr;
    double major = 0.0, minor = 0.0;
    if (!info || !number(*info, "major_version", major)) return {};
    return number(*info, "minor_version", minor) ? fmt::format("{:g}.{:g}", major, minor) : fmt::format("{:g}", major);
}

class HaplyDevice final : public device::HapticDevice {
public:
    HaplyDevice(Clock& clock, std::uint16_t port) : clock_(clock), port_(port) {}
    ~HaplyDevice() override { HaplyDevice::close(); }

    const device::DeviceSpec& spec() const override { return spec_; }
    HaplyFacts facts() const { return {device_id_, firmware_, state_.homed}; }

    Result<void> open() override {
        try {
            beast::error_code problem = boost::asio::error::would_block;
            beast::get_lowest_layer(socket_).async_connect(
                Tcp::endpoint(boost::asio::ip::address_v4::loopback(), port_),
                [&](beast::error_code error) { problem = error; });
            run_until(kOpenDeadlineS, [&] { return problem != boost::asio::error::would_block; });
            if (problem) return fail(phrase("drivers.haply_no_service"));
            beast::get_lowest_layer(socket_).socket().set_option(Tcp::no_delay(true));
            socket_.read_message_max(kLargestMessage);
            problem = boost::asio::error::would_block;
            socket_.async_handshake(fmt::format("127.0.0.1:{}", port_), "/",
                                    [&](beast::error_code error) { problem = error; });
            run_until(kOpenDeadlineS, [&] { return problem != boost::asio::error::would_block; });
            if (problem) return fail(phrase("drivers.haply_other"));
            open_ = true;
            // The service sends a first message with the device's state before any request.
            for (const double deadline_s = clock_.now_s() + kOpenDeadlineS; clock_.now_s() < deadline_s && !lost_;)
                if (receive(deadline_s) && !device_id_.empty()) return {};
            return fail(phrase("drivers.haply_no_device"));
        } catch (const std::exception&) {
            return fail(phrase("drivers.haply_silent"));
        }
    }

    device::DeviceSample read(double) noexcept override {
        if (in_flight_ == 0) write({});
        const double deadline_s = clock_.now_s() + kAnswerDeadlineS;
        bool fresh = false;
        while (!lost_ && in_flight_ > 0 && clock_.now_s() < deadline_s)
            fresh = guarded([&] { return receive(deadline_s); }) || fresh;
        if (!fresh && clock_.now_s() - sent_s_ > kZeroAfterSilenceS) in_flight_ = 0;
        if (fresh) answered_s_ = clock_.now_s();
        device::DeviceSample sample = state_;
        sample.fresh = fresh;
        sample.connected = open_ && !lost_;
        return sample;
    }

    void write(const device::ForceCommand& command) noexcept override {
        // The service answers every message, so further messages before the answers would only fill a queue.
        if (!open_ || lost_ || in_flight_ > 1) return;
        const bool allowed = state_.homed && clock_.now_s() - answered_s_ <= kZeroAfterSilenceS;
        const Vec3 force = allowed ? held_to(command.force_n, spec_.peak_force_n) : Vec3(0.0);
        guarded([&] { return send(force); });
    }

    void close() noexcept override {
        if (!open_) return;
        if (!lost_)
            guarded([&] {
                send(Vec3(0.0));
                receive(clock_.now_s() + kAnswerDeadlineS);
                socket_.async_close(websocket::close_code::normal, [this](beast::error_code) { closed_ = true; });
                run_until(0.1, [this] { return closed_; });
                return true;
            });
        beast::get_lowest_layer(socket_).cancel();
        guarded([&] {
            io_.restart();
            io_.run_for(std::chrono::milliseconds(10));
            return true;
        });
        open_ = false;
    }

private:
    template <class Action>
    bool guarded(Action&& action) noexcept {
        try {
            return action();
        } catch (...) {
            lost_ = true;
            return false;
        }
    }

    template <class Condition>
    void run_until(double seconds, Condition&& condition) {
        const double deadline_s = clock_.now_s() + seconds;
        io_.restart();
        while (!condition()) {
            const double left_s = deadline_s - clock_.now_s();
            if (left_s <= 0.0) return;
            if (io_.run_one_for(duration(left_s)) == 0) return;
        }
    }

    bool send(const Vec3& force_n) {
        outgoing_ = force_message(device_id_, force_n);
        written_ = false;
        socket_.async_write(boost::asio::buffer(outgoing_), [this](beast::error_code error, std::size_t) {
            written_ = true;
            lost_ = lost_ || error;
        });
        run_until(kAnswerDeadlineS, [this] { return written_; });
        if (!written_)
            // If a service on this computer accepts no message for this long, it has hung. The connection must end,
            // because the buffer is only valid during this call.
            lost_ = true;
        if (!lost_) {
            ++in_flight_;
            sent_s_ = clock_.now_s();
        }
        return !lost_;
    }

    // Receives one message, valid or not. If a read has not finished at the deadline, the next call continues it.
    bool receive(double deadline_s) {
        if (!reading_) {
            reading_ = true;
            arrived_ = false;
            socket_.async_read(incoming_, [this](beast::error_code error, std::size_t) {
                arrived_ = true;
                lost_ = lost_ || error;
            });
        }
        run_until(deadline_s - clock_.now_s(), [this] { return arrived_; });
        if (!arrived_ || lost_) return false;
        reading_ = false;
        const std::string text = beast::buffers_to_string(incoming_.data());
        incoming_.consume(incoming_.size());
        if (in_flight_ > 0) --in_flight_;
        if (device_id_.empty()) note_firmware(text);  // only the first message contains the firmware version
        return parse_haply_state(text, device_id_, state_);
    }

    void note_firmware(std::string_view text) {
        const Json json = Json::parse(text, nullptr, false);
        const Json* devices = json.is_discarded() ? nullptr : member(json, "inverse3");
        if (devices && devices->is_array() && !devices->empty()) firmware_ = firmware_of(devices->front());
    }

    Clock& clock_;
    std::uint16_t port_;
    device::DeviceSpec spec_ = *device::find_device_spec("inverse3");
    boost::asio::io_context io_;
    websocket::stream<beast::tcp_stream> socket_{io_};
    beast::flat_buffer incoming_;
    std::string outgoing_, device_id_, firmware_;
    device::DeviceSample state_;
    bool open_ = false, lost_ = false, reading_ = false, arrived_ = false, written_ = false, closed_ = false;
    int in_flight_ = 0;
    double sent_s_ = 0.0, answered_s_ = 0.0;
};

}  // namespace

bool parse_haply_state(std::string_view text, std::string& device_id, device::DeviceSample& sample) {
    const Json json = Json::parse(text, nullptr, false);
    const Json* devices = json.is_discarded() ? nullptr : member(json, "inverse3");
    if (!devices || !devices->is_array()) return false;
    for (const Json& device : *devices) {
        const Json* id = member(device, "device_id");
        if (!id || !id->is_string() || (!device_id.empty() && id->get<std::string>() != device_id)) continue;
        const Json* state = member(device, "state");
        const Json* position = state ? member(*state, "cursor_position") : nullptr;
        Vec3 place{0.0};
        if (!position || !number(*position, "x", place.x) || !number(*position, "y", place.y) ||
            !number(*position, "z", place.z))
            return false;
        if (const Json* status = member(device, "status"))
            if (const Json* calibrated = member(*status, "calibrated"); calibrated && calibrated->is_boolean())
                sample.homed = calibrated->get<bool>();
        device_id = id->get<std::string>();
        sample.position_m = place;
        return true;
    }
    return false;
}

Result<std::unique_ptr<device::HapticDevice>> open_haply_device(Clock& clock, std::uint16_t port) {
    auto device = std::make_unique<HaplyDevice>(clock, port);
    if (const auto opened = device->open(); !opened) return tl::unexpected(opened.error());
    return std::unique_ptr<device::HapticDevice>(std::move(device));
}

Result<HaplyFacts> look_at_haply(Clock& clock, std::uint16_t port) {
    HaplyDevice device(clock, port);
    if (const auto opened = device.open(); !opened) return tl::unexpected(opened.error());
    return device.facts();
}

}  // namespace handrail::drivers
