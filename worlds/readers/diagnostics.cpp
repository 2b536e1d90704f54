#include "worlds/readers/diagnostics.h"

namespace handrail {

std::string excerpt(std::string_view found, std::size_t most) {
    std::string text(found.substr(0, most));
    for (char& c : text)
        if (c < ' ' || c > '~' || c == '"') c = '?';
    if (found.size() > most) text += "...";
    return text;
}

tl::unexpected<Error> nothing_to_touch(const Diagnostics& diagnostics, const std::string& file, std::string_view world, std::string_view parts) {
    const std::string why = fmt::format("Nothing to touch was found in this {}.", world);
    if (diagnostics.kept().empty()) return fail(fmt::format("{} It holds no {}.", why, parts), file);
    const Diagnostic& first = diagnostics.kept().front();
    const std::string count = diagnostics.in_all() == 1 ? "The problem" : fmt::format("{} problems; the first", diagnostics.in_all());
    return fail(fmt::format("{} {}: {}", why, count, first.message), file, first.line, first.column);
}

}  // namespace handrail
