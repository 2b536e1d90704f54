#include "app/main/lesson_grammar.h"

#include "worlds/base/language.h"

namespace handrail::program {

CLI::App* add_lesson_command(CLI::App& app, LessonCall& call) {
    CLI::App* sub = app.add_subcommand("lesson", phrase("help.lesson"));
    sub->add_option("FILE", call.arguments.file, phrase("help.lesson_file"))->required()->type_name("");
    sub->add_option("--session", call.arguments.session, phrase("help.lesson_session"))->type_name("N");
    CLI::Option* learner =
        sub->add_option("--learner", call.arguments.learner, phrase("help.lesson_learner"))->type_name("NAME");
    CLI::Option* played = sub->add_flag("--check", call.arguments.check, phrase("help.lesson_check"));
    sub->add_flag("--protocol", call.arguments.protocol, phrase("help.lesson_protocol"))->excludes(played);
    ExploreArguments& taught = call.explore.arguments;
    sub->add_flag("--no-window", taught.no_window, phrase("help.no_window"));
    sub->add_option("--device", taught.device, phrase("help.device"))->type_name("NAME");
    CLI::Option* record = sub->add_flag("--record", call.recorded, phrase("help.record"));
    sub->add_option("--record-in", taught.record_in, phrase("help.record_in"))
        ->type_name("FOLDER")
        ->excludes(record)
        ->excludes(learner);
    return sub;
}

}  // namespace handrail::program
