#include "audio-cues/sinks/speechd_speech.h"

#include <libspeechd.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "audio-cues/sinks/server_client.h"
#include "worlds/base/language.h"

namespace handrail::sinks {
namespace {

constexpr double kLongestStart_s = 5.0;   // longest time from say() to the first word, for a slow server
constexpr double kSlowestLetter_s = 0.3;  // time per letter of the slowest voice

struct CloseConnection {
    void operator()(SPDConnection* connection) const { spd_close(connection); }
};
using Connection = std::unique_ptr<SPDConnection, CloseConnection>;

}  // namespace

struct SpeechdSpeech::Shared : ServerClient {
    bool start_server = false;  // set before the thread starts

    // The mutex protects the members below.
    bool wanted = false;
    VoiceState state = VoiceState::Unavailable;
    std::string language;
    std::optional<cues::Utterance> job;  // only the newest text, because a new text cuts off the last one
    bool silence = false;
    // Languages that the server does not support: one that has not been announced yet, and the one announced last.
    std::string refused, refused_before;
    // Numbers of the last utterance that was started and of the last one that ended. The voice speaks while they
    // differ.
    std::uint64_t said = 0, finished = 0;
    std::uint64_t calls_begun = 0, calls_answered = 0;
    // The server's number for this client, its number for the newest utterance, and the last utterance whose end the
    // server has reported.
    std::size_t client = 0, message = 0, message_ended = 0;

    void on_end(std::size_t ended_message, std::size_t of_client) {
        const std::lock_guard lock(mutex);
        if (of_client != client) return;
        message_ended = std::max(message_ended, ended_message);
        if (message != 0 && message_ended >= message) finished = std::max(finished, said_as_message);
    }
    std::uint64_t said_as_message = 0;  // number, counted in `said`, of the utterance that the server calls `message`
};

namespace {

// libspeechd calls back on its own thread, without a user pointer. Through this object, the callback finds the one
// instance that is connected. The object is never destroyed, because that thread may outlive everything else.
struct EndListener {
    std::mutex mutex;
    std::weak_ptr<void> of;
    void (*on_end)(void*, std::size_t, std::size_t) = nullptr;
};
EndListener& end_listener() {
    static EndListener& only = *new EndListener;
    return only;
}

void on_end_event(std::size_t message, std::size_t client, SPDNotificationType) {
    EndListener& route_back = end_listener();
    const std::lock_guard lock(route_back.mutex);
    if (const auto of = route_back.of.lock()) route_back.on_end(of.get(), message, client);
}

}  // namespace

// The part that runs on the worker thread.
struct SpeechdSpeech::Worker {
    Shared& shared;
    Connection connection;
    std::string language{};  // the language set on this connection
    int volume_percent = 100;

    template <class Call>
    auto call(Call&& function) {
        {
            const std::lock_guard lock(shared.mutex);
            ++shared.calls_begun;
        }
        auto result = function();
        const std::lock_guard lock(shared.mutex);
        shared.calls_answered = shared.calls_begun;
        return result;
    }

    bool open(const std::string& wanted_language) {
        char* error = nullptr;
        connection.reset(call([&] {
            return spd_open2("handrail", "explore", nullptr, SPD_MODE_THREADED, nullptr, shared.start_server ? 1 : 0,
                             &error);
        }));
        std::free(error);
        if (!connection) return false;
        {
            const std::lock_guard lock(shared.mutex);
            shared.socket = connection->socket;
        }
        connection->callback_end = connection->callback_cancel = &on_end_event;
        const int client = call([&] { return spd_get_client_id(connection.get()); });
        if (client < 0) return false;
        {
            const std::lock_guard lock(shared.mutex);
            shared.client = static_cast<std::size_t>(client);
            shared.message = shared.message_ended = 0;
        }
        const bool notifies = call([&] { return spd_set_notification_on(connection.get(), SPD_END); }) == 0 &&
                              call([&] { return spd_set_notification_on(connection.get(), SPD_CANCEL); }) == 0;
        if (notifies) speak(wanted_language);
        return notifies;
    }

    // Sets the language of the text, because the person's default voice may have another one. Which voice speaks the
    // language depends on the person's settings. If the server has no voice for the language, it refuses; the voice
    // that was set before then speaks with its own accent, which is better than silence. If the server has gone, the
    // next call notices it.
    void speak(const std::string& wanted_language) {
        language = wanted_language;
        const bool taken = call([&] { return spd_set_language(connection.get(), language.c_str()); }) == 0;
        const std::lock_guard lock(shared.mutex);
        if (!taken && shared.refused_before != language) shared.refused = shared.refused_before = language;
    }

    void close() {
        {
            const std::lock_guard lock(shared.mutex);
            shared.socket = -1;
            shared.finished = shared.said;
        }
        connection.reset();
        volume_percent = 100;
    }

    bool say(const cues::Utterance& utterance, std::uint64_t number) {
        if (call([&] { return spd_cancel(connection.get()); }) != 0) return false;
        const int percent = static_cast<int>(std::lround(100.0 * utterance.loudness));
        if (percent != volume_percent && call([&] { return spd_set_volume(connection.get(), 2 * percent - 100); }) != 0)
            return false;
        volume_percent = percent;
        const SPDPriority priority = utterance.speech_class == cues::SpeechClass::Alarm ? SPD_IMPORTANT : SPD_MESSAGE;
        const int message = call([&] { return spd_say(connection.get(), priority, utterance.text.c_str()); });
        if (message < 0) return false;
        const std::lock_guard lock(shared.mutex);
        shared.message = static_cast<std::size_t>(message);
        shared.said_as_message = number;
        // If the server reported the end of an utterance before it returned the utterance's number, `finished` is set
        // here.
        if (shared.message_ended >= shared.message) shared.finished = std::max(shared.finished, number);
        return true;
    }

    // Processes all pending work. Returns false if the server has gone.
    bool work_off() {
        std::optional<cues::Utterance> job;
        std::string wanted_language;
        bool silence = false;
        std::uint64_t number = 0;
        {
            const std::lock_guard lock(shared.mutex);
            job = std::exchange(shared.job, std::nullopt);
            silence = std::exchange(shared.silence, false);
            number = shared.said;
            wanted_language = shared.language;
        }
        if (job && wanted_language != language) speak(wanted_language);
        if (job) return say(*job, number);
        return !silence || call([&] { return spd_cancel(connection.get()); }) == 0;
    }

    // Waits for work. Returns false if the server has gone.
    bool wait(double most_s) {
        pollfd events[2] = {{shared.wake, POLLIN, 0}, {connection ? connection->socket : -1, POLLRDHUP, 0}};
        ::poll(events, 2, most_s < 0.0 ? -1 : static_cast<int>(std::lround(1000.0 * most_s)));
        shared.take_wake();
        return events[1].revents == 0;
    }

    void run() {
        double retry_s = kFirstRetry_s;
        for (;;) {
            bool wanted = false;
            std::string wanted_language;
            {
                const std::lock_guard lock(shared.mutex);
                if (shared.quit) break;
                wanted = shared.wanted;
                wanted_language = shared.language;
            }
            if (!wanted) {
                close();
                wait(-1.0);
                continue;
            }
            if (!connection) {
                const bool usable = open(wanted_language);
                if (!usable) close();
                else retry_s = kFirstRetry_s;
                set_state(usable ? VoiceState::Ready : VoiceState::Unavailable);
                if (!usable) {
                    wait(retry_s);
                    retry_s = std::min(2.0 * retry_s, kSlowestRetry_s);
                }
                continue;
            }
            if (work_off() && wait(-1.0)) continue;
            set_state(VoiceState::Unavailable);
            close();
            wait(retry_s);
        }
        close();
    }

    void set_state(VoiceState state) {
        const std::lock_guard lock(shared.mutex);
        shared.state = state;
        if (state == VoiceState::Unavailable) shared.job.reset();
    }
};

void SpeechdSpeech::work(const std::shared_ptr<Shared>& shared) {
    {
        EndListener& route_back = end_listener();
        const std::lock_guard lock(route_back.mutex);
        route_back.of = shared;
        route_back.on_end = [](void* of, std::size_t message, std::size_t client) {
            static_cast<Shared*>(of)->on_end(message, client);
        };
    }
    Worker{.shared = *shared, .connection = nullptr}.run();
}

SpeechdSpeech::SpeechdSpeech(const settings::Settings::Speech& settings) : shared_(std::make_shared<Shared>()) {
    shared_->start_server = std::getenv("SPEECHD_ADDRESS") == nullptr;
    set_speech(settings);
    thread_ = start_client(shared_, "speechd", [shared = std::weak_ptr(shared_)] {
        if (const auto held = shared.lock()) work(held);
    });
}

SpeechdSpeech::~SpeechdSpeech() { end_client(*shared_, thread_); }

VoiceState SpeechdSpeech::state() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->state;
}

void SpeechdSpeech::want(bool wanted) {
    {
        const std::lock_guard lock(shared_->mutex);
        if (std::exchange(shared_->wanted, wanted) == wanted) return;
        shared_->state = wanted ? VoiceState::Opening : VoiceState::Unavailable;
    }
    shared_->rouse();
}

void SpeechdSpeech::say(const cues::Utterance& utterance) {
    {
        const std::lock_guard lock(shared_->mutex);
        if (shared_->state != VoiceState::Ready) return;
        shared_->job = utterance;
        ++shared_->said;
    }
    speaks_until_s_ = now_s_ + kLongestStart_s + kSlowestLetter_s * static_cast<double>(utterance.text.size());
    shared_->rouse();
}

void SpeechdSpeech::stop() {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->job.reset();
        shared_->silence = true;
        shared_->finished = shared_->said;
    }
    shared_->rouse();
}

std::optional<std::string> SpeechdSpeech::news() {
    const std::lock_guard lock(shared_->mutex);
    if (shared_->refused.empty() || shared_->state != VoiceState::Ready) return std::nullopt;
    return phrase("voice.refuses_language", {{"language", std::exchange(shared_->refused, {})}});
}

bool SpeechdSpeech::speaking() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->finished < shared_->said && now_s_ < speaks_until_s_;
}

void SpeechdSpeech::tick(double now_s) {
    now_s_ = now_s;
    const std::lock_guard lock(shared_->mutex);
    const bool unanswered = shared_->calls_begun != shared_->calls_answered;
    if (!unanswered || watched_call_ != shared_->calls_begun) {
        watched_call_ = unanswered ? shared_->calls_begun : 0;
        watched_since_s_ = now_s;
        return;
    }
    if (now_s - watched_since_s_ < kStalled_s) return;
    // Shutting the connection down makes the pending call fail, so that the thread returns and tries again later.
    shared_->state = VoiceState::Unavailable;
    shared_->finished = shared_->said;
    if (shared_->socket >= 0) ::shutdown(shared_->socket, SHUT_RDWR);
}

void SpeechdSpeech::set_speech(const settings::Settings::Speech& settings) {
    const std::lock_guard lock(shared_->mutex);
    // A name of an espeak-ng voice may be longer than a language code, but it begins with the language code.
    const std::string voice = settings.voice == "auto" ? spoken_language() : settings.voice;
    const std::size_t letters = std::min(voice.find('-'), voice.size());
    shared_->language = letters == 2 || letters == 3 ? voice.substr(0, letters) : "en";
}

}  // namespace handrail::sinks
