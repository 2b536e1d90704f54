#include "app/core/scenario/scenario.h"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <set>

#include "app/core/kept/world_shelf.h"
#include "app/core/scenario/scenario_parts.h"
#include "app/core/scenario/toml_fields.h"
#include "audio-cues/plan/sound_table.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace {

namespace fs = std::filesystem;

// Returns the names of all sounds. Every sound has a name, and every material has a word. These are the same tables
// that provide the names for people.
std::vector<std::string_view> all_sound_names() {
    std::vector<std::string_view> names;
    for (const cues::SoundInfo& row : cues::sound_table()) names.push_back(row.name);
    return names;
}
std::vector<std::string_view> all_material_names() {
    std::vector<std::string_view> names;
    for (int i = 0; i <= static_cast<int>(SoundClass::Generic); ++i)
        names.push_back(cues::material_sound_name(static_cast<SoundClass>(i)));
    return names;
}

Command command_named(TomlFields& fields, const char* key) {
    const std::string word = fields.text(key);
    if (const CommandInfo* row = find_command(word)) return row->command;
    std::vector<std::string> known;
    for (const CommandInfo& row : command_table()) known.emplace_back(row.word);
    throw BadField{fields.node(key).line,
                   phrase("scenario.no_command", {{"word", word}, {"nearest", nearest_name(word, known)}})};
}

constexpr double kLongest_s = 3600.0;
constexpr double kLeastUnit_m = 1e-6, kMostUnit_m = 1e6;
// Names in the order of the enum ActsBy.
constexpr std::array<std::string_view, 3> kActsBy{"window-keys", "terminal-keys", "lines"};

fs::path find_world(const std::string& name, const ScenarioFolders& folders, int line) {
    return find_named_world(name, folders, line);
}

// Returns the rotation by `turn_deg` about `turn_axis`. If there is no axis, the rotation is about the upward axis.
std::optional<Rotation> read_turn(TomlFields& fields) {
    if (!fields.has("turn_deg")) return std::nullopt;
    const Vec3 axis = fields.has("turn_axis") ? fields.vector("turn_axis") : Vec3(0.0, 0.0, 1.0);
    const double length = glm::length(axis);
    if (!(length > 0.0)) throw BadField{fields.line(), phrase("scenario.zero", {{"key", "turn_axis"}})};
    return rotation_about(axis / length, radians_from_degrees(fields.number("turn_deg", -360.0, 360.0)));
}

bool is_left(TomlFields& fields) {
    if (!fields.has("whose")) return false;
    const std::string hand = fields.text("whose");
    if (hand != "left" && hand != "right") throw BadField{fields.line(), phrase("scenario.whose")};
    return hand == "left";
}

ScenarioAction read_action(const settings::TomlValue& table, const ScenarioFolders& folders) {
    TomlFields fields(table, "action");
    ScenarioAction action;
    action.line = fields.line();
    int kinds = 0;
    const auto is = [&](const char* key) { return fields.has(key) && (++kinds, true); };
    if (is("press"))
        action.step = TapCommand{command_named(fields, "press"), fields.number_or("for_s", 0.1, 0.0, kLongest_s),
                                 static_cast<int>(fields.number_or("times", 1.0, 1.0, 1000.0))};
    if (is("hold")) action.step = HoldCommand{command_named(fields, "hold"), fields.number("for_s", 0.0, kLongest_s)};
    if (is("key")) action.step = TapKey{fields.text("key")};
    if (is("type")) action.step = TypeText{fields.text("type")};
    if (is("line")) action.step = TypeLine{fields.text("line")};
    if (is("wait_s")) action.step = Wait{fields.number("wait_s", 0.0, kLongest_s)};
    if (is("move_to"))
        action.step = MoveHand{fields.vector("move_to"), fields.number_or("speed_m_per_s", 0.1, 1e-6, 100.0), false};
    if (is("move_by"))
        action.step = MoveHand{fields.vector("move_by"), fields.number_or("speed_m_per_s", 0.1, 1e-6, 100.0), true};
    if (is("hand_to"))
        action.step = MoveInDevice{{}, fields.vector("hand_to"), fields.number_or("speed_m_per_s", 0.1, 1e-6, 100.0)};
    if (is("control")) {
        MoveInDevice move{fields.text("control"), Vec3(0.0), fields.number_or("speed_m_per_s", 0.1, 1e-6, 100.0)};
        move.to_m = Vec3(fields.number_or("right_mm", 0.0, -1e3, 1e3), fields.number("off_mm", -1e3, 1e3),
                         fields.number_or("up_mm", 0.0, -1e3, 1e3)) *
                    1e-3;
        action.step = std::move(move);
    }
    if (is("push_n")) action.step = PushHand{fields.vector("push_n"), fields.number("for_s", 0.0, kLongest_s)};
    if (is("rest_at")) action.step = RestHand{fields.vector("rest_at"), fields.number("for_s", 0.0, kLongest_s)};
    if (is("add")) {
        AddThing add;
        add.name = fields.text("add");
        if (fields.has("box") == fields.has("model")) throw BadField{action.line, phrase("scenario.add")};
        if (fields.has("box")) add.box_m = fields.vector("box");
        else add.model = find_world(fields.text("model"), folders, fields.node("model").line);
        add.at.position_m = fields.vector("at");
        add.at.rotation = read_turn(fields).value_or(Rotation{});
        add.at.scale = fields.number_or("scale", 1.0, 1e-3, 1e3);
        if (fields.has("material")) add.material = fields.text("material");
        action.step = std::move(add);
    }
    if (is("remove")) action.step = RemoveThing{fields.text("remove")};
    if (is("send")) {
        SendThing send{
            fields.text("send"), {}, read_turn(fields), {}, fields.number_or("speed_m_per_s", 0.3, 1e-6, 100.0)};
        if (fields.has("to")) send.to_m = fields.vector("to");
        if (fields.has("scale")) send.scale = fields.number("scale", 1e-3, 1e3);
        action.step = std::move(send);
    }
    if (is("trouble")) {
        const std::string kind = fields.text("trouble");
        static const std::vector<std::string> kinds_known{"nan", "jump", "freeze", "unplug", "late", "hot", "error"};
        if (std::find(kinds_known.begin(), kinds_known.end(), kind) == kinds_known.end())
            throw BadField{
                fields.node("trouble").line,
                phrase("scenario.no_trouble", {{"word", kind}, {"nearest", nearest_name(kind, kinds_known)}})};
        action.step = ScenarioTrouble{kind, fields.number("for_s", 0.0, kLongest_s)};
    }
    if (is("button")) action.step = DeviceButton{fields.flag("button")};
    if (is("focus")) action.step = KeyboardFocus{fields.flag("focus")};
    if (is("place"))
        action.step = PlaceWalker{fields.vector("place"),
                                  radians_from_degrees(fields.number_or("heading_deg", 0.0, -360.0, 360.0))};
    if (is("set")) {
        const std::string pair = fields.text("set");
        const std::size_t equals = pair.find('=');
        if (equals == std::string::npos) throw BadField{fields.node("set").line, phrase("scenario.set")};
        action.step = ChangeSetting{pair.substr(0, equals), pair.substr(equals + 1)};
    }
    if (fields.has("name")) action.name = fields.text("name");
    if (fields.has("at_s")) action.at_s = fields.number("at_s", 0.0, kLongest_s);
    action.left = is_left(fields);
    if (fields.has("meanwhile")) action.meanwhile = fields.flag("meanwhile");
    fields.done();
    if (kinds != 1) throw BadField{action.line, phrase("scenario.one_action")};
    return action;
}

// Converts the table of a sweep into the moves of that sweep.
std::vector<ScenarioAction> read_sweep(const settings::TomlValue& table) {
    TomlFields fields(table, "sweep");
    const Vec3 at = fields.vector("sweep_at");
    const double from_deg = fields.number("from_deg", -360.0, 360.0), to_deg = fields.number("to_deg", -360.0, 720.0);
    const int angles = static_cast<int>(fields.number("angles", 1.0, 360.0));
    const double reach_m = fields.number("reach_m", 0.0, 1e3), depth_m = fields.number("depth_m", 0.0, 1e3);
    const double speed = fields.number_or("speed_m_per_s", 0.1, 1e-6, 100.0);
    const std::string name = fields.has("name") ? fields.text("name") : std::string{};
    fields.done();
    std::vector<ScenarioAction> moves;
    for (int i = 0; i < angles; ++i) {
        const double heading =
            radians_from_degrees(from_deg + (angles > 1 ? (to_deg - from_deg) * i / (angles - 1) : 0.0));
        const Vec3 away = forward_of_heading(heading);
        for (const Vec3& to : {at + away * reach_m, at - away * depth_m, at + away * reach_m})
            moves.push_back({.name = {}, .step = MoveHand{to, speed, false}, .at_s = {}, .line = fields.line()});
    }
    if (!name.empty()) {
        moves.front().name = name;
        moves.back().name = name + " last";
    }
    return moves;
}

Moment read_moment(TomlFields& fields, const char* key, const std::set<std::string>& names) {
    const settings::TomlValue& node = fields.node(key);
    if (node.number()) return Moment{{}, false, fields.number(key, 0.0, kLongest_s)};
    Moment moment;
    moment.action = fields.text(key);
    if (moment.action.ends_with(" ends")) {
        moment.at_end = true;
        moment.action.resize(moment.action.size() - 5);
    }
    if (!names.contains(moment.action))
        throw BadField{
            node.line,
            phrase("scenario.no_action",
                   {{"word", moment.action},
                    {"nearest", nearest_name(moment.action, std::vector<std::string>(names.begin(), names.end()))}})};
    return moment;
}

void must_be_one_of(const std::string& word, std::span<const std::string_view> known, int line, const char* otherwise) {
    if (std::find(known.begin(), known.end(), word) != known.end()) return;
    throw BadField{
        line,
        phrase(otherwise, {{"word", word},
                           {"nearest", nearest_name(word, std::vector<std::string>(known.begin(), known.end()))}})};
}

// Reads one expectation: the condition to check, given by exactly one key, and when to check it.
class ExpectationReader {
public:
    explicit ExpectationReader(const settings::TomlValue& table) : fields_(table, "expectation") {
        e_.line = fields_.line();
    }

    Expectation read(const std::set<std::string>& names) {
        read_words();
        read_sounds();
        read_forces();
        read_vibrations();
        read_places();
        read_when(names);
        fields_.done();
        if (kinds_ != 1) throw BadField{e_.line, phrase("scenario.one_check")};
        return e_;
    }

private:
    bool is(const char* key, Check check) {
        if (!fields_.has(key)) return false;
        ++kinds_;
        e_.check = check;
        return true;
    }
    void words(const char* key, Check check) {
        if (is(key, check)) e_.text = fields_.text(key);
    }
    void flag(const char* key, Check check) {
        if (is(key, check)) fields_.flag(key);
    }
    // Reads the upper limit `key`, if the table contains that key.
    bool limit(const char* key, Check check, double most) {
        if (!is(key, check)) return false;
        e_.high = fields_.number(key, 0.0, most);
        return true;
    }
    bool range(const char* key, Check check) {
        if (!is(key, check)) return false;
        const auto range = fields_.range(key);
        e_.low = range[0];
        e_.high = range[1];
        return true;
    }
    void frequencies() {
        e_.from_hz = fields_.number("from_hz", 0.1, 500.0);
        e_.to_hz = fields_.number("to_hz", 0.1, 500.0);
    }
    void direction() {
        e_.vector = fields_.vector("direction");
        e_.has_vector = true;
        const double length = glm::length(e_.vector);
        if (!(length > 0.0)) throw BadField{e_.line, phrase("scenario.zero", {{"key", "direction"}})};
        e_.vector /= length;
    }

    void read_words() {
        words("say", Check::Say);
        words("not_say", Check::NotSay);
        words("say_in_order", Check::SayInOrder);
        limit("nothing_twice_s", Check::NothingTwice, 1e6);
    }

    bool sound(const char* key, Check check) {
        if (!is(key, check)) return false;
        e_.text = fields_.text(key);
        must_be_one_of(e_.text, all_sound_names(), e_.line, "scenario.no_sound");
        if (fields_.has("material")) {
            e_.material = fields_.text("material");
            must_be_one_of(e_.material, all_material_names(), e_.line, "scenario.no_material");
        }
        if (fields_.has("muffled_db")) e_.muffled_db = fields_.range("muffled_db");
        if (fields_.has("pitch")) e_.pitch = fields_.range("pitch");
        return true;
    }
    void read_sounds() {
        if (sound("sound", Check::Sound)) e_.high = fields_.number_or("latency_ms", -1.0, 0.0, 10000.0);
        sound("sound_faster", Check::SoundFaster);
        sound("not_sound", Check::NotSound);
        sound("sound_rising", Check::SoundRising);
    }

    void read_forces() {
        if (range("force_n", Check::Force) && fields_.has("direction")) direction();
        limit("force_step_n", Check::ForceStep, 1e6);
        limit("force_spike", Check::ForceSpike, 1e6);
        if (limit("force_angle_deg", Check::ForceAngle, 180.0)) direction();
        flag("force_rising", Check::ForceRising);
        limit("depth_mm", Check::Depth, 1e6);
        limit("penetration_m", Check::Penetration, 1e6);
        if (range("slide_mu", Check::SlideRatio)) direction();
    }

    void read_vibrations() {
        if (limit("force_line_n", Check::ForceLine, 1e6)) e_.from_hz = e_.to_hz = fields_.number("hz", 0.1, 500.0);
        if (limit("force_band_n", Check::ForceBand, 1e6)) frequencies();
        if (range("strongest_line_hz", Check::StrongestLine)) {
            frequencies();
            e_.tolerance = fields_.number("at_least_n", 0.0, 1e6);
        }
    }

    void place(const char* key, Check check) {
        if (!is(key, check)) return;
        e_.vector = fields_.vector(key, true);
        e_.has_vector = true;
        e_.tolerance = fields_.number("within_m", 0.0, 1e6);
        e_.always = false;
    }
    void read_places() {
        place("body_at", Check::BodyAt);
        place("hip_at", Check::HipAt);
        place("proxy_at", Check::ProxyAt);
        if (is("heading_deg", Check::Heading)) {
            e_.low = fields_.number("heading_deg", -360.0, 360.0);
            e_.tolerance = fields_.number_or("within_deg", 0.5, 0.0, 180.0);
            e_.always = false;
        }
        if (is("touching", Check::Touching)) {
            e_.text = fields_.text("touching");
            e_.always = false;
        }
        flag("free", Check::Free);
        flag("told_apart", Check::Distinct);
        words("not_told_apart", Check::NotDistinct);
    }

    void read_when(const std::set<std::string>& names) {
        if (fields_.has("times")) e_.times = static_cast<int>(fields_.number("times", 0.0, 1e6));
        if (fields_.has("always")) e_.always = fields_.flag("always");
        e_.left = is_left(fields_);
        if (fields_.has("after")) e_.from = read_moment(fields_, "after", names);
        if (fields_.has("delay_s")) e_.from.offset_s += fields_.number("delay_s", 0.0, kLongest_s);
        if (fields_.has("before")) {
            e_.to = read_moment(fields_, "before", names);
            e_.has_to = true;
        }
        if (!fields_.has("within_s")) return;
        if (e_.has_to) throw BadField{e_.line, phrase("scenario.not_both")};
        e_.to = e_.from;
        e_.to.offset_s += fields_.number("within_s", 0.0, kLongest_s);
        e_.has_to = true;
    }

    TomlFields fields_;
    Expectation e_;
    int kinds_ = 0;
};

std::string toml_text(const settings::TomlValue& node) {
    if (const auto* v = node.text()) return *v;
    if (const auto* v = node.flag()) return *v ? "true" : "false";
    if (const auto* v = node.whole()) return fmt::format("{}", *v);
    if (const auto* v = node.fraction()) return fmt::format("{}", *v);
    throw BadField{node.line, phrase("scenario.setting")};
}

Scenario read_table(const settings::TomlValue& table, const fs::path& file,
                    const std::vector<fs::path>& world_folders) {
    const ScenarioFolders folders{file.parent_path(), world_folders};
    TomlFields fields(table, "scenario");
    Scenario scenario;
    scenario.file = file;
    scenario.title = fields.text("title");
    scenario.world.file = find_world(fields.text("world"), folders, fields.node("world").line);
    if (fields.has("building")) scenario.world.building = fields.text("building");
    if (fields.has("unit_m")) scenario.world.unit_m = fields.number("unit_m", kLeastUnit_m, kMostUnit_m);
    if (fields.has("map_scale_m_per_unit"))
        scenario.world.map_scale_m_per_unit = fields.number("map_scale_m_per_unit", kLeastUnit_m, kMostUnit_m);
    if (fields.has("device")) scenario.device = fields.text("device");
    if (fields.has("left_device")) scenario.left_device = fields.text("left_device");
    if (fields.has("start")) {
        const settings::TomlValue& start = fields.node("start");
        if (!start.table()) throw BadField{fields.node("start").line, phrase("scenario.start")};
        TomlFields inner(start, "start");
        scenario.has_start = true;
        scenario.start_feet_m = inner.vector("feet");
        scenario.start_heading_rad = radians_from_degrees(inner.number_or("heading_deg", 0.0, -360.0, 360.0));
        inner.done();
    }
    if (fields.has("acts_by")) {
        const std::string word = fields.text("acts_by");
        must_be_one_of(word, kActsBy, fields.node("acts_by").line, "scenario.no_acts_by");
        scenario.acts_by = static_cast<ActsBy>(std::find(kActsBy.begin(), kActsBy.end(), word) - kActsBy.begin());
    }
    if (fields.has("tail_s")) scenario.tail_s = fields.number("tail_s", 0.0, kLongest_s);
    if (fields.has("settings")) {
        const settings::TomlValue::Table* settings = fields.node("settings").table();
        if (!settings) throw BadField{fields.node("settings").line, phrase("scenario.settings")};
        for (const auto& [key, node] : *settings) scenario.settings[key] = toml_text(node);
    }
    const auto each = [&](const char* key, auto&& visit) {
        if (!fields.has(key)) return;
        const settings::TomlValue::Array* list = fields.node(key).array();
        if (!list) throw BadField{fields.node(key).line, phrase("scenario.tables", {{"key", key}})};
        for (const settings::TomlValue& item : *list) {
            if (!item.table()) throw BadField{item.line, phrase("scenario.tables", {{"key", key}})};
            visit(item);
        }
    };
    std::set<std::string> names;
    each("do", [&](const settings::TomlValue& item) {
        for (ScenarioAction& action : read_actions(item, folders, names)) scenario.actions.push_back(std::move(action));
    });
    each("expect",
         [&](const settings::TomlValue& item) { scenario.expectations.push_back(read_expectation(item, names)); });
    fields.done();
    if (scenario.expectations.empty()) throw BadField{0, phrase("scenario.expects_nothing")};
    return scenario;
}

}  // namespace

fs::path find_named_world(const std::string& name, const ScenarioFolders& folders, int line) {
    std::vector<fs::path> places{folders.beside, folders.beside / "worlds"};
    places.insert(places.end(), folders.others.begin(), folders.others.end());
    for (const fs::path& folder : places)
        if (std::error_code ec; fs::is_regular_file(folder / name, ec)) return folder / name;
    // A name without extension, such as "school", means school.map.
    for (const fs::path& folder : places)
        if (!fs::path(name).has_parent_path() && !fs::path(name).has_extension())
            for (const ShelvedWorld& world : worlds_in(folder))
                if (world.file.stem() == name) return world.file;
    // Search for the file name alone next to the scenario, because the scenario and the world may have been copied
    // together from elsewhere.
    if (fs::path beside = folders.beside / fs::path(name).filename(); fs::path(name).has_parent_path())
        if (std::error_code ec; fs::is_regular_file(beside, ec)) return beside;
    throw BadField{line, phrase("scenario.no_world", {{"name", name}})};
}

std::vector<ScenarioAction> read_actions(const settings::TomlValue& table, const ScenarioFolders& folders,
                                         std::set<std::string>& names) {
    std::vector<ScenarioAction> actions;
    if (table.find("sweep_at")) actions = read_sweep(table);
    else actions.push_back(read_action(table, folders));
    for (const ScenarioAction& action : actions)
        if (!action.name.empty() && !names.insert(action.name).second)
            throw BadField{table.line, phrase("scenario.two_actions", {{"name", action.name}})};
    return actions;
}

Expectation read_expectation(const settings::TomlValue& table, const std::set<std::string>& names) {
    return ExpectationReader(table).read(names);
}

Error no_toml(const Error& error, const std::string& file) {
    Error reported = error;
    reported.file = file;
    if (error.line > 0) reported.message = phrase("scenario.not_toml", {{"reason", one_line(error.message)}});
    return reported;
}

Result<Scenario> read_scenario(const fs::path& file, const std::vector<fs::path>& world_folders) {
    const auto text = read_whole_file(file, std::size_t{1} << 24);
    if (!text) return tl::unexpected(text.error());
    return read_scenario_text(*text, file, world_folders);
}

Result<Scenario> read_scenario_text(const std::string& text, const fs::path& file,
                                    const std::vector<fs::path>& world_folders) {
    const std::string name = file.filename().string();
    const Result<settings::TomlValue> table = settings::toml_of(text);
    if (!table) return tl::unexpected(no_toml(table.error(), name));
    try {
        return read_table(*table, file, world_folders);
    } catch (const BadField& bad) {
        return fail(bad.message, name, bad.line);
    }
}

}  // namespace handrail::core
