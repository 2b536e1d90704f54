#include "app/main/learner_grammar.h"

#include "worlds/base/language.h"

namespace handrail::program {

CLI::App* add_learner_command(CLI::App& app, LearnerArguments& arguments) {
    CLI::App* learner = app.add_subcommand("learner", phrase("help.learner"));
    learner->add_option("ACTION", arguments.action, phrase("help.learner_action"))->type_name("");
    learner->add_option("NAME", arguments.name, phrase("help.learner_name"))->type_name("");
    learner->add_option("--give", arguments.give, phrase("help.learner_give"))->type_name("PURPOSES");
    learner->add_option("--withdraw", arguments.withdraw, phrase("help.learner_withdraw"))->type_name("PURPOSES");
    learner->add_option("--by", arguments.by, phrase("help.learner_by"))->type_name("NAME");
    learner->add_option("--until", arguments.until, phrase("help.learner_until"))->type_name("DAY");
    learner->add_option("--to", arguments.to, phrase("help.learner_to"))->type_name("FILE");
    learner->add_flag("--yes", arguments.yes, phrase("help.learner_yes"));
    return learner;
}

void add_learner_option(CLI::App& app, ExploreArguments& arguments) {
    app.add_option("--learner", arguments.learner, phrase("help.as_learner"))
        ->type_name("NAME")
        ->excludes(app.get_option("--record-in"));
}

}  // namespace handrail::program
