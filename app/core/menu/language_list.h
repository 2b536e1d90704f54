// The list of languages that can be spoken, each by its own name. App thread only.
#pragma once

#include <filesystem>

#include "app/core/context/session_part.h"

namespace handrail::core {

class LanguageList : SessionPart {
public:
    explicit LanguageList(const SessionContext& context) : SessionPart(context) {}

    // Folder of the person's own language files; without it there are only the bundled ones.
    void find_in(const std::filesystem::path& folder) { folder_ = folder; }
    const std::filesystem::path& folder() const { return folder_; }
    void open(double now_s);

private:
    std::filesystem::path folder_;
};

}  // namespace handrail::core
