// Text in pieces of gzip, one behind the other in one file: each is whole by itself, so what was written is never lost
// by how the rest ends, and the whole file is what `zcat` reads. Any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace handrail {

// One piece. Of nothing: nothing. Throws std::bad_alloc where memory does not suffice.
std::string gzip_piece(std::string_view text);

struct GzipText {
    std::string text;   // as much as could be read
    bool whole = true;  // false: the file is cut off or damaged behind it
    bool huge = false;  // more than the most one wants to have: cut there
};
// All pieces. Never fails: what is no gzip at all is an empty text that is not whole.
GzipText gunzip_pieces(std::string_view bytes, std::size_t most_bytes);

}  // namespace handrail
