// The Inverse3's service, played by a server on this computer that answers each message with one state, as the public documentation of the service 3.5 has it.
// A thread of its own; one connection.
#pragma once

#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "worlds/base/vec.h"

namespace handrail::test {

enum class Mood { Sound, Damaged, Silent, NoPosition, Hangs_up, Uncalibrated };

class StandInService {
    using Tcp = boost::asio::ip::tcp;
    using Json = nlohmann::json;

public:
    // Port 0: any that is free. Throws where the port is taken.
    explicit StandInService(bool with_device = true, std::uint16_t port = 0)
        : with_device_(with_device), acceptor_(io_, {boost::asio::ip::address_v4::loopback(), port}), thread_([this] { serve(); }) {}
    ~StandInService() {
        boost::beast::error_code ignored;
        Tcp::socket knock(io_);  // in case nobody ever connected
        knock.connect({boost::asio::ip::address_v4::loopback(), port()}, ignored);
        knock.close(ignored);
        thread_.join();
    }
    StandInService(const StandInService&) = delete;
    StandInService& operator=(const StandInService&) = delete;

    std::uint16_t port() const { return port_; }

    std::atomic<Mood> mood{Mood::Sound};
    std::atomic<int> messages{0}, not_understood{0};
    // Under the lock: the hand, 0.1 kg and 8 Ns/m, a millisecond for each message.
    std::mutex lock;
    Vec3 place{0.0}, velocity{0.0}, push{0.0}, force{0.0};
    double largest = 0.0;

private:
    std::string state(bool first) {
        const std::lock_guard guard(lock);
        Json device{{"device_id", "04BA"},
                    {"state", {{"cursor_position", {{"x", place.x}, {"y", place.y}, {"z", place.z}}}, {"cursor_velocity", {{"x", 0}, {"y", 0}, {"z", 0}}}}},
                    {"status", {{"calibrated", mood != Mood::Uncalibrated}, {"ready", true}, {"power_supply", true}}}};
        if (first) device["config"] = {{"device_info", {{"major_version", 2}, {"minor_version", 7}}}};
        if (mood == Mood::NoPosition) device["state"]["cursor_position"]["y"] = nullptr;
        Json all{{"inverse3", with_device_ ? Json::array({device}) : Json::array()}, {"wireless_verse_grip", Json::array()}};
        std::string text = all.dump();
        if (mood == Mood::Damaged) text = text.substr(0, text.size() / 2);
        return text;
    }
    void move(const std::string& text) {
        const Json json = Json::parse(text, nullptr, false);
        if (json.is_discarded() || json["inverse3"][0]["device_id"] != "04BA") {
            ++not_understood;
            return;
        }
        const Json& values = json["inverse3"][0]["commands"]["set_cursor_force"]["values"];
        const std::lock_guard guard(lock);
        force = {values["x"].get<double>(), values["y"].get<double>(), values["z"].get<double>()};
        largest = std::max(largest, glm::length(force));
        velocity += (force + push - 8.0 * velocity) * (1e-3 / 0.1);
        place += velocity * 1e-3;
    }
    void serve() {
        try {
            boost::beast::websocket::stream<Tcp::socket> socket(acceptor_.accept());
            socket.next_layer().set_option(Tcp::no_delay(true));
            socket.accept();
            socket.write(boost::asio::buffer(state(true)));
            for (;;) {
                boost::beast::flat_buffer buffer;
                socket.read(buffer);
                ++messages;
                move(boost::beast::buffers_to_string(buffer.data()));
                if (mood == Mood::Hangs_up) return;
                if (mood == Mood::Silent) continue;
                if (messages % 500 == 0) socket.ping({});
                socket.write(boost::asio::buffer(state(false)));
            }
        } catch (const std::exception&) {  // the other side has gone
        }
    }

    bool with_device_;
    boost::asio::io_context io_;
    Tcp::acceptor acceptor_;
    std::uint16_t port_ = acceptor_.local_endpoint().port();
    std::thread thread_;
};

}  // namespace handrail::test
