#include "app/learners/export_gate.h"

#include <algorithm>
#include <system_error>

#include "app/learners/exported.h"
#include "worlds/base/language.h"

namespace handrail::learners {
namespace {

namespace fs = std::filesystem;

fs::path real_path(const fs::path& path) {
    std::error_code ec;
    return fs::weakly_canonical(fs::absolute(path, ec), ec);
}

// Returns the path of `inside` relative to `whole`; empty if `inside` is not below `whole`.
fs::path below(const fs::path& inside, const fs::path& whole) {
    const auto [of_whole, of_inside] = std::mismatch(whole.begin(), whole.end(), inside.begin(), inside.end());
    fs::path rest;
    if (of_whole == whole.end())
        for (auto part = of_inside; part != inside.end(); ++part) rest /= *part;
    return rest;
}

}  // namespace

Result<ExportGate> ExportGate::of(const Learners& learners, const fs::path& data) {
    if (learners.folder().empty()) return ExportGate();
    const fs::path rest = below(real_path(data), real_path(learners.folder()));
    if (rest.empty()) return ExportGate();
    const std::string id = learners.id_of(rest.begin()->string());
    if (id.empty()) return ExportGate();
    auto learner = learners.find(id);
    if (!learner) return tl::unexpected(std::move(learner.error()));
    return of(learners, std::move(*learner));
}

ExportGate ExportGate::of(const Learners& learners, Learner learner) {
    ExportGate way;
    way.folder_ = learners.folder_of(learner.id);
    way.learner_ = std::move(learner);
    return way;
}

bool ExportGate::leaves(const fs::path& file) const {
    return learner_ && below(real_path(file), real_path(folder_)).empty();
}

Result<void> ExportGate::allows(const fs::path& file) const {
    if (!leaves(file) || learner_->allows(Purpose::Share, today())) return {};
    return fail(phrase("learner.not_shared", {{"name", learner_->name}}));
}

Result<void> ExportGate::write(const fs::path& file, std::string_view content, Writer how) const {
    if (auto allowed = allows(file); !allowed) return allowed;
    if (leaves(file))
        if (auto noted = note_exported(folder_, file, content); !noted) return noted;
    return how(file, content);
}

}  // namespace handrail::learners
