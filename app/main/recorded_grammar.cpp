#include "app/main/recorded_grammar.h"

#include <string>

#include "app/record/hearing.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::program {

CLI::App* add_replay_command(CLI::App& app, ReplayArguments& arguments) {
    CLI::App* command = app.add_subcommand("replay", phrase("help.replay"));
    command->add_option("FOLDER", arguments.folder, phrase("help.replay_folder"))->type_name("");
    CLI::Option* computed = command->add_flag("--check", arguments.check, phrase("help.replay_check"));
    const auto take_speed = [&arguments](const std::string& word) {
        double speed = 0.0;
        if (!parse_finite(word, speed) || speed < record::Hearing::kSlowest || speed > record::Hearing::kFastest)
            throw CLI::ValidationError(phrase("help.no_speed", {{"word", word}}));
        arguments.speed = speed;
    };
    command->add_option_function<std::string>("--speed", take_speed, phrase("help.replay_speed"))
        ->type_name("X")
        ->excludes(computed);
    command->add_option("--csv", arguments.csv, phrase("help.replay_csv"))->type_name("FOLDER");
    command->add_option("--scenario", arguments.scenario, phrase("help.replay_scenario"))->type_name("OUT.toml");
    return command;
}

CLI::App* add_report_command(CLI::App& app, ReportArguments& arguments) {
    CLI::App* command = app.add_subcommand("report", phrase("help.report"));
    command->add_option("FOLDER", arguments.folder, phrase("help.replay_folder"))->type_name("");
    command->add_option("--html", arguments.html, phrase("help.report_html"))->type_name("OUT.html");
    command->add_option("--csv", arguments.csv, phrase("help.report_csv"))->type_name("OUT.csv");
    command->add_option("--json", arguments.json, phrase("help.report_json"))->type_name("OUT.json");
    command->add_option("--learner", arguments.learner, phrase("help.report_learner"))->type_name("NAME");
    command->add_flag("--force", arguments.force, phrase("help.force"));
    return command;
}

}  // namespace handrail::program
