#include "app/import/kept_scene.h"

#include "app/import/reader_answer.h"
#include "worlds/base/language.h"

namespace handrail::importing {

std::string kept_scene(const std::vector<NeighbourFile>& beside, std::string_view scene) {
    stored::Packer pack;
    pack(beside);
    std::string kept = pack.take();
    kept += scene;
    return kept;
}

Result<std::optional<Scene>> scene_in(std::string_view kept,
                                      const std::function<bool(const std::vector<NeighbourFile>&)>& still_good) {
    stored::Unpacker head(kept);
    std::vector<NeighbourFile> beside;
    head(beside);
    if (!head.good()) return fail(phrase("import.damaged"));
    if (!still_good(beside)) return std::optional<Scene>();
    Result<Scene> scene = stored::scene_from(head.rest());
    if (!scene) return tl::unexpected(scene.error());
    return std::optional<Scene>(std::move(*scene));
}

}  // namespace handrail::importing
