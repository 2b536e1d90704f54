// The session's part for additions to a world: reading their file on entering, and saving it when the person or another
// session changes it. App thread only.
#include <utility>

#include "app/core/session/session.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kRetryAdditions_s = 30.0;

}  // namespace

// Takes over the additions to the world that is being entered.
void Session::take_additions() {
    state_.additions_due_s.reset();
    if (given_.side_file) state_.additions = std::move(*std::exchange(given_.side_file, std::nullopt));
    else state_.additions = SideFile();
    guide_.enter_world();
    places_.marks.enter_world();
    places_.faults.enter_world();
}

void Session::tell_additions(double now_s) {
    for (const std::string& news : state_.additions.news()) say(news, cues::SpeechClass::Answer, now_s);
    places_.marks.tell_faults(now_s);
    places_.faults.tell_unreadable(now_s);
    places_.ways.enter_world(now_s);
    learn_.place.tell_kept(now_s);
}

bool Session::save_additions(double now_s) {
    const auto saved = state_.additions.save();
    if (!saved) {
        say(phrase("guide.not_kept", {{"why", saved.error().sentence()}}), cues::SpeechClass::Alarm, now_s);
        state_.additions_due_s = now_s + kRetryAdditions_s;
    } else if (std::exchange(state_.additions_due_s, std::nullopt)) {
        say(phrase("guide.saved_after_all"), cues::SpeechClass::Answer, now_s);
    }
    const SideFile::TakenOver taken = state_.additions.take_over();
    if (taken.differs) take_others_additions();
    for (const std::string& news : taken.news) say(news, cues::SpeechClass::Answer, now_s);
    return saved.has_value();
}

// Tries again to save what could not be saved because of a full disk or missing rights. It stays in memory meanwhile;
// the failure has been announced.
void Session::tick_additions(double now_s) {
    if (!state_.additions_due_s || now_s < *state_.additions_due_s) return;
    // The alarm is not repeated, because it would come every half minute.
    if (!state_.additions.save()) state_.additions_due_s = now_s + kRetryAdditions_s;
    else save_additions(now_s);
}

// Another session has changed the additions to this world: everything is read again.
void Session::take_others_additions() {
    state_.lists.dialogue.close_all();  // lists refer to indices that may have shifted
    places_.marks.take_again();
    places_.faults.take_again();
    places_.ways.take_again();
    where_.rooms.take_names_again();
    learn_.place.take_again();
}

}  // namespace handrail::core
