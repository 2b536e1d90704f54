// The files of settings/languages as they were when the program was built, so that it can speak wherever it stands.
#pragma once

#include <span>
#include <string_view>

namespace handrail {

struct BundledLanguage {
    std::string_view code;     // "en"
    std::string_view content;  // the whole file
};

extern const std::span<const BundledLanguage>
    kBundledLanguages;  // defined in a source that settings/languages/embed.cmake writes

}  // namespace handrail
