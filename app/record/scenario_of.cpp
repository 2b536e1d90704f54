#include "app/record/scenario_of.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "app/core/scenario/scenario_run.h"
#include "app/record/input_text.h"
#include "app/record/json_fields.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

constexpr double kHandEvery_s = 0.1;   // one move of the hand
constexpr double kHandMoved_m = 1e-3;  // less is none
constexpr double kTail_s = 5.0;        // for what is still to be said
constexpr std::size_t kMostExpected = 40;

// A TOML string is a JSON string, but for the slash.
std::string in_quotes(const std::string& text) {
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

// A setting's value as TOML has it: a number and yes or no plainly, else in quotes.
std::string as_value(const std::string& text) {
    double number = 0.0;
    return text == "true" || text == "false" || text.starts_with('"') || parse_finite(text, number) ? text
                                                                                                    : in_quotes(text);
}

struct Writer {
    const Recording& recording;
    double begun_s = 0.0;  // of the world
    std::string actions;
    std::vector<std::string> left_out;
    std::vector<RecordedInput> inputs;

    void act(double now_s, const std::string& what) {
        actions += fmt::format("\n[[do]]\nat_s = {:.3f}\n{}\n", std::max(0.0, now_s - begun_s), what);
    }
    void leave_out(std::string_view why) {
        std::string sentence = phrase(why);
        if (std::find(left_out.begin(), left_out.end(), sentence) == left_out.end())
            left_out.push_back(std::move(sentence));
    }

    void press(const CommandDown& down, double now_s, std::size_t at) {
        double up_s = now_s;
        for (std::size_t i = at + 1; i < inputs.size(); ++i)
            if (const auto* up = std::get_if<CommandUp>(&inputs[i].input); up && up->command == down.command) {
                up_s = inputs[i].now_s;
                break;
            }
        std::string what =
            fmt::format("press = {}\nfor_s = {:.3f}", in_quotes(std::string(info(down.command).word)), up_s - now_s);
        if (down.times > 1) what += fmt::format("\ntimes = {}", down.times);
        act(now_s, what);
    }

    void write(std::size_t at) {
        const double now_s = inputs[at].now_s;
        const SessionInput& input = inputs[at].input;
        if (const auto* down = std::get_if<CommandDown>(&input)) press(*down, now_s, at);
        else if (const auto* key = std::get_if<KeyTapped>(&input)) act(now_s, "key = " + in_quotes(key->key));
        else if (const auto* text = std::get_if<TextTyped>(&input)) act(now_s, "type = " + in_quotes(text->utf8));
        else if (const auto* line = std::get_if<LineTyped>(&input)) {
            act(now_s, "line = " + in_quotes(line->line));
        } else if (std::holds_alternative<ListsLeft>(input)) {
            act(now_s, "key = \"Escape\"");
        } else if (const auto* placed = std::get_if<Placed>(&input)) {
            const Vec3& feet = placed->feet_m;
            act(now_s, fmt::format("place = [{}, {}, {}]\nheading_deg = {}", feet.x, feet.y, feet.z,
                                   placed->heading_rad * 180.0 / 3.14159265358979323846));
        } else if (const auto* focus = std::get_if<FocusChanged>(&input)) {
            act(now_s, fmt::format("focus = {}", focus->focused));
        } else if (const auto* set = std::get_if<SettingSet>(&input)) {
            act(now_s, "set = " + in_quotes(set->key + "=" + set->value));
        } else if (std::holds_alternative<WorldEntered>(input)) {
            leave_out("replay.one_world");
        } else if (std::holds_alternative<Steered>(input) || std::holds_alternative<ItemActed>(input)) {
            leave_out("replay.no_sticks");
        } else if (const auto* act = std::get_if<TeacherActed>(&input)) {
            const bool lists = act->kind == TeacherActed::Kind::Offer || act->kind == TeacherActed::Kind::Learners;
            leave_out(lists ? "replay.no_offers" : "replay.no_lesson");
        } else if (std::holds_alternative<SettingsChanged>(input)) {
            leave_out("replay.no_settings");
        }
    }
};

// Where the hand went, as moves between its places each tenth of a second.
std::vector<std::pair<double, std::string>> moves_of(const Recording& recording, double begun_s) {
    std::vector<std::pair<double, std::string>> moves;
    Vec3 was_m(0.0);
    double next_s = begun_s;
    bool known = false;
    for (const HandRow& row : recording.hands[0]) {
        if (row.time_s < next_s || !is_finite(row.sample.position_m)) continue;
        next_s = row.time_s + kHandEvery_s;
        const Vec3& to = row.sample.position_m;
        const double far_m = glm::length(to - was_m);
        if (known && far_m >= kHandMoved_m)
            moves.emplace_back(row.time_s - kHandEvery_s,
                               fmt::format("hand_to = [{:.6f}, {:.6f}, {:.6f}]\nspeed_m_per_s = {:.4f}", to.x, to.y,
                                           to.z, far_m / kHandEvery_s));
        if (!known || far_m >= kHandMoved_m) was_m = to;
        known = true;
    }
    return moves;
}

// The text without the tables that begin at these lines. A table ends at the next blank line.
std::string without_actions(const std::string& toml, const std::vector<int>& lines) {
    std::string kept;
    bool leaves = false;
    int number = 0;
    std::istringstream in(toml);
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (std::find(lines.begin(), lines.end(), number) != lines.end()) leaves = true;
        else if (line.empty()) leaves = false;
        if (!leaves) kept += line + "\n";
    }
    return kept;
}

}  // namespace

Result<ScenarioText> scenario_of(const Recording& recording, const std::string& title) {
    Writer writer{recording, 0.0, {}, {}, {}};
    WorldRequest world;
    Settings settings_then = recording.head.settings;  // with what the world brings
    std::string device = "none", acts_by = "window-keys";
    double last_s = 0.0;
    std::vector<std::string> expected;
    std::set<std::string> told_by_program;
    bool over = false, expects = true;
    // A scenario has the rooms of its world at once: what was answered before they were found it answers otherwise.
    const auto entered = [](const RecordedLine& line) { return line.is == "room_entered"; };
    bool rooms_known = std::none_of(recording.lines.begin(), recording.lines.end(), entered);
    for (const RecordedLine& line : recording.lines) {
        if (over) break;
        rooms_known = rooms_known || entered(line);
        if (line.is == "acts_by" && world.file.empty()) {
            const auto who = Json::parse(line.json, nullptr, false).value("number", 0);
            acts_by = who == 1 ? "terminal-keys" : who == 2 ? "lines" : "window-keys";
        }
        if (line.is == "said" && !world.file.empty() && expects && rooms_known) {
            const Json json = Json::parse(line.json, nullptr, false);
            const std::string text = json.value("text", std::string());
            if (json.value("class", std::string()) == "answer" && json.value("voiced", false) &&
                text != phrase("rooms.not_yet") && text.find('|') == std::string::npos &&
                line.t_s + recording.head.begun_s > writer.begun_s + 0.5)
                expected.push_back(text);
        }
        // What no list took is followed by its command.
        if (line.is == "not_taken" && !writer.inputs.empty()) writer.inputs.pop_back();
        if (!is_input(line.is)) continue;
        auto input = read_input_line(line.json);
        if (!input) return fail(input.error().message, "events.jsonl", line.line);
        if (const auto* hand = std::get_if<HandChanged>(&input->input);
            hand && hand->hand.present && world.file.empty())
            device = std::string(hand->hand.spec.name) == "sim-f" ? "sim-f" : "sim-t";
        // What the program itself told is not what the world answers.
        if (const auto* told = std::get_if<Told>(&input->input)) told_by_program.insert(told->text);
        if (std::holds_alternative<WorldEntered>(input->input)) {
            if (world.file.empty()) {
                world = input->world.request;
                if (const auto& own = std::get<WorldEntered>(input->input).settings) settings_then = *own;
                writer.begun_s = input->now_s;
                continue;
            }
            writer.leave_out("replay.one_world");
            over = true;
        }
        if (world.file.empty()) continue;
        // It ends by itself.
        if (const auto* down = std::get_if<CommandDown>(&input->input)) {
            expects = down->command != Command::Leave;
            if (!expects) continue;
        }
        last_s = input->now_s;
        writer.inputs.push_back(std::move(*input));
    }
    if (world.file.empty()) return fail(phrase("replay.no_world"));
    std::erase_if(expected, [&](const std::string& text) { return told_by_program.contains(text); });
    if (expected.empty()) return fail(phrase("replay.nothing_answered"));

    std::string toml = fmt::format("title = {}\nworld = {}\ndevice = {}\n", in_quotes(title),
                                   in_quotes(world.file.string()), in_quotes(device));
    if (!world.building.empty()) toml += fmt::format("building = {}\n", in_quotes(world.building));
    if (world.unit_m) toml += fmt::format("unit_m = {}\n", *world.unit_m);
    if (world.map_scale_m_per_unit) toml += fmt::format("map_scale_m_per_unit = {}\n", *world.map_scale_m_per_unit);
    toml += fmt::format("acts_by = {}\ntail_s = {}\n", in_quotes(acts_by), kTail_s);
    const Json settings = Json::parse(settings_text(settings_then), nullptr, false);
    if (const auto set = settings.find("set"); set != settings.end()) {
        toml += "\n[settings]\n";
        for (const auto& [key, value] : set->items())
            toml += fmt::format("{} = {}\n", in_quotes(key), as_value(value.get<std::string>()));
    }
    // Actions in the order of their times.
    const auto moves = moves_of(recording, writer.begun_s);
    std::size_t next = 0;
    const auto move_until = [&](double now_s) {
        for (; next < moves.size() && moves[next].first <= now_s; ++next) {
            writer.act(moves[next].first, moves[next].second);
            // The hand moves while keys are pressed.
        }
    };
    for (std::size_t i = 0; i < writer.inputs.size(); ++i) {
        move_until(writer.inputs[i].now_s);
        writer.write(i);
    }
    if (!over) move_until(last_s + kTail_s);
    toml += writer.actions;
    return ScenarioText{std::move(toml), std::move(expected), std::move(writer.left_out)};
}

std::string with_expectations(const ScenarioText& scenario) {
    std::string all;
    for (std::size_t i = 0; i < std::min(scenario.expected.size(), kMostExpected); ++i)
        all += (all.empty() ? "" : " | ") + scenario.expected[i];
    return scenario.toml + fmt::format("\n[[expect]]\nsay_in_order = {}\n", in_quotes(all));
}

std::vector<std::string> said_by_both(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    // longest[i][j]: of what is common to a from i on and b from j on.
    std::vector<std::vector<std::size_t>> longest(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = a.size(); i-- > 0;)
        for (std::size_t j = b.size(); j-- > 0;)
            longest[i][j] = a[i] == b[j] ? longest[i + 1][j + 1] + 1 : std::max(longest[i + 1][j], longest[i][j + 1]);
    std::vector<std::string> both;
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
        if (a[i] == b[j]) both.push_back(a[i]), ++i, ++j;
        else if (longest[i + 1][j] >= longest[i][j + 1]) ++i;
        else ++j;
    }
    return both;
}

Result<ScenarioText> as_it_runs(ScenarioText scenario, const WorldReader& read) {
    const std::filesystem::path file = "recording.toml";
    const auto parsed = read_scenario_text(with_expectations(scenario), file, {});
    if (!parsed) return tl::unexpected(parsed.error());
    auto scene = read.scene(parsed->world);
    if (!scene) return tl::unexpected(scene.error());
    RecordingAudio audio;
    RecordingSpeech speech;
    std::vector<int> undone;
    const auto log =
        run_scenario(*parsed, std::make_shared<const Scene>(std::move(*scene)), audio, speech, read, {}, &undone);
    if (!log) return tl::unexpected(log.error());
    if (!undone.empty()) {
        scenario.toml = without_actions(scenario.toml, undone);
        scenario.left_out.push_back(phrase("replay.undone", {{"count", undone.size()}}));
    }
    std::vector<std::string> said;
    for (const HeardSpeech& line : speech.lines()) said.push_back(line.utterance.text);
    const std::size_t answers = scenario.expected.size();
    scenario.expected = said_by_both(scenario.expected, said);
    if (scenario.expected.empty()) return fail(phrase("replay.answers_otherwise"));
    if (const std::size_t others = answers - scenario.expected.size(); others > 0)
        scenario.left_out.push_back(phrase("replay.other_answers", {{"count", others}, {"all", answers}}));
    return scenario;
}

}  // namespace handrail
