#include "app/teaching/desk.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <ostream>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestOrder = 400, kMostWatchers = 4, kKept = 20;

// "lead Library" with "lead": "Library".
std::optional<std::string> rest_of(std::string_view order, std::string_view word) {
    if (order.size() <= word.size() + 1 || lower_ascii(order.substr(0, word.size())) != word ||
        order[word.size()] != ' ')
        return std::nullopt;
    return std::string(order.substr(word.size() + 1));
}

bool address_of(const fs::path& path, sockaddr_un& address) {
    address = {};
    address.sun_family = AF_UNIX;
    const std::string text = path.string();
    if (text.size() >= sizeof address.sun_path) return false;
    std::memcpy(static_cast<char*>(address.sun_path), text.c_str(), text.size() + 1);
    return true;
}

bool connects(int descriptor, const sockaddr_un& address) {
    // The kernel's own form of an address.
    return ::connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

bool same_person(int descriptor) {
    ucred peer{};
    socklen_t size = sizeof peer;
    return ::getsockopt(descriptor, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && peer.uid == ::getuid();
}

// Whole lines out of what has come; what is longer than an order is dropped.
void take_lines(std::string& come, std::vector<std::string>& lines) {
    for (std::size_t end = come.find('\n'); end != std::string::npos; end = come.find('\n')) {
        std::string line = one_line(come.substr(0, end));
        come.erase(0, end + 1);
        if (!line.empty() && line.size() <= kLongestOrder) lines.push_back(std::move(line));
    }
    if (come.size() > kLongestOrder) come.clear();
}

}  // namespace

std::string carry_out_order(TeachingRun& run, std::string_view order, double now_s) {
    const std::string word = lower_ascii(order);
    if (word == "summary") return run.summary();
    if (word == "next") return run.next(now_s), phrase("desk_order.done");
    if (word == "repeat") return run.repeat(), phrase("desk_order.done");
    if (word == "end") return run.end(now_s), phrase("desk_order.done");
    if (word == "more") return run.change_help(1), phrase("desk_order.done");
    if (word == "less") return run.change_help(-1), phrase("desk_order.done");
    std::optional<std::string> problem;
    if (const auto name = rest_of(order, "lead")) problem = run.lead_to(*name);
    else if (const auto door = rest_of(order, "block")) problem = run.block(*door, true);
    else if (const auto shut = rest_of(order, "open")) problem = run.block(*shut, false);
    else if (const auto text = rest_of(order, "note")) run.note(*text), problem = "";
    if (!problem) return phrase("desk_order.which");
    return problem->empty() ? phrase("desk_order.done") : *problem;
}

fs::path desk_socket_path() {
    if (const char* run = std::getenv("XDG_RUNTIME_DIR"); run && run[0] == '/')
        return fs::path(run) / "handrail-desk.sock";
    const fs::path own = fs::temp_directory_path() / fmt::format("handrail-{}", ::getuid());
    return own / "desk.sock";
}

struct DeskServer::State {
    fs::path path;
    int listening = -1;
    struct Watcher {
        int descriptor = -1;
        std::string come;
    };
    std::vector<Watcher> watchers;
    std::deque<std::string> kept;

    void send(Watcher& watcher, const std::string& line) {
        const std::string text = line + "\n";
        const ssize_t sent = ::send(watcher.descriptor, text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
        if (sent != static_cast<ssize_t>(text.size())) drop(watcher);
    }
    static void drop(Watcher& watcher) {
        if (watcher.descriptor >= 0) ::close(watcher.descriptor);
        watcher.descriptor = -1;
    }
    void accept_all() {
        for (;;) {
            const int come = ::accept4(listening, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
            if (come < 0) return;
            if (watchers.size() >= kMostWatchers || !same_person(come)) {
                ::close(come);
                continue;
            }
            watchers.push_back({come, {}});
            for (const std::string& line : kept)
                if (watchers.back().descriptor >= 0) send(watchers.back(), line);
        }
    }
};

DeskServer::DeskServer(std::unique_ptr<State> state) : state_(std::move(state)) {}

DeskServer::~DeskServer() {
    for (State::Watcher& watcher : state_->watchers) State::drop(watcher);
    ::close(state_->listening);
    std::error_code ec;
    fs::remove(state_->path, ec);
}

Result<std::unique_ptr<DeskServer>> DeskServer::open(const fs::path& path) {
    const auto refused = [&] { return fail(phrase("desk_order.no_desk", {{"reason", std::strerror(errno)}})); };
    sockaddr_un address{};
    errno = ENAMETOOLONG;
    if (!address_of(path, address)) return refused();
    std::error_code ec;
    if (fs::create_directories(path.parent_path(), ec))
        fs::permissions(path.parent_path(), fs::perms::owner_all, fs::perm_options::replace, ec);
    struct stat folder {};
    if (::stat(path.parent_path().c_str(), &folder) != 0) return refused();
    errno = EACCES;
    if (folder.st_uid != ::getuid() || (folder.st_mode & 0077U) != 0U) return refused();  // others could take it away
    auto state = std::make_unique<State>();
    state->path = path;
    state->listening = ::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (state->listening < 0) return refused();
    // One that a session left behind answers no more; one that answers is another session's.
    const int tried = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const bool taken = tried >= 0 && connects(tried, address);
    if (tried >= 0) ::close(tried);
    if (!taken) fs::remove(path, ec);
    errno = EADDRINUSE;
    const mode_t before = ::umask(0077);
    const bool bound = !taken &&
                       ::bind(state->listening, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
                       ::listen(state->listening, static_cast<int>(kMostWatchers)) == 0;
    ::umask(before);
    if (!bound) {
        ::close(state->listening);
        return refused();
    }
    return std::unique_ptr<DeskServer>(new DeskServer(std::move(state)));
}

std::vector<std::string> DeskServer::take_orders() {
    state_->accept_all();
    std::vector<std::string> orders;
    for (State::Watcher& watcher : state_->watchers) {
        std::array<char, 1024> bytes{};
        const ssize_t got = ::recv(watcher.descriptor, bytes.data(), bytes.size(), MSG_DONTWAIT);
        if (got > 0) {
            watcher.come.append(bytes.data(), static_cast<std::size_t>(got));
            take_lines(watcher.come, orders);
        } else if (got == 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) {
            State::drop(watcher);
        }
    }
    std::erase_if(state_->watchers, [](const State::Watcher& watcher) { return watcher.descriptor < 0; });
    return orders;
}

void DeskServer::tell(const std::string& line) {
    state_->kept.push_back(line);
    if (state_->kept.size() > kKept) state_->kept.pop_front();
    for (State::Watcher& watcher : state_->watchers)
        if (watcher.descriptor >= 0) state_->send(watcher, line);
}

int watch_desk(const fs::path& path, int in_descriptor, std::ostream& out, std::ostream& err) {
    sockaddr_un address{};
    const int desk = address_of(path, address) ? ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0) : -1;
    if (desk < 0 || !connects(desk, address)) {
        if (desk >= 0) ::close(desk);
        err << phrase("desk_order.none") << "\n";
        return 1;
    }
    out << phrase("desk_order.watching") << "\n" << std::flush;
    std::string typed;
    bool input = true, there = true;
    while (there) {
        std::array<pollfd, 2> waits{pollfd{desk, POLLIN, 0}, pollfd{input ? in_descriptor : -1, POLLIN, 0}};
        if (::poll(waits.data(), waits.size(), -1) < 0 && errno != EINTR) break;
        std::array<char, 1024> bytes{};
        if (waits[0].revents != 0) {
            const ssize_t got = ::recv(desk, bytes.data(), bytes.size(), 0);
            there = got > 0;
            if (got > 0) out << std::string_view(bytes.data(), static_cast<std::size_t>(got)) << std::flush;
        }
        if (waits[1].revents == 0) continue;
        const ssize_t got = ::read(in_descriptor, bytes.data(), bytes.size());
        if (got <= 0) {
            input = false;
            ::shutdown(desk, SHUT_WR);
            continue;
        }
        typed.append(bytes.data(), static_cast<std::size_t>(got));
        std::vector<std::string> orders;
        take_lines(typed, orders);
        for (const std::string& order : orders) {
            const std::string line = order + "\n";
            if (::send(desk, line.data(), line.size(), MSG_NOSIGNAL) < 0) there = false;
        }
    }
    ::close(desk);
    return 0;
}

}  // namespace handrail
