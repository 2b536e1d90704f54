#include "tests/kernel/usbip_plug.h"
#include "tests/support/names.h"

#include <arpa/inet.h>
#include <errno.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace handrail::test {
namespace {

using namespace std::chrono_literals;

constexpr const char* kAttach = "/sys/devices/platform/vhci_hcd.0/attach";
constexpr const char* kDetach = "/sys/devices/platform/vhci_hcd.0/detach";
constexpr std::uint32_t kSubmit = 1, kUnlink = 2, kSubmitted = 3, kUnlinked = 4;
constexpr auto kTick = 1ms;  // time between two polls of a device that has no data

bool read_all(int fd, void* to, std::size_t size) {
    auto* at = static_cast<std::uint8_t*>(to);
    for (ssize_t got; size > 0; at += got, size -= static_cast<std::size_t>(got))
        if ((got = ::read(fd, at, size)) <= 0) return false;
    return true;
}

void write_all(int fd, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t gone = ::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (gone <= 0) return;  // the test unplugged the device
        bytes = bytes.subspan(static_cast<std::size_t>(gone));
    }
}

std::vector<std::uint8_t> network_order(std::span<const std::uint32_t> words) {
    std::vector<std::uint8_t> bytes(4 * words.size());
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::uint32_t word = htonl(words[i]);
        std::memcpy(&bytes[4 * i], &word, sizeof word);
    }
    return bytes;
}

}  // namespace

UsbIpPlug::UsbIpPlug(UsbFunction& function, int port, Speed speed) : function_(function), port_(port) {
    std::array<int, 2> ends{-1, -1};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) throw std::runtime_error("no socket");
    socket_ = ends[1];
    std::ofstream attach(kAttach);
    attach << fmt::format("{} {} {} {}", port, ends[0], port + 1, static_cast<int>(speed)) << std::flush;
    const bool attached = attach.good();
    ::close(ends[0]);  // the kernel keeps its own end of the socket pair
    if (!attached) {
        ::close(socket_);
        throw std::runtime_error("the kernel's virtual USB controller does not take the device");
    }
    thread_ = std::thread([this] { run(); });
}

UsbIpPlug::~UsbIpPlug() {
    unplug();
    ::close(socket_);
}

void UsbIpPlug::unplug() {
    if (!thread_.joinable()) return;
    std::ofstream(kDetach) << port_;
    ::shutdown(socket_, SHUT_RDWR);
    thread_.join();
}

void UsbIpPlug::run() {
    while (true) {
        pollfd ready{socket_, POLLIN, 0};
        const int events = ::poll(&ready, 1, static_cast<int>(kTick.count()));
        if (events > 0 && !take_one()) return;
        serve_waiting();
    }
}

bool UsbIpPlug::take_one() {
    std::array<std::uint32_t, 12> header;
    if (!read_all(socket_, header.data(), sizeof header)) return false;
    const std::uint32_t command = ntohl(header[0]);
    if (command == kSubmit) submitted(header);
    else if (command == kUnlink) unlinked(header);
    return command == kSubmit || command == kUnlink;
}

void UsbIpPlug::submitted(std::span<const std::uint32_t, 12> header) {
    const std::uint32_t number = ntohl(header[1]), endpoint = ntohl(header[4]), length = ntohl(header[6]);
    const bool to_host = ntohl(header[3]) != 0;
    ++transfers;
    std::vector<std::uint8_t> data;
    if (!to_host) {
        data.resize(length);
        if (!read_all(socket_, data.data(), data.size())) return;
    }
    if (endpoint != 0 && to_host) {
        waiting_.push_back({number, length, std::chrono::steady_clock::now()});
        return;
    }
    std::array<std::uint8_t, 8> setup;
    std::memcpy(setup.data(), &header[10], setup.size());
    bool taken = true;
    {
        const std::lock_guard guard(lock);
        if (endpoint == 0) taken = function_.answer(usb_setup(setup), data);
        else function_.out(data);
    }
    if (!taken) return answer(number, -EPIPE, 0, {});
    const std::size_t size = std::min<std::size_t>(data.size(), length);
    answer(number, 0, size, to_host ? std::span(data).first(size) : std::span<const std::uint8_t>());
}

void UsbIpPlug::unlinked(std::span<const std::uint32_t, 12> header) {
    const std::uint32_t victim = ntohl(header[5]);
    const auto at = std::find_if(waiting_.begin(), waiting_.end(),
                                 [&](const Waiting& waiting) { return waiting.number == victim; });
    const int status = at == waiting_.end() ? 0 : -ECONNRESET;
    if (at != waiting_.end()) waiting_.erase(at);
    std::array<std::uint32_t, 12> reported{kUnlinked, ntohl(header[1])};
    reported[5] = static_cast<std::uint32_t>(status);
    write_all(socket_, network_order(reported));
}

void UsbIpPlug::serve_waiting() {
    while (!waiting_.empty()) {
        const Waiting& first = waiting_.front();
        std::optional<std::vector<std::uint8_t>> packet;
        {
            const std::lock_guard guard(lock);
            packet = function_.in(
                std::min<std::uint32_t>(first.room, 64),
                std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - first.since));
        }
        if (!packet) return;
        answer(first.number, 0, packet->size(), *packet);
        waiting_.pop_front();
    }
}

void UsbIpPlug::answer(std::uint32_t number, int status, std::size_t length, std::span<const std::uint8_t> data) {
    std::array<std::uint32_t, 12> header{kSubmitted, number};
    header[5] = static_cast<std::uint32_t>(status);
    header[6] = static_cast<std::uint32_t>(length);
    std::vector<std::uint8_t> bytes = network_order(header);
    bytes.insert(bytes.end(), data.begin(), data.end());
    write_all(socket_, bytes);
}

}  // namespace handrail::test
