// Gives access to the files of settings/languages, which are built into the program. So Handrail can speak wherever it
// is installed.
#pragma once

#include <span>
#include <string_view>

namespace handrail {

struct BundledLanguage {
    std::string_view code;     // the language's code: "en"
    std::string_view content;  // the whole text of the language file
};

// Defined in a source file that settings/languages/embed.cmake generates.
extern const std::span<const BundledLanguage> kBundledLanguages;

}  // namespace handrail
