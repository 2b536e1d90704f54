// Formats the results of the comparison as text to be read aloud, as one JSON object, as Markdown tables and as SVG
// plots. Pure functions of the report.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/bench/compare/bench.h"
#include "tests/support/names.h"

namespace handrail::bench {

// The results of one renderer on all scenes of a family. Times and errors are means over the scenes, except the worst,
// deepest and largest values.
struct Summary {
    std::string family, renderer, title, knob;
    double knob_value = 0.0;
    bool has_proxy = true;
    int scenes = 0, referenced = 0, wrong_holds = 0;
    double mean_s = 0.0, p999_s = 0.0, worst_s = 0.0, error_rms_m = 0.0, error_max_m = 0.0, off_share = 0.0,
           penetration_m = 0.0, largest_jump_n = 0.0, largest_gain = 0.0;
    double given_j = 0.0;  // greatest energy over all scenes with closed paths
    bool closed = false;
    double direction_rms_rad = -1.0, direction_max_rad = -1.0;
    double instructions = -1.0;
};
// Return the results in the order of first appearance. An empty family means all hard cases (families T...).
std::vector<Summary> summaries(const BenchReport& report);
std::vector<Summary> hard_case_summary(const BenchReport& report);

std::string text_of(const BenchReport& report);
std::string json_of(const BenchReport& report);
// Return the two documents. The first has the tables over all families. The second has the tables of each family, which
// would be too long for one page. Each document links to the other.
std::string markdown_of(const BenchReport& report, const std::string& families_file);
std::string families_markdown_of(const BenchReport& report, const std::string& first_file);
// Returns pairs of file name and content.
std::vector<std::pair<std::string, std::string>> plots_of(const BenchReport& report);

// Adds instructions per tick to `report` from lines "SCENE<tab>RENDERER<tab>INSTRUCTIONS", as tests/bench/compare.sh
// writes them. Returns the number of lines that matched a result.
std::size_t merge_instructions(BenchReport& report, const std::string& lines);

}  // namespace handrail::bench
