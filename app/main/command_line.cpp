#include "app/main/command_line.h"

#include <CLI/CLI.hpp>

#include "app/core/command.h"
#include "app/core/spoken_language.h"
#include "worlds/base/overloaded.h"
#include "worlds/base/text.h"

namespace handrail {
namespace fs = std::filesystem;
namespace {

// A number option, read without regard to the locale. CLI11's own conversion would follow LC_NUMERIC.
CLI::Option* add_number(CLI::App& app, const std::string& name, const std::string& unit, std::function<void(double)> take, bool zero_allowed,
                        const std::string& help) {
    const auto read = [name, take = std::move(take), zero_allowed](const std::string& word) {
        double value = 0.0;
        if (!parse_finite(word, value)) throw CLI::ValidationError(fmt::format("{} needs a number, not \"{}\".", name, word));
        if (value < 0.0 || (value == 0.0 && !zero_allowed))
            throw CLI::ValidationError(fmt::format("{} must be {}, not {}.", name, zero_allowed ? "0 or more" : "above 0", word));
        take(value);
    };
    return app.add_option_function<std::string>(name, read, help)->type_name(unit)->type_size(1);
}

void add_map_scale(CLI::App& app, CommonArguments& common) {
    add_number(
        app, "--map-scale", "M", [&common](double v) { common.map_scale_m_per_unit = v; }, false, "metres per unit of a .map; 1/32 unless given");
}

void add_settings_options(CLI::App& app, SettingsOptions& options) {
    app.add_option("--settings", options.file, "settings file in place of your own")->type_name("FILE");
    app.add_option("--set", options.assignments, "change one setting for this time, such as --set workspace.scale=40; may be repeated")
        ->type_name("KEY=VALUE")
        ->type_size(1)
        ->expected(1)
        ->allow_extra_args(false)
        ->take_all();
}

std::string part_words() {
    std::string words;
    for (const WizardPartInfo& part : wizard_parts()) words += fmt::format("{}{}", words.empty() ? "" : ", ", part.word);
    return words;
}

// The whole grammar. Lives as long as one parse; the commands' arguments are filled in place.
struct Grammar {
    CLI::App app{"Handrail: learn a building by touch, sound and speech.\nWithout a command it opens WORLD, or a first small world of its own."};
    ExploreCall explore;
    std::vector<std::string> explore_devices;  // --device, once or twice
    InfoArguments info;
    TouchArguments touch;
    ScenarioArguments scenario;
    BenchArguments bench;
    SettingsCall settings;
    DevicesArguments devices;
    ExploreCall calibrate;
    CLI::App *calibrate_app, *info_app, *touch_app, *scenario_app, *bench_app, *settings_app, *devices_app;

    Grammar() {
        app.name("handrail");
        app.require_subcommand(0, 1);
        app.set_version_flag("--version", "handrail " HANDRAIL_VERSION, "say the version");
        app.set_help_flag("-h,--help", "say how to use this");
        app.footer("Exit status: 0 done, 1 it failed, 2 wrong usage. A world whose file is named like a command is opened as ./info.");
        app.add_option("WORLD", explore.arguments.world, "the world to explore")->type_name("");
        app.add_flag("--no-window", explore.arguments.no_window, "stay in the terminal");
        app.add_option("--device", explore_devices, "haptic device by name or serial number, or none; given twice, the first is for the right hand")
            ->type_name("NAME")
            ->type_size(1)
            ->expected(1)
            ->allow_extra_args(false)
            ->take_all();
        add_map_scale(app, explore.arguments.common);
        add_settings_options(app, explore.settings);

        info_app = app.add_subcommand("info", "say what a world holds, and what was understood, guessed or left out");
        info_app->add_option("WORLD", info.world, "the world")->required()->type_name("");
        CLI::Option* json = info_app->add_flag("--json", info.json, "as one JSON object");
        info_app->add_flag("--lint", info.lint, "only whether its materials can be told apart by touch; exit status 1 if not")->excludes(json);
        add_map_scale(*info_app, info.common);

        touch_app = app.add_subcommand("touch", "replay a hand's path through a world, without a device");
        touch_app->add_option("WORLD", touch.world, "the world")->required()->type_name("");
        touch_app->add_option("--path", touch.path_csv, "the hand's path: t,x,y,z")->required()->type_name("IN.csv");
        touch_app->add_option("--out", touch.out_csv, "where to write forces and contacts")->required()->type_name("OUT.csv");
        add_number(
            *touch_app, "--radius", "M", [this](double v) { touch.radius_m = v; }, true, "radius of the ball in world metres; 0.005 unless given");
        add_number(
            *touch_app, "--stiffness", "N_PER_M", [this](double v) { touch.stiffness_n_per_m = v; }, true, "stiffness of every surface");
        add_number(
            *touch_app, "--damping", "NS_PER_M", [this](double v) { touch.damping_ns_per_m = v; }, true, "damping of every surface");
        add_number(
            *touch_app, "--friction-static", "MU", [this](double v) { touch.friction_static = v; }, true, "friction of every surface at rest");
        add_number(
            *touch_app, "--friction-kinetic", "MU", [this](double v) { touch.friction_kinetic = v; }, true, "friction of every surface while sliding");
        add_number(
            *touch_app, "--scale", "S", [this](double v) { touch.scale_world_m_per_hand_m = v; }, false, "world metres per hand metre; 1 unless given");
        touch_app->add_option("--device", touch.device, "apply this model's limits; an ideal device unless given")->type_name("NAME");
        add_map_scale(*touch_app, touch.common);

        scenario_app = app.add_subcommand("scenario", "run scenario files, or folders of them");
        scenario_app->add_option("PATH", scenario.paths, "files or folders")->required()->type_name("");
        scenario_app->add_option("--junit", scenario.junit, "write the results as JUnit XML")->type_name("FILE");
        add_map_scale(*scenario_app, scenario.common);

        bench_app = app.add_subcommand("bench", "measure how fast and how exact touch is, beside other renderers");
        bench_app->add_flag("--quick", bench.quick, "a few seconds instead of some minutes; times are rough");
        bench_app->add_flag("--json", bench.json, "as one JSON object");
        bench_app->add_option("--scene", bench.scene, "only scenes and families with this in their name")->type_name("NAME");
        bench_app->add_flag("--list", bench.list, "say the names of the scenes and measure nothing");
        bench_app->add_option("--map", bench.maps, "also this map; may be repeated")
            ->type_name("FILE")
            ->type_size(1)
            ->expected(1)
            ->allow_extra_args(false)
            ->take_all();
        bench_app->add_option("--svg", bench.svg_folder, "write plots of speed against error into this folder")->type_name("FOLDER");
        bench_app->add_option("--markdown", bench.markdown, "write the tables to this file")->type_name("FILE");
        bench_app->add_option("--instructions", bench.instructions, "instructions per tick as tests/bench/compare.sh counted them")->type_name("FILE");
        bench_app->add_option("--count", bench.count, "only the ticks of one renderer on the first scene, once, to be counted")->type_name("RENDERER");
        add_number(
            *bench_app, "--seconds", "S", [this](double v) { bench.seconds = v; }, true, "how long to run the servo thread; 60 unless given, 0 for not");

        settings_app = app.add_subcommand("settings", "list every setting with its value");
        settings_app->add_flag("--explain", settings.arguments.explain, "with unit, range, meaning and where each value comes from");
        add_settings_options(*settings_app, settings.settings);

        calibrate_app = app.add_subcommand("calibrate", "set up headphones, touch device, force and reach, led by voice");
        calibrate.arguments.calibrate = *parse_wizard_parts("");
        const auto take_parts = [this](const std::string& words) {
            auto parts = parse_wizard_parts(words);
            if (!parts) throw CLI::ValidationError(parts.error().sentence());
            calibrate.arguments.calibrate = std::move(*parts);
        };
        calibrate_app->add_option_function<std::string>("--only", take_parts, fmt::format("only these parts, such as headphones,reach; of {}", part_words()))
            ->type_name("PARTS");
        calibrate_app->add_flag("--no-window", calibrate.arguments.no_window, "stay in the terminal");
        calibrate_app->add_option("--device", calibrate.arguments.device, "haptic device by name or serial number, or none")->type_name("NAME");
        add_settings_options(*calibrate_app, calibrate.settings);

        devices_app = app.add_subcommand("devices", "say which touch devices are plugged in, and what each is and needs");
        devices_app->add_flag("--json", devices.json, "as one JSON object");

        for (CLI::App* sub : {calibrate_app, info_app, touch_app, scenario_app, bench_app, settings_app, devices_app})
            sub->set_help_flag("-h,--help", "say how to use this command");
    }

    CLI::App& chosen() {
        const std::vector<CLI::App*> subs = app.get_subcommands();
        return subs.empty() ? app : *subs.front();
    }

    std::vector<std::string> command_names() {
        std::vector<std::string> names;
        for (const CLI::App* sub : app.get_subcommands(nullptr)) names.push_back(sub->get_name());
        return names;
    }
};

std::string_view help_hint(const CLI::App& app) { return app.get_parent() ? " See --help of this command." : " See --help."; }

// "handrail inof" reads as a world named inof. Where there is no such file and it is no path either, a command was meant.
bool is_misspelt_command(const fs::path& world) {
    std::error_code ec;
    return world.string().find_first_of("./") == std::string::npos && !fs::exists(world, ec);
}

UsageError no_such_command(Grammar& grammar, const std::string& word) {
    return {fmt::format("There is no world file and no command \"{}\"; the nearest command is {}.", word, nearest_name(word, grammar.command_names()))};
}

// A word that nothing took: an unknown option, or one name too many.
UsageError leftover_word(Grammar& grammar, const std::string& word) {
    CLI::App& app = grammar.chosen();
    if (word.starts_with("-")) {
        std::vector<std::string> names;
        for (const CLI::Option* option : app.get_options())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        return {fmt::format("There is no option {}; the nearest is {}.", word, nearest_name(word.substr(0, word.find('=')), names))};
    }
    if (&app == &grammar.app && grammar.explore.arguments.world && is_misspelt_command(*grammar.explore.arguments.world))
        return no_such_command(grammar, grammar.explore.arguments.world->string());
    return {fmt::format("There is one word too many, \"{}\".{}", word, help_hint(app))};
}

// Options that stand before a command must not be lost in silence.
std::optional<UsageError> options_before_command(Grammar& grammar) {
    for (const CLI::Option* option : grammar.app.get_options())
        if (option->count() > 0) {
            const std::string name = option->get_name();
            return UsageError{
                fmt::format("{} does not belong before the command {}; options stand after the command they are for.", name, grammar.chosen().get_name())};
        }
    return std::nullopt;
}

std::string first_line_as_sentence(std::string text) {
    text = text.substr(0, text.find('\n'));
    if (!text.empty() && text.back() != '.') text += '.';
    return text;
}

std::optional<UsageError> check_touch(TouchArguments& touch) {
    // One friction option sets both.
    if (!touch.friction_static) touch.friction_static = touch.friction_kinetic;
    if (!touch.friction_kinetic) touch.friction_kinetic = touch.friction_static;
    if (touch.friction_static && *touch.friction_static < *touch.friction_kinetic)
        return UsageError{fmt::format("--friction-static ({}) must not be below --friction-kinetic ({}).", *touch.friction_static, *touch.friction_kinetic)};
    return std::nullopt;
}

// The person's settings with what the command line changes. Nothing, and a sentence on `err`, for wrong usage.
std::optional<SettingsStore> load_settings(const SettingsOptions& options, std::vector<Diagnostic>& problems, std::ostream& err) {
    std::vector<std::string> words;
    for (const CommandInfo& command : command_table()) words.emplace_back(command.word);
    SettingsStore settings(std::move(words));
    problems = settings.load_file(options.file.value_or(user_settings_path()), SettingSource::UserFile);
    for (const std::string& assignment : options.assignments)
        if (const Result<void> set = settings.set_assignment(assignment, SettingSource::CommandLine); !set) {
            err << set.error().sentence() << "\n";
            return std::nullopt;
        }
    for (Diagnostic& problem : speak_as_set(settings.values().speech, user_languages_folder())) problems.push_back(std::move(problem));
    return settings;
}

int explore(ExploreCall& call, std::ostream& out, std::ostream& err) {
    std::vector<Diagnostic>& problems = call.arguments.settings_problems;
    std::optional<SettingsStore> settings = load_settings(call.settings, problems, err);
    if (!settings) return 2;
    if (call.arguments.world)  // house.settings.toml beside house.map
        for (Diagnostic& problem : settings->load_file(fs::path(*call.arguments.world).replace_extension(".settings.toml"), SettingSource::World))
            problems.push_back(std::move(problem));
    return run_explore(call.arguments, *settings, out, err);
}

}  // namespace

ParsedCommandLine parse_command_line(const std::vector<std::string>& words) {
    Grammar grammar;
    try {
        std::vector<std::string> reversed(words.rbegin(), words.rend());  // CLI11 takes its words last first
        grammar.app.parse(std::move(reversed));
    } catch (const CLI::CallForHelp&) {
        return PrintedText{grammar.app.help()};
    } catch (const CLI::CallForVersion& version) {
        return PrintedText{std::string(version.what()) + "\n"};
    } catch (const CLI::ExtrasError&) {
        const std::vector<std::string> extras = grammar.app.remaining(true);
        return leftover_word(grammar, extras.empty() ? "" : extras.front());
    } catch (const CLI::ParseError& error) {
        return UsageError{first_line_as_sentence(error.what()) + std::string(help_hint(grammar.chosen()))};
    }
    CLI::App& chosen = grammar.chosen();
    if (&chosen != &grammar.app)
        if (auto error = options_before_command(grammar)) return *error;
    if (grammar.explore_devices.size() > 2)
        return UsageError{"There are two hands, so --device can be given twice at most." + std::string(help_hint(grammar.app))};
    if (!grammar.explore_devices.empty()) grammar.explore.arguments.device = grammar.explore_devices.front();
    if (grammar.explore_devices.size() > 1) grammar.explore.arguments.left_device = grammar.explore_devices.back();
    if (&chosen == grammar.info_app) return grammar.info;
    if (&chosen == grammar.scenario_app) return grammar.scenario;
    if (&chosen == grammar.bench_app) return grammar.bench;
    if (&chosen == grammar.settings_app) return grammar.settings;
    if (&chosen == grammar.devices_app) return grammar.devices;
    if (&chosen == grammar.calibrate_app) return grammar.calibrate;
    if (&chosen == grammar.touch_app) {
        if (auto error = check_touch(grammar.touch)) return *error;
        return grammar.touch;
    }
    const auto& world = grammar.explore.arguments.world;
    if (world && is_misspelt_command(*world)) return no_such_command(grammar, world->string());
    return grammar.explore;
}

int run_command_line(const std::vector<std::string>& words, std::ostream& out, std::ostream& err) {
    std::vector<Diagnostic> problems;
    (void)speak_as_set({}, user_languages_folder());  // until settings are read; what is wrong is told then
    ParsedCommandLine parsed = parse_command_line(words);
    return std::visit(
        Overloaded{[&](ExploreCall& call) { return explore(call, out, err); }, [&](const InfoArguments& arguments) { return run_info(arguments, out, err); },
                   [&](const TouchArguments& arguments) { return run_touch(arguments, out, err); },
                   [&](const ScenarioArguments& arguments) { return run_scenarios(arguments, out, err); },
                   [&](const BenchArguments& arguments) { return run_bench_command(arguments, out, err); },
                   [&](const SettingsCall& call) {
                       std::optional<SettingsStore> settings = load_settings(call.settings, problems, err);
                       if (!settings) return 2;
                       for (const Diagnostic& problem : problems) err << problem.sentence() << "\n";
                       return run_settings(call.arguments, *settings, out, err);
                   },
                   [&](const DevicesArguments& arguments) { return run_devices(arguments, out, err); },
                   [&](const PrintedText& printed) {
                       out << printed.text << std::flush;
                       return 0;
                   },
                   [&](const UsageError& error) {
                       err << error.sentence << "\n";
                       return 2;
                   }},
        parsed);
}

}  // namespace handrail
