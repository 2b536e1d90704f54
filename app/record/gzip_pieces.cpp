#include "app/record/gzip_pieces.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>

#include "worlds/base/contract.h"

namespace handrail::record {
namespace {

// windowBits of zlib: 15 selects the largest window, and adding 16 selects the gzip format.
constexpr int kGzip = 15 + 16;

Bytef* bytes_of(std::string_view text) { return reinterpret_cast<Bytef*>(const_cast<char*>(text.data())); }

}  // namespace

std::string gzip_piece(std::string_view text) {
    if (text.empty()) return {};
    contract_pre(text.size() < std::numeric_limits<uInt>::max() / 2);
    z_stream stream{};
    if (deflateInit2(&stream, 6, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY) != Z_OK) throw std::bad_alloc();
    std::string piece(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
    stream.next_in = bytes_of(text);
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = bytes_of(piece);
    stream.avail_out = static_cast<uInt>(piece.size());
    const int result = deflate(&stream, Z_FINISH);
    piece.resize(stream.total_out);
    deflateEnd(&stream);
    contract_pre(result == Z_STREAM_END);
    return piece;
}

GzipText gunzip_pieces(std::string_view bytes, std::size_t most_bytes) {
    GzipText read;
    while (!bytes.empty() && read.whole && !read.huge) {
        z_stream stream{};
        if (inflateInit2(&stream, kGzip) != Z_OK) throw std::bad_alloc();
        stream.next_in = bytes_of(bytes);
        stream.avail_in = static_cast<uInt>(std::min<std::size_t>(bytes.size(), std::numeric_limits<uInt>::max()));
        const uInt given = stream.avail_in;
        int result = Z_OK;
        std::array<char, 1 << 15> part;
        while (result == Z_OK && !read.huge) {
            stream.next_out = bytes_of({part.data(), part.size()});
            stream.avail_out = part.size();
            result = inflate(&stream, Z_NO_FLUSH);
            read.text.append(part.data(), part.size() - stream.avail_out);
            read.huge = read.text.size() > most_bytes;
            // Stops, because the input is cut off.
            if (result == Z_OK && stream.avail_in == 0 && stream.avail_out != 0) break;
        }
        read.whole = result == Z_STREAM_END;
        bytes.remove_prefix(given - stream.avail_in);
        inflateEnd(&stream);
    }
    if (read.huge) read.text.resize(most_bytes);
    return read;
}

}  // namespace handrail::record
