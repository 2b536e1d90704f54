#include "worlds/readers/height_picture.h"

#include <png.h>

#include <csetjmp>
#include <cstring>
#include <vector>

#include "worlds/base/language.h"

namespace handrail::readers {
namespace {

// State that decode() shares with libpng's callbacks. It is plain data that is made before setjmp and freed after it,
// because libpng leaves decode() by a long jump on errors.
struct Decoder {
    const unsigned char* bytes = nullptr;
    std::size_t size = 0, at = 0;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::vector<unsigned char>* pixels = nullptr;
    std::vector<png_bytep>* rows = nullptr;
    int width = 0, height = 0, channels = 0;

    ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
};

void take_bytes(png_structp png, png_bytep out, std::size_t count) {
    auto& decoder = *static_cast<Decoder*>(png_get_io_ptr(png));
    if (count > decoder.size - decoder.at) png_error(png, "cut short");
    std::memcpy(out, decoder.bytes + decoder.at, count);
    decoder.at += count;
}

[[noreturn]] void jump_out(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void keep_quiet(png_structp, png_const_charp) {}

// Decodes to 16 bits per channel, grey or colour, with an alpha channel. This function must not contain an object with
// a destructor, because libpng leaves the function by a long jump, which would skip the destructor.
bool decode(Decoder& d) {
    if (setjmp(png_jmpbuf(d.png))) return false;
    png_set_read_fn(d.png, &d, take_bytes);
    png_set_user_limits(d.png, kLargestPictureSide, kLargestPictureSide);
    png_set_chunk_malloc_max(d.png, 1 << 24);
    png_read_info(d.png, d.info);
    d.width = static_cast<int>(png_get_image_width(d.png, d.info));
    d.height = static_cast<int>(png_get_image_height(d.png, d.info));
    png_set_expand_16(d.png);  // also expands palettes, low bit depths and transparent colours
    png_set_add_alpha(d.png, 0xffff, PNG_FILLER_AFTER);
    png_set_interlace_handling(d.png);
    png_read_update_info(d.png, d.info);
    d.channels = png_get_channels(d.png, d.info);
    const std::size_t row = png_get_rowbytes(d.png, d.info);
    if (row != static_cast<std::size_t>(d.width) * static_cast<std::size_t>(d.channels) * 2) return false;
    d.pixels->resize(row * static_cast<std::size_t>(d.height));
    d.rows->resize(static_cast<std::size_t>(d.height));
    for (std::size_t y = 0; y < d.rows->size(); ++y) (*d.rows)[y] = d.pixels->data() + y * row;
    png_read_image(d.png, d.rows->data());
    png_read_end(d.png, nullptr);
    return true;
}

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

// True if each chunk up to the last has as many bytes in the file as its header states. The check is needed because
// libpng allocates the stated length before it reads: 1.5 GB for a file of 47 bytes.
bool holds_its_chunks(std::string_view bytes) {
    for (std::size_t at = 8; at + 8 <= bytes.size();) {
        const std::size_t length = big_endian(bytes, at);
        if (length > bytes.size() - at - 8) return false;
        if (bytes.substr(at + 4, 4) == "IEND") return true;
        at += 12 + length;
    }
    return false;
}

}  // namespace

Result<HeightPicture> read_height_picture(std::string_view bytes, const std::string& file_name) {
    constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
    if (!bytes.starts_with(kSignature)) return fail(phrase("reader.no_png"), file_name);
    if (bytes.size() >= 24 &&
        (big_endian(bytes, 16) > kLargestPictureSide || big_endian(bytes, 20) > kLargestPictureSide))
        return fail(phrase("reader.large_picture", {{"pixels", kLargestPictureSide}}), file_name);
    if (!holds_its_chunks(bytes)) return fail(phrase("reader.damaged_picture"), file_name);
    std::vector<unsigned char> pixels;
    std::vector<png_bytep> rows;
    Decoder decoder;
    decoder.bytes = reinterpret_cast<const unsigned char*>(bytes.data());
    decoder.size = bytes.size();
    decoder.pixels = &pixels;
    decoder.rows = &rows;
    decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, jump_out, keep_quiet);
    if (decoder.png) decoder.info = png_create_info_struct(decoder.png);
    if (!decoder.info || !decode(decoder) || decoder.channels < 2)
        return fail(phrase("reader.damaged_picture"), file_name);

    HeightPicture picture;
    picture.width = decoder.width;
    picture.height = decoder.height;
    const std::size_t count = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    const auto channels = static_cast<std::size_t>(decoder.channels);
    const auto value = [&](std::size_t pixel, std::size_t channel) {
        const std::size_t at = 2 * (pixel * channels + channel);
        return static_cast<float>(pixels[at] << 8 | pixels[at + 1]) / 65535.0F;
    };
    picture.depths.resize(count);
    // The channel before alpha is the grey channel, or the blue channel of a colour picture.
    for (std::size_t i = 0; i < count; ++i) picture.depths[i] = value(i, channels - 2) * value(i, channels - 1);
    return picture;
}

}  // namespace handrail::readers
