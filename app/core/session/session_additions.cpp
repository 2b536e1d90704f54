// The part of Session that reads the file of additions when a world is entered, and saves it when the person or another
// session changes the additions. Use it on the app thread only.
#include <utility>

#include "app/core/session/session.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kRetryAdditions_s = 30.0;

}  // namespace

// Reads the additions to the world that is being entered.
void Session::take_additions() {
    state_.additions_due_s.reset();
    if (given_.side_file) state_.additions = std::move(*std::exchange(given_.side_file, std::nullopt));
    else state_.additions = SideFile();
    guide_.enter_world();
    places_.marks.enter_world();
    places_.groups.enter_world();
    places_.labels.enter_world();
    places_.faults.enter_world();
}

void Session::announce_additions(double now_s) {
    for (const std::string& news : state_.additions.news()) say(news, cues::SpeechClass::Answer, now_s);
    places_.marks.announce_faults(now_s);
    places_.groups.announce_unreadable(now_s);
    places_.labels.announce_unreadable(now_s);
    places_.ways.enter_world(now_s);
    learn_.place.announce_kept(now_s);
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

// Tries again to save after a failure, such as a full disk or missing rights. The failure has been announced, and the
// additions are in memory meanwhile.
void Session::tick_additions(double now_s) {
    if (!state_.additions_due_s || now_s < *state_.additions_due_s) return;
    // A repeated failure is not announced, because the announcement would come every half minute.
    if (!state_.additions.save()) state_.additions_due_s = now_s + kRetryAdditions_s;
    else save_additions(now_s);
}

// Reads all additions to this world again. Call it when another session has changed them.
void Session::take_others_additions() {
    state_.lists.dialogue.close_all();  // Open lists refer to items by index, and the indices may have changed.
    places_.marks.take_again();
    places_.groups.take_again();
    places_.labels.take_again();
    places_.ways.take_again();
    where_.rooms.take_names_again();
    learn_.place.take_again();
}

}  // namespace handrail::core
