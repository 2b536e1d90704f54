#include "audio-cues/sinks/braille_display.h"

// Removes BrlAPI's functions for a single session, which Handrail does not use.
#define BRLAPI_NO_SINGLE_SESSION
#include <brlapi.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <string>
#include <utility>

#include "audio-cues/sinks/braille_line.h"
#include "audio-cues/sinks/server_client.h"
#include "worlds/base/language.h"

namespace handrail::sinks {
namespace {

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

struct FreeHandle {
    void operator()(brlapi_handle_t* handle) const { std::free(handle); }
};

}  // namespace

struct BrailleDisplay::Shared : ServerClient {
    explicit Shared(std::shared_ptr<BrailleLink> l) : link(std::move(l)) {}

    const std::shared_ptr<BrailleLink> link;

    // The mutex protects the members below.
    bool wanted = false, allowed = true;
    std::string message;
    std::uint64_t messages = 0;
    bool lost = false;  // the loss of the display has not been announced yet
};

// The part that runs on the separate thread.
struct BrailleDisplay::Worker {
    explicit Worker(Shared& s)
        : shared(s), handle(static_cast<brlapi_handle_t*>(std::malloc(brlapi_getHandleSize()))) {}

    Shared& shared;
    std::unique_ptr<brlapi_handle_t, FreeHandle> handle;
    bool connected = false;
    bool holds_tty = false;  // true only if a display was connected
    unsigned window = 0;     // the window for which the thread took the display
    double look_again_s = 0.0;
    BrailleLine line;
    std::uint64_t shown_message = 0;
    std::u32string shown;

    void run() {
        for (;;) {
            bool wanted = false, quit = false;
            std::string message;
            std::uint64_t messages = 0;
            {
                const std::lock_guard lock(shared.mutex);
                wanted = shared.wanted && shared.allowed;
                quit = shared.quit;
                message = shared.message;
                messages = shared.messages;
            }
            if (quit || !wanted) close();
            if (quit) return;
            if (wanted && now_s() >= look_again_s) look();
            if (std::exchange(shown_message, messages) != messages) show_words(message);
            if (holds_tty) show();
            wait(wanted);
        }
    }

    // Searches for a server and, once connected to one, for its display.
    void look() {
        look_again_s = now_s() + kRetry_s;
        if (!connected && !open()) return;
        look_again_s = now_s() + kSizeEvery_s;
        // The display's model name must never be queried, because a server (BRLTTY 6.5) whose display is just
        // connecting then crashes.
        unsigned columns = 0, rows = 0;
        if (brlapi__getDisplaySize(handle.get(), &columns, &rows) < 0) return lose();
        const unsigned cells = columns * rows;
        if (cells == 0) {
            if (holds_tty) report_loss();
            leave_tty();
            return;
        }
        line.set_width(cells);
        const unsigned our_window = shared.link->window;
        if (holds_tty && window != our_window) leave_tty();
        if (!holds_tty && our_window != 0) take_tty(our_window);
    }

    bool open() {
        brlapi_connectionSettings_t settings{nullptr, nullptr};
        const int socket = brlapi__openConnection(handle.get(), &settings, nullptr);
        if (socket < 0) return false;
        connected = true;
        // Sets a handler, because without one the library ends the whole program on an error.
        brlapi__setExceptionHandler(handle.get(),
                                    [](brlapi_handle_t*, int, brlapi_packetType_t, const void*, std::size_t) {});
        const std::lock_guard lock(shared.mutex);
        shared.socket = socket;
        return true;
    }

    void take_tty(unsigned our_window) {
        // The last part of the path; the library puts the value of WINDOWPATH in front.
        const int path = static_cast<int>(our_window);
        if (brlapi__enterTtyModeWithPath(handle.get(), &path, 1, nullptr) < 0) return;
        static constexpr std::array<brlapi_keyCode_t, 6> kOurs{
            BRLAPI_KEY_TYPE_CMD | BRLAPI_KEY_CMD_FWINLT, BRLAPI_KEY_TYPE_CMD | BRLAPI_KEY_CMD_FWINRT,
            BRLAPI_KEY_TYPE_CMD | BRLAPI_KEY_CMD_LNUP,   BRLAPI_KEY_TYPE_CMD | BRLAPI_KEY_CMD_LNDN,
            BRLAPI_KEY_TYPE_CMD | BRLAPI_KEY_CMD_HOME,   BRLAPI_KEY_TYPE_CMD | BRLAPI_KEY_CMD_ROUTE};
        brlapi__ignoreAllKeys(handle.get());
        brlapi__acceptKeys(handle.get(), brlapi_rangeType_command, kOurs.data(), static_cast<unsigned>(kOurs.size()));
        holds_tty = true;
        window = our_window;
        shown.clear();
    }

    void leave_tty() {
        if (std::exchange(holds_tty, false)) brlapi__leaveTtyMode(handle.get());
    }

    // If the text ends with an item of the open list, shows this item with its place in the list and its neighbours;
    // otherwise shows the text.
    void show_words(const std::string& words) {
        const BrailleLink::List list = shared.link->list();
        if (list.items.empty() || list.said.empty() || !words.ends_with(list.said)) return line.show(words);
        line.show_list(std::string_view(words).substr(0, words.size() - list.said.size()), list.items, list.at);
    }

    void show() {
        line.set_heading(heading_cells(shared.link->heading_rad));
        std::u32string cells = line.cells();
        if (cells == shown) return;
        const std::wstring text(cells.begin(), cells.end());
        if (brlapi__writeWText(handle.get(), BRLAPI_CURSOR_OFF, text.c_str()) < 0) return lose();
        shown = std::move(cells);
    }

    void take_keys() {
        brlapi_keyCode_t code = 0;
        int got = 0;
        while ((got = brlapi__readKey(handle.get(), 0, &code)) > 0) {
            switch (code & BRLAPI_KEY_CODE_MASK & ~brlapi_keyCode_t{BRLAPI_KEY_CMD_ARG_MASK}) {
                case BRLAPI_KEY_CMD_ROUTE:
                    ++shared.link->more_requested;
                    continue;
                default:
                    break;
            }
            switch (code & BRLAPI_KEY_CODE_MASK) {
                case BRLAPI_KEY_CMD_FWINRT:
                case BRLAPI_KEY_CMD_LNDN:
                    line.pan_right();
                    break;
                case BRLAPI_KEY_CMD_FWINLT:
                case BRLAPI_KEY_CMD_LNUP:
                    line.pan_left();
                    break;
                case BRLAPI_KEY_CMD_HOME:
                    line.pan_home();
                    break;
                default:
                    break;
            }
        }
        if (got < 0) lose();
    }

    void lose() {
        if (holds_tty) report_loss();
        holds_tty = false;  // set to false so that no leave request is sent over a broken connection
        close();
        look_again_s = now_s() + kRetry_s;
    }

    void report_loss() {
        const std::lock_guard lock(shared.mutex);
        shared.lost = true;
    }

    void close() {
        if (!connected) return;
        leave_tty();
        {
            const std::lock_guard lock(shared.mutex);
            shared.socket = -1;
        }
        brlapi__closeConnection(handle.get());
        connected = false;
        look_again_s = 0.0;
    }

    void wait(bool wanted) {
        pollfd events[2] = {{shared.wake, POLLIN, 0},
                            {connected ? brlapi__getFileDescriptor(handle.get()) : -1, POLLIN, 0}};
        const int wait_ms = wanted ? std::clamp(static_cast<int>(1000.0 * (look_again_s - now_s())) + 1, 1, 5000) : -1;
        ::poll(events, 2, wait_ms);
        if (events[0].revents != 0) shared.take_wake();
        if (events[1].revents == 0) return;
        if (holds_tty) take_keys();
        else if ((events[1].revents & (POLLHUP | POLLERR)) != 0) lose();
        // The next query of the size also reads the data that has arrived, so it is made soon.
        else look_again_s = std::min(look_again_s, now_s() + 0.02);
    }
};

BrailleDisplay::BrailleDisplay(std::shared_ptr<BrailleLink> link, const settings::Settings::Speech& settings)
    : shared_(std::make_shared<Shared>(std::move(link))) {
    shared_->allowed = settings.braille;
    thread_ = start_client(shared_, "braille", [shared = shared_.get()] { Worker(*shared).run(); });
}

BrailleDisplay::~BrailleDisplay() { end_client(*shared_, thread_); }

void BrailleDisplay::want(bool wanted) {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->wanted = wanted;
    }
    shared_->rouse();
}

void BrailleDisplay::write(const cues::Utterance& utterance) {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->message = utterance.text;
        ++shared_->messages;
    }
    shared_->rouse();
}

void BrailleDisplay::tick(double) {
    const double heading_rad = shared_->link->heading_rad;
    if (std::exchange(shown_heading_rad_, heading_rad) != heading_rad) shared_->rouse();
}

void BrailleDisplay::set_speech(const settings::Settings::Speech& settings) {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->allowed = settings.braille;
    }
    shared_->rouse();
}

std::optional<std::string> BrailleDisplay::news() {
    const std::lock_guard lock(shared_->mutex);
    if (!std::exchange(shared_->lost, false)) return std::nullopt;
    return phrase("braille.gone");
}

}  // namespace handrail::sinks
