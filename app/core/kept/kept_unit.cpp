#include "app/core/kept/kept_unit.h"

namespace handrail::core {
namespace {

constexpr const char* kTable = "unit";
constexpr const char* kMetres = "metres";

}  // namespace

std::optional<double> kept_unit(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                bool shipped, const settings::TomlReader& toml) {
    const double metres = number_of(SideFile::peek(world, data_folder, shipped, kTable, toml), kMetres, 0.0);
    if (!(metres > 0.0)) return std::nullopt;
    return metres;
}

void keep_unit(SideFile& file, double metres) {
    SideEntry table = file.table(kTable);
    table[kMetres] = metres;
    file.set_table(kTable, table);
}

}  // namespace handrail::core
