// The files of settings/languages as they were when the program was built, so that it can speak wherever it stands.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace handrail {

struct BundledLanguage {
    std::string_view code;                     // "en"
    std::span<const std::string_view> pieces;  // one behind another they are the file

    [[nodiscard]] std::string content() const {
        std::string whole;
        for (const std::string_view piece : pieces) whole += piece;
        return whole;
    }
};

extern const std::span<const BundledLanguage>
    kBundledLanguages;  // defined in a source that settings/languages/embed.cmake writes

}  // namespace handrail
