#include "app/record/recorded_events.h"

#include "app/record/json_fields.h"
#include "worlds/base/text.h"

namespace handrail::record {
namespace {

class EventReader {
public:
    RecordedEvents read(const Recording& recording) {
        for (const RecordedLine& line : recording.lines) {
            if (events_.more_worlds) break;
            const Json json = Json::parse(line.json, nullptr, false);
            // Skip lines with missing fields. read_recording has reported this damage already.
            if (!json.is_object()) continue;
            try {
                take(line, json);
            } catch (const Json::exception&) {
            }
        }
        if (!events_.more_worlds) {
            if (!recording.lines.empty()) events_.to_s = recording.lines.back().t_s;
            if (!recording.frames.empty())
                events_.to_s = std::max(events_.to_s, recording.frames.back().now_s - recording.head.begun_s);
        }
        if (list_since_s_) list_ended(events_.to_s);
        add_speaking(recording);
        return std::move(events_);
    }

private:
    // Adds the times during which the voice was speaking. They are derived from the answers of SpeechSink::speaking().
    // The last answer in a step is valid until the next step with an answer.
    void add_speaking(const Recording& recording) {
        std::optional<double> since_s;
        for (const CueRow& row : recording.cues) {
            if (row.speaking == 0) continue;
            const double t_s = row.now_s - recording.head.begun_s;
            const bool speaks = (row.speaking & 1U) != 0;
            if (speaks && !since_s) since_s = t_s;
            if (speaks || !since_s) continue;
            events_.busy.push_back({*since_s, t_s});
            since_s.reset();
        }
        if (since_s) events_.busy.push_back({*since_s, events_.to_s});
    }
    void take(const RecordedLine& line, const Json& json) {
        if (line.is == "world_entered") return enter(line);
        if (!events_.world) return;
        if (line.is == "contact")
            events_.contacts.push_back({line.t_s, whole_of<std::uint32_t>(json.at("feature")), json.value("thing", ""),
                                        vec_of(json.at("at_m"))});
        if (line.is == "thing_visited")
            events_.visits.push_back({line.t_s, whole_of<std::uint32_t>(json.at("feature"))});
        if (line.is == "help_asked") events_.help_s.push_back(line.t_s);
        if (line.is == "command_down" && json.value("command", "") == "home") events_.home_s.push_back(line.t_s);
        if (line.is == "teleported") events_.leaps_s.push_back(line.t_s);
        if (line.is == "list_shown") {
            const bool open = json.at("open").get<bool>();
            if (!open && list_since_s_) list_ended(line.t_s);
            if (!open) list_since_s_.reset();
            else if (!list_since_s_) list_since_s_ = line.t_s;
        }
        if (line.is == "teacher") teacher(line, json);
        if (line.is == "led") {
            const std::string goal = json.at("goal").get<std::string>();
            // If guidance to the same goal was interrupted and resumes, it is still the same route.
            if (events_.ways.empty() || events_.ways.back().goal != goal || events_.ways.back().arrived_s)
                events_.ways.push_back({goal, line.t_s, {}});
        }
        if (line.is == "arrived" && !events_.ways.empty() && !json.value("to_nearest", false) &&
            events_.ways.back().goal == json.at("goal").get<std::string>())
            events_.ways.back().arrived_s = line.t_s;
    }
    void teacher(const RecordedLine& line, const Json& json) {
        const std::string act = json.value("act", "");
        if (act == "begin" && events_.lesson.empty()) events_.lesson = json.at("text").get<std::string>();
        if (act == "note") events_.notes.push_back({line.t_s, json.at("text").get<std::string>()});
        if (act != "result") return;
        const Json& items = json.at("items");
        RecordedTask task{line.t_s, items.at(0).get<std::string>(), json.at("text").get<std::string>(), {}};
        for (std::size_t i = 2; i < items.size(); ++i) {
            const auto item = items[i].get<std::string>();
            const std::size_t equals = item.find('=');
            double value = 0.0;
            if (equals != std::string::npos && parse_finite(item.substr(equals + 1), value))
                task.measures[item.substr(0, equals)] = value;
        }
        events_.tasks.push_back(std::move(task));
    }
    void list_ended(double t_s) {
        events_.lists.push_back({*list_since_s_, t_s});
        events_.busy.push_back(events_.lists.back());
    }
    void enter(const RecordedLine& line) {
        if (events_.world) {
            events_.more_worlds = true;
            events_.to_s = line.t_s;
            return;
        }
        auto input = read_input_line(line.json);
        if (!input) return;
        events_.world = std::move(input->world);
        events_.from_s = line.t_s;
    }

    RecordedEvents events_;
    std::optional<double> list_since_s_;
};

}  // namespace

RecordedEvents events_of(const Recording& recording) { return EventReader().read(recording); }

}  // namespace handrail::record
