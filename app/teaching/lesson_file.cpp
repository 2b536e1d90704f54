#include "app/teaching/lesson_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "app/core/scenario/scenario_parts.h"
#include "app/core/scenario/toml_fields.h"
#include "settings/settings.h"
#include "worlds/base/files.h"

namespace handrail::teaching {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestText = 2000;  // longest sentence that a lesson can contain, in bytes
constexpr int kMostLaps = 20;

[[noreturn]] void bad(const settings::TomlValue& node, std::string message) {
    throw core::BadField{node.line, std::move(message)};
}

// Returns the text as a single line that can be spoken.
std::string line_of_text(const settings::TomlValue& node, const std::string& text) {
    if (text.size() > kLongestText || !is_utf8(text)) bad(node, phrase("teaching.long_text", {{"most", kLongestText}}));
    std::string line = one_line(text);
    if (line.empty()) bad(node, phrase("teaching.empty_text"));
    return line;
}

std::string name_in(core::TomlFields& fields, const char* key) {
    return line_of_text(fields.node(key), fields.text(key));
}

// Reads the text under `key`, and its translations under keys such as key_de.
LessonText text_in(const settings::TomlValue& table, core::TomlFields& fields, const char* key) {
    LessonText text;
    if (fields.has(key)) text.text = name_in(fields, key);
    for (const auto& [name, node] : *table.table()) {
        const std::string head = std::string(key) + "_";
        if (name.size() != head.size() + 2 || !name.starts_with(head)) continue;
        text.others.push_back({name.substr(head.size()), name_in(fields, name.c_str())});
    }
    // If there are translations but no main text, this call reports that `key` is missing.
    if (text.text.empty() && !text.others.empty()) fields.node(key);
    return text;
}

int whole(core::TomlFields& fields, const char* key, int low, int high) {
    const double number = fields.number(key, low, high);
    if (number != std::floor(number)) bad(fields.node(key), phrase("teaching.whole", {{"key", key}}));
    return static_cast<int>(number);
}

template <class Visit>
void each_table(core::TomlFields& fields, const char* key, std::size_t most, Visit visit) {
    if (!fields.has(key)) return;
    const settings::TomlValue::Array* list = fields.node(key).array();
    if (!list) bad(fields.node(key), phrase("scenario.tables", {{"key", key}}));
    if (list->size() > most) bad(fields.node(key), phrase("teaching.too_many", {{"key", key}, {"most", most}}));
    for (const settings::TomlValue& item : *list) {
        if (!item.table()) bad(item, phrase("scenario.tables", {{"key", key}}));
        visit(item);
    }
}

std::vector<std::string> names_in(core::TomlFields& fields, const char* key) {
    const settings::TomlValue& node = fields.node(key);
    const settings::TomlValue::Array* list = node.array();
    if (!list || list->empty() || list->size() > LessonFile::kMostPlaces)
        bad(node, phrase("teaching.names", {{"key", key}}));
    std::vector<std::string> names;
    for (const settings::TomlValue& one : *list) {
        if (!one.text()) bad(one, phrase("teaching.names", {{"key", key}}));
        names.push_back(line_of_text(one, *one.text()));
    }
    return names;
}

const settings::TomlValue& table_in(core::TomlFields& fields, const char* key) {
    const settings::TomlValue& node = fields.node(key);
    if (!node.table()) bad(node, phrase("teaching.table", {{"key", key}}));
    return node;
}

// Returns true if a lesson may set `key`. A lesson must not change the strength of forces, what the person hears, or
// how fast.
bool may_be_set(std::string_view key) {
    for (const std::string_view topic : {"haptic.", "speech.", "sound.", "keyboard.", "welcome.", "desk.", "profile."})
        if (key.starts_with(topic)) return false;
    return key != "guidance.strength";
}

std::map<std::string, std::string> settings_in(core::TomlFields& fields) {
    std::map<std::string, std::string> settings;
    if (!fields.has("settings")) return settings;
    settings::SettingsStore tried;
    for (const auto& [key, node] : *table_in(fields, "settings").table()) {
        std::string value;
        if (node.text()) value = *node.text();
        else if (node.flag()) value = *node.flag() ? "true" : "false";
        else if (node.whole()) value = fmt::format("{}", *node.whole());
        else if (node.fraction()) value = fmt::format("{}", *node.fraction());
        else bad(node, phrase("scenario.setting"));
        if (!may_be_set(key)) bad(node, phrase("teaching.not_set_here", {{"key", key}}));
        if (const auto set = tried.set(key, value, settings::SettingSource::CommandLine); !set)
            bad(node, set.error().message);
        settings[key] = value;
    }
    return settings;
}

LessonPlace place_in(const settings::TomlValue& table, const char* what) {
    core::TomlFields fields(table, what);
    LessonPlace place;
    place.line = fields.line();
    if (fields.has("name")) place.name = name_in(fields, "name");
    int kinds = 0;
    if (fields.has("thing")) ++kinds, place.thing = name_in(fields, "thing");
    if (fields.has("room")) ++kinds, place.room = name_in(fields, "room");
    if (fields.has("place_m")) {
        place.place_m = fields.vector("place_m");
        for (int i = 0; i < 3; ++i)
            if (std::abs((*place.place_m)[i]) > 1e5) bad(fields.node("place_m"), phrase("teaching.far_place"));
    }
    fields.done();
    if (kinds > 1 || (kinds == 0 && (!place.place_m || place.name.empty()))) bad(table, phrase("teaching.one_place"));
    if (place.name.empty()) place.name = place.thing + place.room;
    return place;
}

LessonRoute route_in(const settings::TomlValue& table) {
    core::TomlFields fields(table, "route");
    LessonRoute route;
    route.line = fields.line();
    route.name = name_in(fields, "name");
    each_table(fields, "stops", LessonFile::kMostPlaces,
               [&](const settings::TomlValue& item) { route.stops.push_back(place_in(item, "stop")); });
    if (route.stops.empty()) fields.node("stops"), bad(table, phrase("teaching.no_stop"));
    fields.done();
    return route;
}

StepKind kind_in(core::TomlFields& fields) {
    const std::string word = fields.text("do");
    for (std::size_t i = 0; i < kStepWords.size(); ++i)
        if (word == kStepWords[i]) return static_cast<StepKind>(i);
    bad(fields.node("do"),
        phrase("teaching.no_step",
               {{"word", one_line(word)},
                {"nearest", nearest_name(word, std::vector<std::string>(kStepWords.begin(), kStepWords.end()))}}));
}

// Returns the help in each lap, in percent. The last lap has none.
std::vector<int> laps_in(core::TomlFields& fields) {
    std::vector<int> help{0};
    if (fields.has("help_percent")) {
        const settings::TomlValue::Array* list = fields.node("help_percent").array();
        if (!list || list->empty() || list->size() > kMostLaps)
            bad(fields.node("help_percent"), phrase("teaching.percents"));
        help.clear();
        for (const settings::TomlValue& node : *list) {
            const std::int64_t* percent = node.whole();
            if (!percent || *percent < 0 || *percent > 100) bad(node, phrase("teaching.percents"));
            help.push_back(static_cast<int>(*percent));
        }
    }
    if (fields.has("laps")) help.resize(static_cast<std::size_t>(whole(fields, "laps", 1, kMostLaps)), help.back());
    help.back() = 0;
    return help;
}

TaughtStep step_in(const settings::TomlValue& table, const LessonFile& lesson) {
    core::TomlFields fields(table, "step");
    TaughtStep step;
    step.line = fields.line();
    step.kind = kind_in(fields);
    step.say = text_in(table, fields, "say");
    switch (step.kind) {
        case StepKind::Learn:
            step.room = name_in(fields, "room");
            if (fields.has("done")) {
                core::TomlFields done(table_in(fields, "done"), "done");
                if (done.has("walls_percent")) step.walls_percent = whole(done, "walls_percent", 1, 100);
                if (done.has("exits")) step.exits = whole(done, "exits", 1, 100);
                done.done();
            }
            break;
        case StepKind::Go: {
            step.route = name_in(fields, "route");
            if (!lesson.route(step.route)) {
                std::vector<std::string> known;
                for (const LessonRoute& route : lesson.routes) known.push_back(route.name);
                bad(fields.node("route"),
                    phrase("teaching.no_route", {{"name", step.route}, {"nearest", nearest_name(step.route, known)}}));
            }
            step.help_percent = laps_in(fields);
            if (fields.has("block")) step.block = names_in(fields, "block");
            if (fields.has("off_route_m")) step.off_route_m = fields.number("off_route_m", 0.5, 20.0);
            break;
        }
        case StepKind::Free:
            break;
        case StepKind::Point:
        case StepKind::Distance:
            step.from = name_in(fields, "from");
            step.to = names_in(fields, "to");
            if (step.kind == StepKind::Distance && fields.has("along_way")) step.along_way = fields.flag("along_way");
            if (step.kind == StepKind::Point && fields.has("pass_deg"))
                step.pass_deg = fields.number("pass_deg", 1.0, 180.0);
            break;
        case StepKind::Order:
            step.to = names_in(fields, "of");
            if (step.to.size() < 2) bad(fields.node("of"), phrase("teaching.two_to_order"));
            for (std::size_t i = 0; i < step.to.size(); ++i)
                if (std::find(step.to.begin(), step.to.begin() + static_cast<std::ptrdiff_t>(i), step.to[i]) !=
                    step.to.begin() + static_cast<std::ptrdiff_t>(i))
                    bad(fields.node("of"), phrase("teaching.twice", {{"name", step.to[i]}}));
            break;
        case StepKind::Question:
            if (step.say.text.empty()) fields.node("say");
            if (fields.has("scale")) {
                const auto range = fields.range("scale");
                if (range[0] != std::floor(range[0]) || range[1] != std::floor(range[1]) || range[0] < -1000.0 ||
                    range[1] > 1000.0 || range[0] == range[1])
                    bad(fields.node("scale"), phrase("teaching.scale"));
                step.scale = {static_cast<int>(range[0]), static_cast<int>(range[1])};
            }
            break;
    }
    fields.done();
    return step;
}

TaughtSession session_in(const settings::TomlValue& table, const LessonFile& lesson, std::size_t& steps) {
    core::TomlFields fields(table, "session");
    TaughtSession session;
    session.line = fields.line();
    session.name = name_in(fields, "name");
    if (fields.has("minutes")) session.minutes = whole(fields, "minutes", 1, 600);
    if (fields.has("order")) {
        const std::string order = fields.text("order");
        if (order != "shuffle" && order != "written") bad(fields.node("order"), phrase("teaching.order"));
        session.shuffle = order == "shuffle";
    }
    session.settings = settings_in(fields);
    each_table(fields, "step", LessonFile::kMostSteps, [&](const settings::TomlValue& item) {
        session.steps.push_back(step_in(item, lesson));
        if (++steps > LessonFile::kMostSteps)
            bad(item, phrase("teaching.too_many", {{"key", "step"}, {"most", LessonFile::kMostSteps}}));
    });
    if (session.steps.empty()) fields.node("step"), bad(table, phrase("teaching.no_steps"));
    fields.done();
    return session;
}

PupilExpectation measured_in(const settings::TomlValue& table) {
    core::TomlFields fields(table, "expectation");
    PupilExpectation expected;
    expected.line = fields.line();
    if (fields.has("strategy") == fields.has("measure")) bad(table, phrase("teaching.one_measure"));
    if (fields.has("strategy")) {
        expected.strategy = fields.text("strategy");
        const std::vector<std::string> known{"perimeter", "grid", "object", "base"};
        if (std::find(known.begin(), known.end(), expected.strategy) == known.end())
            bad(fields.node("strategy"),
                phrase("teaching.no_strategy",
                       {{"word", one_line(expected.strategy)}, {"nearest", nearest_name(expected.strategy, known)}}));
        expected.at_least = fields.number("share", 0.0, 1.0);
    } else {
        expected.measure = name_in(fields, "measure");
        if (fields.has("step")) expected.step = whole(fields, "step", 1, static_cast<int>(LessonFile::kMostSteps));
        if (!fields.has("at_least") && !fields.has("at_most")) fields.node("at_least");
        if (fields.has("at_least")) expected.at_least = fields.number("at_least", -1e9, 1e9);
        if (fields.has("at_most")) expected.at_most = fields.number("at_most", -1e9, 1e9);
    }
    fields.done();
    return expected;
}

LessonPupil pupil_in(const settings::TomlValue& table, const LessonFile& lesson, const core::ScenarioFolders& folders) {
    core::TomlFields fields(table, "pupil");
    LessonPupil pupil;
    pupil.line = fields.line();
    pupil.name = name_in(fields, "name");
    pupil.session = name_in(fields, "session");
    std::vector<std::string> known;
    for (const TaughtSession& session : lesson.sessions) known.push_back(session.name);
    if (std::find(known.begin(), known.end(), pupil.session) == known.end())
        bad(fields.node("session"),
            phrase("teaching.no_session", {{"name", pupil.session}, {"nearest", nearest_name(pupil.session, known)}}));
    std::set<std::string> names;
    each_table(fields, "do", 1000, [&](const settings::TomlValue& item) {
        for (core::ScenarioAction& action : core::read_actions(item, folders, names))
            pupil.actions.push_back(std::move(action));
    });
    each_table(fields, "expect", 1000, [&](const settings::TomlValue& item) {
        if (item.find("strategy") || item.find("measure")) pupil.measured.push_back(measured_in(item));
        else pupil.expectations.push_back(core::read_expectation(item, names));
    });
    fields.done();
    if (pupil.expectations.empty() && pupil.measured.empty()) bad(table, phrase("teaching.expects_nothing"));
    return pupil;
}

template <class List>
void no_name_twice(const List& list) {
    std::set<std::string> names;
    for (const auto& one : list)
        if (!names.insert(one.name).second)
            throw core::BadField{one.line, phrase("teaching.twice", {{"name", one.name}})};
}

LessonFile lesson_in(const settings::TomlValue& table, const fs::path& file, const core::ScenarioFolders& folders) {
    core::TomlFields fields(table, "lesson");
    LessonFile lesson;
    lesson.file = file;
    if (whole(fields, "handrail_lesson", 0, 1000000) != LessonFile::kForm)
        bad(fields.node("handrail_lesson"), phrase("teaching.other_form"));
    lesson.title = text_in(table, fields, "title");
    if (lesson.title.text.empty()) fields.node("title");
    lesson.world_name = fields.text("world");
    if (lesson.world_name.find('\0') != std::string::npos || !is_utf8(lesson.world_name) ||
        one_line(lesson.world_name) != lesson.world_name)
        bad(fields.node("world"), phrase("teaching.empty_text"));
    lesson.world = core::find_named_world(lesson.world_name, folders, fields.node("world").line);
    if (fields.has("world_checksum")) lesson.world_checksum = name_in(fields, "world_checksum");
    if (fields.has("base")) {
        core::TomlFields base(table_in(fields, "base"), "base");
        lesson.base_feet_m = base.vector("feet");
        lesson.base_heading_rad = radians_from_degrees(base.number_or("heading_deg", 0.0, -360.0, 360.0));
        if (base.has("name")) lesson.base_name = name_in(base, "name");
        base.done();
    }
    lesson.settings = settings_in(fields);
    each_table(fields, "landmark", LessonFile::kMostPlaces,
               [&](const settings::TomlValue& item) { lesson.landmarks.push_back(place_in(item, "landmark")); });
    each_table(fields, "route", LessonFile::kMostPlaces,
               [&](const settings::TomlValue& item) { lesson.routes.push_back(route_in(item)); });
    if (lesson.landmarks.empty()) throw core::BadField{1, phrase("teaching.no_landmark")};
    no_name_twice(lesson.landmarks);
    no_name_twice(lesson.routes);
    std::size_t steps = 0;
    each_table(fields, "session", LessonFile::kMostSessions,
               [&](const settings::TomlValue& item) { lesson.sessions.push_back(session_in(item, lesson, steps)); });
    if (lesson.sessions.empty()) throw core::BadField{1, phrase("teaching.no_sessions")};
    no_name_twice(lesson.sessions);
    each_table(fields, "as", LessonFile::kMostPlaces,
               [&](const settings::TomlValue& item) { lesson.pupils.push_back(pupil_in(item, lesson, folders)); });
    fields.done();
    return lesson;
}

}  // namespace

const LessonRoute* LessonFile::route(std::string_view name) const {
    for (const LessonRoute& one : routes)
        if (one.name == name) return &one;
    return nullptr;
}

Result<LessonFile> read_lesson_text(const std::string& text, const fs::path& file,
                                    const std::vector<fs::path>& world_folders, const settings::TomlReader& toml) {
    const std::string name = file.filename().string();
    const Result<settings::TomlValue> table = toml(text);
    if (!table) return tl::unexpected(core::no_toml(table.error(), name));
    try {
        return lesson_in(*table, file, {file.parent_path(), world_folders});
    } catch (const core::BadField& mistake) {
        return fail(mistake.message, name, mistake.line);
    }
}

Result<LessonFile> read_lesson(const fs::path& file, const std::vector<fs::path>& world_folders,
                               const settings::TomlReader& toml) {
    const auto text = read_whole_file(file, std::size_t{1} << 24);
    if (!text) return tl::unexpected(text.error());
    return read_lesson_text(*text, file, world_folders, toml);
}

std::vector<std::size_t> step_order(const TaughtSession& session, std::size_t session_index, std::uint64_t learner) {
    std::vector<std::size_t> order(session.steps.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!session.shuffle) return order;
    // Shuffle with SplitMix64 (Steele, Lea, Flood 2014), which gives the same order on every machine. The order of
    // std::shuffle differs between implementations.
    std::uint64_t state = learner * 0x9e3779b97f4a7c15U + session_index + 1;
    const auto next = [&] {
        std::uint64_t z = (state += 0x9e3779b97f4a7c15U);
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31U);
    };
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[next() % i]);
    return order;
}

std::vector<std::pair<std::string, std::string>> conditions_of(const LessonFile& lesson, std::size_t session) {
    std::map<std::string, std::string> all = lesson.sessions.at(session).settings;
    all.insert(lesson.settings.begin(), lesson.settings.end());
    return {all.begin(), all.end()};
}

}  // namespace handrail::teaching
