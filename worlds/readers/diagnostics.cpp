#include "worlds/readers/diagnostics.h"

namespace handrail::readers {

std::string excerpt(std::string_view found, std::size_t most) {
    std::string text(found.substr(0, most));
    for (char& c : text)
        if (c < ' ' || c > '~' || c == '"') c = '?';
    if (found.size() > most) text += "...";
    return text;
}

tl::unexpected<Error> nothing_to_touch(const Diagnostics& diagnostics, const std::string& file,
                                       std::string_view world) {
    if (diagnostics.kept().empty()) return fail(phrase("reader.nothing_to_touch", {{"world", world}}), file);
    const Diagnostic& first = diagnostics.kept().front();
    return fail(
        phrase("reader.only_problems", {{"world", world}, {"count", diagnostics.in_all()}, {"problem", first.message}}),
        file, first.line, first.column);
}

}  // namespace handrail::readers
