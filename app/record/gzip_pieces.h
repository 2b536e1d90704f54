// Writes text as a series of gzip pieces in one file. Each piece is complete, so a file whose end is cut off loses only
// the cut piece. `zcat` reads the whole file. Any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace handrail::record {

// Compresses one piece; an empty text gives an empty result. Throws std::bad_alloc if memory does not suffice.
std::string gzip_piece(std::string_view text);

struct GzipText {
    std::string text;   // the text that could be read
    bool whole = true;  // false: the file is cut off or damaged after `text`
    bool huge = false;  // the text was cut at `most_bytes`
};
// Unpacks all pieces. Never fails: if the bytes are not gzip at all, the text is empty and not whole.
GzipText gunzip_pieces(std::string_view bytes, std::size_t most_bytes);

}  // namespace handrail::record
