#include "audio-cues/sinks/text_speech.h"

#include <limits.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>

namespace handrail::sinks {
namespace {

// Calls write(2). If the reader of a pipe has gone, the function returns the error EPIPE and leaves no SIGPIPE pending,
// whatever the process does with that signal.
ssize_t write_without_sigpipe(int fd, const char* data, std::size_t size) {
    sigset_t pipe_signal, before, pending;
    sigemptyset(&pipe_signal);
    sigaddset(&pipe_signal, SIGPIPE);
    sigpending(&pending);
    pthread_sigmask(SIG_BLOCK, &pipe_signal, &before);
    ssize_t put = 0;
    do put = ::write(fd, data, size);
    while (put < 0 && errno == EINTR);
    const int error = errno;
    if (put < 0 && error == EPIPE && sigismember(&pending, SIGPIPE) == 0) {
        const timespec at_once{};
        while (sigtimedwait(&pipe_signal, nullptr, &at_once) < 0 && errno == EINTR) {
        }
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    errno = error;
    return put;
}

}  // namespace

TextSpeech::~TextSpeech() { drain(200); }

void TextSpeech::write(const cues::Utterance& utterance) {
    const char* prefix = utterance.speech_class == cues::SpeechClass::Alarm ? "alert: " : "say: ";
    const std::string line = prefix + utterance.text + '\n';
    if (reader_left_ || backlog_.size() + line.size() > kMostBacklog) return;
    backlog_ += line;
    drain(0);
}

void TextSpeech::tick(double /*now_s*/) { drain(0); }

void TextSpeech::drain(int timeout_ms) {
    while (!reader_left_ && !backlog_.empty()) {
        pollfd ready{.fd = fd_, .events = POLLOUT, .revents = 0};
        const int polled = ::poll(&ready, 1, timeout_ms);
        if (polled < 0 && errno == EINTR) continue;
        if (polled == 0) return;
        if (polled < 0 || (ready.revents & (POLLERR | POLLHUP | POLLNVAL)) != 0) {
            reader_left_ = true;
            break;
        }
        // A pipe that poll() reports as ready accepts PIPE_BUF bytes without waiting. A larger write could block, so no
        // more is written at once.
        const ssize_t put =
            write_without_sigpipe(fd_, backlog_.data(), std::min<std::size_t>(backlog_.size(), PIPE_BUF));
        if (put < 0 && errno == EAGAIN) return;
        if (put < 0) reader_left_ = true;
        else backlog_.erase(0, static_cast<std::size_t>(put));
    }
    if (reader_left_) backlog_.clear();
}

void TeeSpeech::say(const cues::Utterance& utterance) {
    for (const auto& sink : sinks_) sink->say(utterance);
}

void TeeSpeech::write(const cues::Utterance& utterance) {
    for (const auto& sink : sinks_) sink->write(utterance);
}

void TeeSpeech::stop() {
    for (const auto& sink : sinks_) sink->stop();
}

bool TeeSpeech::speaking() const {
    return std::any_of(sinks_.begin(), sinks_.end(), [](const auto& sink) { return sink->speaking(); });
}

void TeeSpeech::tick(double now_s) {
    for (const auto& sink : sinks_) sink->tick(now_s);
}

void TeeSpeech::set_speech(const settings::Settings::Speech& settings) {
    for (const auto& sink : sinks_) sink->set_speech(settings);
}

std::optional<std::string> TeeSpeech::news() {
    for (const auto& sink : sinks_)
        if (auto sentence = sink->news()) return sentence;
    return std::nullopt;
}

}  // namespace handrail::sinks
