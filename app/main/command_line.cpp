#include "app/main/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "app/core/context/context_words.h"
#include "app/core/dialogue/command.h"
#include "app/core/kept/side_file.h"
#include "app/core/kept/spoken_language.h"
#include "app/main/export_grammar.h"
#include "app/main/learner_grammar.h"
#include "app/main/learner_start.h"
#include "app/main/lesson_grammar.h"
#include "app/main/plain_output.h"
#include "app/main/recorded_grammar.h"
#include "app/main/start_place.h"
#include "app/main/world_files.h"
#include "app/main/wrong_usage.h"
#include "worlds/base/language.h"
#include "worlds/base/overloaded.h"
#include "worlds/base/text.h"
#include "worlds/readers/units.h"

namespace handrail::program {
namespace fs = std::filesystem;
namespace {

// Adds an option with a number. The number is read in the same way in every locale, whereas CLI11's own conversion
// would follow LC_NUMERIC.
CLI::Option* add_number(CLI::App& app, const std::string& name, const std::string& unit,
                        std::function<void(double)> take, bool zero_allowed, const std::string& help) {
    const auto read = [name, take = std::move(take), zero_allowed](const std::string& word) {
        double value = 0.0;
        if (!parse_finite(word, value))
            throw CLI::ValidationError(phrase("help.needs_number", {{"option", name}, {"word", word}}));
        if (value < 0.0 || (value == 0.0 && !zero_allowed))
            throw CLI::ValidationError(
                phrase(zero_allowed ? "help.not_below_0" : "help.above_0", {{"option", name}, {"word", word}}));
        take(value);
    };
    return app.add_option_function<std::string>(name, read, help)->type_name(unit)->type_size(1);
}

void add_map_scale(CLI::App& app, CommonArguments& common) {
    add_number(
        app, "--map-scale", "M", [&common](double v) { common.map_scale_m_per_unit = v; }, false,
        phrase("help.map_scale"));
    const auto take_unit = [&common](const std::string& word) {
        common.unit_m = readers::unit_named(word);
        if (!common.unit_m) throw CLI::ValidationError(phrase("help.no_unit", {{"word", word}}));
    };
    app.add_option_function<std::string>("--unit", take_unit, phrase("help.unit"))->type_name("UNIT")->type_size(1);
    app.add_option("--building", common.building, phrase("help.building"))->type_name("NAME");
}

void add_settings_options(CLI::App& app, SettingsOptions& options) {
    app.add_option("--settings", options.file, phrase("help.settings_file"))->type_name("FILE");
    app.add_option("--set", options.assignments, phrase("help.set"))
        ->type_name("KEY=VALUE")
        ->type_size(1)
        ->expected(1)
        ->allow_extra_args(false)
        ->take_all();
}

std::string part_words() {
    std::string words;
    for (const wizard::WizardPartInfo& part : wizard::wizard_parts())
        words += fmt::format("{}{}", words.empty() ? "" : ", ", part.word);
    return words;
}

// The whole grammar of the command line. The object exists during one parse, which fills in the arguments of the
// commands.
struct Grammar {
    CLI::App app{phrase("help.program")};
    ExploreCall explore;
    std::vector<std::string> explore_devices;  // --device, which may be given once or twice
    bool explore_recorded = false;             // --record was given
    InfoArguments info;
    CheckArguments check;
    TouchArguments touch;
    ScenarioArguments scenario;
    ExportCall exported;
    BenchArguments bench;
    SettingsCall settings;
    DevicesArguments devices;
    ExploreCall calibrate;
    struct {
        ReplayCall replay;
        ReportArguments report;
        LearnerArguments learner;
        CLI::App* learner_app;
        LessonCall lesson;
        CLI::App* lesson_app = nullptr;
    } recorded;  // arguments of the commands for recordings, learners and lessons
    CLI::App *replay_app, *report_app, *calibrate_app, *info_app, *check_app, *touch_app, *scenario_app, *export_app,
        *bench_app, *settings_app, *devices_app;

    Grammar() {
        app.name("handrail");
        app.option_defaults()->group(phrase("help.group_options"));
        for (const auto& [label, key] :
             {std::pair{"Usage", "help.usage"}, std::pair{"OPTIONS", "help.options"},
              std::pair{"SUBCOMMAND", "help.subcommand"}, std::pair{"Positionals", "help.positionals"},
              std::pair{"REQUIRED", "help.mandatory"}, std::pair{"Excludes", "help.label_excludes"}})
            app.get_formatter()->label(label, phrase(key));
        app.require_subcommand(0, 1);
        app.set_version_flag("--version", "handrail " HANDRAIL_VERSION, phrase("help.version"));
        app.set_help_flag("-h,--help", phrase("help.help"));
        app.footer(phrase("help.exit_status"));
        app.add_option("WORLD", explore.arguments.world, phrase("help.world_to_explore"))->type_name("");
        app.add_option("--at", explore.arguments.at, phrase("help.at"))->type_name("PLACE");
        app.add_flag("--no-window", explore.arguments.no_window, phrase("help.no_window"));
        app.add_option("--device", explore_devices, phrase("help.devices_given"))
            ->type_name("NAME")
            ->type_size(1)
            ->expected(1)
            ->allow_extra_args(false)
            ->take_all();
        CLI::Option* record = app.add_flag("--record", explore_recorded, phrase("help.record"));
        app.add_option("--record-in", explore.arguments.record_in, phrase("help.record_in"))
            ->type_name("FOLDER")
            ->excludes(record);
        add_learner_option(app, explore.arguments);
        add_map_scale(app, explore.arguments.common);
        add_settings_options(app, explore.settings);

        info_app = app.add_subcommand("info", phrase("help.info"));
        info_app->add_option("WORLD", info.world, phrase("help.the_world"))->required()->type_name("");
        CLI::Option* json = info_app->add_flag("--json", info.json, phrase("help.json"));
        info_app->add_option("--scale", info.scale, phrase("help.info_scale"));
        CLI::Option* lint = info_app->add_flag("--lint", info.lint, phrase("help.lint"))->excludes(json);
        CLI::Option* text =
            info_app->add_flag("--as-words", info.as_words, phrase("help.as_words"))->excludes(json)->excludes(lint);
        const auto take_language = [this](const std::string& word) {
            if (word != "en" && word != "de")
                throw CLI::ValidationError(phrase("help.no_text_language", {{"word", word}}));
            info.language = word;
        };
        info_app->add_option_function<std::string>("--language", take_language, phrase("help.as_words_language"))
            ->needs(text);
        add_map_scale(*info_app, info.common);

        check_app = app.add_subcommand("check", phrase("help.check"));
        check_app->add_option("WORLD", check.world, phrase("help.the_world"))->required()->type_name("");
        check_app->add_flag("--json", check.json, phrase("help.json"));
        add_map_scale(*check_app, check.common);

        touch_app = app.add_subcommand("touch", phrase("help.touch"));
        touch_app->add_option("WORLD", touch.world, phrase("help.the_world"))->required()->type_name("");
        touch_app->add_option("--path", touch.path_csv, phrase("help.path"))->required()->type_name("IN.csv");
        touch_app->add_option("--out", touch.out_csv, phrase("help.out"))->required()->type_name("OUT.csv");
        add_number(
            *touch_app, "--radius", "M", [this](double v) { touch.radius_m = v; }, true, phrase("help.radius"));
        add_number(
            *touch_app, "--stiffness", "N_PER_M", [this](double v) { touch.stiffness_n_per_m = v; }, true,
            phrase("help.stiffness"));
        add_number(
            *touch_app, "--damping", "NS_PER_M", [this](double v) { touch.damping_ns_per_m = v; }, true,
            phrase("help.damping"));
        add_number(
            *touch_app, "--friction-static", "MU", [this](double v) { touch.friction_static = v; }, true,
            phrase("help.friction_static"));
        add_number(
            *touch_app, "--friction-kinetic", "MU", [this](double v) { touch.friction_kinetic = v; }, true,
            phrase("help.friction_kinetic"));
        add_number(
            *touch_app, "--scale", "S", [this](double v) { touch.scale_world_m_per_hand_m = v; }, false,
            phrase("help.scale"));
        touch_app->add_option("--device", touch.device, phrase("help.limits"))->type_name("NAME");
        add_map_scale(*touch_app, touch.common);

        scenario_app = app.add_subcommand("scenario", phrase("help.scenario"));
        scenario_app->add_option("PATH", scenario.paths, phrase("help.paths"))->required()->type_name("");
        scenario_app->add_option("--junit", scenario.junit, phrase("help.junit"))->type_name("FILE");
        scenario_app->add_option("--transcripts", scenario.transcripts, phrase("help.transcripts"))
            ->type_name("FOLDER");
        add_map_scale(*scenario_app, scenario.common);

        add_export();
        bench_app = app.add_subcommand("bench", phrase("help.bench"));
        bench_app->add_option("WORLD", bench.world, phrase("help.world_to_measure"))->type_name("");
        add_map_scale(*bench_app, bench.common);
        bench_app->add_flag("--json", bench.json, phrase("help.json"));
        add_number(
            *bench_app, "--seconds", "S", [this](double v) { bench.seconds = v; }, true, phrase("help.seconds"));

        settings_app = app.add_subcommand("settings", phrase("help.settings"));
        settings_app->add_flag("--explain", settings.arguments.explain, phrase("help.explain"));
        add_settings_options(*settings_app, settings.settings);

        calibrate_app = app.add_subcommand("calibrate", phrase("help.calibrate"));
        calibrate.arguments.calibrate = *wizard::parse_wizard_parts("");
        const auto take_parts = [this](const std::string& words) {
            auto parts = wizard::parse_wizard_parts(words);
            if (!parts) throw CLI::ValidationError(parts.error().sentence());
            calibrate.arguments.calibrate = std::move(*parts);
        };
        calibrate_app
            ->add_option_function<std::string>("--only", take_parts, phrase("help.only", {{"parts", part_words()}}))
            ->type_name("PARTS");
        calibrate_app->add_flag("--no-window", calibrate.arguments.no_window, phrase("help.no_window"));
        calibrate_app->add_option("--device", calibrate.arguments.device, phrase("help.device"))->type_name("NAME");
        add_settings_options(*calibrate_app, calibrate.settings);

        devices_app = app.add_subcommand("devices", phrase("help.devices"));
        devices_app->add_flag("--json", devices.json, phrase("help.json"));

        replay_app = add_replay_command(app, recorded.replay.arguments);
        add_settings_options(*replay_app, recorded.replay.settings);
        report_app = add_report_command(app, recorded.report);
        recorded.learner_app = add_learner_command(app, recorded.learner);
        recorded.lesson_app = add_lesson_command(app, recorded.lesson);
        add_settings_options(*recorded.lesson_app, recorded.lesson.explore.settings);
        for (CLI::App* sub :
             {recorded.lesson_app, recorded.learner_app, replay_app, report_app, calibrate_app, info_app, check_app,
              touch_app, scenario_app, export_app, bench_app, settings_app, devices_app})
            sub->group(phrase("help.group_commands"))->set_help_flag("-h,--help", phrase("help.command_help"));
    }

    void add_export() {
        export_app = add_export_command(app, exported.arguments);
        add_settings_options(*export_app, exported.settings);
        add_map_scale(*export_app, exported.arguments.common);
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

// Adds a hint to the sentence: how to get help on the command.
UsageError with_hint(const CLI::App& app, const std::string& sentence) {
    return {phrase(app.get_parent() ? "help.see_command" : "help.see", {{"sentence", sentence}})};
}

// Returns true if `world`, a word that the parser accepted as a world, is a misspelt command. CLI11 reads "handrail
// inof" as a world named inof. If no such file exists, and the word is not a path either, the person meant a command.
bool is_misspelt_command(const fs::path& world) {
    std::error_code ec;
    return world.string().find_first_of("./") == std::string::npos && !fs::exists(world, ec);
}

UsageError no_such_command(Grammar& grammar, const std::string& word) {
    std::vector<std::string> names = grammar.command_names();
    for (std::string& world : world_names()) names.push_back(std::move(world));
    return {phrase("help.no_such_command", {{"word", word}, {"nearest", nearest_name(word, names)}})};
}

// Returns an error about a word that the grammar does not know: an unknown option, or one name too many.
UsageError leftover_word(Grammar& grammar, const std::string& word) {
    CLI::App& app = grammar.chosen();
    if (word.starts_with("-")) {
        std::vector<std::string> names;
        for (const CLI::Option* option : app.get_options())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        return {phrase("help.no_such_option",
                       {{"option", word}, {"nearest", nearest_name(word.substr(0, word.find('=')), names)}})};
    }
    if (&app == &grammar.app && grammar.explore.arguments.world &&
        is_misspelt_command(*grammar.explore.arguments.world))
        return no_such_command(grammar, grammar.explore.arguments.world->string());
    return with_hint(app, phrase("help.one_too_many", {{"word", word}}));
}

// Returns an error if there are options before a command. The parser accepts such options, but they would have no
// effect.
std::optional<UsageError> options_before_command(Grammar& grammar) {
    for (const CLI::Option* option : grammar.app.get_options())
        if (option->count() > 0) {
            return UsageError{phrase("help.before_command",
                                     {{"option", option->get_name()}, {"command", grammar.chosen().get_name()}})};
        }
    return std::nullopt;
}

std::optional<UsageError> check_touch(TouchArguments& touch) {
    // If only one of the two friction options is given, its value applies to both kinds of friction.
    if (!touch.friction_static) touch.friction_static = touch.friction_kinetic;
    if (!touch.friction_kinetic) touch.friction_kinetic = touch.friction_static;
    if (touch.friction_static && *touch.friction_static < *touch.friction_kinetic)
        return UsageError{phrase("help.friction", {{"static", fmt::format("{}", *touch.friction_static)},
                                                   {"kinetic", fmt::format("{}", *touch.friction_kinetic)}})};
    return std::nullopt;
}

// The language that the program speaks before it has read the settings, and the faults in that language's file. The
// program reports these faults later, and only if the settings choose the same language.
struct FirstLanguage {
    std::string code;
    std::vector<Diagnostic> faults;
};
FirstLanguage speak_first() {
    const fs::path folder = core::user_languages_folder();
    return {core::language_as_set({}, folder), core::speak_as_set({}, folder)};
}

// Returns the person's settings with the changes from the command line. If the command line contains a wrong setting,
// writes a sentence to `err` and returns nothing.
std::optional<settings::SettingsStore> load_settings(const SettingsOptions& options, FirstLanguage first,
                                                     std::vector<Diagnostic>& problems, std::ostream& err) {
    std::vector<std::string> words;
    for (const core::CommandInfo& command : core::command_table()) words.emplace_back(command.word);
    settings::SettingsStore settings(std::move(words));
    problems =
        settings.load_file(options.file.value_or(settings::user_settings_path()), settings::SettingSource::UserFile);
    for (const std::string& assignment : options.assignments)
        if (const Result<void> set = settings.set_assignment(assignment, settings::SettingSource::CommandLine); !set) {
            err << set.error().sentence() << "\n";
            return std::nullopt;
        }
    const settings::Settings::Speech& speech = settings.values().speech;
    const fs::path folder = core::user_languages_folder();
    std::vector<Diagnostic> faults = core::language_as_set(speech, folder) == first.code
                                         ? std::move(first.faults)
                                         : core::speak_as_set(speech, folder);
    for (Diagnostic& fault : faults) problems.push_back(std::move(fault));
    return settings;
}

int refused(std::ostream& err, const Error& error) { return err << error.sentence() << "\n", 1; }

// If the world is a link, replaces it by the world and the place that the link names. A place on the command line
// overrides that of the link.
Result<void> follow_link(ExploreArguments& arguments) {
    if (!arguments.world || arguments.world->extension() != kLinkExtension) return {};
    Result<PlaceLink> link = read_link(*arguments.world, toml_next_to_worlds());
    if (!link) return tl::unexpected(std::move(link.error()));
    arguments.world = std::move(link->world);
    if (arguments.at.empty()) arguments.at = std::move(link->place);
    return {};
}

// Runs one session. If it ends because another learner was chosen, runs a session for that learner, and so on.
int explore(ExploreCall call, FirstLanguage first, std::ostream& err, const LongWork& progress) {
    for (;; first = speak_first()) {
        const ExploreCall requested = call;
        if (const auto begun = begin_as_learner(call); !begun) return refused(err, begun.error());
        if (const auto followed = follow_link(call.arguments); !followed) return refused(err, followed.error());
        std::vector<Diagnostic>& problems = call.arguments.settings_problems;
        std::optional<settings::SettingsStore> settings = load_settings(call.settings, std::move(first), problems, err);
        if (!settings) return 2;
        ExploreEnd end = run_explore(call.arguments, *settings, err, progress);
        if (!end.learner) return end.status;
        call = as_somebody_else(requested, std::move(end));
    }
}

}  // namespace

ParsedCommandLine parse_command_line(const std::vector<std::string>& words) {
    Grammar grammar;
    try {
        // CLI11 expects the arguments in reverse order.
        std::vector<std::string> reversed(words.rbegin(), words.rend());
        grammar.app.parse(std::move(reversed));
    } catch (const CLI::CallForHelp&) {
        return PrintedText{grammar.app.help()};
    } catch (const CLI::CallForVersion& version) {
        return PrintedText{std::string(version.what()) + "\n"};
    } catch (const CLI::ExtrasError&) {
        const std::vector<std::string> extras = grammar.app.remaining(true);
        return leftover_word(grammar, extras.empty() ? "" : extras.front());
    } catch (const CLI::ParseError& error) {
        return with_hint(grammar.chosen(), what_is_wrong(grammar.chosen(), error));
    }
    CLI::App& chosen = grammar.chosen();
    if (&chosen != &grammar.app)
        if (auto error = options_before_command(grammar)) return *error;
    if (grammar.explore_devices.size() > 2) return with_hint(grammar.app, phrase("help.two_hands"));
    if (!grammar.explore_devices.empty()) grammar.explore.arguments.device = grammar.explore_devices.front();
    if (grammar.explore_devices.size() > 1) grammar.explore.arguments.left_device = grammar.explore_devices.back();
    if (&chosen == grammar.info_app) return grammar.info;
    if (&chosen == grammar.check_app) return grammar.check;
    if (&chosen == grammar.scenario_app) return grammar.scenario;
    if (&chosen == grammar.export_app) return grammar.exported;
    if (&chosen == grammar.bench_app) return grammar.bench;
    if (&chosen == grammar.settings_app) return grammar.settings;
    if (&chosen == grammar.devices_app) return grammar.devices;
    if (&chosen == grammar.calibrate_app) return grammar.calibrate;
    if (&chosen == grammar.replay_app) return grammar.recorded.replay;
    if (&chosen == grammar.recorded.lesson_app) {
        ExploreArguments& taught = grammar.recorded.lesson.explore.arguments;
        if (grammar.recorded.lesson.recorded) taught.record_in = core::user_data_folder("recordings");
        taught.program_version = HANDRAIL_VERSION;
        return grammar.recorded.lesson;
    }
    if (&chosen == grammar.report_app) return grammar.recorded.report;
    if (&chosen == grammar.recorded.learner_app) return grammar.recorded.learner;
    if (&chosen == grammar.touch_app) {
        if (auto error = check_touch(grammar.touch)) return *error;
        return grammar.touch;
    }
    if (grammar.explore_recorded) grammar.explore.arguments.record_in = core::user_data_folder("recordings");
    grammar.explore.arguments.program_version = HANDRAIL_VERSION;
    auto& world = grammar.explore.arguments.world;
    if (world && is_misspelt_command(*world)) {
        const auto named = world_by_name(*world);  // a name without a path, as in "handrail house"
        if (!named) return no_such_command(grammar, world->string());
        world = *named;
    }
    return grammar.explore;
}

int run_command_line(const std::vector<std::string>& words, std::ostream& to_out, std::ostream& to_err,
                     const LongWork& progress) {
    PlainOutput out(to_out), err(to_err);
    std::vector<Diagnostic> problems;
    FirstLanguage first = speak_first();
    ParsedCommandLine parsed = parse_command_line(words);
    const auto with_settings = [&](const SettingsOptions& options, const auto& run) {
        std::optional<settings::SettingsStore> settings = load_settings(options, std::move(first), problems, err);
        if (!settings) return 2;
        for (const Diagnostic& problem : problems) err << problem.sentence() << "\n";
        return run(*settings);
    };
    return std::visit(
        Overloaded{
            [&](ExploreCall& call) { return explore(std::move(call), std::move(first), err, progress); },
            [&](const InfoArguments& arguments) { return run_info(arguments, out, err, progress); },
            [&](const CheckArguments& arguments) { return run_check(arguments, out, err, progress); },
            [&](LessonCall& call) {
                const ExploreCall requested = call.explore;
                if (const auto begun = begin_as_learner(call); !begun) return refused(err, begun.error());
                ExploreEnd end;
                const int status = with_settings(call.explore.settings, [&](settings::SettingsStore& settings) {
                    ExploreArguments& taught = call.explore.arguments;
                    const auto done = run_lesson(call.arguments, taught, out, err, progress);
                    if (!done) end = run_explore(taught, settings, err, progress);
                    return done.value_or(end.status);
                });
                if (!end.learner) return status;
                return explore(as_somebody_else(requested, std::move(end)), speak_first(), err, progress);
            },
            [&](const ReportArguments& arguments) { return run_report(arguments, out, err, progress); },
            [&](const LearnerArguments& arguments) { return run_learner(arguments, std::cin, out, err, progress); },
            [&](const TouchArguments& arguments) { return run_touch(arguments, out, err, progress); },
            [&](const ScenarioArguments& arguments) { return run_scenarios(arguments, out, err, progress); },
            [&](ExportCall& call) {
                return with_settings(call.settings, [&](settings::SettingsStore& settings) {
                    call.arguments.settings = settings.values();
                    return run_export(call.arguments, out, err, progress);
                });
            },
            [&](const BenchArguments& arguments) { return run_bench_command(arguments, out, err, progress); },
            [&](const SettingsCall& call) {
                return with_settings(call.settings, [&](settings::SettingsStore& settings) {
                    return run_settings(call.arguments, settings, out, err);
                });
            },
            [&](const DevicesArguments& arguments) { return run_devices(arguments, out, err); },
            [&](const ReplayCall& call) {
                return with_settings(call.settings, [&](settings::SettingsStore& settings) {
                    return run_replay(call.arguments, settings.values(), out, err, progress);
                });
            },
            [&](const PrintedText& printed) {
                out << printed.text << std::flush;
                return 0;
            },
            [&](const UsageError& error) {
                // The sentence may quote what the person typed, so make sure that it is printed as one line.
                err << one_line(error.sentence) << "\n";
                return 2;
            }},
        parsed);
}

}  // namespace handrail::program
