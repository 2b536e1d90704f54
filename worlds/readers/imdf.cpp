// Registers the reader for venues in the Indoor Mapping Data Format. worlds/imdf does the reading.
#include "worlds/imdf/read_imdf.h"
#include "worlds/readers/reader.h"
#include "worlds/readers/spoken_text.h"

namespace handrail::readers {

Result<Scene> read_imdf(std::string_view bytes, const std::string& file_name, const ReadOptions& options) {
    return imdf::read_imdf_venue(
        bytes, file_name,
        {options.building,
         {words_of_name(file_name.substr(0, file_name.find(".imdf"))), options.progress, options.stop}});
}

}  // namespace handrail::readers
