#include "audio-cues/sinks/sound_outputs.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "audio-cues/sinks/espeak_speech.h"
#include "audio-cues/sinks/openal_sink.h"
#include "audio-cues/sinks/text_speech.h"

namespace handrail {
namespace {

// Where not even OpenAL's loopback device can be had: says so once and is silent.
class SilentAudio final : public AudioSink {
public:
    explicit SilentAudio(std::string news) : news_(std::move(news)) {}
    void play(const SoundCue&) override {}
    void set_loop(const SoundCue&) override {}
    void set_listener(const Listener&) override {}
    void stop_all() override {}
    void tick(double) override {}
    std::optional<std::string> news() override { return std::exchange(news_, std::nullopt); }

private:
    std::optional<std::string> news_;
};

}  // namespace

SoundOutputs open_sound_outputs(const Settings& settings, int text_fd) {
    SoundOutputs outputs;
    std::vector<std::unique_ptr<SpeechSink>> voices;
    voices.push_back(std::make_unique<TextSpeech>(text_fd));
    const auto channel = std::make_shared<VoiceChannel>();
    if (auto opened = OpenALSink::open(channel, {}); !opened) {
        outputs.audio = std::make_unique<SilentAudio>(fmt::format("There is no sound: {}", opened.error().sentence()));
    } else {
        outputs.audible = (*opened)->has_device();
        if (outputs.audible) {
            outputs.description = (*opened)->description();
            voices.push_back(open_voice(channel, settings.speech));
        }
        outputs.audio = std::move(*opened);
    }
    outputs.speech = std::make_unique<TeeSpeech>(std::move(voices));
    return outputs;
}

}  // namespace handrail
