#include "worlds/imdf/zip_archive.h"

#include <zlib.h>

#include <algorithm>

#include "worlds/base/language.h"

namespace handrail::imdf {
namespace {

constexpr std::size_t kMostFiles = 10'000, kEnd_bytes = 22, kEntry_bytes = 46, kLocal_bytes = 30;
constexpr std::uint32_t kEnd = 0x06054b50, kEntry = 0x02014b50, kLocal = 0x04034b50;

std::uint32_t number(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

// Unpacks exactly `size` bytes. Returns false if the packed data is damaged or gives more or fewer bytes.
bool inflate_all(std::string_view packed, std::size_t size, std::string& into) {
    into.assign(size, '\0');
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return false;
    stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(into.data());
    stream.avail_out = static_cast<uInt>(size);
    const int end = inflate(&stream, Z_FINISH);
    const bool whole = end == Z_STREAM_END && stream.total_out == size;
    inflateEnd(&stream);
    return whole;
}

}  // namespace

Result<std::map<std::string, std::string>> unzip(std::string_view bytes, const std::string& file_name,
                                                 bool (*wanted)(std::string_view path)) {
    const auto damaged = [&] { return fail(phrase("imdf.damaged_zip"), file_name); };
    if (bytes.size() < kEnd_bytes) return damaged();
    // The end record states the position of the directory. A comment of at most 65,535 bytes follows the end record.
    std::size_t end = bytes.size() - kEnd_bytes;
    const std::size_t first = end > 65'535 ? end - 65'535 : 0;
    while (number(bytes, end, 4) != kEnd)
        if (end-- == first) return damaged();
    const std::size_t count = number(bytes, end + 10, 2);
    std::size_t at = number(bytes, end + 16, 4);
    if (count > kMostFiles) return damaged();
    std::map<std::string, std::string> files;
    std::size_t unpacked = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (at > bytes.size() || bytes.size() - at < kEntry_bytes || number(bytes, at, 4) != kEntry) return damaged();
        const std::uint32_t flags = number(bytes, at + 8, 2), method = number(bytes, at + 10, 2),
                            checksum = number(bytes, at + 16, 4);
        const std::size_t packed = number(bytes, at + 20, 4), size = number(bytes, at + 24, 4),
                          name = number(bytes, at + 28, 2), extra = number(bytes, at + 30, 2),
                          comment = number(bytes, at + 32, 2), local = number(bytes, at + 42, 4);
        if (bytes.size() - at - kEntry_bytes < name) return damaged();
        const std::string_view path = bytes.substr(at + kEntry_bytes, name);
        at += kEntry_bytes + name + extra + comment;
        if (!wanted(path)) continue;
        if ((flags & 1U) != 0) return fail(phrase("imdf.encrypted"), file_name);
        if (local > bytes.size() || bytes.size() - local < kLocal_bytes || number(bytes, local, 4) != kLocal)
            return damaged();
        const std::size_t data = local + kLocal_bytes + number(bytes, local + 26, 2) + number(bytes, local + 28, 2);
        if (data > bytes.size() || bytes.size() - data < packed) return damaged();
        unpacked += size;
        if (unpacked > kMostUnpacked_bytes) return fail(phrase("imdf.too_large"), file_name);
        // This compression method never reduces data to less than a thousandth, so a better ratio means damage.
        if (method == 8 && size / 1100 > packed) return damaged();
        std::string content;
        if (method == 0 && packed == size) content = bytes.substr(data, size);
        else if (method != 8 || !inflate_all(bytes.substr(data, packed), size, content)) return damaged();
        const auto sum =
            static_cast<std::uint32_t>(::crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size()));
        if (sum != checksum) return damaged();
        files.insert_or_assign(std::string(path), std::move(content));
    }
    return files;
}

}  // namespace handrail::imdf
