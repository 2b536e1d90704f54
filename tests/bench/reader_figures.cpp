// Measures the cost of reading worlds. It generates files of every format and reads each as the program does: a .map
// directly, all others by handrail-reader with its limits. It prints rows of a table with wall-clock time, processor
// time and peak memory, as the kernel counts them:
//   build/release/bin/reader_figures [MB...]      (1 10 100)
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "app/import/reader_process.h"
#include "app/import/toml_apart.h"
#include "tests/support/block_mesh.h"
#include "tests/support/names.h"
#include "tests/support/office_ifc.h"
#include "tests/support/office_world.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/zip_text.h"
#include "worlds/base/clock.h"
#include "worlds/stored/stored_scene.h"

namespace {

using namespace handrail;

// Returns a table of 92 triangles, one of a square field of tables that are 2 m apart.
test::BlockMesh table_at(int number, int all) {
    static const std::set<test::Block> blocks{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 1},
                                              {1, 0, 1}, {2, 0, 1}, {0, 1, 1}, {1, 1, 1}, {2, 1, 1},
                                              {0, 2, 1}, {1, 2, 1}, {2, 2, 1}};
    const int side = std::max(1, static_cast<int>(std::ceil(std::sqrt(all))));
    const Vec3 at(2.0 * (number % side), 2.0 * (number / side), 0.0);
    return test::block_mesh(blocks, [&](const Vec3& p) { return at + p * Vec3(0.4, 0.3, 0.37); });
}

template <class Value>
void append(std::string& bytes, Value value) {
    char raw[sizeof(Value)];
    std::memcpy(raw, &value, sizeof(Value));
    bytes.append(raw, sizeof(Value));
}
void append(std::string& bytes, const Vec3& point) {
    for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(point[axis]));
}

std::string map_of(int brushes) { return test::office_world(test::office_size(brushes)).map; }

std::string ifc_of(int rooms) {
    // Number of corridors, which are on five storeys and have rooms on both sides.
    const int corridors = std::max(1, (rooms + 199) / 200);
    return test::office_ifc({5, corridors, std::max(1, rooms / (10 * corridors)), 240}).text;
}

// Returns a building as OSM text. The building has rooms of 6 by 5 m in rows of 40 along corridors, 600 on each level,
// each with a door.
std::string osm_of(int rooms) {
    std::string nodes, ways;
    long id = 0;
    const auto node = [&](double x_m, double y_m, const char* tags) {
        nodes += fmt::format("<node id='{}' lat='{:.8f}' lon='{:.8f}'>{}</node>\n", ++id, 51.0 + y_m / 111'320.0,
                             13.0 + x_m / 70'060.0, tags);
        return id;
    };
    const auto space = [&](const std::vector<long>& refs, const std::string& tags) {
        ways += fmt::format("<way id='{}'>", ++id);
        for (const long ref : refs) ways += fmt::format("<nd ref='{}'/>", ref);
        ways += fmt::format("<nd ref='{}'/>{}</way>\n", refs.front(), tags);
    };
    for (int r = 0; r < rooms; r += 40) {
        const int level = r / 600, row = r % 600 / 40, here = std::min(40, rooms - r);
        const double y = 7.0 * row;
        std::vector<long> south;
        for (int i = 0; i < here; ++i) {
            const double x = 6.0 * i;
            const long door = node(x + 3.0, y + 5.0, "<tag k='door' v='hinged'/>");
            space({node(x, y, ""), node(x + 6.0, y, ""), node(x + 6.0, y + 5.0, ""), door, node(x, y + 5.0, "")},
                  fmt::format("<tag k='indoor' v='room'/><tag k='level' v='{}'/><tag k='name' v='Room {}'/>", level,
                              r + i));
            south.push_back(door);
        }
        std::vector<long> corridor{node(0.0, y + 5.0, "")};
        corridor.insert(corridor.end(), south.begin(), south.end());
        for (const Vec2& p : {Vec2(6.0 * here, y + 5.0), Vec2(6.0 * here, y + 7.0), Vec2(0.0, y + 7.0)})
            corridor.push_back(node(p.x, p.y, ""));
        space(corridor, fmt::format("<tag k='indoor' v='corridor'/><tag k='level' v='{}'/>", level));
    }
    return "<osm version='0.6'>\n" + nodes + ways + "</osm>\n";
}

std::string imdf_of(int rooms) {
    std::string units, levels, openings;
    const auto ring = [](double x, double y, double wide, double deep) {
        std::string text;
        for (const Vec2& p : {Vec2(x, y), Vec2(x + wide, y), Vec2(x + wide, y + deep), Vec2(x, y + deep), Vec2(x, y)})
            text += fmt::format("{}[{:.9f},{:.9f}]", text.empty() ? "" : ",", 13.0 + p.x / 70'060.0,
                                51.0 + p.y / 111'320.0);
        return "{\"type\":\"Polygon\",\"coordinates\":[[" + text + "]]}";
    };
    const auto add = [](std::string& list, const std::string& one) { list += (list.empty() ? "" : ",") + one; };
    for (int r = 0; r < rooms; r += 40) {
        const int level = r / 600, row = r % 600 / 40, here = std::min(40, rooms - r);
        const double y = 7.0 * row;
        if (r % 600 == 0)
            add(levels,
                fmt::format("{{\"type\":\"Feature\",\"id\":\"l{0}\",\"geometry\":null,\"properties\":{{\"ordinal\""
                            ":{0},\"name\":{{\"en\":\"Level {0}\"}}}}}}",
                            level));
        for (int i = 0; i < here; ++i) {
            add(units,
                fmt::format("{{\"type\":\"Feature\",\"id\":\"u{0}\",\"geometry\":{1},\"properties\":{{\"level_id\":"
                            "\"l{2}\",\"category\":\"office\",\"name\":{{\"en\":\"Room {0}\"}}}}}}",
                            r + i, ring(6.0 * i, y, 6.0, 5.0), level));
            add(openings,
                fmt::format(
                    "{{\"type\":\"Feature\",\"id\":\"o{0}\",\"geometry\":{{\"type\":\"LineString\",\"coordinates\":"
                    "[[{1:.9f},{3:.9f}],[{2:.9f},{3:.9f}]]}},\"properties\":{{\"level_id\":\"l{4}\",\"category\":"
                    "\"pedestrian\",\"door\":{{\"type\":\"door\"}}}}}}",
                    r + i, 13.0 + (6.0 * i + 2.5) / 70'060.0, 13.0 + (6.0 * i + 3.5) / 70'060.0,
                    51.0 + (y + 5.0) / 111'320.0, level));
        }
        add(units, fmt::format("{{\"type\":\"Feature\",\"id\":\"c{0}\",\"geometry\":{1},\"properties\":{{\"level_id\":"
                               "\"l{2}\",\"category\":\"walkway\"}}}}",
                               r, ring(0.0, y + 5.0, 6.0 * here, 2.0), level));
    }
    const auto list = [](const std::string& features) {
        return "{\"type\":\"FeatureCollection\",\"features\":[" + features + "]}";
    };
    return test::zipped({{"manifest.json", "{\"version\":\"1.0.0\"}"},
                         {"level.geojson", list(levels)},
                         {"unit.geojson", list(units)},
                         {"opening.geojson", list(openings)}});
}

std::string obj_of(int tables) {
    std::string text;
    std::size_t points = 0;
    for (int i = 0; i < tables; ++i) text += table_at(i, tables).obj(fmt::format("table_{}", i), points);
    return text;
}

std::string stl_of(int tables) {
    std::string body;
    std::uint32_t all = 0;
    for (int i = 0; i < tables; ++i) {
        const test::BlockMesh mesh = table_at(i, tables);
        for (const auto& triangle : mesh.triangles) {
            append(body, Vec3(0.0));
            for (const std::uint32_t corner : triangle) append(body, mesh.points_m[corner]);
            body.append(2, '\0');
            ++all;
        }
    }
    std::string head(80, ' ');
    append(head, all);
    return head + body;
}

std::string ply_of(int tables) {
    std::string points, faces;
    std::uint32_t count = 0, all = 0;
    for (int i = 0; i < tables; ++i) {
        const test::BlockMesh mesh = table_at(i, tables);
        for (const auto& triangle : mesh.triangles) {
            faces += '\3';
            for (const std::uint32_t corner : triangle) append(faces, static_cast<std::int32_t>(count + corner));
            ++all;
        }
        for (const Vec3& p : mesh.points_m) append(points, p);
        count += static_cast<std::uint32_t>(mesh.points_m.size());
    }
    return fmt::format(
               "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
               "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
               count, all) +
           points + faces;
}

// Returns a glTF file with one node for each table; y is up.
std::string glb_of(int tables) {
    std::string bytes, views, accessors, meshes, nodes, roots;
    for (int i = 0; i < tables; ++i) {
        const test::BlockMesh mesh = table_at(i, tables);
        const char* comma = i > 0 ? "," : "";
        const std::size_t from = bytes.size();
        for (const Vec3& p : mesh.points_m) append(bytes, Vec3(p.x, p.z, -p.y));
        const std::size_t middle = bytes.size();
        for (const auto& triangle : mesh.triangles)
            for (const std::uint32_t corner : triangle) append(bytes, corner);
        views += fmt::format(
            "{}{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}}},{{\"buffer\":0,\"byteOffset\":{},"
            "\"byteLength\":{}}}",
            comma, from, middle - from, middle, bytes.size() - middle);
        accessors += fmt::format(
            "{}{{\"bufferView\":{},\"componentType\":5126,\"count\":{},\"type\":\"VEC3\"}},"
            "{{\"bufferView\":{},\"componentType\":5125,\"count\":{},\"type\":\"SCALAR\"}}",
            comma, 2 * i, mesh.points_m.size(), 2 * i + 1, 3 * mesh.triangles.size());
        meshes += fmt::format("{}{{\"primitives\":[{{\"attributes\":{{\"POSITION\":{}}},\"indices\":{}}}]}}", comma,
                              2 * i, 2 * i + 1);
        nodes += fmt::format("{}{{\"name\":\"table {}\",\"mesh\":{}}}", comma, i, i);
        roots += fmt::format("{}{}", comma, i);
    }
    std::string json = "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[" + roots +
                       "]}],\"nodes\":[" + nodes + "],\"meshes\":[" + meshes + "],\"accessors\":[" + accessors +
                       "],\"bufferViews\":[" + views +
                       fmt::format("],\"buffers\":[{{\"byteLength\":{}}}]}}", bytes.size());
    while (json.size() % 4 != 0) json += ' ';
    std::string glb = "glTF";
    append(glb, std::uint32_t{2});
    append(glb, static_cast<std::uint32_t>(28 + json.size() + bytes.size()));
    append(glb, static_cast<std::uint32_t>(json.size()));
    glb += "JSON" + json;
    append(glb, static_cast<std::uint32_t>(bytes.size()));
    return glb + std::string("BIN\0", 4) + bytes;
}

std::string words_of(int rooms) {
    std::string text =
        "Building: Office.\nWalls: 0.2 metres thick.\n\nRoom 1, 6 by 5 metres. Door outside in the south "
        "wall. Start in the middle.\n";
    for (int i = 2; i <= rooms; ++i)
        text += fmt::format(
            "\nRoom {0}, 6 by 5 metres, {1} of Room {2}. Door to Room {2}. Table in the north-east "
            "corner.\n",
            i,
            i % 40 == 1    ? "north"
            : (i / 40) % 2 ? "west"
                           : "east",
            i - 1);
    return text;
}

struct Format {
    const char* name;
    const char* ending;
    std::string (*made)(int size);
    int first;  // size parameter of the first sample
};
constexpr Format kFormats[] = {
    {"map", ".map", map_of, 2'000},        {"ifc", ".ifc", ifc_of, 400}, {"osm", ".osm", osm_of, 1'200},
    {"imdf", ".imdf.zip", imdf_of, 1'200}, {"glb", ".glb", glb_of, 100}, {"obj", ".obj", obj_of, 100},
    {"ply", ".ply", ply_of, 100},          {"stl", ".stl", stl_of, 100}, {"words", ".rooms", words_of, 400},
};

struct Figures {
    double clock_s = 0.0, cpu_s = 0.0, memory_mb = 0.0;
    char became[200] = {};
};

// Runs `work` in a separate process, so that the kernel counts only this work. Returns false if the process ended
// early.
template <class Work>
bool apart(const Work& work) {
    std::fflush(nullptr);
    const pid_t process = ::fork();
    if (process == 0) {
        work();
        std::fflush(nullptr);
        ::_exit(0);
    }
    int status = 0;
    return process > 0 && ::waitpid(process, &status, 0) == process && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void read_and_report(const std::filesystem::path& path, bool as_map, int fd) {
    Figures figures;
    const SteadyClock clock;
    const double before_s = clock.now_s();
    Result<Scene> scene = fail("");
    if (as_map) scene = read_world(path);
    else if (Result<ReadApart> read = read_apart(path, {}, find_reader_program()); read) {
        figures.clock_s = clock.now_s() - before_s;
        scene = scene_from(read->scene);
    } else {
        scene = tl::unexpected(read.error());
    }
    if (figures.clock_s == 0.0) figures.clock_s = clock.now_s() - before_s;
    rusage used{};
    ::getrusage(as_map ? RUSAGE_SELF : RUSAGE_CHILDREN, &used);
    figures.cpu_s = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                    1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    figures.memory_mb = 1.024e-3 * static_cast<double>(used.ru_maxrss);
    const std::string became = scene ? fmt::format("{} solids, {} triangles, {} features", scene->solids.size(),
                                                   scene->triangles.size(), scene->features.size())
                                     : scene.error().sentence();
    std::snprintf(figures.became, sizeof figures.became, "%s", became.c_str());
    if (::write(fd, &figures, sizeof figures) != sizeof figures) ::_exit(1);
}

// Returns the size parameter that gives a file of about `bytes` bytes.
int size_for(const Format& format, double bytes) {
    const double sample = static_cast<double>(format.made(format.first).size());
    return std::max(1, static_cast<int>(std::lround(format.first * bytes / sample)));
}

// Measures reading a side file with this many marks. Prints the median of several first reads, and the time of reading
// it again.
void print_toml_figures(int marks) {
    std::string text;
    for (int i = 0; i < marks; ++i)
        text += fmt::format("[[mark]]\nname = \"Mark {}\"\nplace_m = [{}.5, 2.25, 0.0]\nnear_m = 1.5\n\n", i, i);
    const SteadyClock clock;
    std::vector<double> first_ms, again_ms;
    for (int i = 0; i < 21; ++i) {
        const TomlApart toml(find_reader_program());
        for (std::vector<double>* ms : {&first_ms, &again_ms}) {
            const double before_s = clock.now_s();
            if (!toml(text)) std::abort();
            ms->push_back(1e3 * (clock.now_s() - before_s));
        }
    }
    for (std::vector<double>* ms : {&first_ms, &again_ms}) std::sort(ms->begin(), ms->end());
    std::printf("| %d marks, %.1f KB | %.1f ms | %.2f ms |\n", marks, 1e-3 * static_cast<double>(text.size()),
                first_ms[first_ms.size() / 2], again_ms[again_ms.size() / 2]);
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<double> sizes_mb;
    for (int i = 1; i < argc; ++i) sizes_mb.push_back(std::atof(argv[i]));
    if (sizes_mb.empty()) sizes_mb = {1.0, 10.0, 100.0};
    if (find_reader_program().empty()) {
        std::fputs("reader_figures: handrail-reader is not beside this program\n", stderr);
        return 1;
    }
    const test::TemporaryFolder folder;
    std::printf("| Format | MB | read, on the clock | processor | memory | became |\n|---|---|---|---|---|---|\n");
    for (const Format& format : kFormats)
        for (const double mb : sizes_mb) {
            const std::filesystem::path path = folder.path() / (std::string("figures") + format.ending);
            std::array<int, 2> ends{-1, -1};
            if (!apart([&] { folder.write(path.filename(), format.made(size_for(format, 1e6 * mb))); }) ||
                ::pipe(ends.data()) != 0)
                return 1;
            const bool whole = apart([&] { read_and_report(path, std::strcmp(format.name, "map") == 0, ends[1]); });
            ::close(ends[1]);
            Figures figures;
            const bool reported = ::read(ends[0], &figures, sizeof figures) == sizeof figures;
            ::close(ends[0]);
            if (!whole || !reported) {
                std::fprintf(stderr, "reader_figures: reading %s of %.1f MB broke down\n", format.name, mb);
                return 1;
            }
            std::printf("| %s | %.1f | %.2f s | %.2f s | %.0f MB | %s |\n", format.name,
                        1e-6 * static_cast<double>(std::filesystem::file_size(path)), figures.clock_s, figures.cpu_s,
                        figures.memory_mb, figures.became);
            std::fflush(stdout);
            std::filesystem::remove(path);
        }
    std::printf("\n| Side file | read the first time | again |\n|---|---|---|\n");
    for (const int marks : {10, 1000, 10'000}) print_toml_figures(marks);
    return 0;
}
