#include "worlds/readers/map_words.h"

#include <algorithm>
#include <array>
#include <string>

#include "worlds/base/text.h"

namespace handrail::readers {
namespace {

constexpr std::array kClasses{
    ClassRow{"func_door*", SolidRole::Mover, FeatureKind::Door, "door"},
    ClassRow{"func_plat*", SolidRole::Mover, FeatureKind::Lift, "lift"},
    ClassRow{"func_button", SolidRole::Mover, FeatureKind::Button, "button"},
    ClassRow{"func_train", SolidRole::Mover, FeatureKind::Mover, "moving platform"},
    ClassRow{"func_rotating", SolidRole::Mover, FeatureKind::Mover, "turning part"},
    ClassRow{"func_illusionary", SolidRole::Illusion, FeatureKind::Object, "illusion"},
    ClassRow{"trigger_teleport", SolidRole::Trigger, FeatureKind::Teleport, "teleporter"},
    ClassRow{"trigger_changelevel", SolidRole::Trigger, FeatureKind::Trigger, "exit"},
    ClassRow{"trigger_hurt", SolidRole::Trigger, FeatureKind::Trigger, "danger"},
    ClassRow{"trigger_secret", SolidRole::Trigger, FeatureKind::Trigger, "secret place"},
    ClassRow{"trigger_*", SolidRole::Trigger, FeatureKind::Trigger, "marked place"},
    ClassRow{"func_episodegate", SolidRole::Solid, FeatureKind::Object, "gate"},
    ClassRow{"func_bossgate", SolidRole::Solid, FeatureKind::Object, "gate"},
};

struct SoundRow {
    std::string_view class_name, name;  // `name` is the key of a text
};
constexpr std::array kSounds{
    SoundRow{"ambient_comp_hum", "map.sound_computer_hum"},
    SoundRow{"ambient_drip", "map.sound_dripping_water"},
    SoundRow{"ambient_drone", "map.sound_machine_drone"},
    SoundRow{"ambient_flouro_buzz", "map.sound_lamp_buzzing"},
    SoundRow{"ambient_light_buzz", "map.sound_lamp_buzzing"},
    SoundRow{"ambient_suck_wind", "map.sound_wind"},
    SoundRow{"ambient_swamp*", "map.sound_swamp"},
    SoundRow{"ambient_thunder", "map.sound_thunder"},
    SoundRow{"light_torch*", "map.sound_torch"},
    SoundRow{"light_flame*", "map.sound_flame"},
    SoundRow{"particle_explo*", "map.sound_explosion"},
    SoundRow{"particle_fire*", "map.sound_fire"},
    SoundRow{"particle_fountain*", "map.sound_fountain"},
    SoundRow{"particle_rain*", "map.sound_rain"},
    SoundRow{"particle_snow*", "map.sound_snow"},
};

bool fits(std::string_view pattern, std::string_view name) {
    return pattern.ends_with('*') ? name.starts_with(pattern.substr(0, pattern.size() - 1)) : name == pattern;
}

}  // namespace

const ClassRow* class_row(std::string_view class_name) {
    for (const ClassRow& row : kClasses)
        if (fits(row.class_name, class_name)) return &row;
    return nullptr;
}

void give_name(Feature& feature, std::string_view name) {
    feature.name = name;
    feature.made_name = true;
}

bool is_structure(std::string_view class_name) {
    return class_name.empty() || class_name == "worldspawn" || class_name == "func_group" ||
           class_name.starts_with("func_detail");
}

bool is_particles(std::string_view class_name) {
    constexpr std::array<std::string_view, 9> kStarts{"particle",  "light_torch", "light_flame",
                                                      "env_fire",  "env_spark",   "env_steam",
                                                      "env_smoke", "misc_fire",   "misc_sparks"};
    return std::any_of(kStarts.begin(), kStarts.end(),
                       [&](std::string_view start) { return class_name.starts_with(start); });
}

std::string_view sound_of_class(std::string_view class_name) {
    for (const SoundRow& row : kSounds)
        if (fits(row.class_name, class_name)) return row.name;
    return {};
}

TextureFacts facts_of_texture(std::string_view texture) {
    std::string name = lower_ascii(texture.substr(0, 256));
    if (const std::size_t slash = name.find_last_of("/\\"); slash != std::string::npos) name.erase(0, slash + 1);
    TextureFacts facts;
    if (name.starts_with('*') || name.starts_with('!')) {
        const std::string_view liquid = std::string_view(name).substr(1);
        facts.sense = liquid.starts_with("lava")    ? TextureSense::Lava
                      : liquid.starts_with("slime") ? TextureSense::Slime
                      : liquid.starts_with("tele")  ? TextureSense::Teleport
                                                    : TextureSense::Water;
    } else if (name == "clip") {
        facts.sense = TextureSense::Clip;
    } else if (name == "trigger" || name == "aaatrigger") {
        facts.sense = TextureSense::Trigger;
    } else if (name == "hint" || name == "skip" || name == "hintskip" || name == "origin") {
        facts.sense = TextureSense::LeftOut;
    } else if (name.starts_with("sky")) {
        facts.sky = true;
    } else {
        facts.guess = guess_material(name);
    }
    return facts;
}

}  // namespace handrail::readers
