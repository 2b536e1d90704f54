// Buildings as architects' programs write them (worlds/ifc), as a row of the table of readers.
#include "worlds/ifc/read_ifc.h"
#include "worlds/readers/reader.h"
#include "worlds/readers/spoken_text.h"

namespace handrail {

Result<Scene> read_ifc(std::string_view bytes, const std::string& file_name, const ReadOptions& options) {
    return read_ifc_building(bytes, file_name,
                             {words_of_name(file_name), options.guess_materials, options.progress, options.stop});
}

}  // namespace handrail
