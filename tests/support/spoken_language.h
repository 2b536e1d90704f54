// Sets another language for a test, and restores the language of the process afterwards.
#pragma once

#include <gtest/gtest.h>

#include "worlds/base/language.h"

namespace handrail::test {

class InLanguage {
public:
    explicit InLanguage(std::string_view code, const std::filesystem::path& folder = {}) {
        if (const auto spoken = speak_language(code, folder); !spoken) ADD_FAILURE() << spoken.error().sentence();
    }
    ~InLanguage() { (void)speak_language("en"); }
    InLanguage(const InLanguage&) = delete;
    InLanguage& operator=(const InLanguage&) = delete;
};

}  // namespace handrail::test
