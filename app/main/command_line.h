// Parses the command line and runs one of the commands in commands.h. App thread. The current locale does not affect
// how numbers are read.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "app/main/commands.h"

namespace handrail::program {

// The options --settings and --set, for the commands that use settings.
struct SettingsOptions {
    std::optional<std::filesystem::path> file;  // --settings FILE; none: the file is user_settings_path()
    std::vector<std::string> assignments;       // each --set key=value, in order
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
    bool recorded = false;  // --record was given
};
// The text to print for --help or --version; the exit status is 0.
struct PrintedText {
    std::string text;
};
// One sentence about wrong usage, which suggests the nearest known word; the exit status is 2.
struct UsageError {
    std::string sentence;
};

using ParsedCommandLine = std::variant<ExploreCall, InfoArguments, CheckArguments, TouchArguments, ScenarioArguments,
                                       ExportCall, BenchArguments, SettingsCall, DevicesArguments, LessonCall,
                                       ReplayCall, ReportArguments, LearnerArguments, PrintedText, UsageError>;

// Parses the words, which are the arguments after the program's name. Accesses no file, but checks whether a WORLD
// exists.
ParsedCommandLine parse_command_line(const std::vector<std::string>& words);

// Parses the words, loads the settings if the command uses them, runs the command and returns the exit status.
// `progress` reports long work to a person who waits for it.
int run_command_line(const std::vector<std::string>& words, std::ostream& out, std::ostream& err,
                     const LongWork& progress = {});

}  // namespace handrail::program
