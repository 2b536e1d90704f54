#include "app/record/input_text.h"
#include "app/record/json_fields.h"
#include "worlds/base/language.h"

namespace handrail::record {
namespace {

void put(Json& json, const char* key, const std::optional<double>& value) {
    if (value) json[key] = *value;
}
std::optional<double> taken(const Json& json, const char* key) {
    const auto at = json.find(key);
    return at == json.end() ? std::nullopt : std::optional(at->get<double>());
}

Json json_of(const settings::Settings::Workspace::Override& of) {
    Json json = Json::object();
    put(json, "scale", of.scale);
    put(json, "offset_ahead_m", of.offset_ahead_m);
    put(json, "offset_up_m", of.offset_up_m);
    put(json, "hand_height_m", of.hand_height_m);
    return json;
}

// A number that a profile can contain, with its name in the file.
struct ProfileNumber {
    const char* key;
    std::optional<double> settings::DeviceProfile::*value;
};
constexpr std::array kProfileNumbers{ProfileNumber{"ceiling_n", &settings::DeviceProfile::ceiling_n},
                                     ProfileNumber{"gentlest_n", &settings::DeviceProfile::gentlest_n},
                                     ProfileNumber{"scale", &settings::DeviceProfile::scale},
                                     ProfileNumber{"offset_ahead_m", &settings::DeviceProfile::offset_ahead_m},
                                     ProfileNumber{"offset_up_m", &settings::DeviceProfile::offset_up_m},
                                     ProfileNumber{"width_m", &settings::DeviceProfile::width_m},
                                     ProfileNumber{"depth_m", &settings::DeviceProfile::depth_m},
                                     ProfileNumber{"height_m", &settings::DeviceProfile::height_m}};

Json json_of(const settings::DeviceProfile& profile) {
    Json json = Json::object();
    for (const auto& [key, value] : kProfileNumbers) put(json, key, profile.*value);
    if (profile.hand) json["hand"] = *profile.hand == settings::HoldingHand::Left ? "left" : "right";
    return json;
}

settings::DeviceProfile profile_of(const Json& json) {
    settings::DeviceProfile profile;
    for (const auto& [key, value] : kProfileNumbers) profile.*value = taken(json, key);
    if (json.contains("hand"))
        profile.hand = json["hand"] == "left" ? settings::HoldingHand::Left : settings::HoldingHand::Right;
    return profile;
}

// Returns the keys of the settings table. Other functions convert [workspace.device], [profile] and [keys].
const std::vector<std::string>& table_keys() {
    static const std::vector<std::string> keys = [] {
        std::vector<std::string> all;
        for (settings::SettingRow& row : settings::SettingsStore().explain()) all.push_back(std::move(row.key));
        return all;
    }();
    return keys;
}

}  // namespace

std::string settings_text(const settings::Settings& settings) {
    static const settings::Settings kDefaults;
    Json json = Json::object();
    for (const std::string& key : table_keys()) {
        const auto value = settings::setting_text(settings, key);
        if (value && *value != settings::setting_text(kDefaults, key).value_or("")) json["set"][key] = *value;
    }
    for (const auto& [device, of] : settings.workspace.devices) json["workspace_of"][device] = json_of(of);
    for (const auto& [device, profile] : settings.profiles) json["profile_of"][device] = json_of(profile);
    for (const std::string& device : settings.damaged_profiles) json["damaged_profiles"].push_back(device);
    for (const auto& [command, key] : settings.keys) json["keys"][command] = key;
    return line_of(json);
}

Result<settings::Settings> read_settings_text(const std::string& text) {
    settings::Settings settings;
    const Json json = Json::parse(text, nullptr, false);
    const auto part = [&json](const char* name) {
        const auto at = json.find(name);
        return at == json.end() ? Json::object() : *at;
    };
    if (!json.is_object()) return fail(phrase("recording.no_line"));
    const Json set = part("set"), workspaces = part("workspace_of"), profiles = part("profile_of"),
               damaged = part("damaged_profiles"), keys = part("keys");
    try {
        for (const auto& [key, value] : set.items()) {
            std::string plain = value.get<std::string>();
            if (plain.size() >= 2 && plain.front() == '"') plain = plain.substr(1, plain.size() - 2);
            if (auto done = settings::change_setting(settings, key, plain); !done) return tl::unexpected(done.error());
        }
        for (const auto& [device, of] : workspaces.items())
            settings.workspace.devices[device] = {taken(of, "scale"), taken(of, "offset_ahead_m"),
                                                  taken(of, "offset_up_m"), taken(of, "hand_height_m")};
        for (const auto& [device, of] : profiles.items()) settings.profiles[device] = profile_of(of);
        for (const Json& device : damaged) settings.damaged_profiles.insert(device.get<std::string>());
        for (const auto& [command, key] : keys.items()) settings.keys[command] = key.get<std::string>();
    } catch (const Json::exception&) {
        return fail(phrase("recording.no_line"));
    }
    return settings;
}

}  // namespace handrail::record
