#include "app/wizard/wizard_session.h"

#include <fmt/format.h>

#include <array>

#include "app/core/dialogue/command_words.h"
#include "worlds/base/human_measures.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::wizard {
namespace {

constexpr double kHandSettles_s = 0.4;  // time that a simulated hand needs to reach its target
constexpr double kButton_s = 0.1;
constexpr double kLongestWait_s = 60.0;
constexpr double kMostTaps = 100.0;

struct WordKey {
    std::string_view word;  // word for the key in a typed line
    std::string_view keys;  // names of window keys, separated by blanks
    WizardKey key;
};
constexpr std::array kWordKeys{
    WordKey{"enter", " Enter KeypadEnter ", WizardKey::Enter},
    WordKey{"repeat", " Space Q ", WizardKey::Repeat},
    WordKey{"back", " Backspace ", WizardKey::Back},
    WordKey{"leave", " Escape ", WizardKey::Leave},
    WordKey{"left", " Left ", WizardKey::Left},
    WordKey{"right", " Right ", WizardKey::Right},
    WordKey{"up", " Up ", WizardKey::Up},
    WordKey{"down", " Down ", WizardKey::Down},
    WordKey{"stop", " F12 ", WizardKey::Stop},
    WordKey{"forces", " F Grave ", WizardKey::Forces},
};

struct HandWord {
    std::string_view word, key;
    Vec3 direction;
};
constexpr std::array<std::string_view, 12> kTypedWords{"enter", "repeat", "back", "leave", "left",   "right",
                                                       "up",    "down",   "stop", "help",  "button", "wait"};
constexpr std::array kHandWords{
    HandWord{"hand-forward", "I", {0.0, 1.0, 0.0}}, HandWord{"hand-back", "K", {0.0, -1.0, 0.0}},
    HandWord{"hand-left", "J", {-1.0, 0.0, 0.0}},   HandWord{"hand-right", "L", {1.0, 0.0, 0.0}},
    HandWord{"hand-up", "U", {0.0, 0.0, 1.0}},      HandWord{"hand-down", "O", {0.0, 0.0, -1.0}},
};

}  // namespace

Result<WizardLine> parse_wizard_line(std::string_view line) {
    constexpr std::string_view kBlank = " \t\r\n";
    const std::size_t first = std::min(line.find_first_not_of(kBlank), line.size());
    line = line.substr(first, line.find_last_not_of(kBlank) + 1 - first);
    WizardLine parsed;
    double number = 0.0;
    if (line.empty()) {
        parsed.events = {WizardKey::Enter};
        return parsed;
    }
    if (parse_finite(line, number)) {
        parsed.events = {std::string(line), WizardKey::Enter};
        return parsed;
    }
    const std::size_t blank = std::min(line.find_first_of(kBlank), line.size());
    const std::string typed = lower_ascii(line.substr(0, blank));
    std::string word = core::english_word("wizard_word", kTypedWords, typed);
    if (const auto command = core::command_of_word(typed);
        command && (core::info(*command).word.starts_with("hand-") || *command == core::Command::ToggleForces))
        word = core::info(*command).word;
    std::string_view rest = line.substr(blank);
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlank), rest.size()));
    number = 1.0;
    if (!rest.empty() && !(parse_finite(rest, number) && number > 0.0 && number <= kMostTaps))
        return fail(phrase("wizard.only_number", {{"word", typed}, {"most", kMostTaps}}));
    std::vector<std::string> known;
    for (const std::string_view one : kTypedWords) known.push_back(core::spoken_word("wizard_word", one));
    for (const WordKey& row : kWordKeys)
        if (row.word == word) parsed.events = {row.key};
    for (const HandWord& row : kHandWords) {
        known.push_back(core::spoken_word("command_word", row.word));
        if (row.word == word) parsed.hand_by_m = row.direction * (kHandTap_m * number);
    }
    if (core::is_quit_word(typed) || word == "exit") parsed.events = {WizardKey::Leave, WizardKey::Leave};
    parsed.button = word == "button";
    parsed.help = word == "help";
    if (word == "wait") parsed.wait_s = std::min(number, kLongestWait_s);
    if (parsed.events.empty() && parsed.hand_by_m == Vec3(0.0) && !parsed.button && !parsed.help &&
        parsed.wait_s == 0.0)
        return fail(phrase("wizard.no_answer", {{"word", typed}, {"nearest", nearest_name(typed, known)}}));
    return parsed;
}

std::string wizard_help() { return phrase("wizard.help"); }

void WizardSession::move_hand(const Vec3& by_m) {
    hand_.target_m += by_m;
    const double length_m = glm::length(hand_.target_m);
    if (length_m > reach_m_) hand_.target_m *= reach_m_ / length_m;
}

void WizardSession::press(std::string_view key_name, double now_s) {
    if (key_name == "F1") return type("help");
    // The figure keys of the keypad type the same figures as the other keys.
    if (key_name.starts_with("Keypad") && key_name.size() == 7) key_name.remove_prefix(6);
    if (key_name.size() == 1 && key_name[0] >= '0' && key_name[0] <= '9')
        return wizard_.answer(std::string(key_name), now_s);
    if (key_name == "Period" || key_name == "Comma" || key_name == "KeypadDecimal")
        return wizard_.answer(std::string("."), now_s);
    const std::string wanted = fmt::format(" {} ", key_name);
    for (const WordKey& row : kWordKeys)
        if (row.keys.find(wanted) != std::string_view::npos) return wizard_.answer(row.key, now_s);
    for (const HandWord& row : kHandWords)
        if (row.key == key_name) return move_hand(row.direction * kHandTap_m);
}

void WizardSession::take_line(double now_s) {
    const std::string line = std::move(lines_.front());
    lines_.pop_front();
    auto parsed = parse_wizard_line(line);
    if (!parsed || parsed->help) {
        cues::CueRequest request;
        request.kind = cues::CueRequestKind::Say;
        request.time_s = now_s;
        request.text = parsed ? wizard_help() : parsed.error().message;
        request.repeatable = true;
        announced_.push_back(std::move(request));
        return;
    }
    for (const WizardEvent& event : parsed->events) wizard_.answer(event, now_s);
    settle_until_s_ = now_s + parsed->wait_s;
    if (parsed->hand_by_m != Vec3(0.0)) {
        move_hand(parsed->hand_by_m);
        settle_until_s_ = now_s + kHandSettles_s;
    }
    if (parsed->button) {
        button_until_s_ = now_s + kButton_s;
        settle_until_s_ = now_s + 2.0 * kButton_s;
    }
}

void WizardSession::tick(const WizardSense& sense) {
    reach_m_ = sense.hand.spec.workspace_radius_m;
    wizard_.tick(sense);
    if (!wizard_.finished() && wizard_.waits_for_person() && sense.now_s >= settle_until_s_) {
        if (!lines_.empty()) take_line(sense.now_s);
        else if (lines_end_)
            for (int i = 0; i < 2; ++i) wizard_.answer(WizardKey::Leave, sense.now_s);
    }
    hand_.buttons = sense.now_s < button_until_s_ ? 1U : 0U;
}

std::vector<cues::CueRequest> WizardSession::take_cues() {
    std::vector<cues::CueRequest> cues = wizard_.take_cues();
    cues.insert(cues.end(), std::make_move_iterator(announced_.begin()), std::make_move_iterator(announced_.end()));
    announced_.clear();
    return cues;
}

}  // namespace handrail::wizard
