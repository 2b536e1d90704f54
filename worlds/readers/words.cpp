// Registers the reader for room descriptions. worlds/words does the reading.
#include "worlds/readers/reader.h"
#include "worlds/readers/spoken_text.h"
#include "worlds/words/read_words.h"

namespace handrail::readers {

Result<Scene> read_words(std::string_view bytes, const std::string& file_name, const ReadOptions& options) {
    return words::read_words_building(bytes, file_name, {words_of_name(file_name), options.progress, options.stop});
}

}  // namespace handrail::readers
