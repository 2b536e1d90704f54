#include "app/teaching/desk.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <ostream>
#include <utility>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::teaching {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestOrder = 400, kMostWatchers = 4, kKept = 20;

// Returns the rest of an order after its first word: "Library" for the order "lead Library" and the word "lead".
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
    // The socket functions require a pointer to sockaddr.
    return ::connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

bool same_person(int descriptor) {
    ucred peer{};
    socklen_t size = sizeof peer;
    return ::getsockopt(descriptor, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && peer.uid == ::getuid();
}

bool same_person_owns(const fs::path& file) {
    struct stat found {};
    return ::lstat(file.c_str(), &found) == 0 && S_ISSOCK(found.st_mode) && found.st_uid == ::getuid();
}

// Moves complete lines from the received text `come` to `lines`. Drops lines that are longer than the longest order.
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
    std::string happened;
    if (word == "next") happened = run.next(now_s);
    else if (word == "repeat") happened = run.repeat();
    else if (word == "end") happened = run.end(now_s);
    else if (word == "more") happened = run.change_help(1);
    else if (word == "less") happened = run.change_help(-1);
    else if (word == "leave") happened = run.leave_lead();
    else if (const auto name = rest_of(order, "lead")) happened = run.lead_to(*name);
    else if (const auto door = rest_of(order, "block")) happened = run.block(*door, true);
    else if (const auto shut = rest_of(order, "open")) happened = run.block(*shut, false);
    else if (const auto text = rest_of(order, "note")) return run.note(*text), phrase("desk_order.noted");
    else return phrase("desk_order.which");
    run.note(phrase("desk_order.ordered", {{"order", one_line(std::string(order))}, {"happened", happened}}));
    return happened;
}

fs::path desk_folder() {
    if (const char* run = std::getenv("XDG_RUNTIME_DIR"); run && run[0] == '/') return fs::path(run) / "handrail-desks";
    return fs::temp_directory_path() / fmt::format("handrail-desks-{}", ::getuid());
}

struct DeskServer::State {
    fs::path path;
    std::string title;
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
            send(watchers.back(), title);
            for (const std::string& line : kept)
                if (watchers.back().descriptor >= 0) send(watchers.back(), line);
        }
    }
};

DeskServer::DeskServer(std::unique_ptr<State> state) : state_(std::move(state)) {}

DeskServer::~DeskServer() {
    send(phrase("desk_order.ended"));
    for (State::Watcher& watcher : state_->watchers) State::drop(watcher);
    ::close(state_->listening);
    std::error_code ec;
    fs::remove(state_->path, ec);
}

Result<std::unique_ptr<DeskServer>> DeskServer::open(const fs::path& folder, const std::string& title) {
    const auto refused = [&] { return fail(phrase("desk_order.no_desk", {{"reason", std::strerror(errno)}})); };
    auto state = std::make_unique<State>();
    state->path = folder / fmt::format("{}.sock", ::getpid());
    state->title = one_line(title);
    sockaddr_un address{};
    errno = ENAMETOOLONG;
    if (!address_of(state->path, address)) return refused();
    std::error_code ec;
    if (fs::create_directories(folder, ec))
        fs::permissions(folder, fs::perms::owner_all, fs::perm_options::replace, ec);
    struct stat found {};
    if (::lstat(folder.c_str(), &found) != 0) return refused();
    errno = EACCES;
    // Refuse a folder to which other users have access, because they could replace the socket.
    if (found.st_uid != ::getuid() || (found.st_mode & 0077U) != 0U) return refused();
    state->listening = ::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (state->listening < 0) return refused();
    fs::remove(state->path, ec);  // deletes a socket that an earlier process with the same id left behind
    const mode_t before = ::umask(0077);
    const bool bound = ::bind(state->listening, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
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

void DeskServer::send(const std::string& line) {
    state_->kept.push_back(line);
    if (state_->kept.size() > kKept) state_->kept.pop_front();
    for (State::Watcher& watcher : state_->watchers)
        if (watcher.descriptor >= 0) state_->send(watcher, line);
}

namespace {

// The instructor's end of the connection to a desk.
class WatchedDesk {
public:
    explicit WatchedDesk(int descriptor) : descriptor_(descriptor) {}
    WatchedDesk(WatchedDesk&& other) noexcept
        : descriptor_(std::exchange(other.descriptor_, -1)), come_(std::move(other.come_)) {}
    WatchedDesk& operator=(WatchedDesk&&) = delete;
    ~WatchedDesk() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }

    int descriptor() const { return descriptor_; }
    // Waits for data and appends the data to come_. Returns false if the desk has closed the connection.
    bool receive() {
        std::array<char, 1024> bytes{};
        const ssize_t got = ::recv(descriptor_, bytes.data(), bytes.size(), 0);
        if (got > 0) come_.append(bytes.data(), static_cast<std::size_t>(got));
        return got > 0 || (got < 0 && errno == EINTR);
    }
    std::string take_come() { return std::exchange(come_, {}); }
    // Waits for the first line of the desk, its title, and returns it. Returns an empty text if the desk closes the
    // connection or does not answer.
    std::string title() {
        constexpr timeval kWait{5, 0}, kForEver{0, 0};
        ::setsockopt(descriptor_, SOL_SOCKET, SO_RCVTIMEO, &kWait, sizeof kWait);
        while (come_.find('\n') == std::string::npos)
            if (!receive()) return {};
        ::setsockopt(descriptor_, SOL_SOCKET, SO_RCVTIMEO, &kForEver, sizeof kForEver);
        return come_.substr(0, come_.find('\n'));
    }
    bool send(const std::string& order) const {
        const std::string line = order + "\n";
        return ::send(descriptor_, line.data(), line.size(), MSG_NOSIGNAL) >= 0;
    }

private:
    int descriptor_;
    std::string come_;
};

// Connects to all desks that answer, sorted by file name. Deletes sockets that a crashed program left behind.
std::vector<WatchedDesk> desks_in(const fs::path& folder) {
    std::error_code ec;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, ec))
        if (entry.path().extension() == ".sock") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<WatchedDesk> desks;
    for (const fs::path& file : files) {
        sockaddr_un address{};
        if (!address_of(file, address)) continue;
        WatchedDesk desk(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
        if (desk.descriptor() < 0 || !same_person_owns(file)) continue;
        if (connects(desk.descriptor(), address)) {
            if (!desk.title().empty()) desks.push_back(std::move(desk));
        } else if (errno == ECONNREFUSED) {
            fs::remove(file, ec);
        }
    }
    return desks;
}

// Reads standard input line by line.
class TypedLines {
public:
    explicit TypedLines(int descriptor) : descriptor_(descriptor) {}
    int descriptor() const { return descriptor_; }  // -1: the input has ended
    // Waits for input. At the end of the input, descriptor() becomes -1.
    void read() {
        std::array<char, 1024> bytes{};
        const ssize_t got = ::read(descriptor_, bytes.data(), bytes.size());
        if (got <= 0) {
            descriptor_ = -1;
            return;
        }
        typed_.append(bytes.data(), static_cast<std::size_t>(got));
        take_lines(typed_, lines_);
    }
    // Returns the next complete line, if there is one.
    std::optional<std::string> take() {
        if (lines_.empty()) return std::nullopt;
        std::string line = std::move(lines_.front());
        lines_.erase(lines_.begin());
        return line;
    }

private:
    int descriptor_;
    std::string typed_;
    std::vector<std::string> lines_;
};

// Asks the instructor for the number of a desk. Returns nothing if the input ends first.
std::optional<std::size_t> chosen_of(std::vector<WatchedDesk>& desks, TypedLines& input, std::ostream& out) {
    while (input.descriptor() >= 0) {
        out << phrase("desk_order.several", {{"count", desks.size()}}) << "\n";
        for (std::size_t i = 0; i < desks.size(); ++i) out << fmt::format("{}. {}\n", i + 1, desks[i].title());
        out << std::flush;
        std::optional<std::string> line = input.take();
        for (; !line && input.descriptor() >= 0; line = input.take()) input.read();
        double number = 0.0;
        if (line && parse_finite(*line, number) && number >= 1.0 && number <= static_cast<double>(desks.size()))
            return static_cast<std::size_t>(number) - 1;
    }
    return std::nullopt;
}

}  // namespace

int watch_desk(const fs::path& folder, int in_descriptor, std::ostream& out, std::ostream& err) {
    std::vector<WatchedDesk> desks = desks_in(folder);
    if (desks.empty()) {
        err << phrase("desk_order.none") << "\n";
        return 1;
    }
    TypedLines input(in_descriptor);
    std::optional<std::size_t> chosen = 0;
    if (desks.size() > 1) chosen = chosen_of(desks, input, out);
    if (!chosen) {
        err << phrase("desk_order.none_chosen") << "\n";
        return 1;
    }
    WatchedDesk desk = std::move(desks[*chosen]);
    desks.clear();
    out << desk.take_come() << phrase("desk_order.watching") << "\n" << std::flush;
    for (bool there = true; there;) {
        while (const auto order = input.take()) there = desk.send(*order) && there;
        std::array<pollfd, 2> waits{pollfd{desk.descriptor(), POLLIN, 0}, pollfd{input.descriptor(), POLLIN, 0}};
        if (::poll(waits.data(), waits.size(), -1) < 0 && errno != EINTR) break;
        if (waits[0].revents != 0) {
            there = desk.receive();
            out << desk.take_come() << std::flush;
        }
        if (waits[1].revents == 0) continue;
        input.read();
        if (input.descriptor() < 0) ::shutdown(desk.descriptor(), SHUT_WR);
    }
    return 0;
}

}  // namespace handrail::teaching
