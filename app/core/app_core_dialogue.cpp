// AppCore's part on lists and typed answers: which keys go to them, what is said, and the list of everything that can be done. App thread only.
#include <algorithm>

#include "app/core/app_core.h"

namespace handrail {
namespace {

// What must work whatever is open. A letter may be wanted as a letter.
bool works_always(const KeyMap& keys, std::string_view key) {
    const auto command = keys.find(key);
    if (!command) return false;
    return *command == Command::StopEverything || *command == Command::StopSpeech || (*command == Command::ToggleForces && key.size() > 1);
}

}  // namespace

void AppCore::open_list(ListSpec list, double now_s) {
    std::fill(held_.begin(), held_.end(), false);
    pending_way_m_ = 0.0;
    answer(dialogue_.open(std::move(list)), now_s);
}

void AppCore::ask_text(TextSpec question, double now_s) {
    std::fill(held_.begin(), held_.end(), false);
    pending_way_m_ = 0.0;
    answer(dialogue_.ask(std::move(question)), now_s);
}

bool AppCore::reply(const DialogueReply& reply, double now_s) {
    if (!reply.taken) return false;
    if (reply.denied) play(SoundKind::Denied, now_s);
    if (!reply.words.empty()) answer(reply.words, now_s);
    return true;
}

void AppCore::quiet(double now_s) {
    CueRequest quiet;
    quiet.kind = CueRequestKind::StopSpeech;
    quiet.time_s = now_s;
    cue(std::move(quiet));
}

bool AppCore::take_key(std::string_view key, double now_s) {
    if (works_always(keys_, key)) return false;
    if (take_key_apart(std::string(key), now_s)) return true;
    if (!dialogue_.is_open()) return false;
    quiet(now_s);
    return reply(dialogue_.key(key, now_s), now_s);
}

bool AppCore::take_text(std::string_view utf8, double now_s) {
    if (!dialogue_.is_open()) return false;
    quiet(now_s);
    return reply(dialogue_.typed(utf8, now_s), now_s);
}

bool AppCore::take_act(const ItemAct& act, double now_s) {
    if (!dialogue_.is_open()) return false;
    quiet(now_s);
    return reply(dialogue_.act(act, now_s), now_s);
}

bool AppCore::take_line(std::string_view line, double now_s) {
    if (take_line_apart(line, now_s)) return true;
    if (!dialogue_.is_open()) return false;
    if (const CommandInfo* row = find_command(line); row && (row->command == Command::StopEverything || row->command == Command::ToggleForces)) return false;
    quiet(now_s);
    return reply(dialogue_.line(line, now_s), now_s);
}

}  // namespace handrail
