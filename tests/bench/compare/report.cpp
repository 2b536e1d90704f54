#include "tests/bench/compare/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/bench/compare/svg_plot.h"
#include "tests/support/names.h"
#include "worlds/base/text.h"

namespace handrail::bench {
namespace {

using Json = nlohmann::ordered_json;

// Smallest error in the plots; smaller errors are drawn at this value. It is a millionth of what any device resolves.
constexpr double kLeastError_m = 1e-12;
// Families of spheres are named "sphere of N triangles", or "simplified sphere of N triangles, within E mm".
constexpr std::string_view kSphere = "sphere of ", kSimplified = "simplified ";

bool hard_case(const std::string& family) {
    return family.size() > 1 && family[0] == 'T' && family[1] >= '0' && family[1] <= '9';
}

template <class Chosen>
std::vector<Summary> summarise(const BenchReport& report, bool by_family, Chosen&& chosen) {
    std::vector<Summary> all;
    for (const Measured& m : report.results) {
        if (!chosen(m)) continue;
        auto found = std::find_if(all.begin(), all.end(), [&](const Summary& s) {
            return s.renderer == m.renderer && (!by_family || s.family == m.family);
        });
        if (found == all.end()) {
            all.push_back({});
            found = all.end() - 1;
            found->family = by_family ? m.family : "";
            found->renderer = m.renderer;
            found->title = m.title;
            found->knob = m.knob;
            found->knob_value = m.knob_value;
            found->has_proxy = m.has_proxy;
        }
        Summary& s = *found;
        ++s.scenes;
        s.mean_s += m.mean_s;
        s.p999_s = std::max(s.p999_s, m.p999_s);
        s.worst_s = std::max(s.worst_s, m.worst_s);
        s.largest_jump_n = std::max(s.largest_jump_n, m.largest_jump_n);
        s.largest_gain = std::max(s.largest_gain, m.largest_gain);
        s.penetration_m = std::max(s.penetration_m, m.penetration_m);
        if (m.referenced) {
            ++s.referenced;
            s.error_rms_m += m.error_rms_m * m.error_rms_m;
            s.error_max_m = std::max(s.error_max_m, m.error_max_m);
            s.off_share += m.off_share;
            s.wrong_holds += m.wrong_holds;
        }
        if (m.given_j) {
            s.given_j = s.closed ? std::max(s.given_j, *m.given_j) : *m.given_j;
            s.closed = true;
        }
        if (m.direction_error_rms_rad) {
            s.direction_rms_rad = std::max(s.direction_rms_rad, *m.direction_error_rms_rad);
            s.direction_max_rad = std::max(s.direction_max_rad, *m.direction_error_max_rad);
        }
        if (m.instructions) s.instructions = std::max(s.instructions, *m.instructions);
    }
    for (Summary& s : all) {
        s.mean_s /= s.scenes;
        if (s.referenced > 0) {
            s.error_rms_m = std::sqrt(s.error_rms_m / s.referenced);
            s.off_share /= s.referenced;
        }
    }
    return all;
}

bool is_main(const Summary& s) {
    if (s.renderer == "handrail_uncapped") return true;
    for (const Contestant& c : main_contestants())
        if (c.key == s.renderer) return true;
    return false;
}

// Formats a time for reading: three digits, and no exponent if a unit prefix is enough.
std::string time_words(double seconds) {
    if (seconds < 999.5e-9) return fmt::format("{:.0f} ns", seconds * 1e9);
    if (seconds < 999.5e-6) return fmt::format("{:.3g} us", seconds * 1e6);
    if (seconds < 0.9995) return fmt::format("{:.3g} ms", seconds * 1e3);
    return fmt::format("{:.3g} s", seconds);
}
std::string length_words(double metres) {
    const double size = std::abs(metres);
    if (size < 1e-12) return "0";
    if (size < 0.9995e-9) return fmt::format("{:.0f} pm", metres * 1e12);
    if (size < 0.9995e-6) return fmt::format("{:.3g} nm", metres * 1e9);
    if (size < 0.9995e-3) return fmt::format("{:.3g} um", metres * 1e6);
    return fmt::format("{:.3g} mm", metres * 1e3);
}
std::string energy_words(double joules) {
    if (std::abs(joules) < 5e-7) return "0";
    return std::abs(joules) < 0.9995 ? fmt::format("{:.3g} mJ", joules * 1e3) : fmt::format("{:.3g} J", joules);
}

// Returns the columns of a row, both for text and for Markdown.
const std::vector<std::string>& columns() {
    static const std::vector<std::string> names{
        "Renderer",          "Mean tick",   "99.9 %",      "Worst tick", "Error, rms", "Largest",
        "Off by over 10 um", "Penetration", "Wrong holds", "Force jump", "Work given", "Instructions"};
    return names;
}
std::vector<std::string> cells(const Summary& s) {
    const bool known = s.referenced > 0;
    return {s.title,
            time_words(s.mean_s),
            time_words(s.p999_s),
            time_words(s.worst_s),
            known ? length_words(s.error_rms_m) : "-",
            known ? length_words(s.error_max_m) : "-",
            known ? fmt::format("{:.2g} %", 100.0 * s.off_share) : "-",
            s.has_proxy                   ? length_words(std::max(0.0, s.penetration_m))
            : s.renderer == "penalty_sum" ? "no ball"
                                          : "-",
            known ? std::to_string(s.wrong_holds) : "-",
            fmt::format("{:.3g} N", s.largest_jump_n),
            s.closed ? energy_words(s.given_j) : "-",
            s.instructions >= 0.0 ? fmt::format("{:.0f}", s.instructions) : "-"};
}

std::vector<std::string> families_of(const std::vector<Summary>& all) {
    std::vector<std::string> families;
    for (const Summary& s : all)
        if (std::find(families.begin(), families.end(), s.family) == families.end()) families.push_back(s.family);
    return families;
}

void table(std::ostringstream& out, const std::vector<Summary>& rows, bool markdown) {
    std::vector<std::vector<std::string>> lines{columns()};
    for (const Summary& s : rows) lines.push_back(cells(s));
    // Leaves out columns that are empty in `rows`.
    std::vector<std::size_t> width(columns().size(), 0);
    std::vector<bool> says(columns().size(), false);
    for (std::size_t r = 0; r < lines.size(); ++r)
        for (std::size_t c = 0; c < width.size(); ++c) {
            width[c] = std::max(width[c], lines[r][c].size());
            says[c] = says[c] || (r > 0 && lines[r][c] != "-");
        }
    for (std::size_t r = 0; r < lines.size(); ++r) {
        std::string line = markdown ? "|" : "  ";
        for (std::size_t c = 0; c < width.size(); ++c) {
            if (!says[c]) continue;
            line += markdown ? " " + lines[r][c] + " |"
                    : c == 0 ? fmt::format("{:<{}}", lines[r][c], width[c])
                             : fmt::format("  {:>{}}", lines[r][c], width[c]);
        }
        out << line << '\n';
        if (markdown && r == 0)
            out << "|---|" << [&] {
                std::string rule;
                for (std::size_t c = 1; c < width.size(); ++c) rule += says[c] ? "---|" : "";
                return rule;
            }() << '\n';
    }
}

std::string family_words(const BenchReport& report, const std::string& family) {
    int scenes = 0;
    std::size_t ticks = 0, obstacles = 0;
    double build_s = 0.0, bytes = 0.0, simplified_m = 0.0;
    for (const SceneCost& c : report.scenes)
        if (c.family == family) {
            ++scenes;
            simplified_m = std::max(simplified_m, c.simplify_measured_m);
            ticks += c.ticks;
            obstacles = std::max(obstacles, c.obstacles);
            build_s = std::max(build_s, c.build_s);
            bytes = std::max(bytes, c.bytes_per_obstacle);
        }
    return fmt::format("{}{}: {} scene{}, up to {} obstacle{}, {} ticks; built in {}, {:.0f} bytes each", family,
                       simplified_m > 0.0 ? fmt::format(" (measured: {})", length_words(simplified_m)) : "", scenes,
                       scenes == 1 ? "" : "s", obstacles, obstacles == 1 ? "" : "s", ticks, time_words(build_s), bytes);
}

std::string direction_words(const std::vector<Summary>& rows) {
    std::string words;
    for (const Summary& s : rows)
        if (s.direction_rms_rad >= 0.0)
            words += fmt::format("{}{} {:.3g} degrees rms, {:.3g} at most",
                                 words.empty() ? "Direction of the force against the exact sphere: " : "; ", s.title,
                                 degrees_from_radians(s.direction_rms_rad), degrees_from_radians(s.direction_max_rad));
    return words.empty() ? words : words + ".\n";
}

// Returns the rows of the main renderers, or those of the knobs. If `family` is not empty, returns only the rows of
// that family.
std::vector<Summary> only(std::vector<Summary> rows, bool main, const std::string& family) {
    std::erase_if(rows,
                  [&](const Summary& s) { return is_main(s) != main || (!family.empty() && s.family != family); });
    return rows;
}

std::string heading_of(const std::string& words, bool markdown) {
    return markdown ? "\n## " + words + "\n\n" : "\n" + words + "\n";
}

void hard_case_table(std::ostringstream& out, const BenchReport& report, bool markdown) {
    const std::vector<Summary> hard = hard_case_summary(report);
    if (hard.empty()) return;
    out << heading_of("All hard cases together", markdown);
    table(out, only(hard, true, ""), markdown);
}

void knob_table(std::ostringstream& out, const BenchReport& report, bool markdown) {
    const std::vector<Summary> knobs = only(hard_case_summary(report), false, "");
    if (knobs.empty()) return;
    out << heading_of("The knobs, over all hard cases", markdown);
    table(out, knobs, markdown);
}

void family_tables(std::ostringstream& out, const BenchReport& report, bool markdown) {
    const std::vector<Summary> by_family = summaries(report);
    for (const std::string& family : families_of(by_family)) {
        out << heading_of(family_words(report, family), markdown);
        const std::vector<Summary> rows = only(by_family, true, family);
        table(out, rows, markdown);
        const std::string directions = direction_words(rows);
        if (!directions.empty()) out << (markdown ? "\n" : "  ") << directions;
    }
}

// Writes the table of the worst ticks.
void worst_tick_table(std::ostringstream& out, const BenchReport& report, bool markdown) {
    const auto heading = [&](const std::string& words) { out << heading_of(words, markdown); };
    if (!report.worst.empty()) {
        heading("The worst ticks: places with more near the ball than a tick has time for");
        if (markdown)
            out << "| Place | Mean tick | 99.9 % | Worst tick | Most work | Most looks | Ticks that waited | "
                   "Instructions, mean | Instructions, worst tick |\n|---|---|---|---|---|---|---|---|---|\n";
        for (const WorstTicks& w : report.worst) {
            const std::string waited = fmt::format("{} of {}", w.waits, w.ticks),
                              counted = w.instructions >= 0.0 ? fmt::format("{:.0f}", w.instructions) : "-",
                              most = w.worst_instructions >= 0.0 ? fmt::format("{:.0f}", w.worst_instructions) : "-";
            if (markdown)
                out << fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", w.scene, time_words(w.mean_s),
                                   time_words(w.p999_s), time_words(w.worst_s), w.most_work, w.most_looks, waited,
                                   counted, most);
            else
                out << fmt::format(
                    "  {}: mean {}, 99.9 % {}, worst {}; at most {} of work and {} looks; {} ticks waited{}\n", w.scene,
                    time_words(w.mean_s), time_words(w.p999_s), time_words(w.worst_s), w.most_work, w.most_looks,
                    waited,
                    w.instructions >= 0.0 ? "; " + counted + " instructions in the mean, " + most + " at worst" : "");
        }
    }
}

// Writes the tables of the stiffest walls, moving objects and the servo thread.
void loop_tables(std::ostringstream& out, const BenchReport& report, bool markdown) {
    const auto heading = [&](const std::string& words) { out << heading_of(words, markdown); };
    if (!report.stability.empty()) {
        heading("Stiffest wall that a hand holds with each renderer (0.3 kg, 3 Ns/m, 6 N, delay 1 ms, no damping)");
        std::vector<std::string> walls;
        for (const Stability& s : report.stability)
            if (std::find(walls.begin(), walls.end(), s.wall) == walls.end()) walls.push_back(s.wall);
        if (markdown) {
            out << "| Renderer |";
            for (const std::string& wall : walls) out << " " << wall << ", N/m |";
            out << "\n|---|";
            for (std::size_t i = 0; i < walls.size(); ++i) out << "---|";
            out << '\n';
            for (const Contestant& c : main_contestants()) {
                out << "| " << c.title << " |";
                for (const std::string& wall : walls)
                    for (const Stability& s : report.stability)
                        if (s.wall == wall && s.renderer == c.key) out << fmt::format(" {:.0f} |", s.stiffness_n_per_m);
                out << '\n';
            }
        } else {
            for (const Stability& s : report.stability)
                out << fmt::format("  {}, {}: {:.0f} N/m\n", s.wall, s.title, s.stiffness_n_per_m);
        }
    }
    if (!report.bodies.empty()) {
        heading("Moving objects: a ball on a rubber string, pushed to and fro without damping");
        if (markdown)
            out << "| Method | Mass | Error of the force, rms | Swing of the force | Given to the hand in a loop | "
                   "Correct | Tick of the hand | Step of the engine |\n|---|---|---|---|---|---|---|---|\n";
        for (const BodiesMeasured& b : report.bodies)
            out << fmt::format(
                fmt::runtime(
                    markdown ? "| {} | {:g} kg | {:.3f} N | {:.2f} N | {:+.3f} mJ | {:+.3f} mJ | {} | {} |\n"
                             : "  {}, {:g} kg: {:.3f} N off in a swing of {:.2f} N; {:+.3f} mJ given to the hand in a "
                               "loop where {:+.3f} mJ are right; tick {}, engine's step {}\n"),
                b.way, b.mass_kg, b.error_n, b.felt_n, 1e3 * b.given_j, 1e3 * b.right_given_j, time_words(b.tick_s),
                time_words(b.step_s));
    }
    if (report.servo) {
        const ServoMeasured& s = *report.servo;
        heading(fmt::format("The servo thread, {:g} s with a simulated Falcon in two walls", s.seconds));
        out << fmt::format(
            "{}{} ticks; period up to {} in half and {} in 99 % of them, worst {}; a tick up to {} in 99 % of them, "
            "worst {}; {} overruns. {}\n",
            markdown ? "" : "  ", s.ticks, time_words(s.periods.quantile_s(0.5)),
            time_words(s.periods.quantile_s(0.99)), time_words(s.periods.worst_s),
            time_words(s.durations.quantile_s(0.99)), time_words(s.durations.worst_s), s.overruns, s.scheduling);
    }
}

// Writes the overview, with a row for each family and a column for each renderer.
void at_a_glance(std::ostringstream& out, const BenchReport& report) {
    const std::vector<Summary> all = summaries(report);
    std::vector<Summary> titles;
    for (const Summary& s : all)
        if (is_main(s) &&
            std::none_of(titles.begin(), titles.end(), [&](const Summary& t) { return t.renderer == s.renderer; }))
            titles.push_back(s);
    const auto one_table = [&](const std::string& heading, auto&& belongs, auto&& cell) {
        std::string rows;
        for (const std::string& family : families_of(all)) {
            if (!belongs(family)) continue;
            rows += "| " + family + " |";
            for (const Summary& t : titles) {
                const auto found = std::find_if(all.begin(), all.end(), [&](const Summary& s) {
                    return s.family == family && s.renderer == t.renderer;
                });
                rows += " " + (found == all.end() ? std::string("-") : cell(*found)) + " |";
            }
            rows += '\n';
        }
        if (rows.empty()) return;
        out << "\n## At a glance: " << heading << "\n\n| Family |";
        for (const Summary& t : titles) out << ' ' << t.title << " |";
        out << "\n|---|";
        for (std::size_t i = 0; i < titles.size(); ++i) out << "---|";
        out << '\n' << rows;
    };
    one_table(
        "mean tick and error, rms", [](const std::string& f) { return f.find("sphere") == std::string::npos; },
        [](const Summary& s) {
            return time_words(s.mean_s) + (s.referenced > 0 ? ", " + length_words(s.error_rms_m) : "");
        });
    one_table(
        "sliding over a sphere of 0.5 m; mean and worst tick, direction of the force, instructions",
        [](const std::string& f) { return f.find("sphere") != std::string::npos; },
        [](const Summary& s) {
            return fmt::format("{}, {}, {:.2g} degrees rms{}", time_words(s.mean_s), time_words(s.worst_s),
                               degrees_from_radians(s.direction_rms_rad),
                               s.instructions >= 0.0 ? fmt::format(", {:.0f} instructions", s.instructions) : "");
        });
}

// Makes a plot with a point for each main renderer and a curve for each knob.
Plot plot_of(const std::string& title, const std::vector<Summary>& rows, double Summary::*error,
             const std::string& error_title, double least) {
    Plot plot{title, "mean time of one tick, nanoseconds", error_title, 0.0, least, {}};
    std::vector<PlotSeries> curves;
    for (const Summary& s : rows) {
        if (s.referenced == 0 || s.*error < 0.0) continue;
        const PlotPoint point{s.mean_s * 1e9, s.*error, {}};
        if (is_main(s)) {
            plot.series.push_back({s.title, {point}, false});
        } else {
            const std::string name = s.renderer.starts_with("active_set") ? "Active-set god-object, by rounds"
                                     : s.knob == "rounds"                 ? "Handrail's solver alone, by rounds"
                                                          : "Handrail's solver alone, by candidate margin";
            auto found =
                std::find_if(curves.begin(), curves.end(), [&](const PlotSeries& c) { return c.name == name; });
            if (found == curves.end()) {
                curves.push_back({name, {}, true});
                found = curves.end() - 1;
            }
            found->points.push_back(
                {point.x, point.y,
                 s.knob == "rounds" ? fmt::format("{:g}", s.knob_value) : fmt::format("{:g} mm", s.knob_value * 1e3)});
        }
    }
    plot.series.insert(plot.series.end(), curves.begin(), curves.end());
    return plot;
}

std::string file_word(const std::string& words) {
    std::string out;
    for (const char c : lower_ascii(words)) out += (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '-';
    return out;
}

}  // namespace

std::vector<Summary> summaries(const BenchReport& report) {
    return summarise(report, true, [](const Measured&) { return true; });
}
std::vector<Summary> hard_case_summary(const BenchReport& report) {
    return summarise(report, false, [](const Measured& m) { return hard_case(m.family); });
}

std::string text_of(const BenchReport& report) {
    std::ostringstream out;
    out << fmt::format(
        "Speed against error, on {}, in {:.0f} seconds{}. At 1 kN/m a millimetre of error is a newton.\n",
        report.machine, report.took_s, report.quick ? ", quickly: times are rough" : "");
    for (const std::string& sentence : report.left_out) out << sentence << '\n';
    hard_case_table(out, report, false);
    knob_table(out, report, false);
    family_tables(out, report, false);
    worst_tick_table(out, report, false);
    loop_tables(out, report, false);
    return out.str();
}

std::string markdown_of(const BenchReport& report, const std::string& families_file) {
    std::ostringstream out;
    out << fmt::format(
        "<!-- Made by `./run bench --compare --markdown`; do not edit. -->\n"
        "# Speed against error: tables\n\nMeasured {} on "
        "{}{}. [How to read this](results/speed.md#speed-against-error); [each family separately]({}).\n",
        report.day, report.machine, report.quick ? ", quickly: times are rough" : "", families_file);
    for (const std::string& sentence : report.left_out) out << '\n' << sentence << '\n';
    hard_case_table(out, report, true);
    worst_tick_table(out, report, true);
    return out.str();
}

std::string families_markdown_of(const BenchReport& report, const std::string& first_file) {
    std::ostringstream out;
    out << fmt::format(
        "<!-- Made by `./run bench --compare --markdown`; do not edit. -->\n"
        "# Speed against error: each family separately\n\n"
        "Measured {} on {}{}. [All hard cases together]({}).\n",
        report.day, report.machine, report.quick ? ", quickly: times are rough" : "", first_file);
    at_a_glance(out, report);
    knob_table(out, report, true);
    loop_tables(out, report, true);
    family_tables(out, report, true);
    return out.str();
}

std::string json_of(const BenchReport& report) {
    Json results = Json::array(), scenes = Json::array(), stability = Json::array(), servo;
    for (const Measured& m : report.results) {
        Json one{{"scene", m.scene},
                 {"family", m.family},
                 {"seed", m.seed},
                 {"renderer", m.renderer},
                 {"title", m.title},
                 {"ticks", m.ticks},
                 {"mean_tick_s", m.mean_s},
                 {"p50_tick_s", m.p50_s},
                 {"p999_tick_s", m.p999_s},
                 {"worst_tick_s", m.worst_s},
                 {"mean_rounds", m.mean_rounds},
                 {"most_rounds", m.most_rounds},
                 {"largest_force_jump_n", m.largest_jump_n},
                 {"largest_gain", m.largest_gain}};
        if (!m.knob.empty()) {
            one["knob"] = m.knob;
            one["knob_value"] = m.knob_value;
        }
        const auto or_null = [](bool known, double value) { return known ? Json(value) : Json(nullptr); };
        one["error_rms_m"] = or_null(m.referenced, m.error_rms_m);
        one["error_p99_m"] = or_null(m.referenced, m.error_p99_m);
        one["error_max_m"] = or_null(m.referenced, m.error_max_m);
        one["share_off_by_10_um"] = or_null(m.referenced, m.off_share);
        one["wrong_holds"] = m.referenced ? Json(m.wrong_holds) : Json(nullptr);
        one["penetration_m"] = or_null(m.has_proxy, m.penetration_m);
        one["work_given_j"] = or_null(m.given_j.has_value(), m.given_j.value_or(0.0));
        if (m.direction_error_rms_rad) {
            one["direction_error_rms_rad"] = *m.direction_error_rms_rad;
            one["direction_error_max_rad"] = *m.direction_error_max_rad;
        }
        one["instructions_per_tick"] = or_null(m.instructions.has_value(), m.instructions.value_or(0.0));
        results.push_back(std::move(one));
    }
    for (const SceneCost& c : report.scenes)
        scenes.push_back({{"scene", c.scene},
                          {"family", c.family},
                          {"obstacles", c.obstacles},
                          {"ticks", c.ticks},
                          {"build_s", c.build_s},
                          {"bytes_per_obstacle", c.bytes_per_obstacle},
                          {"referenced", c.referenced},
                          {"simplify_bound_m", c.simplify_bound_m},
                          {"simplify_measured_m", c.simplify_measured_m}});
    for (const Stability& s : report.stability)
        stability.push_back(
            {{"wall", s.wall}, {"renderer", s.renderer}, {"stable_stiffness_n_per_m", s.stiffness_n_per_m}});
    if (report.servo)
        servo = {{"seconds_s", report.servo->seconds},
                 {"ticks", report.servo->ticks},
                 {"period_p50_s", report.servo->periods.quantile_s(0.5)},
                 {"period_p99_s", report.servo->periods.quantile_s(0.99)},
                 {"period_worst_s", report.servo->periods.worst_s},
                 {"tick_p99_s", report.servo->durations.quantile_s(0.99)},
                 {"tick_worst_s", report.servo->durations.worst_s},
                 {"overruns", report.servo->overruns},
                 {"scheduling", report.servo->scheduling}};
    Json worst = Json::array();
    for (const WorstTicks& w : report.worst)
        worst.push_back(
            {{"scene", w.scene},
             {"ticks", w.ticks},
             {"mean_s", w.mean_s},
             {"p999_s", w.p999_s},
             {"worst_s", w.worst_s},
             {"most_work", w.most_work},
             {"most_looks", w.most_looks},
             {"waits", w.waits},
             {"instructions", w.instructions >= 0.0 ? Json(w.instructions) : Json(nullptr)},
             {"worst_instructions", w.worst_instructions >= 0.0 ? Json(w.worst_instructions) : Json(nullptr)}});
    Json bodies = Json::array();
    for (const BodiesMeasured& b : report.bodies)
        bodies.push_back({{"way", b.way},
                          {"mass_kg", b.mass_kg},
                          {"error_n", b.error_n},
                          {"felt_n", b.felt_n},
                          {"given_j", b.given_j},
                          {"right_given_j", b.right_given_j},
                          {"tick_s", b.tick_s},
                          {"step_s", b.step_s}});
    const Json all{
        {"machine", report.machine}, {"quick", report.quick},         {"stiffness_n_per_m", kStiffness_n_per_m},
        {"took_s", report.took_s},   {"results", std::move(results)}, {"scenes", std::move(scenes)},
        {"worst", std::move(worst)}, {"bodies", std::move(bodies)},   {"stability", std::move(stability)},
        {"servo_thread", servo},     {"left_out", report.left_out}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::pair<std::string, std::string>> plots_of(const BenchReport& report) {
    std::vector<std::pair<std::string, std::string>> files;
    const std::string error = "error of the ball's place, rms, metres";
    if (const std::vector<Summary> hard = hard_case_summary(report); !hard.empty())
        files.emplace_back("bench-hard-cases.svg", svg_of(plot_of("Speed against error over all hard cases", hard,
                                                                  &Summary::error_rms_m, error, kLeastError_m)));
    const std::vector<Summary> by_family = summaries(report);
    Plot cost{"What the density of a mesh costs",
              "triangles of a sphere of half a metre",
              "time of one tick, nanoseconds: mean, and worst",
              0.0,
              0.0,
              {}};
    for (const std::string& family : families_of(by_family)) {
        std::vector<Summary> rows = by_family;
        std::erase_if(rows, [&](const Summary& s) { return s.family != family; });
        if (family.starts_with("sphere")) {
            files.emplace_back(
                "bench-" + file_word(family) + ".svg",
                svg_of(plot_of("Speed against direction of the force, " + family, rows, &Summary::direction_rms_rad,
                               "error of the force's direction, rms, radians", 0.0)));
            double triangles = 0.0;
            for (const SceneCost& c : report.scenes)
                if (c.family == family) triangles = static_cast<double>(c.obstacles);
            for (const Summary& s : rows) {
                if (!is_main(s)) continue;
                for (const bool worst : {false, true}) {
                    const std::string name = s.title + (worst ? ", worst" : ", mean");
                    if (worst && s.renderer != "handrail") continue;
                    auto found = std::find_if(cost.series.begin(), cost.series.end(),
                                              [&](const PlotSeries& c) { return c.name == name; });
                    if (found == cost.series.end()) {
                        cost.series.push_back({name, {}, true});
                        found = cost.series.end() - 1;
                    }
                    found->points.push_back({triangles, (worst ? s.worst_s : s.mean_s) * 1e9, {}});
                }
            }
        } else if (!family.starts_with(kSimplified) &&
                   std::any_of(rows.begin(), rows.end(), [](const Summary& s) { return s.referenced > 0; })) {
            files.emplace_back(
                "bench-" + file_word(family) + ".svg",
                svg_of(plot_of("Speed against error, " + family, rows, &Summary::error_rms_m, error, kLeastError_m)));
        }
    }
    if (!cost.series.empty()) files.emplace_back("bench-triangles.svg", svg_of(cost));
    const std::string direction = "error of the force's direction against the exact sphere, rms, degrees";
    Plot density{"How dense a mesh must be", "mean time of one tick, nanoseconds", direction, 0.0, 0.0, {}};
    Plot simplified{"What simplifying a mesh buys", "mean time of one tick, nanoseconds", direction, 0.0, 0.0, {}};
    for (const Summary& s : by_family) {
        if (s.direction_rms_rad < 0.0 || !is_main(s)) continue;
        // The label of a point is for example "9680" for an unchanged sphere and "0.3 mm" for a simplified one.
        const bool coarser = s.family.starts_with(kSimplified);
        const std::size_t digits = coarser ? s.family.find("within ") + 7 : kSphere.size();
        const std::string label =
            s.family.substr(digits, coarser ? std::string::npos : s.family.find(" triangles") - digits);
        std::vector<PlotSeries>& series = coarser ? simplified.series : density.series;
        auto found = std::find_if(series.begin(), series.end(), [&](const PlotSeries& c) { return c.name == s.title; });
        if (found == series.end()) {
            series.push_back({s.title, {}, true});
            found = series.end() - 1;
        }
        found->points.push_back(
            {s.mean_s * 1e9, degrees_from_radians(s.direction_rms_rad), s.renderer == "handrail" ? label : ""});
    }
    if (!density.series.empty()) files.emplace_back("bench-density.svg", svg_of(density));
    if (!simplified.series.empty()) files.emplace_back("bench-simplified.svg", svg_of(simplified));
    return files;
}

std::size_t merge_instructions(BenchReport& report, const std::string& lines) {
    std::size_t merged = 0;
    std::istringstream in(lines);
    for (std::string line; std::getline(in, line);) {
        const std::size_t first = line.find('\t'), second = line.find('\t', first + 1);
        double value = 0.0;
        if (first == std::string::npos || second == std::string::npos || !parse_finite(line.substr(second + 1), value))
            continue;
        for (WorstTicks& w : report.worst)
            if (w.scene == line.substr(0, first)) {
                const bool of_worst = line.substr(first + 1, second - first - 1) == "worst tick";
                (of_worst ? w.worst_instructions : w.instructions) = value;
                ++merged;
            }
        for (Measured& m : report.results)
            if (m.scene == line.substr(0, first) && m.renderer == line.substr(first + 1, second - first - 1)) {
                m.instructions = value;
                ++merged;
            }
    }
    return merged;
}

}  // namespace handrail::bench
