// Registers the readers for IFC, the format of architects' programs, plain or zipped. worlds/ifc does the reading.
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/ifc/read_ifc.h"
#include "worlds/imdf/zip_archive.h"
#include "worlds/readers/reader.h"
#include "worlds/readers/spoken_text.h"

namespace handrail::readers {
namespace {

bool is_model(std::string_view path) {
    const std::string_view name = path.substr(path.rfind('/') + 1);  // if there is no slash, npos + 1 is 0
    return lower_ascii(name).ends_with(".ifc") && !name.starts_with('.') && !path.starts_with("__MACOSX/");
}

}  // namespace

Result<Scene> read_ifc(std::string_view bytes, const std::string& file_name, const ReadOptions& options) {
    return ifc::read_ifc_building(
        bytes, file_name,
        {words_of_name(file_name), options.guess_materials, options.progress, options.stage, options.stop});
}

bool is_ifczip(const std::filesystem::path& path, std::string_view bytes) {
    if (!bytes.starts_with("PK\x03\x04")) return false;
    if (lower_ascii(path.extension().string()) == ".ifczip") return true;
    // The first file's name follows the first 30 bytes of the archive. Two of those bytes hold the length of the name.
    if (bytes.size() < 30) return false;
    const auto length = static_cast<std::size_t>(static_cast<unsigned char>(bytes[26])) |
                        static_cast<std::size_t>(static_cast<unsigned char>(bytes[27])) << 8U;
    return is_model(bytes.substr(30, length));
}

Result<Scene> read_ifczip(std::string_view bytes, const std::string& file_name, const ReadOptions& options) {
    const Result<std::map<std::string, std::string>> models = imdf::unzip(bytes, file_name, is_model);
    if (!models) return tl::unexpected(models.error());
    if (models->empty()) return fail(phrase("reader.no_ifc_in_zip"), file_name);
    if (models->size() > 1) return fail(phrase("reader.several_ifc_in_zip", {{"n", models->size()}}), file_name);
    return read_ifc(models->begin()->second, file_name, options);
}

}  // namespace handrail::readers
