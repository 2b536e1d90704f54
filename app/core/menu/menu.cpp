#include "app/core/menu/menu.h"

#include <functional>
#include <memory>

#include "app/core/menu/preset_list.h"
#include "app/core/menu/setting_lists.h"
#include "audio-cues/plan/sound_table.h"
#include "worlds/base/language.h"

namespace handrail::core {

bool Menu::act(Command command, double now_s) {
    if (command == Command::Menu) open(now_s);
    else if (command == Command::Help) commands_.open(false, now_s);
    else if (command == Command::InputHelp) commands_.toggle_input_help(now_s);
    else if (command == Command::Language) languages_.open(now_s);
    else if (command == Command::Presets) open_presets(context_, now_s);
    else if (command == Command::Devices) reports_.request_devices(now_s);
    else return false;
    return true;
}

void Menu::open(double now_s) {
    ListSpec list;
    list.title = phrase("menu.title");
    list.stays_open = true;
    std::vector<std::function<void()>> acts;
    const auto add = [&](std::string name, std::function<void()> act) {
        list.items.push_back({std::move(name), {}, false});
        acts.push_back(std::move(act));
    };
    add(phrase("menu.what_i_can_do"), [this] { commands_.open(false, context_.tick_s); });
    list.items.back().also_typed = phrase("menu.what_i_can_do_question");
    add(phrase("menu.worlds"), [this] { worlds_.open(context_.tick_s); });
    add(phrase("menu.read_again"), [this] {
        context_.lists.dialogue.close_all();
        context_.requests.read_again = true;
    });
    add(phrase("language.menu"), [this] { languages_.open(context_.tick_s); });
    add(phrase("menu.settings"), [this] { open_setting_topics(context_, context_.tick_s); });
    add(phrase("preset.title"), [this] { open_presets(context_, context_.tick_s); });
    add(phrase("menu.keys"), [this] { commands_.open(true, context_.tick_s); });
    add(phrase("menu.sounds"), [this] { open_sounds(context_.tick_s); });
    add(phrase("menu.devices"), [this] { reports_.request_devices(context_.tick_s); });
    if (reports_.has_crash()) add(phrase("menu.crash_report"), [this] { reports_.open_crash(context_.tick_s); });
    if (reports_.has_settings_faults())
        add(phrase("menu.settings_faults"), [this] { reports_.open_settings_faults(context_.tick_s); });
    for (const auto& [key, command] :
         {std::pair{"menu.learners", Command::Learners}, std::pair{"menu.input_help", Command::InputHelp},
          std::pair{"menu.set_up", Command::Calibrate}, std::pair{"menu.leave", Command::Leave}}) {
        add(phrase(key), [this, chosen = command] {
            context_.lists.dialogue.close_all();
            context_.session_requests.perform(chosen, context_.tick_s);
        });
        if (command == Command::Learners) list.items.back().also_typed = phrase("menu.learners_question");
    }
    list.chosen = [acts](std::size_t i) { acts[i](); };
    context_.open_list(std::move(list), now_s);
}

void Menu::open_sounds(double now_s) {
    ListSpec list;
    list.title = phrase("menu.sounds_title");
    list.stays_open = true;
    const auto entries = std::make_shared<const std::vector<cues::DictionaryEntry>>(cues::sound_dictionary());
    for (const cues::DictionaryEntry& entry : *entries) list.items.push_back({entry.text, {}, false});
    list.chosen = [this, entries](std::size_t i) {
        cues::CueRequest request;
        request.kind = cues::CueRequestKind::Demonstrate;
        request.time_s = context_.tick_s;
        request.text = (*entries)[i].text;
        request.sound = (*entries)[i].kind;
        request.material = (*entries)[i].material;
        request.position_m = context_.avatar.ears_m() + forward_of_heading(context_.avatar.heading_rad);
        context_.cues.cue(std::move(request));
    };
    context_.open_list(std::move(list), now_s);
}

}  // namespace handrail::core
