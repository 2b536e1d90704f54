// Tests the measures of ten lessons whose learners walk, stop, query and answer at random. Calculates all measures a
// second time, by plain sums over the lines and tables of the recordings. Some measures depend on when a sample was
// taken: the lesson samples ten times a second, the tables sixty times. For these measures, the sums give the smallest
// and the largest permissible value.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "app/main/session_report.h"
#include "app/main/world_files.h"
#include "app/record/json_fields.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/whole_lesson/lesson_home.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/stated_building.h"

namespace handrail::test {
namespace measured_again_test {

namespace fs = std::filesystem;

// The rooms are rectangular, so that the walls are four lines.
constexpr const char* kLibrary =
    "Building: Town library.\n"
    "Walls: 0.2 metres thick.\n\n"
    "Hall, 8 by 6 metres. Door outside in the south wall.\n"
    "Start in the middle, facing north.\n\n"
    "Corridor, 20 by 2 metres, north of Hall. Opening to Hall, 1.2 metres wide. Opening to Library, 1.2 metres wide, "
    "12 metres along its left wall. Opening to "
    "Office, 1.2 metres wide, 4 metres along its left wall.\n\n"
    "Library, 6 by 5 metres, north of Corridor, 2 metres further east.\n\n"
    "Office, 5 by 4 metres, north of Corridor, 8 metres further west.\n";
constexpr const char* kLesson = R"(handrail_lesson = 1
title = "To the library"
world = "library.rooms"
base = { feet = [4.0, 2.0, 0.0], heading_deg = 0, name = "Start" }
[[landmark]]
room = "Library"
[[landmark]]
room = "Office"
[[landmark]]
room = "Corridor"
[[route]]
name = "to the library"
stops = [{ room = "Library" }]
[[session]]
name = "All"
[[session.step]]
do = "learn"
room = "Hall"
[[session.step]]
do = "point"
from = "base"
to = ["Library", "Office", "Corridor"]
pass_deg = 20
[[session.step]]
do = "go"
route = "to the library"
help_percent = [100, 0]
[[session.step]]
do = "free"
[[session.step]]
do = "distance"
from = "base"
to = ["Office", "Library"]
[[session.step]]
do = "order"
of = ["Corridor", "Office", "Library"]
[[session.step]]
do = "ask"
say = "How sure were you?"
scale = [1, 7]
)";

// ---- the learner ----

class Pupil {
public:
    Pupil(Sitting& sitting, TaughtWorld& world, std::uint64_t seed) : sitting_(sitting), world_(world), draw_(seed) {}

    void takes_all() {
        learns();
        points();
        goes();
        looks_round();
        for (int question = 0; question < 2; ++question) {
            ASSERT_TRUE(sitting_.hears("How far is it to")) << sitting_.all();
            sitting_.type(std::to_string(5 + chance(25)));
            sitting_.key("Enter");
        }
        ASSERT_TRUE(sitting_.hears("Put 3 places in order")) << sitting_.all();
        for (int place = 0; place < 2; ++place) {
            sitting_.key(chance(2) == 0 ? "Home" : "End");
            sitting_.key("Enter");
        }
        ASSERT_TRUE(sitting_.hears("How sure were you?")) << sitting_.all();
        sitting_.type(std::to_string(1 + chance(7)));
        sitting_.key("Enter");
        ASSERT_TRUE(sitting_.hears("All is over.")) << sitting_.all();
        sitting_.live(1.0);
    }

private:
    int chance(int of) { return static_cast<int>(draw_() % static_cast<std::uint64_t>(of)); }
    double between(double least, double most) { return least + (most - least) * chance(1001) / 1000.0; }

    // Does something that any learner does now and then. Chooses the action at random.
    void dawdles() {
        switch (chance(7)) {
            case 0:
                return sitting_.live(between(3.0, 5.0));
            case 1:
                return sitting_.live(0.7);
            case 2:  // opens the list of rooms, goes through it and closes it
                sitting_.key("Shift+4");
                for (int down = chance(4); down > 0; --down) sitting_.key("Down");
                sitting_.live(between(0.0, 4.0));
                return sitting_.key("Escape");
            case 3:
                return sitting_.hold(Command::WhereAmI, 0.5);
            case 4:
                sitting_.face(sitting_.app().feet_m() + Vec3(between(-1.0, 1.0), between(-1.0, 1.0), 0.0));
                return;
            default:
                return;
        }
    }
    void walks_to(const Vec3& place_m) {
        const Route way = world_.way(sitting_.app().feet_m(), {{"", place_m, place_m}});
        ASSERT_TRUE(way.reaches);
        ASSERT_TRUE(sitting_.walk(way.points_m)) << sitting_.all();
    }

    void learns() {
        ASSERT_TRUE(sitting_.hears("Get to know")) << sitting_.all();
        for (int turn = 2 + chance(3); turn > 0; --turn) {
            dawdles();
            walks_to({between(1.5, 6.5), between(1.5, 4.5), 0.0});
            sitting_.face(sitting_.app().feet_m() + Vec3(between(-1.0, 1.0), between(-1.0, 1.0), 0.0));
            sitting_.hold(chance(2) == 0 ? Command::TrailLeft : Command::TrailRight, between(3.0, 9.0));
        }
        if (chance(2) == 0) sitting_.key("Home");
        sitting_.key("Alt+Enter");
    }
    void points() {
        for (const char* name : {"Library", "Office", "Corridor"}) {
            ASSERT_TRUE(sitting_.hears("Face " + std::string(name))) << sitting_.all();
            const Vec3 way = world_.place(name)->middle_m - sitting_.app().feet_m();
            const double towards_rad = std::atan2(way.x, way.y) + between(-1.0, 1.0);
            sitting_.face(sitting_.app().feet_m() + Vec3(std::sin(towards_rad), std::cos(towards_rad), 0.0));
            sitting_.key("Alt+Enter");
        }
    }
    void goes() {
        const DeskLine desk;
        ASSERT_TRUE(desk.connected());
        for (int lap = 0; lap < 2; ++lap) {
            ASSERT_TRUE(sitting_.hears(lap == 0 ? "Help: 100 percent" : "Without help")) << sitting_.all();
            dawdles();
            if (chance(2) == 0) walks_to({between(-4.0, 12.0), between(6.8, 7.2), 0.0});
            if (chance(3) == 0) desk.order(sitting_, "note goes slowly");
            if (chance(3) == 0) desk.order(sitting_, chance(2) == 0 ? "more" : "less");
            if (chance(3) == 0) sitting_.key("Home");
            dawdles();
            walks_to(world_.place("Library")->stand_m);
            ASSERT_TRUE(sitting_.hears("You reached Library.")) << sitting_.all();
        }
    }
    void looks_round() {
        for (int turn = 1 + chance(3); turn > 0; --turn) {
            walks_to(world_.place(chance(2) == 0 ? "Office" : "Corridor")->stand_m);
            dawdles();
        }
        if (chance(2) == 0) sitting_.key("Home");
        dawdles();
        sitting_.key("Alt+Enter");
    }

    Sitting& sitting_;
    TaughtWorld& world_;
    std::mt19937_64 draw_;
};

// ---- the second calculation of the measures ----

struct Range {
    double least = 0.0, most = 0.0;
};
using Ranges = std::map<std::string, Range>;

// Time by which the lesson may be late: it samples ten times a second and acts a frame later.
constexpr double kLooks_s = 0.15;

class Sums {
public:
    Sums(const Recording& recording, TaughtWorld& world, const Scene& scene)
        : recording_(recording), world_(world), scene_(scene) {
        for (const RecordedLine& line : recording.lines) lines_.emplace_back(line.t_s, Json::parse(line.json));
        std::optional<double> open_s, speaks_s, led_s;
        const double end_s = lines_.back().first;
        for (const auto& [t_s, json] : lines_) {
            const auto is = json.at("is").get<std::string>();
            if (is == "list_shown") span(busy_, open_s, json.at("open").get<bool>(), t_s);
            if (is == "leading") span(led_, led_s, json.at("on").get<bool>(), t_s);
        }
        for (const CueRow& row : recording.cues)
            if (row.speaking != 0) span(busy_, speaks_s, (row.speaking & 1U) != 0, at_s(row.now_s));
        span(busy_, open_s, false, end_s), span(busy_, speaks_s, false, end_s), span(led_, led_s, false, end_s);
    }

    // Returns the measures of each measured task, in order.
    std::vector<std::pair<std::string, Ranges>> tasks() {
        std::vector<std::pair<std::string, Ranges>> tasks;
        double from_s = 0.0;
        for (const auto& [t_s, json] : lines_) {
            if (json.at("is") != "teacher") continue;
            if (json.at("act") == "begin") from_s = t_s;
            if (json.at("act") != "result") continue;
            const auto kind = json.at("items").at(0).get<std::string>();
            tasks.emplace_back(kind, of(kind, from_s, t_s));
            from_s = t_s;
        }
        return tasks;
    }
    Range walked(double from_s, double to_s) const {
        double way_m = 0.0, rest_m = 0.0;  // rest_m: at most this much is lost where the counting begins again
        std::optional<Vec3> last_m;
        Vec3 before_m{0.0};
        for (const FrameRow& frame : frames(from_s, to_s)) {
            // Nobody walks this far between two samples, so something placed the walker elsewhere.
            if (last_m && flat(frame.feet_m, before_m) > 0.5) {
                last_m.reset();
                rest_m += 0.25;
            }
            before_m = frame.feet_m;
            if (!last_m) last_m = frame.feet_m;
            const double step_m = flat(frame.feet_m, *last_m);
            if (step_m < 0.25) continue;
            way_m += step_m;
            last_m = frame.feet_m;
        }
        return {0.97 * way_m - 0.3, 1.03 * way_m + 0.3 + rest_m};
    }
    // Returns the rooms that the walker visited, in order. A position counts for a room if it is at least `in_m` inside
    // the room's outline.
    std::vector<std::string> rooms(double from_s, double to_s, double in_m) const {
        std::vector<std::string> rooms;
        for (const FrameRow& frame : frames(from_s, to_s))
            for (const StatedRoom& room : scene_.stated->rooms) {
                const auto [least, most] = box(room);
                const Vec3& feet = frame.feet_m;
                if (feet.x < least.x + in_m || feet.x > most.x - in_m || feet.y < least.y + in_m ||
                    feet.y > most.y - in_m)
                    continue;
                if (rooms.empty() || rooms.back() != room.name) rooms.push_back(room.name);
            }
        return rooms;
    }

private:
    static double flat(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); }
    static void span(std::vector<Span>& spans, std::optional<double>& since_s, bool on, double t_s) {
        if (!on && since_s) spans.push_back({*since_s, t_s});
        if (!on) since_s.reset();
        else if (!since_s) since_s = t_s;
    }
    static std::pair<Vec2, Vec2> box(const StatedRoom& room) {
        Vec2 least(1e300), most(-1e300);
        for (const Vec2& p : room.rings[0]) least = glm::min(least, p), most = glm::max(most, p);
        return {least, most};
    }
    double at_s(double now_s) const { return now_s - recording_.head.begun_s; }
    std::span<const FrameRow> frames(double from_s, double to_s) const {
        const auto& all = recording_.frames;
        const auto at = [&](double t_s) {
            return std::find_if(all.begin(), all.end(), [&](const FrameRow& row) { return at_s(row.now_s) > t_s; });
        };
        const auto begin = at(from_s + 1e-3), end = at(to_s + 1e-3);
        return {begin, end};
    }
    // Returns the frame before a line. In the frame of the line itself, the lesson may already have placed the walker
    // elsewhere.
    const FrameRow& frame_before(double t_s) const { return frames(-1.0, t_s - 0.01).back(); }
    // Counts the recorded lines that satisfy `is`. `least` omits lines close to either end of the period; `most`
    // includes those just outside it.
    Range count(const std::function<bool(const Json&)>& is, double from_s, double to_s) const {
        Range range;
        for (const auto& [t_s, json] : lines_) {
            if (!is(json)) continue;
            if (t_s > from_s + kLooks_s && t_s < to_s - kLooks_s) ++range.least;
            if (t_s > from_s - kLooks_s && t_s < to_s + kLooks_s) ++range.most;
        }
        return range;
    }
    // Returns how many seconds the learner was busy with speech or a list. Samples every hundredth of a second.
    double busy_s(double from_s, double to_s) const {
        double busy_s = 0.0;
        for (double t_s = from_s; t_s < to_s; t_s += 0.01)
            busy_s += std::any_of(busy_.begin(), busy_.end(),
                                  [&](const Span& span) { return t_s >= span.from_s && t_s < span.to_s; })
                          ? 0.01
                          : 0.0;
        return busy_s;
    }
    // Returns the number and the total duration of the learner's pauses. A pause is a stay within 0.15 m that lasts
    // longer than `longer_s`.
    std::pair<int, double> stays(double from_s, double to_s, double longer_s) const {
        const auto all = frames(from_s, to_s);
        int count = 0;
        double sum_s = 0.0;
        for (std::size_t i = 0; i < all.size();) {
            std::size_t end = i;
            while (end + 1 < all.size() && flat(all[i].feet_m, all[end + 1].feet_m) <= 0.15) ++end;
            const double begin_s = at_s(all[i].now_s), stop_s = at_s(all[end].now_s);
            if (stop_s - begin_s <= longer_s) {
                ++i;
                continue;
            }
            const double free_s = stop_s - begin_s - busy_s(begin_s, stop_s);
            if (free_s > longer_s) ++count, sum_s += free_s;
            i = end + 1;
        }
        return {count, sum_s};
    }
    Range contacts(double from_s, double to_s) const {
        const auto episodes = [&](double begin_s, double end_s) {
            std::map<std::uint32_t, double> last_s;
            int count = 0;
            for (const auto& [t_s, json] : lines_) {
                if (json.at("is") != "contact" || t_s < begin_s || t_s > end_s) continue;
                const auto thing = json.at("feature").get<std::uint32_t>();
                if (!last_s.contains(thing) || t_s - last_s[thing] > 2.0) ++count;
                last_s[thing] = t_s;
            }
            return static_cast<double>(count);
        };
        return {episodes(from_s + kLooks_s, to_s - kLooks_s), episodes(from_s - kLooks_s, to_s + kLooks_s)};
    }
    // Returns how much of the hall's four walls the learner knows, in percent. If the walker was near enough to trail
    // or touch a wall, the learner knows a part of that wall as wide as the walker. If the session guides the walker to
    // a wall, the walker trails that wall from 0.3 m in front of it.
    Range walls(double until_s) const {
        const StatedRoom& hall = scene_.stated->rooms[0];
        const auto corners = box(hall);
        constexpr double kHalfWall_m = 0.1;
        const Vec2 least = corners.first + kHalfWall_m, most = corners.second - kHalfWall_m;
        constexpr double kStep_m = 0.01, kBody_m = 0.25;
        const auto share = [&](double near_m, double reach_m) {
            double known_m = 0.0, whole_m = 0.0;
            for (int side = 0; side < 4; ++side) {
                const bool along_x = side < 2;
                const double from_m = along_x ? least.x : least.y, to_m = along_x ? most.x : most.y;
                const double line_m = side == 0 ? least.y : side == 1 ? most.y : side == 2 ? least.x : most.x;
                const auto pieces = static_cast<std::size_t>((to_m - from_m) / kStep_m);
                std::vector<bool> known(pieces, false);
                for (const FrameRow& frame : frames(-1.0, until_s)) {
                    const double off_m = std::abs((along_x ? frame.feet_m.y : frame.feet_m.x) - line_m);
                    if (off_m > near_m) continue;
                    const double at_m = (along_x ? frame.feet_m.x : frame.feet_m.y) - from_m;
                    for (double p_m = std::max(0.0, at_m - reach_m); p_m < std::min(to_m - from_m, at_m + reach_m);
                         p_m += kStep_m)
                        known[std::min(pieces - 1, static_cast<std::size_t>(p_m / kStep_m))] = true;
                }
                whole_m += to_m - from_m;
                known_m += kStep_m * static_cast<double>(std::count(known.begin(), known.end(), true));
            }
            return 100.0 * known_m / whole_m;
        };
        return {share(kBody_m + 0.04, 0.8 * kBody_m) - 5.0, share(kBody_m + 0.35, 1.2 * kBody_m) + 5.0};
    }
    // Returns the answers to questions of the task, within the time of the task.
    std::vector<std::pair<double, std::string>> answers(double from_s, double to_s) const {
        std::vector<std::pair<double, std::string>> answers;
        for (const auto& [t_s, json] : lines_)
            if (json.at("is") == "answered" && t_s > from_s && t_s <= to_s)
                answers.emplace_back(t_s, json.at("text").get<std::string>());
        return answers;
    }
    const TaughtStep& step(StepKind kind) const {
        for (const TaughtStep& step : world_.lesson().sessions[0].steps)
            if (step.kind == kind) return step;
        throw std::logic_error("no such step");
    }

    void add_go(Ranges& ranges, double from_s, double to_s) {
        const Vec3 end_m = frame_before(to_s).feet_m;
        TaughtPlace stop = *world_.place("Library");
        const bool reached = flat(end_m, stop.stand_m) < 1.55;
        ranges["reached"] = {reached ? 1.0 : 0.0, reached ? 1.0 : 0.0};
        stop.stand_m = end_m;
        const Route shortest = world_.way(world_.base().stand_m, {stop});
        double shortest_m = 0.0;
        for (std::size_t i = 1; i < shortest.points_m.size(); ++i)
            shortest_m += flat(shortest.points_m[i - 1], shortest.points_m[i]);
        const Range way = walked(from_s, to_s);
        ranges["path_ratio"] = {way.least / shortest_m, way.most / shortest_m};
    }
    void add_point(Ranges& ranges, double from_s, double to_s) {
        double sum_deg = 0.0;
        int passed = 0, count = 0;
        std::size_t at = 0;
        for (const auto& [t_s, text] : answers(from_s, to_s)) {
            const FrameRow& frame = frame_before(t_s);
            const Vec3 way = world_.place(step(StepKind::Point).to[at++])->middle_m - frame.feet_m;
            double off_deg = std::abs(frame.heading_rad - std::atan2(way.x, way.y)) * 180.0 / 3.14159265358979;
            while (off_deg > 180.0) off_deg = std::abs(off_deg - 360.0);
            sum_deg += off_deg;
            passed += off_deg <= 20.0 ? 1 : 0;
            ++count;
        }
        ranges["pointing_off"] = {sum_deg / count - 0.05, sum_deg / count + 0.05};
        const double percent = 100.0 * passed / count;
        ranges["pointing_passed"] = {percent - 1e-9, percent + 1e-9};
    }
    void add_distance(Ranges& ranges, double from_s, double to_s) {
        double product = 1.0;
        std::size_t at = 0;
        for (const auto& [t_s, text] : answers(from_s, to_s)) {
            const Vec3 to_m = world_.place(step(StepKind::Distance).to[at++])->middle_m;
            product *= std::stod(text) * Settings{}.walk.step_length_m / flat(to_m, world_.base().stand_m);
        }
        const double mean = std::pow(product, 1.0 / static_cast<double>(at));
        ranges["distance_judged"] = {mean - 1e-6, mean + 1e-6};
    }
    // Computes the order measure from the lists that the task showed and the choices that the learner made.
    void add_order(Ranges& ranges, double from_s, double to_s) {
        std::vector<std::string> shown;
        for (const auto& [t_s, json] : lines_)
            if (t_s >= from_s && t_s <= to_s && json.at("is") == "teacher" && json.at("act") == "order")
                shown = json.at("items").get<std::vector<std::string>>();
        const std::vector<std::string>& right = step(StepKind::Order).to;
        std::vector<std::ptrdiff_t> put;
        std::istringstream chosen(answers(from_s, to_s).back().second);
        for (std::size_t number = 0; chosen >> number;)
            put.push_back(std::find(right.begin(), right.end(), shown.at(number - 1)) - right.begin());
        double kept = 0.0;
        for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
            kept += put[static_cast<std::size_t>(a)] < put[static_cast<std::size_t>(b)] ? 1.0 / 3.0 : -1.0 / 3.0;
        ranges["order_kept"] = {kept - 1e-9, kept + 1e-9};
    }

    Ranges of(const std::string& kind, double from_s, double to_s) {
        Ranges ranges;
        ranges["time"] = {to_s - from_s - kLooks_s, to_s - from_s + kLooks_s};
        const auto fewest = stays(from_s, to_s, 2.25), most = stays(from_s, to_s, 1.75);
        ranges["pauses"] = {static_cast<double>(fewest.first), static_cast<double>(most.first)};
        ranges["pause_time"] = {fewest.second - 0.35 * fewest.first, most.second + 0.35 * most.first};
        ranges["contacts_hand"] = contacts(from_s, to_s);
        ranges["help_asked"] = count(
            [](const Json& json) {
                return json.at("is") == "help_asked" ||
                       (json.at("is") == "lesson_wished" && json.at("wish") == "more_help");
            },
            from_s, to_s);
        double led_s = 0.0;
        for (const Span& span : led_) led_s += std::max(0.0, std::min(span.to_s, to_s) - std::max(span.from_s, from_s));
        ranges["led_time"] = {led_s - kLooks_s, led_s + kLooks_s};
        if (kind == "learn") ranges["walls_percent"] = walls(to_s);
        if (kind == "go") add_go(ranges, from_s, to_s);
        if (kind == "point") add_point(ranges, from_s, to_s);
        if (kind == "distance") add_distance(ranges, from_s, to_s);
        if (kind == "order") add_order(ranges, from_s, to_s);
        if (kind == "ask") {
            const double answer = std::stod(answers(from_s, to_s).back().second);
            ranges["answer"] = {answer, answer};
        }
        return ranges;
    }

    const Recording& recording_;
    TaughtWorld& world_;
    const Scene& scene_;
    std::vector<std::pair<double, Json>> lines_;
    std::vector<Span> busy_, led_;
};

// Returns true for measures of a task that the sums of this file do not cover.
bool not_summed(const std::string& key) {
    return key == "turns_missed" || key == "turns_early" || key == "exits_percent" || key == "pointing_side" ||
           key.starts_with("strategy_");
}

// Returns whether `whole` contains all entries of `part` in the same order, possibly with others between them.
bool holds_in_order(const std::vector<std::string>& whole, const std::vector<std::string>& part) {
    auto at = whole.begin();
    for (const std::string& name : part) {
        at = std::find(at, whole.end(), name);
        if (at == whole.end()) return false;
        ++at;
    }
    return true;
}

// Reads the learner's only recording.
Result<Recording> recording_of(const Learner& learner) {
    return read_recording(fs::directory_iterator(Learners(user_data_folder()).recordings_of(learner.id))->path());
}
// The learner does not consent to being remembered. So the lesson must not use what the learner learnt in an earlier
// lesson.
constexpr std::array kAgreed = {Purpose::Record};

class MeasuredAgain : public LessonHome, public testing::WithParamInterface<int> {};
using JumpMeasured = LessonHome;

// The lesson samples every sixth frame, before it receives the events of that frame. So the test tries the jump in each
// of six frames.
TEST_F(JumpMeasured, is_not_counted_as_walking_in_any_frame) {
    constexpr int kFrames = 6;
    home_.write("library.rooms", kLibrary);
    const std::string text = kLesson;
    home_.write("library.lesson.toml", text.substr(0, text.find("[[session.step]]")) +
                                           "[[session.step]]\ndo = \"go\"\nroute = \"to the library\"\n"
                                           "help_percent = [0, 0, 0, 0, 0, 0]\n");
    const Learner learner = pupil(kAgreed);
    const ExploreArguments arguments = taught(home_.path() / "library.lesson.toml", 1);
    TaughtWorld& world = *arguments.lesson->world;
    {
        Sitting sitting(arguments);
        ASSERT_TRUE(sitting.know_rooms());
        for (int lap = 0; lap < kFrames; ++lap) {
            ASSERT_TRUE(sitting.hears("Without help")) << sitting.all();
            sitting.live(lap * Sitting::kFrame_s);
            ASSERT_TRUE(sitting.walk(world.way(sitting.app().feet_m(), {*world.place("Corridor")}).points_m));
            sitting.hold(Command::Home, 0.5);
            ASSERT_TRUE(sitting.walk(world.way(sitting.app().feet_m(), {*world.place("Library")}).points_m));
            ASSERT_TRUE(sitting.hears("You reached Library.")) << sitting.all();
        }
        sitting.live(1.0);
    }
    const auto recording = recording_of(learner);
    ASSERT_TRUE(recording) << recording.error().sentence();
    const auto scene = std::make_shared<const Scene>(*read_world(home_.path() / "library.rooms"));
    const auto again = Sums(*recording, world, *scene).tasks();
    const RecordedEvents events = events_of(*recording);
    ASSERT_EQ(events.tasks.size(), static_cast<std::size_t>(kFrames));
    ASSERT_EQ(again.size(), events.tasks.size());
    for (std::size_t i = 0; i < again.size(); ++i)
        EXPECT_LE(events.tasks[i].measures.at("path_ratio"), again[i].second.at("path_ratio").most) << i;
}

using ListInReport = LessonHome;

TEST_F(ListInReport, is_quoted_by_its_opening_sentence_and_not_by_its_items) {
    home_.write("library.rooms", kLibrary);
    home_.write("library.lesson.toml", kLesson);
    const Learner learner = pupil(kAgreed);
    const ExploreArguments arguments = taught(home_.path() / "library.lesson.toml", 1);
    std::vector<std::string> said;
    {
        Sitting sitting(arguments);
        ASSERT_TRUE(sitting.know_rooms());
        ASSERT_TRUE(sitting.hears("Get to know")) << sitting.all();
        sitting.live(8.0);
        for (const char* key : {"Shift+4", "Down", "Down", "Down"}) {
            const std::string before = sitting.all();
            sitting.key(key);
            sitting.live(4.0);
            said.push_back(sitting.all().substr(before.size()));
            said.back() = said.back().substr(0, said.back().find('\n'));
        }
        sitting.key("Escape");
        sitting.live(1.0);
        sitting.hold(Command::WhereAmI, 0.5);
        ASSERT_TRUE(sitting.hears("Hall")) << sitting.all();
        sitting.live(3.0);
    }
    const auto recording = recording_of(learner);
    ASSERT_TRUE(recording) << recording.error().sentence();
    const auto scene = std::make_shared<const Scene>(*read_world(home_.path() / "library.rooms"));
    const auto report = report_of(*recording, events_of(*recording), scene);
    ASSERT_TRUE(report) << report.error().sentence();
    const auto quoted = [&](const std::string& text) {
        return std::any_of(report->course.begin(), report->course.end(),
                           [&](const ReportEvent& event) { return event.text == text; });
    };
    EXPECT_TRUE(quoted(said[0])) << said[0];
    for (std::size_t i = 1; i < said.size(); ++i) {
        EXPECT_FALSE(said[i].empty()) << i;
        EXPECT_FALSE(quoted(said[i])) << said[i];
    }
    EXPECT_EQ(std::count_if(report->course.begin(), report->course.end(),
                            [](const ReportEvent& event) { return event.text.starts_with("Hall, at the base"); }),
              1)
        << "what is said after the list stands in the course";
}

TEST_P(MeasuredAgain, from_the_recording_of_a_lesson_all_results_match_what_was_announced) {
    home_.write("library.rooms", kLibrary);
    home_.write("library.lesson.toml", kLesson);
    const Learner learner = pupil(kAgreed);
    const ExploreArguments arguments = taught(home_.path() / "library.lesson.toml", 1);
    TaughtWorld& world = *arguments.lesson->world;
    {
        Sitting sitting(arguments);
        ASSERT_TRUE(sitting.know_rooms());
        Pupil(sitting, world, static_cast<std::uint64_t>(GetParam())).takes_all();
        ASSERT_FALSE(HasFatalFailure());
    }
    const auto recording = recording_of(learner);
    ASSERT_TRUE(recording) << recording.error().sentence();
    const auto scene = std::make_shared<const Scene>(*read_world(home_.path() / "library.rooms"));
    const RecordedEvents events = events_of(*recording);
    const auto report = report_of(*recording, events, scene);
    ASSERT_TRUE(report) << report.error().sentence();

    Sums sums(*recording, world, *scene);
    const auto again = sums.tasks();
    ASSERT_EQ(report->tasks.size(), again.size() + 1) << "the whole stands before the tasks";
    EXPECT_EQ(again.size(), 8U);
    for (std::size_t i = 0; i < again.size(); ++i) {
        const auto& [kind, ranges] = again[i];
        const ReportTask& task = report->tasks[i + 1];
        std::size_t compared = 0;
        for (const ReportMeasure& reported : task.measures) {
            if (not_summed(reported.key)) continue;
            const auto at = ranges.find(reported.key);
            ASSERT_NE(at, ranges.end()) << kind << ": nothing gives " << reported.key << " " << reported.value;
            EXPECT_GE(reported.value, at->second.least) << kind << " " << i << ": " << reported.key;
            EXPECT_LE(reported.value, at->second.most) << kind << " " << i << ": " << reported.key;
            ++compared;
        }
        EXPECT_EQ(compared + (ranges.contains("reached") ? 1 : 0), ranges.size()) << kind << ": one is not told";
        if (kind == "go") {
            EXPECT_EQ(task.reached, ranges.at("reached").least == 1.0);
        }
    }
    const Range walked = sums.walked(events.from_s, events.to_s);
    EXPECT_GE(report->walked_m, walked.least);
    EXPECT_LE(report->walked_m, walked.most);
    EXPECT_TRUE(holds_in_order(report->rooms, sums.rooms(events.from_s, events.to_s, 0.4)));
    EXPECT_TRUE(holds_in_order(sums.rooms(events.from_s, events.to_s, -0.1), report->rooms));
}

// Under a sanitizer, the test runs only three lessons, because all run the same code.
INSTANTIATE_TEST_SUITE_P(Pupil, MeasuredAgain, testing::Range(1, kSanitizerScale == 1.0 ? 11 : 4));

}  // namespace measured_again_test
}  // namespace handrail::test
