#include "app/main/ears.h"

#include <unistd.h>

#include <utility>

#include "audio-cues/sinks/sound_outputs.h"
#include "worlds/base/language.h"

namespace handrail {

Ears::Ears(const Settings& settings, bool with_window, Clock& clock, AudioThread::ContactRing& left_contacts,
           SessionRecording& recording, std::vector<std::string>& news)
    : clock_(clock), recording_(recording) {
    std::shared_ptr<ReaderChannel> reader;
    if (with_window) {
        reader = std::make_shared<ReaderChannel>();
        accessible_ = Accessible::start(reader);
        braille_ = std::make_shared<BrailleLink>();
    }
    SoundOutputs outputs = recording.noted(open_sound_outputs(settings, STDOUT_FILENO, std::move(reader), braille_));
    has_sound_ = !outputs.description.empty();
    news.push_back(std::move(outputs.description));
    sound_ = std::make_unique<AudioThread>(std::move(outputs.audio), std::move(outputs.speech), clock, &contacts_,
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

void Ears::show(const Session& app) {
    if (!accessible_ && !braille_) return;
    if (braille_ && app.scene()) braille_->heading_rad = app.listener().heading_rad;
    DialogueView view = app.dialogue().view();
    if (view == shown_dialogue_) return;
    if (accessible_) accessible_->show(view);
    if (braille_) {
        BrailleLink::List list;
        if (view.kind == DialogueView::Kind::List) list = {view.where, {}, view.at};
        for (const ListItem& item : view.items)
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
    for (SpokenLine& line : sound_->take_spoken()) last_spoken_ = std::move(line.text);
}

}  // namespace handrail
