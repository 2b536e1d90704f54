// Lists the languages that can be spoken, each under its own name for itself. Use it on the app thread only.
#pragma once

#include <filesystem>

#include "app/core/context/session_part.h"

namespace handrail::core {

class LanguageList : SessionPart {
public:
    explicit LanguageList(const SessionContext& context) : SessionPart(context) {}

    // Sets the folder of the person's own language files. Without a folder, only the bundled languages are listed.
    void find_in(const std::filesystem::path& folder) { folder_ = folder; }
    const std::filesystem::path& folder() const { return folder_; }
    void open(double now_s);

private:
    std::filesystem::path folder_;
};

}  // namespace handrail::core
