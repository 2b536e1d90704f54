#include "app/main/ears.h"

#include <unistd.h>

#include <utility>

#include "audio-cues/sinks/sound_outputs.h"
#include "worlds/base/language.h"

namespace handrail::program {

Ears::Ears(const settings::Settings& settings, bool with_window, Clock& clock,
           cues::AudioThread::ContactRing& left_contacts, SessionRecording& recording, std::vector<std::string>& news)
    : clock_(clock), recording_(recording) {
    std::shared_ptr<sinks::ReaderChannel> reader;
    if (with_window) {
        reader = std::make_shared<sinks::ReaderChannel>();
        accessible_ = accessible::Accessible::start(reader);
        braille_ = std::make_shared<sinks::BrailleLink>();
    }
    sinks::SoundOutputs outputs =
        recording.noted(sinks::open_sound_outputs(settings, STDOUT_FILENO, std::move(reader), braille_));
    has_sound_ = !outputs.description.empty();
    news.push_back(std::move(outputs.description));
    sound_ = std::make_unique<cues::AudioThread>(std::move(outputs.audio), std::move(outputs.speech), clock, &contacts_,
                                                 settings, &left_contacts);
    recording.listen_to(*sound_);
}

std::string Ears::voice_that_speaks() {
    constexpr double kPatience_s = 1.5;
    const double until_s = clock_.now_s() + kPatience_s;
    std::string voice = sound_->who_speaks();
    while (voice.empty() && clock_.now_s() < until_s) {
        clock_.sleep_until_s(clock_.now_s() + 0.01);
        voice = sound_->who_speaks();
    }
    return voice.empty() ? phrase("voice.text_alone") : voice;
}

void Ears::show(const core::Session& app) {
    if (!accessible_ && !braille_) return;
    if (braille_ && app.scene()) braille_->heading_rad = app.listener().heading_rad;
    core::DialogueView view = app.dialogue().view();
    if (view == shown_dialogue_) return;
    if (accessible_) accessible_->show(view);
    if (braille_) {
        sinks::BrailleLink::List list;
        if (view.kind == core::DialogueView::Kind::List) list = {view.where, {}, view.at};
        for (const core::ListItem& item : view.items)
            list.items.push_back(item.value.empty() ? item.name : item.name + ", " + item.value);
        braille_->set_list(std::move(list));
    }
    shown_dialogue_ = std::move(view);
}

void Ears::follow_hands(bool two, bool stands_in) {
    if (std::exchange(two_hands_, two) != two) {
        recording_.note("ears_two_hands", two ? 1 : 0);
        sound_->set_two_hands(two);
    }
    if (std::exchange(hand_stands_in_, stands_in) != stands_in) {
        recording_.note("ears_stand_in", stands_in ? 1 : 0);
        sound_->set_hand_stands_in(stands_in);
    }
}

void Ears::note_spoken() {
    for (cues::SpokenLine& line : sound_->take_spoken()) {
        if (messages_.size() == core::kShownMessages) messages_.erase(messages_.begin());
        messages_.push_back(std::move(line.text));
    }
}

}  // namespace handrail::program
