// Writes text as a series of gzip pieces in one file. Each piece is complete, so a file whose end is cut off loses only
// the cut piece. `zcat` reads the whole file. Any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace handrail::record {

// Compresses one piece. Returns an empty text if `text` is empty. Throws std::bad_alloc if there is not enough memory.
std::string gzip_piece(std::string_view text);

struct GzipText {
    std::string text;   // the text that could be read
    bool whole = true;  // false: the file is cut off or damaged after `text`
    bool huge = false;  // true: `text` was cut off at `most_bytes`
};
// Unpacks all pieces. Never fails: if the bytes are not gzip at all, `text` is empty and `whole` is false.
GzipText gunzip_pieces(std::string_view bytes, std::size_t most_bytes);

}  // namespace handrail::record
