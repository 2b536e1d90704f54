#include "settings/settings.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <cstdlib>
#include <map>
#include <sstream>
#include <unordered_map>

#include "settings/parse_toml.h"
#include "settings/table.h"
#include "worlds/base/contract.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/overloaded.h"
#include "worlds/base/text.h"

namespace handrail::settings {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kLongestFileBytes = std::size_t{1} << 20;
constexpr std::string_view kDevicePrefix = "workspace.device.";
constexpr std::string_view kProfilePrefix = "profile.";
constexpr std::string_view kKeysPrefix = "keys.";

struct Entry {
    SettingValue value;
    std::string origin;
};
// The entries of one source, indexed by full key. Names of devices and commands are spelled as in the file.
using Layer = std::map<std::string, Entry>;

// A full key of one device in [workspace.device] or [profile], split into the name of the device and the field.
template <class Field>
struct MemberKey {
    std::string device;
    const Field* field;
};

template <class Field>
std::optional<MemberKey<Field>> split_member_key(std::string_view key, std::string_view prefix,
                                                 std::span<const Field> fields) {
    if (!key.starts_with(prefix)) return std::nullopt;
    key.remove_prefix(prefix.size());
    const std::size_t dot = key.rfind('.');
    if (dot == std::string_view::npos || dot == 0) return std::nullopt;
    std::string_view device = key.substr(0, dot);
    if (device.size() > 2 && device.front() == '"' && device.back() == '"')
        device = device.substr(1, device.size() - 2);
    if (device.find('"') != std::string_view::npos || !is_short_text(device)) return std::nullopt;
    for (const Field& info : fields)
        if (info.field == key.substr(dot + 1)) return MemberKey<Field>{lower_ascii(device), &info};
    return std::nullopt;
}

std::optional<MemberKey<OverrideInfo>> split_device_key(std::string_view key) {
    return split_member_key(key, kDevicePrefix, override_table());
}
std::optional<MemberKey<ProfileInfo>> split_profile_key(std::string_view key) {
    return split_member_key(key, kProfilePrefix, profile_table());
}

// Returns the key in its only canonical spelling: device names in lower case.
std::string canonical_key(std::string_view key) {
    if (const auto device = split_device_key(key))
        return fmt::format("{}{}.{}", kDevicePrefix, device->device, device->field->field);
    if (const auto profile = split_profile_key(key))
        return fmt::format("{}{}.{}", kProfilePrefix, profile->device, profile->field->field);
    return std::string(key);
}

bool is_command_word(std::string_view word) {
    const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-'; };
    return !word.empty() && word.size() <= 64 && std::all_of(word.begin(), word.end(), fits);
}

// Converts a value of a TOML file. Returns nothing for values that no setting accepts: lists, dates and times.
std::optional<SettingValue> from_toml(const TomlValue& value) {
    if (const auto* v = value.flag()) return *v;
    if (const auto* v = value.whole()) return *v;
    if (const auto* v = value.fraction()) return *v;
    if (const auto* v = value.text()) return *v;
    return std::nullopt;
}

// Returns the error for a key that does not exist. It names the nearest key that exists.
Error unknown_setting(std::string_view key) {
    std::vector<std::string> names;
    for (const SettingInfo& info : settings_table()) names.emplace_back(info.key);
    Error error;
    error.message = phrase("settings_file.unknown", {{"key", key}, {"nearest", nearest_key(key, names)}});
    return error;
}

// Returns the value as TOML text. Numbers have the fewest digits that read back as the same number.
std::string toml_text(const SettingValue& value) {
    return std::visit(Overloaded{[](bool v) { return std::string(v ? "true" : "false"); },
                                 [](std::int64_t v) { return fmt::format("{}", v); },
                                 [](double v) {
                                     const std::string digits = fmt::format("{}", v);
                                     return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
                                 },
                                 [](const std::string& v) {
                                     std::string text = "\"";
                                     for (const char c : v) {
                                         if (c == '"' || c == '\\') text += '\\';
                                         text += c;
                                     }
                                     return text + '"';
                                 }},
                      value);
}

// Adds the name of the file to an error of a TomlReader. If the line is known, turns the reason into a sentence.
Error damage_in(const fs::path& path, const Error& error) {
    Error reported = error;
    reported.file = path.filename().string();
    if (error.line > 0) reported.message = phrase("settings_file.damaged", {{"reason", error.message}});
    return reported;
}

Result<toml::table> parse(const std::string& content, const fs::path& path) {
    try {
        return parse_toml(content);
    } catch (const toml::parse_error& error) {
        const toml::source_position& at = error.source().begin;
        Error found{{}, static_cast<int>(at.line), static_cast<int>(at.column), std::string(error.description())};
        return tl::unexpected(damage_in(path, found));
    }
}

// True if `text` reads back as exactly `table`. The check prevents the loss of anything that a person wrote in the
// file.
bool says_the_same(const std::string& text, const toml::table& table) {
    try {
        return parse_toml(text) == table;
    } catch (const toml::parse_error&) {
        return false;
    }
}

// Puts one value into a table and makes the tables on the path to it. If a name within the path has a plain value, a
// table replaces that value.
void put(toml::table& root, std::span<const std::string> path, const SettingValue& value) {
    toml::table* table = &root;
    for (const std::string& name : path.first(path.size() - 1)) {
        toml::table* inner = (*table)[name].as_table();
        if (!inner) {
            table->insert_or_assign(name, toml::table{});
            inner = (*table)[name].as_table();
        }
        table = inner;
    }
    std::visit([&](const auto& v) { table->insert_or_assign(path.back(), v); }, value);
}

// Returns the offset in `text` of the character at `place`. Lines and columns count from 1.
std::size_t offset_of(const std::string& text, const toml::source_position& place) {
    std::size_t at = 0;
    for (toml::source_index line = 1; line < place.line && at < text.size(); ++line)
        at = std::min(text.find('\n', at), text.size() - 1) + 1;
    for (toml::source_index column = 1; column < place.column && at < text.size(); ++column) {
        do ++at;
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80);
    }
    return at;
}

// Changes or adds one value in the text of a file and keeps everything else, including comments. The result is correct
// for files that are written in the usual way, with [tables]. The caller must check the result by reading the returned
// text back.
std::string with_value(std::string text, std::span<const std::string> path, const SettingValue& value) {
    try {
        const toml::table table = parse_toml(text);
        const toml::node* node = &table;
        for (const std::string& name : path) node = node && node->as_table() ? node->as_table()->get(name) : nullptr;
        if (node) {
            const std::size_t begin = offset_of(text, node->source().begin);
            return text.replace(begin, offset_of(text, node->source().end) - begin, toml_text(value));
        }
    } catch (const toml::parse_error&) {
        return text;
    }
    std::string header = "[" + path[0];  // header of the table: [walk], [profile."NAME"] or [workspace.device."NAME"]
    if (path.size() == 4) header += "." + path[1];
    if (path.size() > 2) header += "." + toml_text(path[path.size() - 2]);
    header += "]";
    const std::string line = fmt::format("{} = {}\n", path.back(), toml_text(value));
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
        if (std::string_view(text).substr(at, end - at).starts_with(header)) {
            if (text[end - 1] != '\n') text += '\n';
            return text.insert(text.find('\n', at) + 1, line);
        }
        at = end;
    }
    if (!text.empty() && text.back() != '\n') text += '\n';
    return text + (text.empty() ? "" : "\n") + header + "\n" + line;
}

std::vector<std::string> path_of(std::string_view key) {
    if (const auto device = split_device_key(key))
        return {"workspace", "device", device->device, std::string(device->field->field)};
    if (const auto profile = split_profile_key(key))
        return {"profile", profile->device, std::string(profile->field->field)};
    const std::size_t dot = key.find('.');
    return {std::string(key.substr(0, dot)), std::string(key.substr(dot + 1))};
}

// Returns the name nearest to the unknown `key`, among those that the person may have meant.
std::string nearest_of_all(std::string_view key, std::span<const std::string> command_words) {
    std::vector<std::string> names;
    if (key.starts_with(kDevicePrefix) && key.rfind('.') >= kDevicePrefix.size()) {
        for (const OverrideInfo& info : override_table())
            names.push_back(fmt::format("{}.{}", key.substr(0, key.rfind('.')), info.field));
    } else if (key.starts_with(kProfilePrefix) && key.rfind('.') >= kProfilePrefix.size()) {
        for (const ProfileInfo& info : profile_table())
            names.push_back(fmt::format("{}.{}", key.substr(0, key.rfind('.')), info.field));
    } else {
        for (const SettingInfo& info : settings_table()) names.emplace_back(info.key);
        for (const std::string& word : command_words) names.push_back(fmt::format("{}{}", kKeysPrefix, word));
    }
    return nearest_key(key, names);
}

// Writes the value of one entry into `target`. Fails with an error of one sentence.
Result<void> apply_to(Settings& target, const std::string& key, const SettingValue& value,
                      std::span<const std::string> command_words) {
    if (const SettingInfo* info = find_setting(key)) return apply(*info, value, target);
    if (const auto device = split_device_key(key))
        return number_in_range(key, *device->field->plain, value).map([&](double number) {
            target.workspace.devices[device->device].*device->field->at = number;
        });
    if (const auto profile = split_profile_key(key)) {
        DeviceProfile changed = target.profiles[profile->device];
        return apply(key, *profile->field, value, changed).map([&] { target.profiles[profile->device] = changed; });
    }
    if (key.starts_with(kKeysPrefix) && key.size() > kKeysPrefix.size()) {
        const std::string word = key.substr(kKeysPrefix.size());
        const bool known = std::find(command_words.begin(), command_words.end(), word) != command_words.end();
        if (known || (command_words.empty() && is_command_word(word)))
            return key_text(key, value).map([&](const std::string& text) { target.keys[word] = text; });
    }
    return fail(phrase("settings_file.unknown", {{"key", key}, {"nearest", nearest_of_all(key, command_words)}}));
}

// Returns the value for this key that the person typed or gave on the command line.
SettingValue value_typed(const std::string& key, std::string_view value) {
    if (const SettingInfo* info = find_setting(key)) return value_from_word(*info, value);
    if (const auto device = split_device_key(key)) return value_from_word(*device->field->plain, value);
    if (const auto profile = split_profile_key(key)) return value_from_word(*profile->field, value);
    if (key.starts_with(kKeysPrefix)) return without_quotes(value);
    return std::string(value);
}

}  // namespace

struct SettingsStore::Impl {
    std::vector<std::string> command_words;
    std::map<SettingSource, Layer> layers;  // ordered from the weakest source to the strongest
    fs::path user_file;
    std::set<std::string> damaged_profiles;  // names of the damaged profiles in the person's file
    Settings values;

    Result<void> check(const std::string& key, const SettingValue& value, SettingSource source) const {
        Settings scratch;
        if (Result<void> applied = apply_to(scratch, key, value, command_words); !applied) return applied;
        if (source == SettingSource::World && !world_may_set(key))
            return fail(phrase("settings_file.not_for_worlds", {{"key", key}}));
        return {};
    }

    // If `layer` sets a value for all devices, removes the value that a weaker source set for one device.
    void forget_weaker(const Layer& layer) {
        for (const OverrideInfo& info : override_table()) {
            if (!layer.contains(std::string(info.plain->key))) continue;
            for (auto& [device, own] : values.workspace.devices) (own.*info.at).reset();
            for (const ProfileInfo& field : profile_table())
                if (field.field == info.field && field.number)
                    for (auto& [device, own] : values.profiles) (own.*field.number).reset();
        }
    }

    void rebuild() {
        values = Settings{};
        for (const auto& [source, layer] : layers) {
            forget_weaker(layer);
            for (const auto& [key, entry] : layer) {
                const Result<void> applied = apply_to(values, key, entry.value, command_words);
                contract_pre(applied.has_value());  // entries were checked before they were added to the layer
            }
        }
        // A profile is no longer damaged if it has a force ceiling again, because the device was measured again.
        for (const std::string& damaged : damaged_profiles)
            if (const auto profile = values.profiles.find(damaged);
                profile == values.profiles.end() || !profile->second.ceiling_n)
                values.damaged_profiles.insert(damaged);
    }

    void collect(const TomlValue::Table& table, const std::string& prefix, const fs::path& path, SettingSource source,
                 Layer& layer, std::set<std::string>& damaged, std::vector<Diagnostic>& problems) const {
        for (const auto& [name, node] : table) {
            // A dot inside a quoted name does not separate the parts of a path. Only names of devices may contain dots.
            const std::string_view plain = name;
            const bool quoted =
                plain.find('.') != std::string_view::npos && prefix != kDevicePrefix && prefix != kProfilePrefix;
            const std::string key =
                canonical_key(quoted ? fmt::format("{}\"{}\"", prefix, plain) : fmt::format("{}{}", prefix, plain));
            if (const TomlValue::Table* inner = node.table()) {
                collect(*inner, key + ".", path, source, layer, damaged, problems);
                continue;
            }
            const int line = node.line;
            const std::optional<SettingValue> value = from_toml(node);
            Result<void> checked = check(key, value.value_or(std::string{}), source);
            if (const SettingInfo* info = find_setting(key); info && !value)
                checked = fail(phrase("settings_file.wrong_kind", {{"key", key}, {"range", range_of(*info)}}));
            const auto profile = split_profile_key(key);
            if (checked) {
                layer[key] = {*value, fmt::format("{}:{}", path.string(), line)};
            } else if (!profile || damaged.insert(profile->device).second) {
                problems.push_back({Severity::Error, path.filename().string(), line, node.column,
                                    checked.error().message,
                                    phrase(profile ? "settings_file.profile_set_aside" : "settings_file.not_used")});
            }
        }
    }

    // Removes from `layer` each profile that has an impossible value. Its forces may be correct only together with that
    // value.
    static void set_aside(const std::set<std::string>& damaged, Layer& layer) {
        std::erase_if(layer, [&](const auto& entry) {
            const auto profile = split_profile_key(entry.first);
            return profile && damaged.contains(profile->device);
        });
    }

    // Returns the strongest source that sets this key, and the origin of the value there.
    std::pair<SettingSource, std::string> provenance(const std::string& key) const {
        for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer)
            if (const auto entry = layer->second.find(key); entry != layer->second.end())
                return {layer->first, entry->second.origin};
        return {SettingSource::Default, {}};
    }
};

SettingsStore::SettingsStore(std::vector<std::string> command_words) : impl_(std::make_unique<Impl>()) {
    impl_->command_words = std::move(command_words);
}
SettingsStore::~SettingsStore() = default;
SettingsStore::SettingsStore(SettingsStore&&) noexcept = default;
SettingsStore& SettingsStore::operator=(SettingsStore&&) noexcept = default;

const Settings& SettingsStore::values() const { return impl_->values; }

std::vector<Diagnostic> SettingsStore::load_file(const fs::path& path, SettingSource source, const TomlReader& toml) {
    contract_pre(source != SettingSource::Default);
    if (source == SettingSource::UserFile) impl_->user_file = path;
    std::error_code ec;
    if (path.empty() || fs::status(path, ec).type() == fs::file_type::not_found) {
        clear(source);
        return {};
    }
    const Result<TomlValue> table =
        read_whole_file(path, kLongestFileBytes).and_then([&](const std::string& content) -> Result<TomlValue> {
            Result<TomlValue> read = toml(content);
            if (!read) return tl::unexpected(damage_in(path, read.error()));
            return read;
        });
    if (!table) {
        const Error& e = table.error();
        return {{Severity::Error, e.file, e.line, e.column, e.message, phrase("settings_file.none_used")}};
    }
    std::vector<Diagnostic> problems;
    Layer layer;
    std::set<std::string> damaged;
    impl_->collect(*table->table(), "", path, source, layer, damaged, problems);
    Impl::set_aside(damaged, layer);
    if (source == SettingSource::UserFile) impl_->damaged_profiles = std::move(damaged);
    // Sorts the problems by line, because a TOML table is sorted by name, but people read their file from the top.
    std::stable_sort(problems.begin(), problems.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
    impl_->layers[source] = std::move(layer);
    impl_->rebuild();
    return problems;
}

Result<std::string> setting_text(const Settings& settings, std::string_view key) {
    const SettingInfo* info = find_setting(key);
    if (!info) return tl::unexpected(unknown_setting(key));
    const SettingValue value = current_value(*info, settings);
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    return toml_text(value);
}

Result<void> change_setting(Settings& settings, std::string_view key, std::string_view value) {
    const std::string name = canonical_key(key);
    return apply_to(settings, name, value_typed(name, value), {});
}

Result<void> SettingsStore::set(std::string_view key, std::string_view value, SettingSource source) {
    contract_pre(source != SettingSource::Default);
    const std::string name = canonical_key(key);
    SettingValue parsed = value_typed(name, value);
    if (Result<void> checked = impl_->check(name, parsed, source); !checked) return checked;
    impl_->layers[source][name] = {std::move(parsed), source == SettingSource::CommandLine ? "--set" : ""};
    impl_->rebuild();
    return {};
}

Result<void> SettingsStore::set_assignment(std::string_view assignment, SettingSource source) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos || equals == 0)
        return fail(phrase("settings_file.no_assignment", {{"text", assignment}}));
    return set(assignment.substr(0, equals), assignment.substr(equals + 1), source);
}

void SettingsStore::clear(SettingSource source) {
    impl_->layers.erase(source);
    if (source == SettingSource::UserFile) impl_->damaged_profiles.clear();
    impl_->rebuild();
}

void SettingsStore::take_layer(SettingSource source, SettingsStore other) {
    impl_->layers[source] = std::move(other.impl_->layers[source]);
    impl_->rebuild();
}

std::vector<SettingRow> SettingsStore::explain() const {
    std::vector<SettingRow> rows;
    const auto add = [&](const std::string& key, const SettingValue& value, std::string_view unit, std::string range,
                         std::string meaning) {
        const auto [source, origin] = impl_->provenance(key);
        rows.push_back(
            {key, toml_text(value), spoken_unit(unit), std::move(range), std::move(meaning), source, origin});
    };
    for (const SettingInfo& info : settings_table())
        add(std::string(info.key), current_value(info, impl_->values), info.unit, range_of(info), meaning_of(info));
    // The effective entries of [workspace.device], [profile] and [keys]. Stronger layers replace the entries of weaker
    // ones.
    std::map<std::string, SettingValue> family;
    for (const auto& [source, layer] : impl_->layers)
        for (const auto& [key, entry] : layer)
            if (!find_setting(key)) family[key] = entry.value;
    for (const auto& [key, value] : family) {
        if (const auto device = split_device_key(key))
            add(key, value, device->field->plain->unit, range_of(*device->field->plain),
                meaning_of(*device->field->plain));
        else if (const auto profile = split_profile_key(key))
            add(key, value, profile->field->unit, range_of(*profile->field), meaning_of(*profile->field));
        else add(key, value, "", phrase("setting_range.key"), phrase("setting.keys"));
    }
    return rows;
}

Result<void> SettingsStore::save_user_file() {
    const auto wanted = to_save();
    if (!wanted) return tl::unexpected(wanted.error());
    return *wanted ? write_named_file_atomically((*wanted)->file, (*wanted)->text) : Result<void>{};
}

Result<std::optional<SettingsStore::ToSave>> SettingsStore::to_save() const {
    const auto live = impl_->layers.find(SettingSource::Live);
    if (live == impl_->layers.end() || live->second.empty()) return std::nullopt;
    const fs::path& path = impl_->user_file;
    if (path.empty()) return fail(phrase("settings_file.no_folder"));
    // Reads the person's file again, because another program may have changed it since the start.
    std::string held;
    std::error_code ec;
    const auto not_saved = [](Error error) {
        error.message += " " + phrase("settings_file.not_saved");
        return tl::unexpected(std::move(error));
    };
    if (fs::status(path, ec).type() != fs::file_type::not_found) {
        Result<std::string> content = read_whole_file(path, kLongestFileBytes);
        if (!content) return not_saved(content.error());
        held = std::move(*content);
    }
    Result<toml::table> table = parse(held, path);
    if (!table) return not_saved(table.error());
    std::string text = held;
    for (const auto& [key, entry] : live->second) {
        put(*table, path_of(key), entry.value);
        text = with_value(text, path_of(key), entry.value);
    }
    // If the file is written in an unusual way, the whole file is written again. It loses its comments, but keeps its
    // meaning.
    if (!says_the_same(text, *table)) {
        std::ostringstream out;
        out.exceptions(std::ios::badbit);  // without exceptions, a lack of memory would cut the text short unnoticed
        out << toml::toml_formatter{*table, toml::format_flags::none} << "\n";
        text = out.str();
        if (!says_the_same(text, *table))
            return not_saved({path.filename().string(), 0, 0, phrase("settings_file.unwritable")});
    }
    if (text == held) return std::nullopt;
    return ToSave{path, std::move(text)};
}

fs::path settings_next_to(const fs::path& world) {
    return world.empty() ? fs::path() : fs::path(world).replace_extension(".settings.toml");
}

std::string profile_key(std::string_view device_name, std::string_view serial) {
    return lower_ascii(serial.empty() ? std::string(device_name) : fmt::format("{} {}", device_name, serial));
}

std::string source_name(SettingSource source) {
    switch (source) {
        case SettingSource::Default:
            return phrase("settings_file.from_default");
        case SettingSource::UserFile:
            return phrase("settings_file.from_user");
        case SettingSource::World:
            return phrase("settings_file.from_world");
        case SettingSource::CommandLine:
            return phrase("settings_file.from_command_line");
        case SettingSource::Live:
            return phrase("settings_file.from_now");
    }
    return {};
}

fs::path user_settings_path() {
    // The base directory specification allows only an absolute path in XDG_CONFIG_HOME.
    const char* config = std::getenv("XDG_CONFIG_HOME");
    if (config && config[0] == '/') return fs::path(config) / "handrail" / "settings.toml";
    const char* home = std::getenv("HOME");
    if (home && home[0] == '/') return fs::path(home) / ".config" / "handrail" / "settings.toml";
    return {};
}

}  // namespace handrail::settings
