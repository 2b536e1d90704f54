#include "app/core/menu/preset_list.h"

#include "settings/presets.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

std::string name_of(const settings::Preset& preset) { return phrase(preset.name_key); }

// Returns the values of a preset: "steps of 0.5 metres, 0.6 metres a second, verbosity 3".
std::string value_words(const settings::Preset& preset) {
    return phrase("preset.values",
                  {{"step", preset.step_length_m}, {"speed", preset.speed_m_per_s}, {"verbosity", preset.verbosity}});
}

}  // namespace

void open_presets(const SessionContext& context, double now_s) {
    ListSpec list;
    list.title = phrase("preset.title");
    for (const settings::Preset& preset : settings::presets()) {
        if (preset.is_set(context.settings)) list.at = list.items.size();
        list.items.push_back({sentence_case(name_of(preset)), value_words(preset), false});
    }
    list.chosen = [&context](std::size_t i) {
        const settings::Preset& preset = settings::presets()[i];
        for (const auto& [key, value] : preset.values()) context.set(key, value, context.tick_s);
        context.answer(
            phrase("preset.chosen", {{"name", sentence_case(name_of(preset))}, {"values", value_words(preset)}}),
            context.tick_s);
    };
    context.open_list(std::move(list), now_s);
}

}  // namespace handrail::core
