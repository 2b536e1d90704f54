#include "app/core/kept/spoken_language.h"

#include "app/core/kept/side_file.h"

namespace handrail::core {

std::string language_as_set(const settings::Settings::Speech& settings, const std::filesystem::path& folder) {
    return settings.language == "auto" ? language_of_environment(folder) : settings.language;
}

std::vector<Diagnostic> speak_as_set(const settings::Settings::Speech& settings, const std::filesystem::path& folder) {
    const Result<std::vector<Diagnostic>> spoken = speak_language(language_as_set(settings, folder), folder);
    if (spoken) return *spoken;
    const Error& error = spoken.error();
    return {{Severity::Warning, error.file, error.line, error.column, error.message, {}}};
}

std::filesystem::path user_languages_folder() { return user_data_folder("languages"); }

}  // namespace handrail::core
