#include "audio-cues/sinks/sound_outputs.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "audio-cues/sinks/embedded_voice.h"
#include "audio-cues/sinks/openal_sink.h"
#include "audio-cues/sinks/speechd_speech.h"
#include "audio-cues/sinks/text_speech.h"
#include "audio-cues/sinks/voice_router.h"
#include "worlds/base/language.h"

namespace handrail::sinks {
namespace {

// Used if even OpenAL's loopback device is unavailable. SilentAudio reports that once and makes no sound.
class SilentAudio final : public cues::AudioSink {
public:
    explicit SilentAudio(std::string news) : news_(std::move(news)) {}
    void play(const cues::SoundCue&) override {}
    void set_loop(const cues::SoundCue&) override {}
    void set_listener(const cues::Listener&) override {}
    void stop_all() override {}
    void tick(double) override {}
    std::optional<std::string> news() override { return std::exchange(news_, std::nullopt); }

private:
    std::optional<std::string> news_;
};

}  // namespace

SoundOutputs open_sound_outputs(const settings::Settings& settings, int text_fd, std::shared_ptr<ReaderChannel> reader,
                                std::shared_ptr<BrailleLink> braille) {
    SoundOutputs outputs;
    std::vector<std::unique_ptr<Voice>> voices;
    if (reader) voices.push_back(std::make_unique<ReaderVoice>(std::move(reader)));
    voices.push_back(std::make_unique<SpeechdSpeech>(settings.speech));
    const auto channel = std::make_shared<VoiceChannel>();
    if (auto opened = OpenALSink::open(channel, {.periods = settings.sound.periods,
                                                 .hrtf = settings.sound.headphones,
                                                 .hrtf_set = settings.sound.hrtf,
                                                 .pack = settings.sound.pack});
        !opened) {
        outputs.audio =
            std::make_unique<SilentAudio>(phrase("sound_output.no_sound", {{"problem", opened.error().sentence()}}));
    } else {
        // `sound` stays valid here, because the owner of both sinks destroys the speech sink first.
        voices.push_back(std::make_unique<EmbeddedVoice>(
            channel, [sound = opened->get()] { return sound->has_device(); }, settings.speech));
        if ((*opened)->has_device()) outputs.description = (*opened)->description();
        outputs.audio = std::move(*opened);
        outputs.audio->set_sound(settings.sound);
    }
    outputs.speech = std::make_unique<VoiceRouter>(
        std::move(voices), std::make_unique<TextSpeech>(text_fd),
        braille ? std::make_unique<BrailleDisplay>(std::move(braille), settings.speech) : nullptr, settings.speech);
    return outputs;
}

}  // namespace handrail::sinks
