// The command line, from words to one of the commands in commands.h. Numbers are read the same way in every language
// setting. App thread.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "app/main/commands.h"

namespace handrail {

// --settings and --set, for the commands that use settings.
struct SettingsOptions {
    std::optional<std::filesystem::path> file;  // --settings FILE; none: user_settings_path()
    std::vector<std::string> assignments;       // --set key=value, in order
};

struct ExploreCall {
    ExploreArguments arguments;
    SettingsOptions settings;
};
struct SettingsCall {
    SettingsArguments arguments;
    SettingsOptions settings;
};
struct ExportCall {
    ExportArguments arguments;
    SettingsOptions settings;
};
struct ReplayCall {
    ReplayArguments arguments;
    SettingsOptions settings;
};
struct LessonCall {
    LessonArguments arguments;
    ExploreCall explore;
    bool recorded = false;  // --record
};
// --help and --version: exit status 0.
struct PrintedText {
    std::string text;
};
// Wrong usage, in one sentence that names the nearest known word: exit status 2.
struct UsageError {
    std::string sentence;
};

using ParsedCommandLine = std::variant<ExploreCall, InfoArguments, CheckArguments, TouchArguments, ScenarioArguments,
                                       ExportCall, BenchArguments, SettingsCall, DevicesArguments, LessonCall,
                                       ReplayCall, ReportArguments, LearnerArguments, PrintedText, UsageError>;

// `words` are the arguments after the program's name. Touches no file but to ask whether a WORLD exists.
ParsedCommandLine parse_command_line(const std::vector<std::string>& words);

// Parses, loads the settings where they are needed, runs the command and gives the exit status.
// `progress`: of what takes long, for whoever waits.
int run_command_line(const std::vector<std::string>& words, std::ostream& out, std::ostream& err,
                     const LongWork& progress = {});

}  // namespace handrail
