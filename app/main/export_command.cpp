#include <algorithm>
#include <iterator>
#include <memory>

#include "app/core/kept/side_file.h"
#include "app/core/whereabouts/rooms_of_world.h"
#include "app/core/world/walker.h"
#include "app/learners/export_gate.h"
#include "app/main/commands.h"
#include "app/main/page_export.h"
#include "app/main/route_cards.h"
#include "app/main/world_files.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/exports/names.h"
#include "worlds/exports/sheet.h"
#include "worlds/exports/storey_stl.h"
#include "worlds/exports/swell_sheet.h"
#include "worlds/plan/storey.h"

namespace handrail::program {
namespace {

namespace fs = std::filesystem;

// A file that the command will write. The command writes no file before the contents of all files are complete.
struct MadeFile {
    fs::path path;
    std::string content, said;
    // True if the person gave this name; otherwise the name is derived from one that the person gave.
    bool named = true;
};

std::string ending_of(const fs::path& path) { return lower_ascii(path.extension().string()); }

// Inserts `what` into the file name: "plan.svg" and "key-2" give "plan-key-2.svg".
fs::path beside(const fs::path& path, const std::string& what) {
    return path.parent_path() / (path.stem().string() + "-" + what + path.extension().string());
}

Result<exports::SheetOptions> options_of(const ExportArguments& arguments) {
    exports::SheetOptions options;
    options.coarse = arguments.coarse;
    if (!arguments.swell && !arguments.stl && !arguments.route_card && !arguments.page)
        return fail(phrase("export.nothing_asked"));
    if (const std::string ending = arguments.swell ? ending_of(*arguments.swell) : ".svg";
        ending != ".svg" && ending != ".pdf")
        return fail(phrase("export.swell_ending", {{"file", arguments.swell->string()}}));
    if (const std::string ending = arguments.route_card ? ending_of(*arguments.route_card) : ".txt";
        ending != ".brf" && ending != ".txt")
        return fail(phrase("export.card_ending", {{"file", arguments.route_card->string()}}));
    if (const std::string ending = arguments.page ? ending_of(*arguments.page) : ".html"; ending != ".html")
        return fail(phrase("export.page_ending", {{"file", arguments.page->string()}}));
    if ((arguments.from || arguments.to) && !arguments.route_card) return fail(phrase("export.card_needed"));
    const std::string paper = lower_ascii(arguments.paper);
    if (paper != "a4" && paper != "a3") return fail(phrase("export.paper", {{"word", arguments.paper}}));
    options.paper = paper == "a3" ? exports::kA3 : exports::kA4;
    options.table = exports::braille_table_of(spoken_language());
    if (!arguments.braille.empty()) {
        const auto named = exports::braille_table_named(lower_ascii(arguments.braille));
        if (!named) return fail(phrase("export.braille", {{"word", arguments.braille}}));
        options.table = *named;
    }
    return options;
}

// The plan of a storey. If the storey has floors above each other, also the second plan, which shows the upper floors.
struct StoreyPlans {
    plan::Storey storey;
    std::optional<plan::Storey> upper;
};

// Makes several sheets. Returns only the sheets that show the middle of the room with that name.
Result<std::vector<exports::SwellSheet>> sheets_around(const std::string& name, const StoreyPlans& plans,
                                                       const exports::SheetOptions& options) {
    std::vector<std::string> names;
    for (const plan::Storey* storey : {&plans.storey, plans.upper ? &*plans.upper : nullptr}) {
        if (!storey) continue;
        for (const plan::StoreyRoom& room : storey->rooms) {
            if (room.elsewhere) continue;
            names.push_back(room.name);
            if (lower_ascii(room.name) != lower_ascii(name)) continue;
            exports::SheetOptions without_signs = options;
            if (storey->upper) without_signs.plate_signs.clear();
            Result<std::vector<exports::SwellSheet>> sheets = exports::swell_sheets(*storey, without_signs);
            if (!sheets) return sheets;
            const Vec2& at = room.middle_m;
            std::erase_if(*sheets, [&](const exports::SwellSheet& sheet) {
                return sheet.part && (at.x < sheet.part->min_m.x || at.y < sheet.part->min_m.y ||
                                      at.x > sheet.part->max_m.x || at.y > sheet.part->max_m.y);
            });
            return sheets;
        }
    }
    return fail(phrase("export.no_place", {{"name", name}, {"nearest", nearest_name(name, names)}}));
}

// Returns one sheet, or several if the person requested them.
Result<std::vector<exports::SwellSheet>> sheets_of(const StoreyPlans& plans, const exports::SheetOptions& options,
                                                   const ExportArguments& arguments) {
    if (arguments.around) return sheets_around(*arguments.around, plans, options);
    if (!arguments.sheets) {
        Result<exports::SwellSheet> one = exports::swell_sheet(plans.storey, options);
        if (!one) return tl::unexpected(one.error());
        return std::vector<exports::SwellSheet>{std::move(*one)};
    }
    Result<std::vector<exports::SwellSheet>> sheets = exports::swell_sheets(plans.storey, options);
    if (!sheets || !plans.upper) return sheets;
    exports::SheetOptions without_plate = options;
    // The printed plate shows only the lower floors, so this sheet is no key to the plate.
    without_plate.plate_signs.clear();
    Result<std::vector<exports::SwellSheet>> more = exports::swell_sheets(*plans.upper, without_plate);
    if (!more) return more;
    std::move(more->begin(), more->end(), std::back_inserter(*sheets));
    return sheets;
}

// Returns true if the sheets leave out rooms above other rooms, because the person requested no second plan.
bool hides_rooms(const StoreyPlans& plans, const ExportArguments& arguments) {
    return plans.upper && !arguments.sheets && !arguments.around;
}

bool keep_promises(const StoreyPlans& plans, const exports::SheetOptions& options, const ExportArguments& arguments) {
    if (hides_rooms(plans, arguments)) return false;
    const Result<std::vector<exports::SwellSheet>> sheets = sheets_of(plans, options, arguments);
    return sheets && std::all_of(sheets->begin(), sheets->end(),
                                 [](const exports::SwellSheet& sheet) { return sheet.broken.empty(); });
}

// Returns sentences that suggest what to change if sheets do not keep their promises. Suggests larger paper and a
// coarser plan only if a trial shows that these help.
std::vector<std::string> helps(const StoreyPlans& plans, const exports::SheetOptions& options,
                               const ExportArguments& arguments) {
    std::vector<std::string> said;
    if (!arguments.sheets && options.paper.long_mm < exports::kA3.long_mm) {
        exports::SheetOptions larger = options;
        larger.paper = exports::kA3;
        if (keep_promises(plans, larger, arguments)) said.push_back(phrase("export.help_a3"));
    }
    if (!arguments.sheets && !arguments.around) said.push_back(phrase("export.help_sheets"));
    if (!arguments.around) said.push_back(phrase("export.help_around"));
    if (!options.coarse) {
        exports::SheetOptions coarse = options;
        coarse.coarse = true;
        if (keep_promises(plans, coarse, arguments)) said.push_back(phrase("export.help_coarse"));
    }
    return said;
}

struct SheetsReport {
    std::vector<std::string> simplified;
    bool broken = false;
};

// Adds the files of one sheet and its key. `which` is empty for the first sheet.
void add_svg(const fs::path& path, const std::string& which, const exports::SwellSheet& sheet, const std::string& said,
             std::vector<MadeFile>& files) {
    const std::string language = spoken_language();
    const auto add = [&](const fs::path& file, const exports::SheetPage& page) {
        files.push_back({file, exports::svg_of(page, language),
                         phrase("export.wrote", {{"file", file.string()}, {"title", page.title}}), false});
    };
    files.push_back(
        {which.empty() ? path : beside(path, which), exports::svg_of(sheet.plan, language), said, which.empty()});
    for (std::size_t i = 0; i < sheet.key.size(); ++i)
        add(beside(path, (which.empty() ? "" : which + "-") + "key-" + std::to_string(i + 1)), sheet.key[i]);
}

Result<SheetsReport> add_swell(const fs::path& path, const StoreyPlans& plans, const exports::SheetOptions& options,
                               const ExportArguments& arguments, std::vector<MadeFile>& files) {
    const Result<std::vector<exports::SwellSheet>> sheets = sheets_of(plans, options, arguments);
    if (!sheets) {
        Error error = sheets.error();
        if (!arguments.sheets && !arguments.around)
            for (const std::string& help : helps(plans, options, arguments)) error.message += "\n" + help;
        return tl::unexpected(std::move(error));
    }
    std::vector<exports::SheetPage> pages;
    if (arguments.strip) {
        Result<exports::SheetPage> made = exports::calibration_strip(options.paper, options.table);
        if (!made) return tl::unexpected(made.error());
        pages.push_back(std::move(*made));
    }
    const bool pdf = ending_of(path) == ".pdf";
    SheetsReport sheets_report;
    std::string all;
    for (const exports::SwellSheet& sheet : *sheets) {
        const bool first = &sheet == &sheets->front();
        const std::string which = first ? "" : std::to_string(&sheet - &sheets->front() + 1);
        const fs::path file = pdf || first ? path : beside(path, which);
        const std::string said = phrase("export.wrote_swell", {{"file", file.string()},
                                                               {"title", sheet.plan.title},
                                                               {"one_to", sheet.one_to},
                                                               {"rooms", sheet.signs.size()},
                                                               {"things", sheet.drawn.size()}});
        all += (first ? "" : "\n") + said;
        if (pdf) {
            pages.push_back(sheet.plan);
            pages.insert(pages.end(), sheet.key.begin(), sheet.key.end());
        } else add_svg(path, which, sheet, said, files);
        for (const std::vector<std::string>* sentences : {&sheet.broken, &sheet.simplified})
            for (const std::string& sentence : *sentences)
                if (std::find(sheets_report.simplified.begin(), sheets_report.simplified.end(), sentence) ==
                    sheets_report.simplified.end())
                    sheets_report.simplified.push_back(sentence);
        sheets_report.broken = sheets_report.broken || !sheet.broken.empty();
    }
    if (pdf) files.push_back({path, exports::pdf_of(pages, spoken_language()), all});
    else if (arguments.strip)
        files.push_back(
            {beside(path, "strip"), exports::svg_of(pages.front(), spoken_language()),
             phrase("export.wrote", {{"file", beside(path, "strip").string()}, {"title", pages.front().title}}),
             false});
    if (hides_rooms(plans, arguments)) {
        sheets_report.simplified.push_back(phrase("export.hidden", {{"names", exports::hidden_names(plans.storey)}}));
        sheets_report.broken = true;
    }
    sheets_report.simplified.push_back(phrase("export.print_as_is"));
    if (sheets_report.broken) {
        sheets_report.simplified.push_back(phrase("export.promise_broken"));
        const std::vector<std::string> what = helps(plans, options, arguments);
        if (!what.empty()) sheets_report.simplified.push_back(phrase("export.helps"));
        sheets_report.simplified.insert(sheets_report.simplified.end(), what.begin(), what.end());
    }
    return sheets_report;
}

void add_stl(const fs::path& path, const plan::Storey& storey, const exports::StoreyPlate& plate,
             std::vector<MadeFile>& files, std::vector<std::string>& simplified) {
    files.push_back({path, exports::stl_of(plate.triangles),
                     phrase("export.wrote_stl", {{"file", path.string()},
                                                 {"one_to", plate.one_to},
                                                 {"x", plate.wide_mm},
                                                 {"y", plate.deep_mm},
                                                 {"things", plate.drawn.size()}})});
    if (!storey.hidden.empty())
        simplified.push_back(phrase(
            "export.of_plate", {{"sentence", phrase("export.hidden", {{"names", exports::hidden_names(storey)}})}}));
    for (const std::string& sentence : plate.simplified)
        simplified.push_back(phrase("export.of_plate", {{"sentence", sentence}}));
}

Result<void> add_card(const fs::path& path, const std::vector<exports::CardRoute>& ways, exports::BrailleTable table,
                      std::vector<MadeFile>& files) {
    const Result<std::string> text =
        ending_of(path) == ".brf" ? exports::card_brf(ways, table) : exports::card_text(ways);
    if (!text) return tl::unexpected(text.error());
    files.push_back({path, *text, phrase("export.wrote_card", {{"file", path.string()}, {"count", ways.size()}})});
    return {};
}

// Writes all files. Writes none of them if one exists already and must not be replaced.
Result<void> write_all(const learners::ExportGate& export_gate, const std::vector<MadeFile>& files, bool force,
                       std::ostream& out) {
    std::error_code ec;
    if (!force)
        for (const MadeFile& file : files)
            if (fs::exists(fs::symlink_status(file.path, ec)))
                return fail(phrase("export.exists", {{"file", file.path.string()}}));
    for (const MadeFile& file : files) {
        const auto how = file.named ? write_named_file_atomically : write_file_atomically;
        if (Result<void> written = export_gate.write(file.path, file.content, how); !written) return written;
        out << file.said << '\n';
    }
    return {};
}

}  // namespace

int run_export(const ExportArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress) {
    const auto failed = [&](const Error& error, int status) {
        progress.done();
        err << error.sentence() << '\n';
        return status;
    };
    Result<exports::SheetOptions> options = options_of(arguments);
    if (!options) return failed(options.error(), 2);
    const Result<fs::path> given = world_given(arguments.world);
    if (!given) return failed(given.error(), 1);
    const fs::path& world = *given;
    const Result<learners::ExportGate> export_gate =
        learners::ExportGate::of(learners::Learners(core::user_data_folder()), world);
    if (!export_gate) return failed(export_gate.error(), 1);
    Result<Scene> read = mended_and_valid(imported(world, progress.followed(arguments.common.read_options(world))),
                                          world, arguments.common);
    if (!read) return failed(read.error(), 1);
    const auto scene = std::make_shared<const Scene>(std::move(*read));
    std::string core_of_page;
    if (arguments.page) {
        Result<std::string> core = page_core();
        if (!core) return failed(core.error(), 1);
        core_of_page = std::move(*core);
    }
    progress.at(phrase("progress.rooms"));
    const core::WalkerSize size = core::walker_size(*scene, settings::Settings{}.walk.body_radius_m);
    core::RoomsOfWorld rooms(scene, navigation::walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m),
                             at_once());
    if (!rooms.ready() || !rooms.found())
        return failed({world.string(), 0, 0, rooms.problem().empty() ? phrase("export.no_rooms") : rooms.problem()}, 1);
    const navigation::WalkSpace& space = rooms.navigation().space();
    const int number = arguments.storey.value_or(plan::storey_of_start(*scene, rooms.graph(), space));
    const Result<plan::Storey> storey = plan::storey_of(*scene, rooms.graph(), space, number);
    if (!storey) return failed(storey.error(), 1);
    std::vector<MadeFile> files;
    std::vector<std::string> simplified;
    progress.at(phrase("progress.sheets"));
    bool broken = false;
    std::optional<exports::StoreyPlate> plate;
    if (arguments.stl) {
        Result<exports::StoreyPlate> made = exports::storey_plate(*storey, options->table);
        if (!made) return failed(made.error(), 1);
        for (const exports::RoomSign& sign : made->signs)
            options->plate_signs.push_back(sign.on_sheet ? sign.sign : std::string());
        plate = std::move(*made);
    }
    if (arguments.swell) {
        const StoreyPlans plans{*storey, plan::upper_part_of(*scene, rooms.graph(), space, *storey)};
        Result<SheetsReport> sheets_report = add_swell(*arguments.swell, plans, *options, arguments, files);
        if (!sheets_report) return failed(sheets_report.error(), 1);
        simplified = std::move(sheets_report->simplified);
        broken = sheets_report->broken;
    }
    if (plate) add_stl(*arguments.stl, *storey, *plate, files, simplified);
    if (arguments.page)
        files.push_back({*arguments.page, page_of(core_of_page, *scene, rooms.graph(), space),
                         phrase("export.wrote_page", {{"file", arguments.page->string()}})});
    if (arguments.route_card) {
        progress.at(phrase("progress.ways"));
        const Result<CardRoutes> ways = card_routes(scene, rooms.graph(), rooms.navigation(), *storey,
                                                    {arguments.from, arguments.to, arguments.settings});
        if (!ways) return failed(ways.error(), 1);
        if (const Result<void> made = add_card(*arguments.route_card, ways->ways, options->table, files); !made)
            return failed(made.error(), 1);
        if (!ways->unreached.empty())
            simplified.push_back(phrase("export.unreached", {{"names", exports::names_list(ways->unreached)}}));
    }
    progress.done();
    if (const Result<void> written = write_all(*export_gate, files, arguments.force, out); !written)
        return failed(written.error(), 1);
    for (const std::string& sentence : simplified) out << sentence << '\n';
    return broken ? 1 : 0;
}

}  // namespace handrail::program
