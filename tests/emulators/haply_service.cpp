#include "tests/emulators/haply_service.h"
#include "tests/support/names.h"

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>
#include <thread>

namespace handrail::test {

using Tcp = boost::asio::ip::tcp;
using Json = nlohmann::json;

struct StandInService::Server {
    Server(StandInService& of, bool with_device, std::uint16_t at)
        : service(of),
          with_device_(with_device),
          acceptor_(io_, {boost::asio::ip::address_v4::loopback(), at}),
          thread_([this] { serve(); }) {}
    ~Server() {
        boost::beast::error_code ignored;
        Tcp::socket knock(io_);  // this connection ends a pending accept
        knock.connect({boost::asio::ip::address_v4::loopback(), port_}, ignored);
        knock.close(ignored);
        thread_.join();
    }

    std::string state(bool first) {
        const std::lock_guard guard(service.lock);
        Json device{
            {"device_id", "04BA"},
            {"state",
             {{"cursor_position", {{"x", service.place.x}, {"y", service.place.y}, {"z", service.place.z}}},
              {"cursor_velocity", {{"x", 0}, {"y", 0}, {"z", 0}}}}},
            {"status", {{"calibrated", service.mood != Mood::Uncalibrated}, {"ready", true}, {"power_supply", true}}}};
        if (first) device["config"] = {{"device_info", {{"major_version", 2}, {"minor_version", 7}}}};
        if (service.mood == Mood::NoPosition) device["state"]["cursor_position"]["y"] = nullptr;
        Json all{{"inverse3", with_device_ ? Json::array({device}) : Json::array()},
                 {"wireless_verse_grip", Json::array()}};
        std::string text = all.dump();
        if (service.mood == Mood::Damaged) text = text.substr(0, text.size() / 2);
        return text;
    }
    void move(const std::string& text) {
        const Json json = Json::parse(text, nullptr, false);
        if (json.is_discarded() || json["inverse3"][0]["device_id"] != "04BA") {
            ++service.not_understood;
            return;
        }
        const Json& values = json["inverse3"][0]["commands"]["set_cursor_force"]["values"];
        const std::lock_guard guard(service.lock);
        service.force = {values["x"].get<double>(), values["y"].get<double>(), values["z"].get<double>()};
        service.largest = std::max(service.largest, glm::length(service.force));
        service.velocity += (service.force + service.push - 8.0 * service.velocity) * (1e-3 / 0.1);
        service.place += service.velocity * 1e-3;
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
                ++service.messages;
                move(boost::beast::buffers_to_string(buffer.data()));
                if (service.mood == Mood::Hangs_up) return;
                if (service.mood == Mood::Silent) continue;
                if (service.messages % 500 == 0) socket.ping({});
                socket.write(boost::asio::buffer(state(false)));
            }
        } catch (const std::exception&) {  // the client has disconnected
        }
    }

    StandInService& service;
    bool with_device_;
    boost::asio::io_context io_;
    Tcp::acceptor acceptor_;
    std::uint16_t port_ = acceptor_.local_endpoint().port();
    std::thread thread_;
};

StandInService::StandInService(bool with_device, std::uint16_t port)
    : server_(std::make_unique<Server>(*this, with_device, port)) {}

StandInService::~StandInService() = default;

std::uint16_t StandInService::port() const { return server_->port_; }

std::uint16_t port_of_nobody() {
    boost::asio::io_context io;
    return Tcp::acceptor(io, {boost::asio::ip::address_v4::loopback(), 0}).local_endpoint().port();
}

}  // namespace handrail::test
