#include "worlds/words/read_words.h"

#include "worlds/words/words_plan.h"

namespace handrail::words {

Result<Scene> read_words_building(std::string_view bytes, const std::string& file_name,
                                  const floorplan::PlanOptions& options) {
    constexpr std::size_t kLargest = std::size_t{8} << 20, kMostKept = 20;
    if (bytes.size() > kLargest) return fail(phrase("rooms_text.too_large"), file_name);
    WordsPlan words(file_name);
    Result<floorplan::FloorPlan> plan = words.build(bytes);
    if (!plan) return tl::unexpected(plan.error());
    if (options.stop.stop_requested()) return fail(phrase("files.stopped"), file_name);
    Result<Scene> scene = floorplan::scene_of_plan(std::move(*plan), file_name, options);
    if (!scene) return scene;
    // Puts the warnings about the text before the scene's own warnings, in the order of the lines.
    std::vector<Diagnostic> warnings = words.warnings();
    for (Diagnostic& warning : scene->report.warnings)
        if (warnings.size() < kMostKept) warnings.push_back(std::move(warning));
    scene->report.warnings = std::move(warnings);
    scene->report.warnings_in_all += words.warnings_in_all();
    return scene;
}

}  // namespace handrail::words
