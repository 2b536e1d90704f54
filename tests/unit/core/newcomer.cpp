#include "tests/unit/core/newcomer.h"

#include <cctype>
#include <cmath>
#include <regex>
#include <utility>

#include "app/core/scenario/session_log.h"
#include "tests/support/names.h"
#include "tests/support/worlds_once.h"

namespace handrail::test {
namespace {

// Returns true if `text` begins with the whole words `with`: "Stairs" does not begin with "Stair".
bool begins(const std::string& text, const std::string& with) {
    return text.rfind(with, 0) == 0 &&
           (text.size() == with.size() || std::isalnum(static_cast<unsigned char>(text[with.size()])) == 0);
}

// Returns "Kitchen" for "Route to which room. Kitchen, 12 steps, 1 of 5" and for "Kitchen, 12 steps, 1 of 5".
std::string entry_of(std::string spoken) {
    static const std::regex count(", \\d+ of \\d+\\s*$");
    return std::regex_replace(spoken, count, "");
}

}  // namespace

Newcomer::Newcomer(std::shared_ptr<const Scene> world, const std::filesystem::path& records, const HandFacts& hand) {
    session_ = std::make_unique<HeadlessSession>(Settings{}, hand, audio_, speech_,
                                                 test::with_known_rooms({.records_in = records}));
    session_->app().apply(WorldEntered{make_ready(std::move(world))}, 0.0);
    wait(1.0);
}

void Newcomer::wait(double seconds) {
    for (const double until = session_->now_s() + seconds; session_->now_s() < until - 1e-9;) session_->advance();
}

void Newcomer::tap(const std::string& key, double then_s) {
    session_->tap_key(key);
    wait(then_s);
}

void Newcomer::hold(const std::string& key, double seconds) {
    const auto command = session_->app().keys().find(key);
    if (!command) return;
    session_->press(*command);
    wait(seconds);
    session_->app().apply(CommandUp{*command}, session_->now_s());
    wait(0.2);
}

std::string Newcomer::request(const std::string& key, double listen_s) {
    const std::size_t before = lines();
    tap(key, listen_s);
    std::string all;
    for (std::size_t i = before; i < lines(); ++i) all += (all.empty() ? "" : " ") + line(i);
    return all;
}

bool Newcomer::heard(const std::string& words, std::size_t since) const {
    for (std::size_t i = since; i < lines(); ++i)
        if (words_in_order(words, line(i))) return true;
    return false;
}

std::string Newcomer::last_lines(std::size_t count) const {
    std::string all;
    for (std::size_t i = lines() > count ? lines() - count : 0; i < lines(); ++i) all += line(i) + "\n";
    return all;
}

// Parses "Facing north, 12 degrees".
double Newcomer::heading_deg() {
    static const std::regex degrees("(\\d+) degrees");
    const std::string text = request("C", 0.2);
    std::smatch found;
    return std::regex_search(text, found, degrees) ? std::stod(found[1]) : 0.0;
}

void Newcomer::turn(double right_deg) {
    if (std::abs(right_deg) < 3.0) return;
    const double goal = heading_deg() + right_deg;
    for (int i = 0; i < 60; ++i) {
        const double off = std::remainder(goal - heading_deg(), 360.0);
        if (std::abs(off) <= 3.0) return;
        const bool large = std::abs(off) > 20.0;
        tap(off > 0 ? (large ? "Right" : "Alt+Right") : (large ? "Left" : "Alt+Left"), 0.3);
    }
}

bool Newcomer::bumped_since(std::size_t sounds) const {
    for (std::size_t i = sounds; i < audio_.sounds().size(); ++i)
        if (audio_.sounds()[i].cue.kind == SoundKind::Bump) return true;
    return false;
}

bool Newcomer::walk(int steps) {
    for (int i = 0; i < steps; ++i) {
        const std::size_t sounds = audio_.sounds().size(), said = lines();
        tap("Up", 0.9);
        if (heard("Step again to go over the edge", said)) {
            if (!over_edges_) return true;
            tap("Up", 1.2);
            continue;
        }
        if (!bumped_since(sounds)) continue;
        if (heard_of_lock(said)) return true;
        // If the leaf of an open door blocks the newcomer, the Use key is not pressed, because it would shut the door.
        if (!heard("open", said) && (heard("shut", said) || heard("door", said) || door_ahead())) {
            const std::string answer = request("Enter", 3.0);
            if (heard_of_lock(said)) return true;
            if (answer.find("opens") != std::string::npos || answer.find("Left") != std::string::npos) {
                tap("Up", 0.9);
                continue;
            }
        }
        return true;
    }
    return false;
}

bool Newcomer::door_ahead() {
    const std::string ahead = request("3");
    return ahead.find("oor") != std::string::npos || ahead.find("ntrance") != std::string::npos;
}

// Parses "Door is locked. Button, metal opens it, 70 steps, behind, above."
bool Newcomer::heard_of_lock(std::size_t since) {
    static const std::regex reported("(\\S.*) is locked\\. (.+) opens it, (.+)\\.");
    std::smatch found;
    for (std::size_t i = since; i < lines(); ++i) {
        const std::string text = line(i);
        if (!std::regex_search(text, found, reported)) continue;
        locked_ = Locked{found[1], found[2], found[3]};
        return true;
    }
    return false;
}

// If something blocks the newcomer, walks sideways for a few steps, on alternate sides, and farther each time.
void Newcomer::get_round() {
    ++met_;
    const std::string along = met_ % 4 < 2 ? "Shift+Left" : "Shift+Right";
    hold(along, 0.7 + 0.4 * static_cast<double>(met_ % 7));
}

// Presses the announced key, then waits until the lift has stopped and its door has had time to open.
void Newcomer::ride() {
    const std::size_t since = lines();
    request("Enter");
    for (int i = 0; i < 60 && !heard("stops", since); ++i) wait(0.5);
    wait(2.0);
}

bool Newcomer::obey(const std::string& text) {
    if (text.find("You are standing in it. Enter starts it") != std::string::npos) {
        ride();
        return true;
    }
    if (text.find("You are standing at them. Use Enter to take them") != std::string::npos) {
        request("Enter", 1.0);
        return true;
    }
    const auto direction = direction_in(text);
    if (!direction) return false;
    turn(direction->right_deg);
    over_edges_ = text.find("edge") != std::string::npos;  // true: the route leads down over the edge
    if (walk(std::clamp(direction->steps, 1, 8)) && !locked_) get_round();
    return true;
}

// A long list begins with its kinds. The last of them opens the whole list.
std::string Newcomer::open_list(const std::string& key) {
    std::string spoken = request(key);
    if (session_->app().dialogue().is_open() && begins(request("End"), "Everything")) spoken = request("Enter");
    else if (session_->app().dialogue().is_open()) request("Home");
    static const std::regex title("^[^.]*\\. ");
    return std::regex_replace(spoken, title, "", std::regex_constants::format_first_only);
}

std::vector<std::string> Newcomer::entries(const std::string& key) {
    std::vector<std::string> all;
    std::string spoken = open_list(key);
    // Reads until the end of the list, where Down repeats the last entry or starts again at the first. Consecutive
    // footways may have the same name.
    std::string before;
    for (int i = 0; i < 200 && !spoken.empty() && spoken != before; ++i) {
        const std::string entry = entry_of(spoken);
        if (all.size() > 1 && entry == all.front() && spoken.find(" 1 of ") != std::string::npos) break;
        all.push_back(entry);
        before = std::exchange(spoken, request("Down"));
    }
    while (session_->app().dialogue().is_open()) tap("Escape");
    return all;
}

std::string Newcomer::choose(const std::string& key, const std::string& begin) {
    std::string spoken = open_list(key);
    std::string before;
    for (int i = 0; i < 200; ++i) {
        if (begins(spoken, begin)) {
            const std::string answer = request("Enter", 0.8);
            // If several things have that name, chooses the nearest one.
            return answer.find(": which one?") == std::string::npos ? answer : request("Enter", 0.8);
        }
        if (spoken == before || spoken.empty()) break;
        before = spoken;
        spoken = request("Down");
    }
    tap("Escape");
    return {};
}

bool Newcomer::go_to_room(const std::string& room) {
    const std::size_t since = lines();
    const std::string way = choose("Shift+4", room);
    if (way.empty() || way.find("No walking route") != std::string::npos) return false;
    return follow_words_to(room, since);
}

bool Newcomer::go_by_words_to_thing(const std::string& thing) {
    const std::size_t since = lines();
    if (choose("Shift+H", thing).empty()) return false;
    tap("Down");
    const std::string way = request("Enter", 0.8);
    if (way.empty() || way.find("No walking route") != std::string::npos) return false;
    return follow_words_to(thing, since);
}

bool Newcomer::follow_words_to(const std::string& goal, std::size_t since) {
    locked_.reset();
    for (int requested = 0; requested < 120 && !locked_; ++requested) {
        if (heard(goal + " You are there", since)) return true;
        const std::string on = choose("Shift+4", "Where the route continues");
        if (heard(goal + " You are there", since)) return true;
        if (!obey(on)) return false;
    }
    return false;
}

bool Newcomer::go_to_thing(const std::string& thing) {
    const std::size_t since = lines();
    if (choose("Shift+H", thing).empty()) return false;
    tap("Enter", 0.6);  // The beacon is the first of the tools to find the thing.
    for (int beats = 0; beats < 120; ++beats) {
        if (heard("Here " + thing, since)) return true;
        const std::size_t sounds = audio_.sounds().size();
        wait(1.3);
        std::optional<double> right_deg;
        for (std::size_t i = sounds; i < audio_.sounds().size(); ++i)
            if (is_beacon(audio_.sounds()[i].cue.kind))
                right_deg = right_of_ears_deg(audio_.sounds()[i].cue.position_m);
        if (!right_deg) continue;
        turn(*right_deg);
        if (walk(3)) get_round();
    }
    return false;
}

double Newcomer::right_of_ears_deg(const Vec3& place_m) const {
    const Vec3 way = place_m - audio_.listener().ears_m;
    return std::remainder(degrees_from_radians(std::atan2(way.x, way.y) - audio_.listener().heading_rad), 360.0);
}

std::vector<Newcomer::Heard> Newcomer::listen_to(SoundKind kind) const {
    std::vector<Heard> all;
    for (const SoundCue& cue : audio_.world_sounds())
        if (cue.kind == kind && cue.loudness > 0.0)
            all.push_back({cue.source, right_of_ears_deg(cue.position_m), cue.muffled_db});
    return all;
}

void Newcomer::obey_ears(double right_deg) {
    turn(right_deg);
    if (walk(2)) get_round();
}

}  // namespace handrail::test
