// Session's part on what the person adds to a world: its file when one enters, and when it or another session changes
// it. App thread only.
#include <utility>

#include "app/core/session/session.h"
#include "worlds/base/language.h"

namespace handrail {

// What was added to the world that is entered.
void Session::take_additions() {
    if (side_file_next_) additions_ = std::move(*std::exchange(side_file_next_, std::nullopt));
    else additions_ = SideFile();
    guide_.enter_world();
    mark_list_.enter_world();
}

void Session::tell_additions(double now_s) {
    for (const std::string& news : additions_.news()) say(news, SpeechClass::Answer, now_s);
    mark_list_.tell_faults(now_s);
    kept_ways_.enter_world(now_s);
}

void Session::save_additions(double now_s) {
    if (const auto saved = additions_.save(); !saved)
        say(phrase("guide.not_kept", {{"why", saved.error().sentence()}}), SpeechClass::Alarm, now_s);
    const SideFile::TakenOver taken = additions_.take_over();
    if (taken.differs) take_others_additions();
    for (const std::string& news : taken.news) say(news, SpeechClass::Answer, now_s);
}

// Another session has added to this world or changed what was added: everything is as the file has it now.
void Session::take_others_additions() {
    lists_.dialogue.close_all();  // a list goes by places that may have shifted
    mark_list_.take_again();
    kept_ways_.take_again();
    rooms_.take_names_again();
}

}  // namespace handrail
