#include <fmt/format.h>

#include <cstdlib>

#include "app/main/commands.h"
#include "app/main/world_files.h"
#include "tests/bench/compare/report.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

namespace fs = std::filesystem;

// The worlds that ship with the program, in the order of their names.
std::vector<fs::path> bundled_maps() {
    std::vector<fs::path> maps;
    std::error_code ec;
    for (const fs::directory_entry& entry : fs::directory_iterator(world_folder(), ec))
        if (entry.path().extension() == ".map") maps.push_back(entry.path());
    std::sort(maps.begin(), maps.end());
    return maps;
}

// False, and a sentence on `err`, if it could not be written.
bool told(const Result<void>& written, std::ostream& err) {
    if (!written) err << written.error().sentence() << '\n';
    return written.has_value();
}

}  // namespace

int run_bench_command(const BenchArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress) {
    bench::BenchOptions options;
    options.maps = bundled_maps();
    for (const fs::path& map : arguments.maps) {
        std::error_code ec;
        if (!fs::is_regular_file(map, ec)) {
            err << one_line(phrase("program.no_map", {{"file", map.string()}})) << '\n';
            return 1;
        }
        options.maps.push_back(map);
    }
    options.only = arguments.scene;
    options.quick = arguments.quick;
    options.servo_s = arguments.seconds.value_or(arguments.quick ? 1.0 : 60.0);
    const std::vector<std::string> names = bench::scene_names(options);
    if (names.empty()) {
        err << one_line(phrase("program.no_scene", {{"name", arguments.scene}})) << '\n';
        return 1;
    }
    if (arguments.list) {
        for (const std::string& name : names) out << name << '\n';
        return 0;
    }
    if (arguments.count) {
        std::size_t ticks = 0;
        const Result<double> sum = bench::count_once(options, *arguments.count, ticks);
        if (!sum) {
            err << sum.error().sentence() << '\n';
            return 1;
        }
        out << fmt::format("{}\t{}\t{}\t{}\n", names.front(), *arguments.count, ticks, *sum);
        return 0;
    }
    std::string counted;
    if (arguments.instructions) {
        auto read = read_whole_file(*arguments.instructions);
        if (!read) {
            err << read.error().sentence() << '\n';
            return 1;
        }
        counted = std::move(*read);
    }
    if (!arguments.json)
        options.progress = [&progress](const std::string& scene) {
            progress.at(phrase("progress.bench", {{"scene", scene}}));
        };
    bench::BenchReport report = bench::run_bench(options);
    progress.done();
    bench::merge_instructions(report, counted);
    out << (arguments.json ? bench::json_of(report) : bench::text_of(report)) << std::flush;
    bool written = true;
    if (arguments.svg_folder) {
        std::error_code ec;
        fs::create_directories(*arguments.svg_folder, ec);
        for (const auto& [name, content] : bench::plots_of(report))
            written = written && told(write_file_atomically(*arguments.svg_folder / name, content), err);
    }
    if (arguments.markdown) {
        const fs::path& file = *arguments.markdown;
        fs::path families = file;
        families.replace_filename(file.stem().string() + "-families" + file.extension().string());
        const std::string markdown = bench::markdown_of(report, families.filename().string()),
                          of_families = bench::families_markdown_of(report, file.filename().string());
        written = written && told(write_named_file_atomically(file, markdown), err) &&
                  told(write_file_atomically(families, of_families), err);
    }
    return written ? 0 : 1;
}

}  // namespace handrail
