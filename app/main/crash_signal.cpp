#include "app/main/crash_signal.h"

#include <execinfo.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

// Addresses that the linker defines: where this program begins in memory, and where its code ends.
extern "C" const char __ehdr_start;  // NOLINT(bugprone-reserved-identifier): that is its name
extern "C" const char etext;

namespace handrail::program {
namespace {

constexpr std::array<int, 5> kSignals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
std::array<struct sigaction, kSignals.size()> former_actions{};
volatile std::sig_atomic_t noted = -1;  // descriptor of the file for the note; -1: none

// The functions from here to on_crash call only functions that a signal handler may call. backtrace() is such a
// function only after its first call, so CrashSignal calls it before any crash.
void write_number(unsigned long value, unsigned base) {
    std::array<char, 24> digits;
    std::size_t at = digits.size();
    do {
        digits[--at] = "0123456789abcdef"[value % base];
        value /= base;
    } while (value > 0);
    [[maybe_unused]] const ssize_t ignored = ::write(noted, digits.data() + at, digits.size() - at);
}

void write_text(const char* text, std::size_t length) {
    [[maybe_unused]] const ssize_t ignored = ::write(noted, text, length);
}

void on_crash(int signal) {
    const int error = errno;
    if (noted >= 0) {
        write_number(static_cast<unsigned long>(signal), 10);
        std::array<void*, 32> places{};
        const int count = ::backtrace(places.data(), static_cast<int>(places.size()));
        for (int i = 0; i < count; ++i) {
            const char* place = static_cast<const char*>(places[static_cast<std::size_t>(i)]);
            write_text("\n", 1);
            if (place >= &__ehdr_start && place < &etext) {
                write_text("handrail+0x", 11);
                write_number(static_cast<unsigned long>(place - &__ehdr_start), 16);
            } else {
                write_text("-", 1);
            }
        }
        write_text("\n", 1);
        noted = -1;
    }
    for (std::size_t i = 0; i < kSignals.size(); ++i)
        if (kSignals[i] == signal) ::sigaction(signal, &former_actions[i], nullptr);
    // The signal is blocked during this function, so the previous handler receives it after the return.
    ::raise(signal);
    errno = error;
}

}  // namespace

CrashSignal::CrashSignal(const std::filesystem::path& file) {
    if (file.empty()) return;
    std::array<void*, 4> places{};
    ::backtrace(places.data(), static_cast<int>(places.size()));
    noted = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0600);
    struct sigaction action {};
    action.sa_handler = on_crash;
    action.sa_flags = SA_ONSTACK;
    ::sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &action, &former_actions[i]);
    caught_ = true;
}

CrashSignal::~CrashSignal() {
    if (!caught_) return;
    for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &former_actions[i], nullptr);
    const int file = noted;
    noted = -1;
    if (file >= 0) ::close(file);
}

}  // namespace handrail::program
