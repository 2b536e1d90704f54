// Runs `./run bench --compare`, which compares speed and error of Handrail's renderer and others on the same scenes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <optional>

#include "tests/bench/compare/report.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "worlds/base/files.h"

namespace handrail::bench {
namespace {

namespace fs = std::filesystem;

// Returns the worlds that come with the program, sorted by name.
std::vector<fs::path> bundled_maps() {
    std::vector<fs::path> maps;
    for (const fs::directory_entry& entry : fs::directory_iterator(test::project_root() / "worlds/maps"))
        if (entry.path().extension() == ".map") maps.push_back(entry.path());
    std::sort(maps.begin(), maps.end());
    return maps;
}

int refuse(const Error& error) {
    std::cerr << error.sentence() << '\n';
    return 1;
}

// Returns true if `written` succeeded. Otherwise prints its error on stderr and returns false.
bool reported(const Result<void>& written) { return written || refuse(written.error()) == 0; }

int run(int argc, char** argv) {
    CLI::App app("Compares our renderer with others: speed against error.");
    BenchOptions options;
    options.maps = bundled_maps();
    bool json = false, list = false;
    std::vector<fs::path> more_maps;
    std::optional<fs::path> svg_folder, markdown, instructions;
    std::optional<double> seconds;
    std::optional<std::string> count;
    app.add_flag("--quick", options.quick, "take seconds instead of minutes; the times are rough");
    app.add_flag("--json", json, "print one JSON object instead of text");
    app.add_option("--scene", options.only, "only scenes and families of scenes with this in their name");
    app.add_flag("--list", list, "print the names of the scenes without measuring anything");
    app.add_option("--map", more_maps, "also this map; may be repeated")->check(CLI::ExistingFile);
    app.add_option("--svg", svg_folder, "write plots of speed against error to this folder");
    app.add_option("--markdown", markdown, "write the tables to this file, and those of each family next to it");
    app.add_option("--instructions", instructions, "file with the counts of tests/bench/compare.sh");
    app.add_option("--count", count, "run the ticks of this renderer on the first scene, once, to be counted");
    app.add_option("--seconds", seconds, "how long to run the servo thread; 0 skips it")->check(CLI::NonNegativeNumber);
    CLI11_PARSE(app, argc, argv);
    options.maps.insert(options.maps.end(), more_maps.begin(), more_maps.end());
    options.servo_s = seconds.value_or(options.quick ? 1.0 : 60.0);
    const std::vector<std::string> names = scene_names(options);
    if (names.empty()) {
        std::cerr << "No scene name contains \"" << options.only << "\"; --list prints the names.\n";
        return 1;
    }
    if (list) {
        for (const std::string& name : names) std::cout << name << '\n';
        return 0;
    }
    if (count) {
        std::size_t ticks = 0;
        const Result<double> sum = count_once(options, *count, ticks);
        if (!sum) return refuse(sum.error());
        std::cout << fmt::format("{}\t{}\t{}\t{}\n", names.front(), *count, ticks, *sum);
        return 0;
    }
    std::string counted;
    if (instructions) {
        auto read = read_whole_file(*instructions);
        if (!read) return refuse(read.error());
        counted = std::move(*read);
    }
    if (!json) options.progress = [](const std::string& scene) { std::cerr << "Measuring " << scene << '\n'; };
    BenchReport report = run_bench(options);
    merge_instructions(report, counted);
    std::cout << (json ? json_of(report) : text_of(report)) << std::flush;
    bool written = true;
    if (svg_folder) {
        fs::create_directories(*svg_folder);
        for (const auto& [name, content] : plots_of(report))
            written = reported(write_file_atomically(*svg_folder / name, content)) && written;
    }
    if (markdown) {
        fs::path families = *markdown;
        families.replace_filename(markdown->stem().string() + "-families" + markdown->extension().string());
        written =
            reported(write_named_file_atomically(*markdown, markdown_of(report, families.filename().string()))) &&
            reported(write_file_atomically(families, families_markdown_of(report, markdown->filename().string()))) &&
            written;
    }
    return written ? 0 : 1;
}

}  // namespace
}  // namespace handrail::bench

int main(int argc, char** argv) { return handrail::bench::run(argc, argv); }
