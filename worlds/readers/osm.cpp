// Registers the reader for buildings from OpenStreetMap. worlds/osm does the reading.
#include "worlds/osm/read_osm.h"
#include "worlds/readers/reader.h"
#include "worlds/readers/spoken_text.h"

namespace handrail::readers {

Result<Scene> read_osm(std::string_view bytes, const std::string& file_name, const ReadOptions& options) {
    const osm::OsmForm form = osm::osm_form(bytes, file_name);
    return osm::read_osm_building(
        bytes, form == osm::OsmForm::None ? osm::OsmForm::Xml : form, file_name,
        {options.building,
         {words_of_name(file_name.substr(0, file_name.find(".osm"))), options.progress, options.stop}});
}

}  // namespace handrail::readers
