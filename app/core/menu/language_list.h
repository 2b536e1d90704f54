// The languages that can be spoken, as a list, each by its own name. App thread only.
#pragma once

#include <filesystem>

#include "app/core/context/session_context.h"

namespace handrail {

class LanguageList {
public:
    explicit LanguageList(const SessionContext& context) : context_(context) {}
    LanguageList(const LanguageList&) = delete;  // an open list knows it by its place
    LanguageList& operator=(const LanguageList&) = delete;

    // Files of languages of the person's own; until this is called there are the bundled ones.
    void find_in(const std::filesystem::path& folder) { folder_ = folder; }
    const std::filesystem::path& folder() const { return folder_; }
    void open(double now_s);

private:
    const SessionContext& context_;
    std::filesystem::path folder_;
};

}  // namespace handrail
