#include "audio-cues/sinks/espeak_speech.h"

#include <espeak-ng/espeak_ng.h>
#include <espeak-ng/speak_lib.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "worlds/base/executor.h"
#include "worlds/base/language.h"

namespace handrail::sinks {
namespace {

// Number of samples that are sent together. They are 0.19 s of speech, which espeak-ng makes in about 1 ms. The sink
// plays the pieces without a gap.
constexpr std::size_t kPiece = 4096;

// espeak-ng has one state per process, which these flags mirror. Only the code that has set `library_taken` may use
// `library_ready` and the library. The library is never terminated, because espeak_Terminate can wait for ever for a
// thread that does not listen yet (seen with 1.51).
std::atomic<bool> library_taken{false};
bool library_ready = false;

// State of the callback while a text is being synthesised. Voice thread only.
struct Synthesis {
    VoiceChannel* channel = nullptr;
    VoiceChannel::Ticket ticket = 0;
    std::vector<std::int16_t> piece;

    // Sends the current piece. Returns false if the utterance was cut off.
    bool send() {
        const bool wanted = channel->append(ticket, piece);
        piece.clear();
        return wanted;
    }
};

// espeak-ng calls this function with the samples of every 20 ms of speech. Returning 1 ends the synthesis.
int on_samples(short* samples, int count, espeak_EVENT* events) {
    auto* synthesis = static_cast<Synthesis*>(events->user_data);
    if (synthesis == nullptr) return 0;
    if (samples != nullptr && count > 0) synthesis->piece.insert(synthesis->piece.end(), samples, samples + count);
    if (synthesis->piece.size() < kPiece && !synthesis->channel->cut(synthesis->ticket)) return 0;
    return synthesis->send() ? 0 : 1;
}

std::string status_words(espeak_ng_STATUS status) {
    std::array<char, 256> words{};
    espeak_ng_GetStatusCodeMessage(status, words.data(), words.size());
    return words.data();
}

}  // namespace

struct EspeakSpeech::Impl {
    struct Job {
        std::string text;
        VoiceChannel::Ticket ticket = 0;
    };

    std::shared_ptr<VoiceChannel> channel;
    int rate_hz = 0;  // set before open() returns

    std::mutex mutex;  // protects the five members below
    std::condition_variable changed;
    std::optional<Job> job;  // only the newest text, because a new text cuts off the last one
    settings::Settings::Speech settings;
    bool new_settings = false;
    bool quit = false;
    std::optional<std::string> news;

    std::thread thread;  // the only thread that calls espeak-ng

    void run(std::promise<Result<void>> ready) {
        Result<void> started = start_library();
        const bool usable = started.has_value();
        ready.set_value(std::move(started));
        if (usable) speak_jobs();
    }

    Result<void> start_library() {
        if (!library_ready) {
            espeak_ng_InitializePath(nullptr);
            espeak_ng_ERROR_CONTEXT context = nullptr;
            espeak_ng_STATUS status = espeak_ng_Initialize(&context);
            espeak_ng_ClearErrorContext(&context);
            if (status == ENS_OK) status = espeak_ng_InitializeOutput(ENOUTPUT_MODE_SYNCHRONOUS, 0, nullptr);
            if (status != ENS_OK) return fail(phrase("voice.cannot_start", {{"reason", status_words(status)}}));
            library_ready = true;
        }
        rate_hz = espeak_ng_GetSampleRate();
        espeak_SetSynthCallback(&on_samples);
        apply(settings);
        return {};
    }

    // The setting `voice` is a language ("en", "pt-br"), the program's language ("auto"), or one of the library's own
    // names. If the library knows neither, the voice is English.
    void apply(const settings::Settings::Speech& wanted) {
        const std::string voice = wanted.voice == "auto" ? spoken_language() : wanted.voice;
        if (!choose(voice)) {
            choose("en");
            const std::lock_guard lock(mutex);
            news = phrase("voice.no_such_voice", {{"voice", voice}});
        }
        espeak_SetParameter(espeakRATE, std::clamp(wanted.rate_wpm, espeakRATE_MINIMUM, espeakRATE_MAXIMUM), 0);
    }

    static bool choose(const std::string& voice) {
        if (espeak_ng_SetVoiceByName(voice.c_str()) == ENS_OK) return true;
        // If the library lacks a language, it chooses another one and reports success.
        espeak_VOICE properties{};
        properties.languages = voice.c_str();
        if (espeak_ng_SetVoiceByProperties(&properties) != ENS_OK) return false;
        const espeak_VOICE* chosen = espeak_GetCurrentVoice();
        const std::string language = voice.substr(0, voice.find('-'));
        return chosen != nullptr && chosen->languages != nullptr &&
               // Skips the byte at [0], which is a priority.
               std::string_view(chosen->languages).substr(1).starts_with(language);
    }

    void speak_jobs() {
        Synthesis synthesis{.channel = channel.get(), .ticket = 0, .piece = {}};
        for (;;) {
            Job next;
            std::optional<settings::Settings::Speech> changed_settings;
            {
                std::unique_lock lock(mutex);
                changed.wait(lock, [&] { return job || quit; });
                if (quit) return;
                next = *std::exchange(job, std::nullopt);
                if (std::exchange(new_settings, false)) changed_settings = settings;
            }
            if (changed_settings) apply(*changed_settings);
            synthesis.ticket = next.ticket;
            synthesis.piece.clear();
            espeak_ng_Synthesize(next.text.c_str(), next.text.size() + 1, 0, POS_CHARACTER, 0, espeakCHARS_UTF8,
                                 nullptr, &synthesis);
            synthesis.send();
            channel->end(next.ticket);
        }
    }
};

EspeakSpeech::EspeakSpeech(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<std::unique_ptr<EspeakSpeech>> EspeakSpeech::open(std::shared_ptr<VoiceChannel> channel,
                                                         const settings::Settings::Speech& settings) {
    if (library_taken.exchange(true)) return fail(phrase("voice.in_use"));
    auto impl = std::make_unique<Impl>();
    impl->channel = std::move(channel);
    impl->settings = settings;
    std::promise<Result<void>> ready;
    std::future<Result<void>> started = ready.get_future();
    impl->thread = std::thread([state = impl.get(), promise = std::move(ready)]() mutable {
        name_this_thread("espeak");
        state->run(std::move(promise));
    });
    if (auto result = started.get(); !result) {
        impl->thread.join();
        library_taken = false;
        return tl::unexpected(result.error());
    }
    return std::unique_ptr<EspeakSpeech>(new EspeakSpeech(std::move(impl)));
}

EspeakSpeech::~EspeakSpeech() {
    stop();
    {
        const std::lock_guard lock(impl_->mutex);
        impl_->quit = true;
    }
    impl_->changed.notify_one();
    impl_->thread.join();
    library_taken = false;
}

void EspeakSpeech::say(const cues::Utterance& utterance) {
    // begin() on this thread cuts off the last utterance, and makes speaking() true from now on.
    const VoiceChannel::Ticket ticket = impl_->channel->begin(impl_->rate_hz, utterance.loudness, utterance.right_rad);
    {
        const std::lock_guard lock(impl_->mutex);
        impl_->job = Impl::Job{utterance.text, ticket};
    }
    impl_->changed.notify_one();
}

void EspeakSpeech::stop() {
    {
        const std::lock_guard lock(impl_->mutex);
        impl_->job.reset();
    }
    impl_->channel->stop();
}

bool EspeakSpeech::speaking() const { return impl_->channel->playing(); }

std::optional<std::string> EspeakSpeech::news() {
    const std::lock_guard lock(impl_->mutex);
    return std::exchange(impl_->news, std::nullopt);
}

void EspeakSpeech::set_speech(const settings::Settings::Speech& settings) {
    const std::lock_guard lock(impl_->mutex);
    impl_->settings = settings;
    impl_->new_settings = true;
}

std::span<const Note> BeepSpeech::pattern(cues::SpeechClass speech_class) {
    static constexpr std::array<Note, 4> kAlarm{
        {{0.0, 0.07, 1200.0, 1.0}, {0.1, 0.07, 1200.0, 1.0}, {0.2, 0.07, 1200.0, 1.0}, {0.3, 0.14, 1200.0, 1.0}}};
    static constexpr std::array<Note, 2> kAnswer{{{0.0, 0.06, 880.0, 0.8}, {0.1, 0.06, 1100.0, 0.8}}};
    static constexpr std::array<Note, 1> kContact{{{0.0, 0.05, 700.0, 0.7}}};
    static constexpr std::array<Note, 1> kAmbient{{{0.0, 0.12, 350.0, 0.5}}};
    switch (speech_class) {
        case cues::SpeechClass::Alarm:
            return kAlarm;
        case cues::SpeechClass::Warning:
        case cues::SpeechClass::Answer:
        case cues::SpeechClass::Guidance:
            return kAnswer;
        case cues::SpeechClass::Contact:
            return kContact;
        case cues::SpeechClass::Ambient:
            break;
    }
    return kAmbient;
}

void BeepSpeech::say(const cues::Utterance& utterance) {
    std::vector<std::int16_t> samples;
    for (const float s : synthesise_notes(pattern(utterance.speech_class)))
        samples.push_back(static_cast<std::int16_t>(std::lround(32767.0F * s)));
    const VoiceChannel::Ticket ticket = channel_->begin(kSampleRate_hz, utterance.loudness);
    channel_->append(ticket, samples);
    channel_->end(ticket);
}

std::unique_ptr<cues::SpeechSink> open_voice(const std::shared_ptr<VoiceChannel>& channel,
                                             const settings::Settings::Speech& settings) {
    auto opened = EspeakSpeech::open(channel, settings);
    if (opened) return std::move(*opened);
    return std::make_unique<BeepSpeech>(channel, phrase("voice.beeps", {{"problem", opened.error().sentence()}}));
}

}  // namespace handrail::sinks
