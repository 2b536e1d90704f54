// AppCore's part on languages: the list of those that can be spoken, each by its own name. App thread only.
#include "app/core/app_core.h"
#include "app/core/spoken_language.h"

namespace handrail {

void AppCore::open_languages(double now_s) {
    const std::vector<LanguageName> languages = languages_to_choose(languages_folder_);
    ListSpec list;
    list.title = phrase("language.menu");
    for (const LanguageName& language : languages) {
        if (language.code == spoken_language()) list.at = list.items.size();
        list.items.push_back({language.name, {}, false});
    }
    list.chosen = [this, languages](std::size_t i) {
        change_setting("speech.language", languages[i].code);
        if (spoken_language() == languages[i].code) answer(phrase("language.changed", {{"name", languages[i].name}}), last_tick_s_);
    };
    open_list(std::move(list), now_s);
}

}  // namespace handrail
