// Tests the outputs of the comparison of renderers: one JSON object, tables, and pictures with text for people who
// cannot see them.
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/bench/compare/report.h"
#include "tests/bench/compare/svg_plot.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"

namespace handrail::bench {
namespace report_test {

const BenchReport& small_report() {
    static const BenchReport report = [] {
        BenchOptions options;
        options.quick = true;
        options.only = "T6";
        BenchReport made = run_bench(options);
        options.only = "sphere of 980";
        BenchReport sphere = run_bench(options);
        made.results.insert(made.results.end(), sphere.results.begin(), sphere.results.end());
        made.scenes.insert(made.scenes.end(), sphere.scenes.begin(), sphere.scenes.end());
        made.stability.push_back(stable_stiffness(handrail_touch(), "flat wall", 2.0));
        return made;
    }();
    return report;
}

TEST(BenchReport, contains_every_renderer_on_every_scene_with_speed_and_error) {
    const auto json = nlohmann::json::parse(json_of(small_report()));
    std::set<std::pair<std::string, std::string>> seen;
    for (const auto& one : json["results"]) {
        seen.emplace(one["scene"].get<std::string>(), one["renderer"].get<std::string>());
        EXPECT_GT(one["mean_tick_s"].get<double>(), 0.0);
        EXPECT_GE(one["worst_tick_s"].get<double>(), one["p50_tick_s"].get<double>());
        EXPECT_TRUE(one["error_rms_m"].is_number()) << one["scene"];
    }
    for (const auto& scene : json["scenes"])
        for (const Contestant& c : main_contestants())
            EXPECT_TRUE(seen.contains({scene["scene"].get<std::string>(), c.key})) << scene["scene"] << ' ' << c.key;
    EXPECT_EQ(json["stability"].size(), 1U);
    for (const auto& [key, value] : json["results"][0].items())
        if (value.is_number_float() && key != "knob_value" && key != "mean_rounds" && key != "share_off_by_10_um" &&
            key != "largest_gain" && key != "instructions_per_tick") {
            EXPECT_TRUE(key.ends_with("_s") || key.ends_with("_m") || key.ends_with("_n") || key.ends_with("_j") ||
                        key.ends_with("_rad"))
                << key;
        }
}

TEST(BenchReport, has_the_same_content_as_text_and_as_markdown) {
    for (const std::string& text : {text_of(small_report()), markdown_of(small_report(), "families.md"),
                                    families_markdown_of(small_report(), "first.md")})
        for (const Contestant& c : main_contestants()) EXPECT_NE(text.find(c.title), std::string::npos) << c.title;
}

TEST(BenchReport, includes_counted_instructions) {
    BenchReport report = small_report();
    EXPECT_EQ(
        merge_instructions(report, "nonsense\nT6 box edge, solid\thandrail\t1234.5\nT6 box edge, solid\tnobody\t1\n"),
        1U);
    EXPECT_NE(json_of(report).find("1234.5"), std::string::npos);
}

TEST(BenchWorlds, a_simplified_sphere_is_coarser_within_its_error_bound_and_reports_it) {
    const BenchWorld fine = sphere_world(7, 10, 0), coarse = sphere_world(7, 10, 0, 10e-3);
    EXPECT_LT(coarse.scene->obstacles.size(), fine.scene->obstacles.size());
    EXPECT_GT(coarse.simplify_measured_m, 0.0);
    EXPECT_LE(coarse.simplify_measured_m, coarse.simplify_bound_m);
    EXPECT_EQ(coarse.family, "simplified sphere of 980 triangles, within 10 mm");
}

TEST(BenchBodies, feel_as_the_formula_says_and_give_the_hand_no_energy) {
    const std::vector<BodiesMeasured> all = run_bodies();
    ASSERT_EQ(all.size(), 9U);
    for (std::size_t i = 0; i < all.size(); i += 3) {
        SCOPED_TRACE(all[i].mass_kg);
        EXPECT_LT(all[i].error_n, 0.05 * all[i].felt_n) << "the model";
        EXPECT_NEAR(1e3 * all[i].given_j, 1e3 * all[i].right_given_j, 0.05);
    }
}

TEST(BenchPlots, have_a_title_labels_for_all_points_and_axes_with_units) {
    const auto files = plots_of(small_report());
    ASSERT_GE(files.size(), 3U);
    for (const auto& [name, svg] : files) {
        EXPECT_TRUE(name.ends_with(".svg"));
        for (const char* part :
             {"<title id=\"title\">", "<desc id=\"words\">", "role=\"img\"", "nanoseconds", "</svg>"})
            EXPECT_NE(svg.find(part), std::string::npos) << name << ' ' << part;
        EXPECT_EQ(svg.find("nan "), std::string::npos) << name;
        EXPECT_EQ(svg.find("\"nan"), std::string::npos) << name;
        EXPECT_EQ(svg.find("inf"), std::string::npos) << name;
        // Every tag must open and close, so that no tag is cut off.
        EXPECT_EQ(std::count(svg.begin(), svg.end(), '<'), std::count(svg.begin(), svg.end(), '>')) << name;
    }
}

TEST(BenchPlots, survive_empty_and_zero_series_and_names_with_markup) {
    Plot plot{"a < b & c", "x",
              "y",         0.0,
              1e-12,       {{"none", {}, true}, {"zero", {{0.0, 0.0, ""}}, false}, {"<one>", {{1.0, 1.0, "k"}}, true}}};
    const std::string svg = svg_of(plot);
    EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
    EXPECT_NE(svg.find("&lt;one&gt;"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_NE(svg_of({}).find("</svg>"), std::string::npos);
}

}  // namespace report_test
}  // namespace handrail::bench
