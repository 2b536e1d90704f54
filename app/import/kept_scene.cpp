#include "app/import/kept_scene.h"

#include "app/import/reader_answer.h"
#include "worlds/base/language.h"

namespace handrail {
namespace {

constexpr std::string_view kBegins = "handrail-scene\n";

}  // namespace

template <class A, Is<KeptFrom> T>
void fields(A& a, T& v) {
    auto& [version, size, sum, said, beside] = v;
    a(version, size, sum, said, beside);
}

std::string kept_file(const KeptFrom& from, std::string_view scene) {
    Packer pack;
    pack(from);
    std::string head = pack.take();
    head.insert(0, kBegins);
    Packer sums;
    sums(checksum(checksum(0, head), scene), static_cast<std::uint64_t>(scene.size()));
    std::string file = sums.take();
    file.reserve(file.size() + head.size() + scene.size());
    file += head;
    file += scene;
    return file;
}

Result<std::optional<Scene>> scene_in(std::string_view file, const std::function<bool(const KeptFrom&)>& still_good) {
    Unpacker unpack(file);
    std::uint32_t sum = 0;
    std::uint64_t size = 0;
    unpack(sum, size);
    const std::string_view after = unpack.rest();
    if (!unpack.good() || !after.starts_with(kBegins)) return fail(phrase("import.damaged"));
    Unpacker head(after.substr(kBegins.size()));
    KeptFrom from;
    head(from);
    if (!head.good() || head.rest().size() != size) return fail(phrase("import.damaged"));
    if (!still_good(from)) return std::optional<Scene>();
    if (checksum(0, after) != sum) return fail(phrase("import.damaged"));
    Result<Scene> scene = scene_from(head.rest());
    if (!scene) return tl::unexpected(scene.error());
    return std::optional<Scene>(std::move(*scene));
}

}  // namespace handrail
