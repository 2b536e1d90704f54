// Writes lessons as text; see lesson_file.h.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/teaching/lesson_file.h"

namespace handrail::teaching {
namespace {

// Returns a text of a single line as a TOML string.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + "\"";
}

std::string number(double value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

std::string vector(const Vec3& v) { return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z)); }

std::string names(const std::vector<std::string>& list) {
    std::string text = "[";
    for (std::size_t i = 0; i < list.size(); ++i) text += (i ? ", " : "") + quoted(list[i]);
    return text + "]";
}

void put(std::string& out, const char* key, const LessonText& text) {
    if (text.text.empty()) return;
    out += fmt::format("{} = {}\n", key, quoted(text.text));
    for (const TextIn& other : text.others) out += fmt::format("{}_{} = {}\n", key, other.language, quoted(other.text));
}

std::string place_fields(const LessonPlace& place, const char* between) {
    std::vector<std::string> fields;
    if (!place.thing.empty()) fields.push_back("thing = " + quoted(place.thing));
    if (!place.room.empty()) fields.push_back("room = " + quoted(place.room));
    if (place.name != place.thing + place.room) fields.insert(fields.begin(), "name = " + quoted(place.name));
    if (place.place_m) fields.push_back("place_m = " + vector(*place.place_m));
    return fmt::format("{}", fmt::join(fields, between));
}

void put_settings(std::string& out, const std::map<std::string, std::string>& settings, const char* table) {
    if (settings.empty()) return;
    out += fmt::format("\n[{}]\n", table);
    for (const auto& [key, value] : settings) out += fmt::format("{} = {}\n", quoted(key), quoted(value));
}

void put_step(std::string& out, const TaughtStep& step) {
    out += fmt::format("\n[[session.step]]\ndo = \"{}\"\n", kStepWords.at(static_cast<std::size_t>(step.kind)));
    put(out, "say", step.say);
    switch (step.kind) {
        case StepKind::Learn:
            out += "room = " + quoted(step.room) + "\n";
            if (step.walls_percent > 0 && step.exits > 0)
                out += fmt::format("done = {{ walls_percent = {}, exits = {} }}\n", step.walls_percent, step.exits);
            else if (step.walls_percent > 0)
                out += fmt::format("done = {{ walls_percent = {} }}\n", step.walls_percent);
            else if (step.exits > 0) out += fmt::format("done = {{ exits = {} }}\n", step.exits);
            break;
        case StepKind::Go:
            out += fmt::format("route = {}\nhelp_percent = [{}]\n", quoted(step.route),
                               fmt::join(step.help_percent, ", "));
            if (!step.block.empty()) out += "block = " + names(step.block) + "\n";
            out += fmt::format("off_route_m = {}\n", number(step.off_route_m));
            break;
        case StepKind::Point:
        case StepKind::Distance:
            out += fmt::format("from = {}\nto = {}\n", quoted(step.from), names(step.to));
            if (step.along_way) out += "along_way = true\n";
            if (step.pass_deg) out += fmt::format("pass_deg = {}\n", number(*step.pass_deg));
            break;
        case StepKind::Order:
            out += "of = " + names(step.to) + "\n";
            break;
        case StepKind::Question:
            if (step.scale) out += fmt::format("scale = [{}, {}]\n", (*step.scale)[0], (*step.scale)[1]);
            break;
        case StepKind::Free:
            break;
    }
}

}  // namespace

std::string lesson_text(const LessonFile& lesson) {
    std::string out = fmt::format("handrail_lesson = {}\n", LessonFile::kForm);
    put(out, "title", lesson.title);
    out += "world = " + quoted(lesson.world_name) + "\n";
    if (!lesson.world_checksum.empty()) out += "world_checksum = " + quoted(lesson.world_checksum) + "\n";
    if (lesson.base_feet_m) {
        out += fmt::format("base = {{ feet = {}, heading_deg = {}", vector(*lesson.base_feet_m),
                           number(degrees_from_radians(lesson.base_heading_rad)));
        out += lesson.base_name.empty() ? " }\n" : ", name = " + quoted(lesson.base_name) + " }\n";
    }
    put_settings(out, lesson.settings, "settings");
    for (const LessonPlace& landmark : lesson.landmarks)
        out += "\n[[landmark]]\n" + place_fields(landmark, "\n") + "\n";
    for (const LessonRoute& route : lesson.routes) {
        out += "\n[[route]]\nname = " + quoted(route.name) + "\nstops = [\n";
        for (const LessonPlace& stop : route.stops) out += "  { " + place_fields(stop, ", ") + " },\n";
        out += "]\n";
    }
    for (const TaughtSession& session : lesson.sessions) {
        out += "\n[[session]]\nname = " + quoted(session.name) + "\n";
        if (session.minutes > 0) out += fmt::format("minutes = {}\n", session.minutes);
        if (session.shuffle) out += "order = \"shuffle\"\n";
        put_settings(out, session.settings, "session.settings");
        for (const TaughtStep& step : session.steps) put_step(out, step);
    }
    return out;
}

}  // namespace handrail::teaching
