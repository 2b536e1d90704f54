#include "app/core/scenario/session_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/core/dialogue/words.h"
#include "audio-cues/plan/sound_table.h"
#include "worlds/base/language.h"
#include "worlds/scene/lint.h"

namespace handrail::core {
namespace {

constexpr double kFeltForce_n = 0.05;  // a person cannot feel the direction of a force below this

struct Window {
    double from_s, to_s;
    bool has(double t) const { return t >= from_s - 1e-9 && t <= to_s + 1e-9; }
};

std::string shown(const Vec3& v) { return fmt::format("({:.4f}, {:.4f}, {:.4f})", v.x, v.y, v.z); }

class Checker {
public:
    Checker(const Scenario& scenario, const SessionLog& log, const Scene& scene, const Expectation& e)
        : log_(log), ticks_(e.left ? log.left_ticks : log.ticks), scene_(scene), e_(e) {
        window_ = {moment(e.from), e.has_to ? moment(e.to) : log.end_s};
        where_ = phrase("log.where", {{"file", scenario.file.filename().string()},
                                      {"line", e.line},
                                      {"from", window_.from_s},
                                      {"to", window_.to_s}});
    }

    // Returns an error sentence, or an empty text if the expectation is met.
    std::string failure() const {
        switch (e_.check) {
            case Check::Say:
                return say(true);
            case Check::NotSay:
                return say(false);
            case Check::SayInOrder:
                return say_in_order();
            case Check::NothingTwice:
                return nothing_twice();
            case Check::SoundFaster:
                return sound_faster();
            case Check::Sound:
            case Check::NotSound:
                return sound();
            case Check::SoundRising:
                return sound_rising();
            case Check::Force:
                return each_tick(
                    [&](const LoggedTick& t) {
                        const double n = e_.has_vector ? glm::dot(t.force_n, e_.vector) : glm::length(t.force_n);
                        return wrong_unless(n >= e_.low && n <= e_.high, [=] {
                            return phrase("log.force", {{"force", n}, {"vector", shown(t.force_n)}});
                        });
                    },
                    phrase("log.force_range", {{"least", e_.low}, {"most", e_.high}}));
            case Check::ForceStep:
                return force_step();
            case Check::ForceSpike:
                return force_spike();
            case Check::ForceLine:
            case Check::ForceBand:
                return force_lines();
            case Check::ForceAngle:
                return each_tick(
                    [&](const LoggedTick& t) {
                        const double force = glm::length(t.force_n);
                        const double off = degrees_from_radians(
                            std::acos(std::clamp(glm::dot(t.force_n, e_.vector) / force, -1.0, 1.0)));
                        return wrong_unless(force <= kFeltForce_n || off <= e_.high, [=] {
                            return phrase("log.angle", {{"angle", off}, {"vector", shown(t.force_n)}});
                        });
                    },
                    phrase("log.angle_range", {{"most", e_.high}, {"vector", shown(e_.vector)}}));
            case Check::Depth:
                return each_tick(
                    [&](const LoggedTick& t) {
                        const double depth_mm = t.contact ? 1e3 * glm::length(t.hip_m - t.proxy_m) / t.scale : 0.0;
                        return wrong_unless(depth_mm <= e_.high, [=] {
                            return phrase("log.depth", {{"depth", depth_mm}});
                        });
                    },
                    phrase("log.depth_range", {{"most", e_.high}}));
            case Check::ForceRising:
                return force_rising();
            case Check::SlideRatio:
                return each_tick(
                    [&](const LoggedTick& t) {
                        const double along = glm::dot(t.force_n, e_.vector),
                                     across = glm::length(t.force_n - e_.vector * along);
                        return wrong_unless(along > 0.0 && across >= e_.low * along && across <= e_.high * along, [=] {
                            return phrase("log.slide",
                                          {{"across", across}, {"along", along}, {"ratio", across / along}});
                        });
                    },
                    phrase("log.slide_range", {{"least", e_.low}, {"most", e_.high}}));
            case Check::StrongestLine:
                return strongest_line();
            case Check::Distinct:
            case Check::NotDistinct:
                return distinct();
            case Check::BodyAt:
                return place("log.body_range", "log.body_at", [](const LoggedTick& t) { return t.feet_m; });
            case Check::HipAt:
                return place("log.hand_range", "log.hand_at", [](const LoggedTick& t) { return t.hip_m; });
            case Check::ProxyAt:
                return place("log.proxy_range", "log.proxy_at", [](const LoggedTick& t) { return t.proxy_m; });
            case Check::Heading:
                return each_tick(
                    [&](const LoggedTick& t) {
                        const double off =
                            degrees_from_radians(std::abs(wrap_angle(t.heading_rad - radians_from_degrees(e_.low))));
                        return wrong_unless(off <= e_.tolerance, [=] {
                            return phrase("log.heading", {{"heading", degrees_from_radians(t.heading_rad)}});
                        });
                    },
                    phrase("log.heading_range", {{"heading", e_.low}}));
            case Check::Penetration:
                return each_tick(
                    [&](const LoggedTick& t) {
                        const double depth = overlap_m(scene_, t.proxy_m, t.radius_m);
                        return wrong_unless(depth <= e_.high, [=] {
                            return phrase("log.penetration", {{"depth", depth}, {"vector", shown(t.proxy_m)}});
                        });
                    },
                    phrase("log.penetration_range", {{"most", e_.high}}));
            case Check::Touching:
                return each_tick(
                    [&](const LoggedTick& t) {
                        const std::string name = t.contact ? stored_name(scene_, t.touched) : std::string("nothing");
                        return wrong_unless(words_in_order(e_.text, name), [=] {
                            if (!t.contact) return phrase("log.touching_nothing");
                            return name.empty() ? phrase("log.touching_unnamed")
                                                : phrase("log.touching", {{"name", name}});
                        });
                    },
                    phrase("log.touching_wanted", {{"name", e_.text}}));
            case Check::Free:
                return each_tick(
                    [&](const LoggedTick& t) {
                        return wrong_unless(!t.contact && t.force_n == Vec3(0.0), [=] {
                            return phrase(t.contact ? "log.contact" : "log.no_contact", {{"vector", shown(t.force_n)}});
                        });
                    },
                    phrase("log.free"));
        }
        return {};
    }

private:
    double moment(const Moment& m) const {
        if (m.action.empty()) return m.offset_s;
        const auto found = log_.action_times.find(m.action);
        if (found == log_.action_times.end()) return m.offset_s;
        return (m.at_end ? found->second.second : found->second.first) + m.offset_s;
    }
    std::string fail(const std::string& expected, const std::string& seen) const {
        return phrase("log.failed", {{"where", where_}, {"expected", expected}, {"seen", seen}});
    }

    std::string say(bool wanted) const {
        int found = 0;
        std::string others;
        for (const LoggedLine& line : log_.lines) {
            if (!window_.has(line.time_s)) continue;
            if (words_in_order(e_.text, line.text)) ++found;
            if (others.size() < 600) others += fmt::format(" {:.3f} s \"{}\"", line.time_s, line.text);
        }
        const int least = wanted ? e_.times.value_or(1) : 0;
        const bool holds = wanted ? (e_.times ? found == least : found >= 1) : found == 0;
        if (holds) return {};
        return fail(phrase(!wanted    ? "log.never"
                           : e_.times ? "log.exactly"
                                      : "log.at_least",
                           {{"text", e_.text}, {"count", least}}),
                    phrase(others.empty() ? "log.said_nothing" : "log.said", {{"count", found}, {"lines", others}}));
    }

    std::string say_in_order() const {
        std::string said;
        std::size_t begin = 0;
        const auto next = [&] {
            const std::size_t end = std::min(e_.text.find('|', begin), e_.text.size());
            std::string part = e_.text.substr(begin, end - begin);
            begin = end + 1;
            return part;
        };
        std::string part = next();
        for (const LoggedLine& line : log_.lines) {
            if (!window_.has(line.time_s)) continue;
            said += fmt::format(" {:.3f} s \"{}\"", line.time_s, line.text);
            if (!words_in_order(part, line.text)) continue;
            if (begin > e_.text.size()) return {};
            part = next();
        }
        return fail(phrase("log.in_turn", {{"text", part}}), phrase("log.not_there", {{"lines", said}}));
    }

    std::string nothing_twice() const {
        for (std::size_t i = 0; i < log_.lines.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (window_.has(log_.lines[k].time_s) && window_.has(log_.lines[i].time_s) &&
                    log_.lines[i].text == log_.lines[k].text && log_.lines[i].time_s - log_.lines[k].time_s < e_.high)
                    return fail(phrase("log.nothing_twice", {{"seconds", e_.high}}),
                                phrase("log.twice", {{"text", log_.lines[i].text},
                                                     {"first", log_.lines[k].time_s},
                                                     {"second", log_.lines[i].time_s}}));
        return {};
    }

    std::string sound_faster() const {
        std::vector<double> times_s;
        for (const LoggedSound& s : log_.sounds)
            if (window_.has(s.time_s) && is_wanted(s)) times_s.push_back(s.time_s);
        std::string seen;
        bool holds = times_s.size() >= 4;
        for (std::size_t i = 1; i < times_s.size(); ++i) {
            seen += fmt::format(" {:.3f}", times_s[i] - times_s[i - 1]);
            // A pause is longer only if the difference exceeds 0.02 s, which is about one frame.
            if (i >= 2 && times_s[i] - times_s[i - 1] > times_s[i - 1] - times_s[i - 2] + 0.02) holds = false;
        }
        if (holds && times_s.back() - times_s[times_s.size() - 2] < 0.5 * (times_s[1] - times_s[0])) return {};
        return fail(phrase("log.ever_sooner", {{"text", e_.text}}), phrase("log.seconds_between", {{"seconds", seen}}));
    }

    bool is_wanted(const LoggedSound& s) const {
        if (e_.pitch && (s.cue.pitch < (*e_.pitch)[0] || s.cue.pitch > (*e_.pitch)[1])) return false;
        if (cues::info(s.cue.kind).name != e_.text ||
            (!e_.material.empty() && cues::material_sound_name(s.cue.material) != e_.material))
            return false;
        return !e_.muffled_db || (s.cue.loudness > 0.0 && s.cue.muffled_db >= (*e_.muffled_db)[0] &&
                                  s.cue.muffled_db <= (*e_.muffled_db)[1]);
    }

    std::string sound() const {
        int found = 0;
        double latest_ms = 0.0;
        std::string others;
        for (const LoggedSound& s : log_.sounds) {
            if (!window_.has(s.time_s)) continue;
            if (is_wanted(s)) {
                ++found;
                latest_ms = std::max(latest_ms, (s.time_s - s.cue.event_time_s) * 1e3);
            } else if (!s.loop && others.size() < 400) {
                others += " " + phrase("log.other", {{"seconds", s.time_s},
                                                     {"sound", cues::info(s.cue.kind).name},
                                                     {"material", cues::material_sound_name(s.cue.material)}});
            }
        }
        const bool wanted = e_.check == Check::Sound;
        const std::string what =
            phrase(e_.material.empty() ? "log.sound" : "log.sound_of", {{"sound", e_.text}, {"material", e_.material}});
        if (wanted ? (e_.times ? found != *e_.times : found < 1) : found != 0)
            return fail(phrase(!wanted    ? "log.sound_never"
                               : e_.times ? "log.sound_exactly"
                                          : "log.sound_once",
                               {{"sound", what}, {"count", e_.times.value_or(1)}}),
                        phrase(others.empty() ? "log.sound_no_others" : "log.sound_others",
                               {{"count", found}, {"others", others}}));
        if (wanted && e_.high >= 0.0 && latest_ms > e_.high)
            return fail(phrase("log.sound_within", {{"sound", what}, {"ms", e_.high}}),
                        phrase("log.sound_after", {{"ms", latest_ms}}));
        return {};
    }

    std::string sound_rising() const {
        double last = -1.0, first = -1.0;
        for (const LoggedSound& s : log_.sounds) {
            if (!window_.has(s.time_s) || !is_wanted(s)) continue;
            if (first < 0.0) first = s.cue.loudness;
            if (s.cue.loudness < last - 1e-9)
                return fail(phrase("log.to_grow", {{"sound", e_.text}}),
                            phrase("log.fell", {{"before", last}, {"after", s.cue.loudness}, {"seconds", s.time_s}}));
            last = s.cue.loudness;
        }
        if (first < 0.0 || !(last > first))
            return fail(phrase("log.to_grow", {{"sound", e_.text}}),
                        first < 0.0 ? phrase("log.not_heard") : phrase("log.all_the_time", {{"loudness", first}}));
        return {};
    }

    // Returns what is wrong with a tick, or an empty text if nothing is. It is a function, so that words are made only
    // when needed, because there are a thousand ticks a second.
    using Wrong = std::function<std::string()>;
    template <class Words>
    static Wrong wrong_unless(bool holds, Words words) {
        return holds ? Wrong{} : Wrong(std::move(words));
    }

    template <class Test>
    std::string each_tick(Test test, const std::string& expected) const {
        Wrong last;
        double last_s = 0.0;
        bool any_tick = false;
        for (const LoggedTick& t : ticks_) {
            if (!window_.has(t.time_s)) continue;
            any_tick = true;
            Wrong wrong = test(t);
            if (!wrong && !e_.always) return {};
            if (wrong && e_.always)
                return fail(phrase("log.always", {{"expected", expected}}),
                            phrase("log.at", {{"seen", wrong()}, {"seconds", t.time_s}}));
            last = std::move(wrong);
            last_s = t.time_s;
        }
        if (!any_tick) return fail(expected, phrase("log.no_tick"));
        if (e_.always) return {};
        return fail(phrase("log.sometime", {{"expected", expected}}),
                    phrase("log.at_end", {{"seen", last()}, {"seconds", last_s}}));
    }

    std::string force_step() const {
        const LoggedTick* before = nullptr;
        double worst = 0.0, when = 0.0;
        for (const LoggedTick& t : ticks_) {
            if (!window_.has(t.time_s)) continue;
            if (before) {
                const double step = glm::length(t.force_n - before->force_n);
                if (step > worst) {
                    worst = step;
                    when = t.time_s;
                }
            }
            before = &t;
        }
        return worst <= e_.high ? std::string()
                                : fail(phrase("log.force_step", {{"most", e_.high}}),
                                       phrase("log.newtons_at", {{"force", worst}, {"seconds", when}}));
    }

    std::string force_lines() const {
        double worst = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<double> samples;
            for (const LoggedTick& t : ticks_)
                if (window_.has(t.time_s)) samples.push_back(t.force_n[axis]);
            worst = std::max(worst, line_amplitude(samples, 1e-3, e_.from_hz, e_.to_hz));
        }
        return worst <= e_.high
                   ? std::string()
                   : fail(phrase("log.force_band", {{"most", e_.high}, {"from", e_.from_hz}, {"to", e_.to_hz}}),
                          phrase("log.newtons", {{"force", worst}}));
    }

    std::string strongest_line() const {
        double best_n = 0.0, best_hz = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<double> samples;
            for (const LoggedTick& t : ticks_)
                if (window_.has(t.time_s)) samples.push_back(t.force_n[axis]);
            const double step_hz = samples.empty() ? 1.0 : 0.25e3 / static_cast<double>(samples.size());
            for (double hz = e_.from_hz; hz <= e_.to_hz; hz += step_hz)
                if (const double n = line_amplitude(samples, 1e-3, hz, hz); n > best_n) {
                    best_n = n;
                    best_hz = hz;
                }
        }
        if (best_n >= e_.tolerance && best_hz >= e_.low && best_hz <= e_.high) return {};
        return fail(phrase("log.strongest_line", {{"from", e_.low}, {"to", e_.high}, {"least", e_.tolerance}}),
                    phrase("log.line", {{"force", best_n}, {"hz", best_hz}}));
    }

    std::string distinct() const {
        const std::vector<std::string> problems = lint_materials(scene_).problems;
        if (e_.check == Check::Distinct)
            return problems.empty() ? std::string() : fail(phrase("log.told_apart"), problems.front());
        for (const std::string& problem : problems)
            if (words_in_order(e_.text, problem)) return {};
        return fail(phrase("log.to_be_named", {{"text", e_.text}}),
                    problems.empty() ? phrase("log.nothing_reported") : problems.front());
    }

    std::string force_spike() const {
        const LoggedTick* first = nullptr;
        const LoggedTick* before = nullptr;
        for (const LoggedTick& t : ticks_) {
            if (!window_.has(t.time_s)) continue;
            if (!first) first = &t;
            if (before) {
                const double force = glm::length(t.force_n), last = glm::length(before->force_n),
                             begin = glm::length(first->force_n);
                if (force > e_.high * std::min(last, begin) + 1e-9)
                    return fail(phrase("log.force_spike", {{"most", e_.high}}),
                                phrase("log.spike",
                                       {{"force", force}, {"seconds", t.time_s}, {"last", last}, {"first", begin}}));
            }
            before = &t;
        }
        return first ? std::string() : fail(phrase("log.a_force"), phrase("log.no_tick"));
    }

    std::string force_rising() const {
        const LoggedTick* before = nullptr;
        for (const LoggedTick& t : ticks_) {
            if (!window_.has(t.time_s)) continue;
            if (before && glm::length(t.force_n) < glm::length(before->force_n) - 1e-9)
                return fail(phrase("log.only_rises"), phrase("log.falls", {{"force", glm::length(t.force_n)},
                                                                           {"last", glm::length(before->force_n)},
                                                                           {"seconds", t.time_s}}));
            before = &t;
        }
        return {};
    }

    template <class Where>
    std::string place(const char* wanted, const char* seen, Where where) const {
        return each_tick(
            [&](const LoggedTick& t) {
                double off = 0.0;
                for (int axis = 0; axis < 3; ++axis)
                    if (!std::isnan(e_.vector[axis])) off = std::max(off, std::abs(where(t)[axis] - e_.vector[axis]));
                return wrong_unless(off <= e_.tolerance, [=] { return phrase(seen, {{"place", shown(where(t))}}); });
            },
            phrase(wanted, {{"within", e_.tolerance}, {"place", shown(e_.vector)}}));
    }

    const SessionLog& log_;
    const std::vector<LoggedTick>& ticks_;
    const Scene& scene_;
    const Expectation& e_;
    Window window_{};
    std::string where_;
};

}  // namespace

std::vector<std::string> failures(const Scenario& scenario, const SessionLog& log, const Scene& scene) {
    std::vector<std::string> found;
    for (const Expectation& e : scenario.expectations) {
        const std::string failure = Checker(scenario, log, scene, e).failure();
        if (!failure.empty()) found.push_back(failure);
    }
    return found;
}

}  // namespace handrail::core
