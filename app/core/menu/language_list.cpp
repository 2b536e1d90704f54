#include "app/core/menu/language_list.h"

#include "app/core/kept/spoken_language.h"
#include "worlds/base/language.h"

namespace handrail::core {

void LanguageList::open(double now_s) {
    const std::vector<LanguageName> languages = languages_to_choose(folder_);
    ListSpec list;
    list.title = phrase("language.menu");
    for (const LanguageName& language : languages) {
        if (language.code == spoken_language()) list.at = list.items.size();
        list.items.push_back({language.name, {}, false});
    }
    list.chosen = [this, languages](std::size_t i) {
        context_.set("speech.language", languages[i].code, context_.tick_s);
        if (spoken_language() == languages[i].code)
            context_.answer(phrase("language.changed", {{"name", languages[i].name}}), context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

}  // namespace handrail::core
