// The languages that can be spoken, as a list, each by its own name. App thread only.
#pragma once

#include <filesystem>

#include "app/core/context/session_part.h"

namespace handrail {

class LanguageList : SessionPart {
public:
    explicit LanguageList(const SessionContext& context) : SessionPart(context) {}

    // Files of languages of the person's own; until this is called there are the bundled ones.
    void find_in(const std::filesystem::path& folder) { folder_ = folder; }
    const std::filesystem::path& folder() const { return folder_; }
    void open(double now_s);

private:
    std::filesystem::path folder_;
};

}  // namespace handrail
