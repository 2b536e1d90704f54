#include "app/terminal/raw_terminal.h"

#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <string_view>

namespace handrail::terminal {
namespace {

// Data for the signal handlers. The program writes `held` before it sets `is_taken`, and only reads it while `is_taken`
// is set.
struct Held {
    int input = -1, output = -1;
    termios before{}, raw{};
};
Held held;
std::atomic<bool> is_taken{false};
static_assert(std::atomic<bool>::is_always_lock_free);

// Signals that end a program by default. If the process already handles one of them (EndSignals) or ignores it,
// RawTerminal does not change that.
constexpr std::array kEnding{SIGHUP,  SIGINT,  SIGQUIT, SIGILL,  SIGTRAP, SIGABRT,   SIGBUS,  SIGFPE,  SIGSEGV, SIGSYS,
                             SIGPIPE, SIGALRM, SIGTERM, SIGUSR1, SIGUSR2, SIGVTALRM, SIGPROF, SIGXCPU, SIGXFSZ};
std::array<struct sigaction, kEnding.size()> ending_before;
std::array<bool, kEnding.size()> ending_caught;
struct sigaction stop_before, go_on_before;
bool stop_caught = false, go_on_caught = false;

// The stack on which a handler runs after the normal stack has overflowed.
alignas(16) std::array<char, 65536> spare_stack;

constexpr std::string_view kMarkPastes = "\x1b[?2004h", kMarkNoPastes = "\x1b[?2004l";

// Returns true if the program is in the foreground of the terminal. In the background, the terminal's modes belong to
// the shell, and changing them would stop this process. A negative process group means that there is no job control.
bool is_ours(int terminal) {
    const pid_t foreground = ::tcgetpgrp(terminal);
    return foreground < 0 || foreground == ::getpgrp();
}

// Writes text to the terminal without waiting. Drops the text if the terminal cannot accept it at once.
void write_if_ready(std::string_view text) {
    pollfd ready{held.output, POLLOUT, 0};
    if (::poll(&ready, 1, 0) != 1 || (ready.revents & POLLOUT) == 0) return;
    [[maybe_unused]] const ssize_t put = ::write(held.output, text.data(), text.size());
}

void give_back() {
    if (!is_taken.load(std::memory_order_acquire) || !is_ours(held.input)) return;
    ::tcsetattr(held.input, TCSANOW, &held.before);
    write_if_ready(kMarkNoPastes);
}

void take_again() {
    if (!is_taken.load(std::memory_order_acquire) || !is_ours(held.input)) return;
    ::tcsetattr(held.input, TCSANOW, &held.raw);
    write_if_ready(kMarkPastes);
}

// Restores the terminal, and then lets the signal have its usual effect.
void on_ending(int signal) {
    const int error = errno;
    give_back();
    for (std::size_t i = 0; i < kEnding.size(); ++i)
        if (kEnding[i] == signal) ::sigaction(signal, &ending_before[i], nullptr);
    ::raise(signal);  // delivered only after this handler has returned
    errno = error;
}

void catch_stop();

void on_stop(int signal) {
    const int error = errno;
    give_back();
    struct sigaction stop {};
    stop.sa_handler = SIG_DFL;
    ::sigaction(signal, &stop, nullptr);
    sigset_t this_one, mask;
    sigemptyset(&this_one);
    sigaddset(&this_one, signal);
    ::raise(signal);
    ::pthread_sigmask(SIG_UNBLOCK, &this_one, &mask);  // the process stops here until it is continued
    ::pthread_sigmask(SIG_SETMASK, &mask, nullptr);
    catch_stop();
    take_again();
    errno = error;
}

void on_going_on(int) {
    const int error = errno;
    take_again();
    errno = error;
}

void install(int signal, void (*handler)(int), struct sigaction* before) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART | SA_ONSTACK;
    sigfillset(&action.sa_mask);
    ::sigaction(signal, &action, before);
}

void catch_stop() { install(SIGTSTP, on_stop, nullptr); }

bool ends_by_default(int signal) {
    struct sigaction now {};
    return ::sigaction(signal, nullptr, &now) == 0 && (now.sa_flags & SA_SIGINFO) == 0 && now.sa_handler == SIG_DFL;
}

// Returns true if the signal reports a crash. RawTerminal handles crashes even if another handler exists, such as a
// sanitizer's. That other handler is called after on_ending.
bool is_crash(int signal) {
    return signal == SIGSEGV || signal == SIGBUS || signal == SIGFPE || signal == SIGILL || signal == SIGABRT ||
           signal == SIGTRAP || signal == SIGSYS;
}

void catch_signals() {
    for (std::size_t i = 0; i < kEnding.size(); ++i) {
        ending_caught[i] = is_crash(kEnding[i]) || ends_by_default(kEnding[i]);
        if (ending_caught[i]) install(kEnding[i], on_ending, &ending_before[i]);
    }
    stop_caught = ends_by_default(SIGTSTP);
    if (stop_caught) install(SIGTSTP, on_stop, &stop_before);
    go_on_caught = ends_by_default(SIGCONT);
    if (go_on_caught) install(SIGCONT, on_going_on, &go_on_before);
}

void let_signals_go() {
    if (go_on_caught) ::sigaction(SIGCONT, &go_on_before, nullptr);
    if (stop_caught) ::sigaction(SIGTSTP, &stop_before, nullptr);
    for (std::size_t i = 0; i < kEnding.size(); ++i)
        if (ending_caught[i]) ::sigaction(kEnding[i], &ending_before[i], nullptr);
}

void set_a_stack_aside() {
    stack_t now{};
    if (::sigaltstack(nullptr, &now) != 0 || (now.ss_flags & SS_DISABLE) == 0) return;
    stack_t spare{};
    spare.ss_sp = spare_stack.data();
    spare.ss_size = spare_stack.size();
    ::sigaltstack(&spare, nullptr);
}

}  // namespace

std::unique_ptr<RawTerminal> RawTerminal::take(int input, int output) {
    if (is_taken.load(std::memory_order_acquire) || ::isatty(input) != 1 || ::isatty(output) != 1 || !is_ours(input))
        return nullptr;
    termios before{};
    if (::tcgetattr(input, &before) != 0) return nullptr;
    held = {input, output, before, before};
    held.raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ECHONL | IEXTEN);
    held.raw.c_lflag |= ISIG;
    // Enter arrives as CR, Ctrl+S and Ctrl+Q arrive as keys, and all eight bits of each byte arrive.
    held.raw.c_iflag &= ~static_cast<tcflag_t>(ICRNL | INLCR | IGNCR | IXON | ISTRIP);
    held.raw.c_cc[VMIN] = 1;
    held.raw.c_cc[VTIME] = 0;
    static const int at_exit = std::atexit(give_back);
    static_cast<void>(at_exit);
    set_a_stack_aside();
    is_taken.store(true, std::memory_order_release);
    catch_signals();
    if (::tcsetattr(input, TCSANOW, &held.raw) != 0) {
        let_signals_go();
        is_taken.store(false, std::memory_order_release);
        return nullptr;
    }
    write_if_ready(kMarkPastes);
    return std::unique_ptr<RawTerminal>(new RawTerminal);
}

RawTerminal::RawTerminal() = default;

RawTerminal::~RawTerminal() {
    // Discard keys that the person meant for this program. Otherwise the shell would receive them, and Up and Enter
    // would repeat the shell's last command.
    if (is_ours(held.input)) ::tcflush(held.input, TCIFLUSH);
    give_back();
    is_taken.store(false, std::memory_order_release);
    let_signals_go();
}

char RawTerminal::erase() const { return static_cast<char>(held.before.c_cc[VERASE]); }

}  // namespace handrail::terminal
