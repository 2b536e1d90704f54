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

namespace handrail::record {
namespace {

constexpr double kHandEvery_s = 0.1;   // interval between two moves of the hand in the scenario
constexpr double kHandMoved_m = 1e-3;  // smaller movements of the hand than this are ignored
constexpr double kTail_s = 5.0;        // time at the end of the scenario in which the last lines are spoken
constexpr std::size_t kMostExpected = 40;

// Returns a text as a TOML string. A JSON string is also valid in TOML unless JSON escapes the slash, which dump() does
// not.
std::string in_quotes(const std::string& text) {
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Returns a setting's value in TOML: numbers and booleans without quotes, everything else in quotes.
std::string as_value(const std::string& text) {
    double number = 0.0;
    return text == "true" || text == "false" || text.starts_with('"') || parse_finite(text, number) ? text
                                                                                                    : in_quotes(text);
}

struct Writer {
    const Recording& recording;
    double begun_s = 0.0;  // time at which the person entered the world
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

    void press(const core::CommandDown& down, double now_s, std::size_t at) {
        double up_s = now_s;
        for (std::size_t i = at + 1; i < inputs.size(); ++i)
            if (const auto* up = std::get_if<core::CommandUp>(&inputs[i].input); up && up->command == down.command) {
                up_s = inputs[i].now_s;
                break;
            }
        std::string what = fmt::format("press = {}\nfor_s = {:.3f}",
                                       in_quotes(std::string(core::info(down.command).word)), up_s - now_s);
        if (down.times > 1) what += fmt::format("\ntimes = {}", down.times);
        act(now_s, what);
    }

    void write(std::size_t at) {
        const double now_s = inputs[at].now_s;
        const core::SessionInput& input = inputs[at].input;
        if (const auto* down = std::get_if<core::CommandDown>(&input)) press(*down, now_s, at);
        else if (const auto* key = std::get_if<core::KeyTapped>(&input)) act(now_s, "key = " + in_quotes(key->key));
        else if (const auto* text = std::get_if<core::TextTyped>(&input)) act(now_s, "type = " + in_quotes(text->utf8));
        else if (const auto* line = std::get_if<core::LineTyped>(&input)) {
            act(now_s, "line = " + in_quotes(line->line));
        } else if (std::holds_alternative<core::ListsLeft>(input)) {
            act(now_s, "key = \"Escape\"");
        } else if (const auto* placed = std::get_if<core::Placed>(&input)) {
            const Vec3& feet = placed->feet_m;
            act(now_s, fmt::format("place = [{}, {}, {}]\nheading_deg = {}", feet.x, feet.y, feet.z,
                                   placed->heading_rad * 180.0 / 3.14159265358979323846));
        } else if (const auto* focus = std::get_if<core::FocusChanged>(&input)) {
            act(now_s, fmt::format("focus = {}", focus->focused));
        } else if (const auto* set = std::get_if<core::SettingSet>(&input)) {
            act(now_s, "set = " + in_quotes(set->key + "=" + set->value));
        } else if (std::holds_alternative<core::WorldEntered>(input)) {
            leave_out("replay.one_world");
        } else if (std::holds_alternative<core::Steered>(input) || std::holds_alternative<core::ItemActed>(input)) {
            leave_out("replay.no_sticks");
        } else if (const auto* act = std::get_if<core::TeacherActed>(&input)) {
            const bool lists =
                act->kind == core::TeacherActed::Kind::Offer || act->kind == core::TeacherActed::Kind::Learners;
            leave_out(lists ? "replay.no_offers" : "replay.no_lesson");
        } else if (std::holds_alternative<core::SettingsChanged>(input)) {
            leave_out("replay.no_settings");
        }
    }
};

// Returns the movements of the hand. Each of them goes from one position to the position a tenth of a second later.
std::vector<std::pair<double, std::string>> moves_of(const Recording& recording, double begun_s) {
    std::vector<std::pair<double, std::string>> moves;
    Vec3 was_m(0.0);
    double next_s = begun_s;
    bool known = false;
    for (const servo::HandRow& row : recording.hands[0]) {
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

// Removes the TOML tables that begin at these lines. A table ends at the next blank line.
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

// Reads a recording line by line. Collects which world the person entered and how, what the person did in it, and what
// the program answered.
class RecordingReader {
public:
    explicit RecordingReader(const Recording& recording)
        : recording_(recording), writer_{recording, 0.0, {}, {}, {}}, settings_(recording.head.settings) {
        // If no line reports that a room was entered, the rooms are known from the beginning. A scenario always knows
        // the rooms of its world at once. So answers that the program gave before it had found the rooms would differ,
        // and take_said() ignores them.
        rooms_known_ = std::none_of(recording.lines.begin(), recording.lines.end(), enters_room);
    }

    Result<ScenarioText> read(const std::string& title) {
        for (const RecordedLine& line : recording_.lines) {
            if (over_) break;
            if (const auto taken = take(line); !taken) return tl::unexpected(taken.error());
        }
        if (!entered()) return fail(phrase("replay.no_world"));
        std::erase_if(expected_, [&](const std::string& text) { return said_by_program_.contains(text); });
        if (expected_.empty()) return fail(phrase("replay.nothing_answered"));
        std::string toml = head_of(title);
        write_actions();
        toml += writer_.actions;
        return ScenarioText{std::move(toml), std::move(expected_), std::move(writer_.left_out)};
    }

private:
    static bool enters_room(const RecordedLine& line) { return line.is == "room_entered"; }
    bool entered() const { return !world_.file.empty(); }

    Result<void> take(const RecordedLine& line) {
        rooms_known_ = rooms_known_ || enters_room(line);
        if (line.is == "acts_by" && !entered()) {
            const auto who = Json::parse(line.json, nullptr, false).value("number", 0);
            acts_by_ = who == 1 ? "terminal-keys" : who == 2 ? "lines" : "window-keys";
        }
        if (line.is == "said") take_said(line);
        // The recording contains each key as an input. If no list used the key, "not_taken" follows, and then the key's
        // command as another input. So drop the key.
        if (line.is == "not_taken" && !writer_.inputs.empty()) writer_.inputs.pop_back();
        if (!is_input(line.is)) return {};
        auto input = read_input_line(line.json);
        if (!input) return fail(input.error().message, "events.jsonl", line.line);
        take_input(std::move(*input));
        return {};
    }

    // Adds an answer to the expectations if it was spoken at least half a second after the person entered the world. An
    // earlier answer may be the reply to an earlier action.
    void take_said(const RecordedLine& line) {
        if (!entered() || !expects_ || !rooms_known_) return;
        const Json json = Json::parse(line.json, nullptr, false);
        const std::string text = json.value("text", std::string());
        if (json.value("class", std::string()) == "answer" && json.value("voiced", false) &&
            text != phrase("rooms.not_yet") && text.find('|') == std::string::npos &&
            line.t_s + recording_.head.begun_s > writer_.begun_s + 0.5)
            expected_.push_back(text);
    }

    void take_input(RecordedInput input) {
        if (const auto* hand = std::get_if<core::HandChanged>(&input.input); hand && hand->hand.present && !entered())
            device_ = std::string(hand->hand.spec.name) == "sim-f" ? "sim-f" : "sim-t";
        // Remember what the program itself announced, because that is not an answer of the world.
        if (const auto* announcement = std::get_if<core::Announcement>(&input.input))
            said_by_program_.insert(announcement->text);
        if (const auto* world = std::get_if<core::WorldEntered>(&input.input)) {
            if (!entered()) {
                world_ = input.world.request;
                if (world->settings) settings_ = *world->settings;
                writer_.begun_s = input.now_s;
                return;
            }
            writer_.leave_out("replay.one_world");
            over_ = true;
        }
        if (!entered()) return;
        // The scenario must not contain the command Leave, which would end the scenario.
        if (const auto* down = std::get_if<core::CommandDown>(&input.input)) {
            expects_ = down->command != core::Command::Leave;
            if (!expects_) return;
        }
        last_s_ = input.now_s;
        writer_.inputs.push_back(std::move(input));
    }

    std::string head_of(const std::string& title) const {
        std::string toml = fmt::format("title = {}\nworld = {}\ndevice = {}\n", in_quotes(title),
                                       in_quotes(world_.file.string()), in_quotes(device_));
        if (!world_.building.empty()) toml += fmt::format("building = {}\n", in_quotes(world_.building));
        if (world_.unit_m) toml += fmt::format("unit_m = {}\n", *world_.unit_m);
        if (world_.map_scale_m_per_unit)
            toml += fmt::format("map_scale_m_per_unit = {}\n", *world_.map_scale_m_per_unit);
        toml += fmt::format("acts_by = {}\ntail_s = {}\n", in_quotes(acts_by_), kTail_s);
        const Json settings = Json::parse(settings_text(settings_), nullptr, false);
        if (const auto set = settings.find("set"); set != settings.end()) {
            toml += "\n[settings]\n";
            for (const auto& [key, value] : set->items())
                toml += fmt::format("{} = {}\n", in_quotes(key), as_value(value.get<std::string>()));
        }
        return toml;
    }

    // Writes keys and movements of the hand in the order of time, because the hand also moves while keys are held down.
    void write_actions() {
        const auto moves = moves_of(recording_, writer_.begun_s);
        std::size_t next = 0;
        const auto move_until = [&](double now_s) {
            for (; next < moves.size() && moves[next].first <= now_s; ++next)
                writer_.act(moves[next].first, moves[next].second);
        };
        for (std::size_t i = 0; i < writer_.inputs.size(); ++i) {
            move_until(writer_.inputs[i].now_s);
            writer_.write(i);
        }
        if (!over_) move_until(last_s_ + kTail_s);
    }

    const Recording& recording_;
    Writer writer_;
    core::WorldRequest world_;
    settings::Settings settings_;  // settings of the session, including those that the world brings
    std::string device_ = "none", acts_by_ = "window-keys";
    double last_s_ = 0.0;
    std::vector<std::string> expected_;
    std::set<std::string> said_by_program_;
    bool over_ = false, expects_ = true, rooms_known_ = false;
};

}  // namespace

Result<ScenarioText> scenario_of(const Recording& recording, const std::string& title) {
    return RecordingReader(recording).read(title);
}

std::string with_expectations(const ScenarioText& scenario) {
    std::string all;
    for (std::size_t i = 0; i < std::min(scenario.expected.size(), kMostExpected); ++i)
        all += (all.empty() ? "" : " | ") + scenario.expected[i];
    return scenario.toml + fmt::format("\n[[expect]]\nsay_in_order = {}\n", in_quotes(all));
}

std::vector<std::string> said_by_both(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    // longest[i][j] is the length of the longest common subsequence of a from i on and b from j on.
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

Result<ScenarioText> as_it_runs(ScenarioText scenario, const core::WorldReader& read) {
    const std::filesystem::path file = "recording.toml";
    const auto parsed = core::read_scenario_text(with_expectations(scenario), file, {});
    if (!parsed) return tl::unexpected(parsed.error());
    auto scene = read.scene(parsed->world);
    if (!scene) return tl::unexpected(scene.error());
    sinks::RecordingAudio audio;
    sinks::RecordingSpeech speech;
    std::vector<int> undone;
    const auto log =
        core::run_scenario(*parsed, std::make_shared<const Scene>(std::move(*scene)), audio, speech, read, {}, &undone);
    if (!log) return tl::unexpected(log.error());
    if (!undone.empty()) {
        scenario.toml = without_actions(scenario.toml, undone);
        scenario.left_out.push_back(phrase("replay.undone", {{"count", undone.size()}}));
    }
    std::vector<std::string> said;
    for (const sinks::HeardSpeech& line : speech.lines()) said.push_back(line.utterance.text);
    const std::size_t answers = scenario.expected.size();
    scenario.expected = said_by_both(scenario.expected, said);
    if (scenario.expected.empty()) return fail(phrase("replay.answers_otherwise"));
    if (const std::size_t others = answers - scenario.expected.size(); others > 0)
        scenario.left_out.push_back(phrase("replay.other_answers", {{"count", others}, {"all", answers}}));
    return scenario;
}

}  // namespace handrail::record
