// Implements an output module of speech-dispatcher that writes into a file instead of speaking through a sound card. So
// tests can read what was said and when it was interrupted. For each event, the module writes one line to $RECORDED:
// seconds of CLOCK_MONOTONIC, then "speak WORDS", "end" or "stop". $RECORDED_WORD_MS is the duration of a word. The
// module uses the protocol between the server and its modules: commands on standard input, events on standard output.
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>

namespace {

using Clock = std::chrono::steady_clock;

// Returns the text of SSML, which the server sends. Removes the tags and replaces the five named entities by their
// characters.
std::string without_markup(const std::string& ssml) {
    std::string text;
    for (std::size_t i = 0; i < ssml.size(); ++i) {
        if (ssml[i] == '<') {
            i = ssml.find('>', i);
            if (i == std::string::npos) break;
            continue;
        }
        bool named = false;
        for (const auto& [name, letter] :
             {std::pair{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}}) {
            if (ssml.compare(i, std::char_traits<char>::length(name), name) != 0) continue;
            text += letter;
            i += std::char_traits<char>::length(name) - 1;
            named = true;
            break;
        }
        if (!named) text += ssml[i] == '\n' ? ' ' : ssml[i];
    }
    return text;
}

class Module {
public:
    int run() {
        std::string line;
        while (next_line(line)) {
            if (line == "INIT") answer("299-It writes down what it is told.\n299 OK LOADED SUCCESSFULLY");
            else if (line == "AUDIO") take_settings("207 OK RECEIVING AUDIO SETTINGS", "203 OK AUDIO INITIALIZED");
            else if (line == "SET") take_settings("203 OK RECEIVING SETTINGS", "203 OK SETTINGS RECEIVED");
            else if (line == "LOGLEVEL") take_settings("207 OK RECEIVING LOGLEVEL SETTINGS", "203 OK LOGLEVEL SET");
            else if (line == "SPEAK" || line == "CHAR" || line == "KEY" || line == "SOUND_ICON") speak();
            else if (line == "STOP") stop("stop", "703 STOP");
            else if (line == "PAUSE") stop("pause", "704 PAUSE");
            else if (line == "LIST VOICES") answer("200-recorder\ten\tnone\n200 OK VOICE LIST SENT");
            else if (line == "QUIT") return answer("210 OK QUIT"), 0;
            else answer("300 ERR UNKNOWN COMMAND");
        }
        return 0;
    }

private:
    static void answer(const char* text) {
        std::puts(text);
        std::fflush(stdout);
    }

    void note(const std::string& event) const {
        std::FILE* file = std::fopen(recorded_, "a");
        if (!file) return;
        std::fprintf(file, "%.6f %s\n", std::chrono::duration<double>(Clock::now().time_since_epoch()).count(),
                     event.c_str());
        std::fclose(file);
    }

    // Waits for a whole line from the server. If the current utterance ends while it waits, reports that end.
    bool next_line(std::string& line) {
        for (;;) {
            if (const std::size_t end = buffer_.find('\n'); end != std::string::npos) {
                line = buffer_.substr(0, end);
                buffer_.erase(0, end + 1);
                return true;
            }
            const int wait_ms =
                ends_ ? static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(*ends_ - Clock::now()).count())
                      : -1;
            pollfd input{0, POLLIN, 0};
            if (!ends_ || wait_ms > 0) ::poll(&input, 1, wait_ms);
            if (ends_ && Clock::now() >= *ends_) stop("end", "702 END");
            if (input.revents == 0) continue;
            char block[4096];
            const ssize_t got = ::read(0, block, sizeof block);
            if (got <= 0) return false;
            buffer_.append(block, static_cast<std::size_t>(got));
        }
    }

    void take_settings(const char* ready, const char* taken) {
        answer(ready);
        for (std::string line; next_line(line) && line != ".";) {
        }
        answer(taken);
    }

    void speak() {
        answer("202 OK RECEIVING MESSAGE");
        std::string text;
        for (std::string line; next_line(line) && line != ".";) text += (text.empty() ? "" : "\n") + line;
        text = without_markup(text);
        answer("200 OK SPEAKING");
        answer("701 BEGIN");
        note("speak " + text);
        int words = 1;
        for (const char letter : text) words += letter == ' ';
        ends_ = Clock::now() + words * word_;
    }

    void stop(const char* event, const char* reported) {
        if (!ends_) return;
        ends_.reset();
        note(event);
        answer(reported);
    }

    const char* recorded_ = std::getenv("RECORDED") ? std::getenv("RECORDED") : "/dev/null";
    std::chrono::milliseconds word_{std::getenv("RECORDED_WORD_MS") ? std::atoi(std::getenv("RECORDED_WORD_MS")) : 5};
    std::string buffer_;
    std::optional<Clock::time_point> ends_;  // when the current utterance ends
};

}  // namespace

int main() { return Module().run(); }
