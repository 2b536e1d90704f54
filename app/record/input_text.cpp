#include "app/record/input_text.h"

#include <cmath>
#include <map>

#include "app/core/scenario/read_request.h"
#include "app/record/json_fields.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/overloaded.h"

namespace handrail::record {
namespace {

constexpr std::array<const char*, 5> kActs = {"go_to", "choose", "less", "more", "put"};

constexpr std::array<const char*, 15> kTeacherActs = {"begin", "offer",  "task",    "ask",   "order",
                                                      "point", "lead",   "leave",   "block", "open",
                                                      "note",  "result", "summary", "end",   "learners"};

template <std::size_t N>
std::size_t place_in(const std::array<const char*, N>& words, const Json& word) {
    for (std::size_t i = 0; i < N; ++i)
        if (word == words[i]) return i;
    throw Json::other_error::create(501, "word", nullptr);
}

core::Command command_of(const Json& json) {
    if (const core::CommandInfo* found = core::find_command(json.at("command").get<std::string>()))
        return found->command;
    throw Json::other_error::create(501, "command", nullptr);
}

Json json_of(const core::HandFacts& hand) {
    Json json{{"present", hand.present}};
    if (!hand.present) return json;
    const device::DeviceSpec& spec = hand.spec;
    json["simulated"] = hand.simulated;
    json["device"] = std::string(spec.name);
    json["serial"] = hand.serial;
    // A device without a limit has the value infinity, which JSON cannot express. So leave the key out.
    if (std::isfinite(spec.peak_force_n)) json["peak_force_n"] = spec.peak_force_n;
    json["rated_stiffness_n_per_m"] = spec.rated_stiffness_n_per_m;
    json["workspace_radius_m"] = spec.workspace_radius_m;
    json["device_damping_ns_per_m"] = spec.device_damping_ns_per_m;
    json["delay_s"] = spec.delay_s;
    json["min_rate_hz"] = spec.min_rate_hz;
    json["encoder_quantum_m"] = spec.encoder_quantum_m;
    json["kinesthetic"] = spec.kinesthetic;
    json["sustained_share"] = spec.sustained_share;
    return json;
}

core::HandFacts hand_of(const Json& json) {
    core::HandFacts hand;
    hand.present = json.at("present").get<bool>();
    if (!hand.present) return hand;
    hand.simulated = json.at("simulated").get<bool>();
    hand.serial = json.at("serial").get<std::string>();
    const std::string name = json.at("device").get<std::string>();
    const device::DeviceSpec* model = device::find_device_spec(name);
    hand.spec = model ? *model : device::ideal_device_spec();
    device::DeviceSpec& spec = hand.spec;
    const auto peak = json.find("peak_force_n");
    spec.peak_force_n = peak == json.end() ? std::numeric_limits<double>::infinity() : peak->get<double>();
    spec.rated_stiffness_n_per_m = json.at("rated_stiffness_n_per_m").get<double>();
    spec.workspace_radius_m = json.at("workspace_radius_m").get<double>();
    spec.device_damping_ns_per_m = json.at("device_damping_ns_per_m").get<double>();
    spec.delay_s = json.at("delay_s").get<double>();
    spec.min_rate_hz = json.at("min_rate_hz").get<double>();
    spec.encoder_quantum_m = json.at("encoder_quantum_m").get<double>();
    spec.kinesthetic = json.at("kinesthetic").get<bool>();
    spec.sustained_share = json.at("sustained_share").get<double>();
    return hand;
}

Json json_of(const settings::Settings& settings) { return Json::parse(settings_text(settings)); }
settings::Settings settings_of(const Json& json) {
    auto settings = read_settings_text(json.dump());
    if (!settings) throw Json::other_error::create(501, settings.error().message, nullptr);
    return std::move(*settings);
}

Json json_of(const core::LastPlace& place) {
    Json json{{"world", place.world.file.string()},
              {"feet_m", json_of_vec(place.feet_m)},
              {"heading_rad", place.heading_rad}};
    if (!place.world.building.empty()) json["building"] = place.world.building;
    if (place.world.map_scale_m_per_unit) json["map_scale_m_per_unit"] = *place.world.map_scale_m_per_unit;
    if (place.world.unit_m) json["unit_m"] = *place.world.unit_m;
    return json;
}
std::optional<double> number_of(const Json& json, const char* key) {
    const auto at = json.find(key);
    return at == json.end() ? std::nullopt : std::optional(at->get<double>());
}
core::LastPlace last_place_of(const Json& json) {
    const core::WorldRequest world{json.at("world").get<std::string>(), number_of(json, "map_scale_m_per_unit"),
                                   number_of(json, "unit_m"), json.value("building", std::string())};
    return {world, vec_of(json.at("feet_m")), json.at("heading_rad").get<double>()};
}

Json json_of(const core::Placed& in) {
    Json json{{"feet_m", json_of_vec(in.feet_m)}, {"heading_rad", in.heading_rad}};
    if (!in.name.empty()) json["name"] = in.name;
    return json;
}
core::Placed placed_of(const Json& json) {
    return {vec_of(json.at("feet_m")), json.at("heading_rad").get<double>(), json.value("name", std::string())};
}

// Converts a WorldEntered to JSON, including the options of the world readers.
Json json_of(const core::WorldEntered& in) {
    const readers::ReadOptions read = core::read_options(in.request);
    Json json{{"world", in.request.file.string()},
              {"map_metres_per_unit", read.map_metres_per_unit},
              {"obj_metres_per_unit", read.obj_metres_per_unit},
              {"unit_is_known", read.unit_is_known}};
    if (!read.building.empty()) json["building"] = read.building;
    if (in.settings) json["settings"] = json_of(*in.settings);
    if (in.begins_at) json["begins_at"] = json_of(*in.begins_at);
    if (!in.additions) return json;
    json["checksum"] = in.additions->world_checksum();
    const auto text = in.additions->path().empty() ? fail({}) : read_whole_file(in.additions->path());
    json["additions"] = text ? *text : std::string();
    return json;
}

RecordedWorld world_of(const Json& json) {
    RecordedWorld world;
    world.request.file = json.at("world").get<std::string>();
    world.request.building = json.value("building", std::string());
    const double map_m = json.at("map_metres_per_unit").get<double>(),
                 other_m = json.at("obj_metres_per_unit").get<double>();
    if (json.at("unit_is_known").get<bool>()) {
        if (map_m == other_m) world.request.unit_m = map_m;
        else world.request.map_scale_m_per_unit = map_m;
    }
    world.checksum = json.value("checksum", std::string());
    world.has_additions = json.contains("additions");
    world.additions = json.value("additions", std::string());
    return world;
}

Json fields_of(const core::SessionInput& input) {
    return std::visit(
        Overloaded{
            [](const core::CommandDown& in) {
                Json json{{"is", "command_down"}, {"command", std::string(core::info(in.command).word)}};
                if (in.times != 1) json["times"] = in.times;
                return json;
            },
            [](const core::CommandUp& in) {
                return Json{{"is", "command_up"}, {"command", std::string(core::info(in.command).word)}};
            },
            [](const core::KeyTapped& in) {
                return Json{{"is", "key"}, {"key", in.key}};
            },
            [](const core::TextTyped& in) {
                return Json{{"is", "text"}, {"text", in.utf8}};
            },
            [](const core::LineTyped& in) {
                return Json{{"is", "line"}, {"line", in.line}};
            },
            [](const core::ListsLeft&) {
                return Json{{"is", "lists_left"}};
            },
            [](const core::ItemActed& in) {
                return Json{{"is", "item_act"},
                            {"act", kActs.at(static_cast<std::size_t>(in.act.kind))},
                            {"item", in.act.item},
                            {"name", in.act.name},
                            {"number", in.act.number}};
            },
            [](const core::Steered& in) {
                Json json{{"is", "steered"},
                          {"ahead", in.steering.ahead},
                          {"right", in.steering.right},
                          {"turn_right", in.steering.turn_right}};
                if (in.steering.cane_right_rad_per_s != 0.0)
                    json["cane_right_rad_per_s"] = in.steering.cane_right_rad_per_s;
                return json;
            },
            [](const core::FocusChanged& in) {
                return Json{{"is", "focus"}, {"focused", in.focused}};
            },
            [](const core::Stopped& in) {
                return Json{{"is", "stops"}, {"count", in.count}};
            },
            [](const core::HandMoved& in) {
                return Json{{"is", "hand_moved"}, {"by_m", json_of_vec(in.by_m)}};
            },
            [](const core::SettingSet& in) {
                return Json{{"is", "setting"}, {"key", in.key}, {"value", in.value}};
            },
            [](const core::SettingsChanged& in) {
                return Json{{"is", "settings"}, {"settings", json_of(in.settings)}};
            },
            [](const core::HandChanged& in) {
                return Json{{"is", "hand"},
                            {"hand", json_of(in.hand)},
                            {"settings", json_of(in.settings)},
                            {"for_want_of_one", in.for_want_of_one}};
            },
            [](const core::LeftHandChanged& in) {
                return Json{{"is", "left_hand"}, {"hand", json_of(in.hand)}};
            },
            [](const core::HandOffered& in) {
                return Json{{"is", "hand_offered"}, {"spoken_name", in.spoken_name}};
            },
            [](const core::WorldEntered& in) {
                Json json{{"is", "world_entered"}};
                json.update(json_of(in));
                return json;
            },
            [](const core::Placed& in) {
                Json json = json_of(in);
                json["is"] = "placed";
                return json;
            },
            [](const core::Announcement& in) {
                return Json{{"is", "told"},
                            {"text", in.text},
                            {"class", kClassWords.at(static_cast<std::size_t>(in.speech_class))}};
            },
            [](const core::LinesOwed& in) {
                return Json{{"is", "lines_owed"}, {"topics", in.topics.bits}};
            },
            [](const core::FirstMinutesBegun& in) {
                return Json{
                    {"is", "first_minutes"}, {"who_speaks", in.who_speaks}, {"owner_sets_up", in.owner_sets_up}};
            },
            [](const core::LessonLeft&) {
                return Json{{"is", "lesson_left"}};
            },
            [](const core::SetUpOver&) {
                return Json{{"is", "set_up_over"}};
            },
            [](const core::LastPlaceKnown& in) {
                return Json{{"is", "last_place"}, {"place", json_of(in.place)}};
            },
            [](const core::WentOnAt& in) {
                return Json{{"is", "went_on_at"}, {"place", json_of(in.place)}};
            },
            [](const core::CrashReportKnown& in) {
                return Json{{"is", "crash_report"}, {"file", in.file}, {"lines", in.lines}};
            },
            [](const core::SettingsFaultsKnown& in) {
                return Json{{"is", "settings_faults"}, {"faults", in.faults}};
            },
            [](const core::DevicesFound& in) {
                return Json{{"is", "devices"}, {"sentences", in.sentences}};
            },
            [](const core::TeacherActed& in) {
                Json json{{"is", "teacher"},           {"act", kTeacherActs.at(static_cast<std::size_t>(in.kind))},
                          {"text", in.text},           {"items", in.items},
                          {"places_m", Json::array()}, {"number", in.number}};
                for (const Vec3& place : in.places_m) json["places_m"].push_back(json_of_vec(place));
                return json;
            },
            [](const core::WorldsKnown& in) {
                Json recent = Json::array();
                for (const auto& world : in.shelf.recent) recent.push_back(world.string());
                return Json{{"is", "worlds"}, {"bundled", in.shelf.bundled.string()}, {"recent", std::move(recent)}};
            },
        },
        input);
}

using ReadFields = core::SessionInput (*)(const Json&);
const std::map<std::string, ReadFields, std::less<>>& readers() {
    static const std::map<std::string, ReadFields, std::less<>> kReaders = {
        {"command_down",
         [](const Json& j) -> core::SessionInput {
             return core::CommandDown{command_of(j), j.contains("times") ? whole_of<int>(j.at("times")) : 1};
         }},
        {"command_up", [](const Json& j) -> core::SessionInput { return core::CommandUp{command_of(j)}; }},
        {"key", [](const Json& j) -> core::SessionInput { return core::KeyTapped{j.at("key").get<std::string>()}; }},
        {"text", [](const Json& j) -> core::SessionInput { return core::TextTyped{j.at("text").get<std::string>()}; }},
        {"line", [](const Json& j) -> core::SessionInput { return core::LineTyped{j.at("line").get<std::string>()}; }},
        {"lines_owed",
         [](const Json& j) -> core::SessionInput {
             return core::LinesOwed{{whole_of<std::uint32_t>(j.at("topics"))}};
         }},
        {"lists_left", [](const Json&) -> core::SessionInput { return core::ListsLeft{}; }},
        {"item_act",
         [](const Json& j) -> core::SessionInput {
             return core::ItemActed{{static_cast<core::ItemAct::Kind>(place_in(kActs, j.at("act"))),
                                     whole_of<std::size_t>(j.at("item")), j.at("name").get<std::string>(),
                                     j.at("number").get<double>()}};
         }},
        {"steered",
         [](const Json& j) -> core::SessionInput {
             return core::Steered{{j.at("ahead").get<double>(), j.at("right").get<double>(),
                                   j.at("turn_right").get<double>(), j.value("cane_right_rad_per_s", 0.0)}};
         }},
        {"focus", [](const Json& j) -> core::SessionInput { return core::FocusChanged{j.at("focused").get<bool>()}; }},
        {"stops",
         [](const Json& j) -> core::SessionInput { return core::Stopped{whole_of<std::uint32_t>(j.at("count"))}; }},
        {"hand_moved", [](const Json& j) -> core::SessionInput { return core::HandMoved{vec_of(j.at("by_m"))}; }},
        {"setting",
         [](const Json& j) -> core::SessionInput {
             return core::SettingSet{j.at("key").get<std::string>(), j.at("value").get<std::string>()};
         }},
        {"settings",
         [](const Json& j) -> core::SessionInput { return core::SettingsChanged{settings_of(j.at("settings"))}; }},
        {"hand",
         [](const Json& j) -> core::SessionInput {
             return core::HandChanged{hand_of(j.at("hand")), settings_of(j.at("settings")),
                                      j.at("for_want_of_one").get<bool>()};
         }},
        {"left_hand", [](const Json& j) -> core::SessionInput { return core::LeftHandChanged{hand_of(j.at("hand"))}; }},
        {"hand_offered",
         [](const Json& j) -> core::SessionInput { return core::HandOffered{j.at("spoken_name").get<std::string>()}; }},
        {"world_entered",
         [](const Json& j) -> core::SessionInput {
             return core::WorldEntered{
                 {},
                 {},
                 world_of(j).request,
                 j.contains("settings") ? std::optional(settings_of(j.at("settings"))) : std::nullopt,
                 j.contains("begins_at") ? std::optional(placed_of(j.at("begins_at"))) : std::nullopt};
         }},
        {"placed", [](const Json& j) -> core::SessionInput { return placed_of(j); }},
        {"told",
         [](const Json& j) -> core::SessionInput {
             return core::Announcement{j.at("text").get<std::string>(),
                                       static_cast<cues::SpeechClass>(place_in(kClassWords, j.at("class")))};
         }},
        {"first_minutes",
         [](const Json& j) -> core::SessionInput {
             return core::FirstMinutesBegun{j.at("who_speaks").get<std::string>(), j.at("owner_sets_up").get<bool>()};
         }},
        {"lesson_left", [](const Json&) -> core::SessionInput { return core::LessonLeft{}; }},
        {"set_up_over", [](const Json&) -> core::SessionInput { return core::SetUpOver{}; }},
        {"last_place",
         [](const Json& j) -> core::SessionInput { return core::LastPlaceKnown{last_place_of(j.at("place"))}; }},
        {"went_on_at",
         [](const Json& j) -> core::SessionInput { return core::WentOnAt{last_place_of(j.at("place"))}; }},
        {"crash_report",
         [](const Json& j) -> core::SessionInput {
             return core::CrashReportKnown{j.at("file").get<std::string>(),
                                           j.at("lines").get<std::vector<std::string>>()};
         }},
        {"settings_faults",
         [](const Json& j) -> core::SessionInput {
             return core::SettingsFaultsKnown{j.at("faults").get<std::vector<std::string>>()};
         }},
        {"devices",
         [](const Json& j) -> core::SessionInput {
             return core::DevicesFound{j.at("sentences").get<std::vector<std::string>>()};
         }},
        {"teacher",
         [](const Json& j) -> core::SessionInput {
             core::TeacherActed act{static_cast<core::TeacherActed::Kind>(place_in(kTeacherActs, j.at("act"))),
                                    j.at("text").get<std::string>(),
                                    j.at("items").get<std::vector<std::string>>(),
                                    {},
                                    j.at("number").get<double>()};
             for (const Json& place : j.at("places_m")) act.places_m.push_back(vec_of(place));
             return act;
         }},
        {"worlds",
         [](const Json& j) -> core::SessionInput {
             core::WorldShelf shelf{j.at("bundled").get<std::string>(), {}};
             for (const Json& world : j.at("recent")) shelf.recent.emplace_back(world.get<std::string>());
             return core::WorldsKnown{std::move(shelf)};
         }},
    };
    return kReaders;
}

}  // namespace

bool is_input(const std::string& is) { return readers().contains(is); }

std::string input_line(const core::SessionInput& input, double now_s, std::uint64_t frame, double begun_s) {
    Json line{{"t", std::llround((now_s - begun_s) * 1e3)}};
    line.update(fields_of(input));
    line["frame"] = frame;
    line["now_s"] = now_s;
    return line_of(line);
}

Result<RecordedInput> read_input_line(const std::string& line) {
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object()) return fail(phrase("recording.no_line"));
    try {
        const auto reader = readers().find(json.at("is").get<std::string>());
        if (reader == readers().end()) return fail(phrase("recording.no_line"));
        RecordedInput read{
            whole_of<std::uint64_t>(json.at("frame")), json.at("now_s").get<double>(), reader->second(json), {}};
        if (std::holds_alternative<core::WorldEntered>(read.input)) read.world = world_of(json);
        return read;
    } catch (const Json::exception&) {
        return fail(phrase("recording.no_line"));
    }
}

}  // namespace handrail::record
