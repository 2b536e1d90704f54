#include "tests/voices/braille_server.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <fstream>

#include "tests/support/temporary_folder.h"

namespace handrail::test {

namespace fs = std::filesystem;

namespace {

constexpr int kBrlApiPort = 4101;  // BrlAPI's server number N listens on the port with this number plus N

// Returns a server number whose port nobody listens on at present.
int free_number() {
    for (int number = 100 + ::getpid() % 800;; ++number) {
        const int probe = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(static_cast<std::uint16_t>(kBrlApiPort + number));
        const bool is_free = ::bind(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
        ::close(probe);
        if (is_free) return number;
    }
}

}  // namespace

std::string BrailleServer::why_not() {
#if defined(HANDRAIL_SANITIZED)
    return "BRLTTY and its library are not judged under the sanitizers";
#endif
    return installed("brltty") ? "" : "brltty is not installed";
}

BrailleServer::BrailleServer(const fs::path& folder) : folder_(folder / "braille"), port_(free_number()) {
    fs::create_directories(folder_ / "var");
    std::ofstream(folder_ / "brltty.conf") << "";
    start_again();
}

BrailleServer::~BrailleServer() { kill(); }

Environment BrailleServer::environment() const {
    return {{"BRLAPI_HOST", "127.0.0.1:" + std::to_string(port_)}, {"WINDOWPATH", ""}, {"XDG_VTNR", ""}};
}

void BrailleServer::kill() {
    if (process_) process_->kill();
    if (display_ >= 0) ::close(display_);
    display_ = -1;
}

bool BrailleServer::start_again() {
    fs::remove(folder_ / "display");
    const std::string var = (folder_ / "var").string();
    process_ = ChildProcess::start({"brltty", "-n",
                                    "-q",     "-e",
                                    "-M",     "1",
                                    "-f",     (folder_ / "brltty.conf").string(),
                                    "-b",     "vr",
                                    "-d",     "server:" + (folder_ / "display").string(),
                                    "-x",     "no",
                                    "-s",     "no",
                                    "-P",     (folder_ / "pid").string(),
                                    "-U",     var,
                                    "-W",     var,
                                    "-A",     "auth=none,host=127.0.0.1:" + std::to_string(port_)},
                                   {{"HOME", folder_.string()}, {"DISPLAY", ""}, {"DBUS_SESSION_BUS_ADDRESS", ""}},
                                   folder_ / "brltty.out");
    return process_ && connect_display();
}

bool BrailleServer::unplug_display_and_plug_in_another() {
    ::close(display_);
    display_ = -1;
    return connect_display();
}

bool BrailleServer::connect_display() {
    received_.clear();
    shown_.clear();
    return eventually([&] {
        if (!process_->running()) return false;
        const int to = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::strncpy(address.sun_path, (folder_ / "display").c_str(), sizeof address.sun_path - 1);
        const std::string size = "cells " + std::to_string(kCells) + " 1\n";
        if (::connect(to, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
            ::write(to, size.data(), size.size()) < 0) {
            ::close(to);
            ::usleep(20000);
            return false;
        }
        display_ = to;
        return true;
    });
}

std::string BrailleServer::shown() {
    char block[4096];
    for (ssize_t got = 0; display_ >= 0 && (got = ::recv(display_, block, sizeof block, MSG_DONTWAIT)) > 0;)
        received_.append(block, static_cast<std::size_t>(got));
    for (std::size_t end = 0; (end = received_.find('\n')) != std::string::npos; received_.erase(0, end + 1)) {
        const std::string line = received_.substr(0, end);
        const std::size_t open = line.find('"'), close = line.rfind('"');
        if (line.rfind("Visual", 0) == 0 && open < close) shown_ = line.substr(open + 1, close - open - 1);
    }
    return shown_.substr(0, shown_.find_last_not_of(' ') + 1);
}

bool BrailleServer::shows(const std::string& words) {
    return eventually([&] { return shown().find(words) != std::string::npos; });
}

void BrailleServer::press(const std::string& command) const {
    const std::string line = command + "\n";
    if (::write(display_, line.data(), line.size()) < 0) {
        // Ignore a failure: the process has ended, which other functions report.
    }
}

std::string BrailleServer::everything() const {
    return "display: " + shown_ + "\nBRLTTY:\n" + content_of(folder_ / "brltty.out");
}

}  // namespace handrail::test
