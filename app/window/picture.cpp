#include "app/window/picture.h"

#include <png.h>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail {

Result<void> save_png(const Picture& picture, const std::filesystem::path& path) {
    contract_pre(picture.width > 0 && picture.height > 0 &&
                 picture.rgb.size() ==
                     3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = PNG_FORMAT_RGB;
    if (png_image_write_to_file(&image, path.c_str(), 0, picture.rgb.data(), 0, nullptr) == 0)
        return fail(phrase("window.not_saved", {{"reason", image.message}}), path.string());
    return {};
}

}  // namespace handrail
