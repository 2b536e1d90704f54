#include "app/main/wrong_usage.h"

#include <algorithm>
#include <optional>

#include "worlds/base/language.h"

namespace handrail::program {
namespace {

std::string first_line_as_sentence(std::string text) {
    text = text.substr(0, text.find('\n'));
    if (!text.empty() && text.back() != '.') text += '.';
    return text;
}

// Returns what is wrong with `option`; nothing if the error is about something else.
std::optional<std::string> wrong_with(const CLI::Option& option, const CLI::ParseError& error) {
    const std::string name = option.get_name(), message = error.what();
    const auto other_of = [](const std::set<CLI::Option*>& others, bool given) -> const CLI::Option* {
        const auto found = std::find_if(others.begin(), others.end(),
                                        [given](const CLI::Option* other) { return (other->count() > 0) == given; });
        return found == others.end() ? nullptr : *found;
    };
    if (dynamic_cast<const CLI::RequiredError*>(&error) && option.get_required() && option.count() == 0)
        return phrase("help.required", {{"name", name}});
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) && message.starts_with(name + ": "))
        return option.count() > 1 ? phrase("help.once", {{"option", name}})
                                  : phrase("help.value_missing", {{"option", name}, {"value", option.get_type_name()}});
    if (dynamic_cast<const CLI::ExcludesError*>(&error) && option.count() > 0)
        if (const CLI::Option* other = other_of(option.get_excludes(), true))
            return phrase("help.excludes", {{"option", name}, {"other", other->get_name()}});
    if (dynamic_cast<const CLI::RequiresError*>(&error) && option.count() > 0)
        if (const CLI::Option* other = other_of(option.get_needs(), false))
            return phrase("help.needs", {{"option", name}, {"other", other->get_name()}});
    // CLI11 converts only whole numbers itself; add_number reads all others. So a conversion error of CLI11 means that
    // a whole number is needed.
    if (dynamic_cast<const CLI::ConversionError*>(&error) && option.count() > 0 &&
        message.find(name + " = ") != std::string::npos)
        return phrase("help.needs_whole", {{"option", name}, {"word", option.results().front()}});
    return std::nullopt;
}

}  // namespace

std::string what_is_wrong(const CLI::App& app, const CLI::ParseError& error) {
    for (const CLI::Option* option : app.get_options())
        if (auto words = wrong_with(*option, error)) return std::move(*words);
    return first_line_as_sentence(error.what());
}

}  // namespace handrail::program
