#include "app/terminal/terminal.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>
#include <algorithm>
#include <iterator>

#include <array>
#include <cerrno>
#include <charconv>

#include "app/core/dialogue/command_words.h"
#include "app/core/dialogue/typed_sentences.h"
#include "worlds/base/executor.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

constexpr std::size_t kLongestLine = 4096;

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

// A word of a command with what may stand after it.
Result<TerminalLine> command_line_of(std::string_view line) {
    const std::size_t blank = line.find_first_of(" \t");
    const std::string word = lower_ascii(line.substr(0, blank));
    const std::string_view rest = blank == std::string_view::npos ? std::string_view{} : trimmed(line.substr(blank));
    TerminalLine parsed;
    if (is_quit_word(word)) {
        parsed.leave = true;
    } else if (parsed.command = command_of_word(word); !parsed.command) {
        return fail(phrase("terminal.no_command", {{"word", word}, {"nearest", nearest_name(word, spoken_words())}}));
    }
    if (parsed.command && takes_choice(*parsed.command)) {
        parsed.choice = rest;
    } else if (!rest.empty()) {
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), parsed.times);
        if (error != std::errc{} || end != rest.data() + rest.size() || parsed.times < 1 || parsed.times > kMostTimes)
            return fail(phrase("terminal.only_count", {{"word", word}, {"most", kMostTimes}}));
    }
    return parsed;
}

// Of several words, of which none is a number: what is wrong is no count.
bool is_sentence(std::string_view line) {
    return line.find_first_of(" \t") != std::string_view::npos &&
           line.find_first_of("0123456789") == std::string_view::npos;
}

}  // namespace

Result<TerminalLine> parse_terminal_line(std::string_view line) {
    line = trimmed(line);
    if (line.empty()) return TerminalLine{};
    Result<TerminalLine> parsed = command_line_of(line);
    // "find my way to the kitchen" looks for no thing of that name.
    if (!parsed || !parsed->choice.empty())
        if (auto said = typed_sentence(line)) return TerminalLine{said->command, said->times, std::move(said->choice)};
    if (parsed) return parsed;
    if (is_sentence(line)) {
        const std::string_view first = line.substr(0, line.find_first_of(" \t"));
        const auto command = command_of_word(first);
        return fail(command ? phrase("terminal.no_sentence_word", {{"line", line}, {"word", spoken_word(*command)}})
                            : phrase("terminal.no_sentence", {{"line", line}}));
    }
    return parsed;
}

std::vector<std::string> LineInput::take() {
    std::vector<std::string> lines;
    for (std::size_t bytes = 0; !ended_ && bytes < kBytesAtOnce;) {
        pollfd wait{descriptor_, POLLIN, 0};
        const int ready = ::poll(&wait, 1, 0);
        if (ready == 0 || (ready < 0 && errno == EINTR)) break;
        char block[4096];
        const ssize_t got = ready < 0 ? -1 : ::read(descriptor_, block, sizeof block);
        if (got < 0 && (errno == EINTR || errno == EAGAIN)) break;
        if (got <= 0) {
            ended_ = true;
            if (!partial_.empty()) lines.push_back(std::exchange(partial_, {}));
            break;
        }
        bytes += static_cast<std::size_t>(got);
        for (ssize_t i = 0; i < got; ++i) {
            if (block[i] == '\n') lines.push_back(std::exchange(partial_, {}));
            else if (partial_.size() < kLongestLine) partial_ += block[i];
        }
    }
    return lines;
}

LineWatch::LineWatch(int descriptor, WhenFull when_full, std::function<bool(std::string_view)> at_once)
    : input_(descriptor),
      descriptor_(descriptor),
      when_full_(when_full),
      at_once_(std::move(at_once)),
      wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      thread_([this] {
          name_this_thread("lines");
          run();
      }) {}

LineWatch::~LineWatch() {
    leaving_ = true;
    wake();
    thread_.join();
}

void LineWatch::wake() {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = ::write(wake_.get(), &one, sizeof one);
}

std::vector<std::string> LineWatch::take(bool& emptied, std::size_t most) {
    std::vector<std::string> taken;
    bool made_room = false;
    {
        const std::lock_guard guard(mutex_);
        emptied = std::exchange(emptied_, false);
        const bool was_full = lines_.size() >= kMostWaiting;
        const auto end = lines_.begin() + static_cast<std::ptrdiff_t>(std::min(most, lines_.size()));
        taken.assign(std::make_move_iterator(lines_.begin()), std::make_move_iterator(end));
        lines_.erase(lines_.begin(), end);
        made_room = was_full && lines_.size() < kMostWaiting;
    }
    if (made_room) wake();
    return taken;
}

bool LineWatch::is_full() {
    const std::lock_guard guard(mutex_);
    return lines_.size() >= kMostWaiting;
}

void LineWatch::run() {
    while (!input_.ended()) {
        const bool waits = when_full_ == WhenFull::Waits && is_full();
        std::array<pollfd, 2> watched{pollfd{waits ? -1 : descriptor_, POLLIN, 0}, pollfd{wake_.get(), POLLIN, 0}};
        if (::poll(watched.data(), watched.size(), -1) < 0 && errno != EINTR) break;
        if (leaving_) return;
        if (watched[1].revents != 0) {
            std::uint64_t count = 0;
            [[maybe_unused]] const ssize_t got = ::read(wake_.get(), &count, sizeof count);
        }
        if (waits) continue;
        for (std::string& line : input_.take()) {
            // Held while the line acts too: whoever takes lines after it was seen finds none from before it.
            const std::lock_guard guard(mutex_);
            if (at_once_(line)) {
                lines_.clear();
                emptied_ = true;
            } else if (when_full_ == WhenFull::Waits || lines_.size() < kMostWaiting) {
                lines_.push_back(std::move(line));
            }
        }
    }
    ended_.store(true, std::memory_order_release);
}

}  // namespace handrail
