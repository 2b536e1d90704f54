#include "tests/support/zip_text.h"

#include <zlib.h>

namespace handrail::test {
namespace {

std::string little(std::size_t value, int size) {
    std::string bytes;
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xffU);
    return bytes;
}

std::string deflated_bytes(const std::string& text) {
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    std::string packed(text.size() + 1000, '\0'), copy = text;
    stream.next_in = reinterpret_cast<Bytef*>(copy.data());
    stream.avail_in = static_cast<uInt>(copy.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

}  // namespace

std::string zipped(const std::map<std::string, std::string>& files, bool deflated) {
    std::string archive, directory;
    for (const auto& [name, content] : files) {
        const std::string data = deflated ? deflated_bytes(content) : content;
        const std::string about =
            little(20, 2) + little(0, 2) + little(deflated ? 8 : 0, 2) + little(0, 4) +
            little(::crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size()), 4) +
            little(data.size(), 4) + little(content.size(), 4) + little(name.size(), 2) + little(0, 2);
        directory += "PK\x01\x02" + little(20, 2) + about + little(0, 2) + little(0, 4) + little(0, 4) +
                     little(archive.size(), 4) + name;
        archive += "PK\x03\x04" + about + name + data;
    }
    const std::size_t at = archive.size();
    return archive + directory + "PK\x05\x06" + little(0, 4) + little(files.size(), 2) + little(files.size(), 2) +
           little(directory.size(), 4) + little(at, 4) + little(0, 2);
}

}  // namespace handrail::test
