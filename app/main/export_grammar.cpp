#include "app/main/export_grammar.h"

#include <cmath>
#include <string>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::program {

CLI::App* add_export_command(CLI::App& app, ExportArguments& arguments) {
    CLI::App* command = app.add_subcommand("export", phrase("help.export"));
    command->add_option("WORLD", arguments.world, phrase("help.the_world"))->required()->type_name("");
    command->add_option("--swell", arguments.swell, phrase("help.swell"))->type_name("FILE");
    command->add_option("--stl", arguments.stl, phrase("help.stl"))->type_name("FILE");
    command->add_option("--route-card", arguments.route_card, phrase("help.route_card"))->type_name("FILE");
    command->add_option("--page", arguments.page, phrase("help.page"))->type_name("FILE");
    command->add_option("--from", arguments.from, phrase("help.card_from"))->type_name("NAME");
    command->add_option("--to", arguments.to, phrase("help.card_to"))->type_name("NAME");
    const auto take_storey = [&arguments](const std::string& word) {
        double number = 0.0;
        if (!parse_finite(word, number) || number < 1.0 || number > 1000.0 || number != std::floor(number))
            throw CLI::ValidationError(phrase("export.storey", {{"word", word}}));
        arguments.storey = static_cast<int>(number);
    };
    command->add_option_function<std::string>("--storey", take_storey, phrase("help.storey"))->type_name("N");
    command->add_option("--paper", arguments.paper, phrase("help.paper"))->type_name("SIZE");
    command->add_option("--braille", arguments.braille, phrase("help.braille"))->type_name("TABLE");
    command->add_flag("--sheets", arguments.sheets, phrase("help.sheets"));
    command->add_option("--around", arguments.around, phrase("help.around"))->type_name("NAME");
    command->add_flag("--coarse", arguments.coarse, phrase("help.coarse"));
    command->add_flag("--strip", arguments.strip, phrase("help.strip"));
    command->add_flag("--force", arguments.force, phrase("help.force"));
    return command;
}

}  // namespace handrail::program
