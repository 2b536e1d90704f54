// Reads glTF 2.0, as .glb or .gltf. Coordinates are in metres with y up and are turned to z up. Nodes become things
// with their names, and their triangles are placed as the file says. Source: Khronos, glTF 2.0 specification.
// Compressed meshes, lines and points are not read.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "worlds/base/text.h"
#include "worlds/readers/mesh_scene.h"

namespace handrail::readers {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kDeepest = 64, kMostNodes = 200'000, kMostNumbers = std::size_t{1} << 31;

// Turns a point to z up: the file's y becomes up, and the file's z, which points towards the viewer, becomes south.
Vec3 to_world(const glm::dmat4& m, const Vec3& p) {
    const Vec3 at = Vec3(m[0]) * p.x + Vec3(m[1]) * p.y + Vec3(m[2]) * p.z + Vec3(m[3]);
    return {at.x, -at.z, at.y};
}

bool turns_inside_out(const glm::dmat4& m) { return glm::determinant(glm::dmat3(m)) < 0.0; }

const Json& in(const Json& object, const char* key) {
    static const Json kNone;
    if (!object.is_object()) return kNone;
    const auto found = object.find(key);
    return found == object.end() ? kNone : *found;
}

std::optional<std::size_t> whole(const Json& value) {
    if (!value.is_number_integer() || value.get<double>() < 0.0 || value.get<double>() >= 2147483648.0)
        return std::nullopt;
    return static_cast<std::size_t>(value.get<double>());
}

// Returns the entry of one of the file's lists to which `number` refers.
const Json& entry(const Json& list, const Json& number) {
    static const Json kNone;
    const auto at = whole(number);
    return list.is_array() && at && *at < list.size() ? list[*at] : kNone;
}

std::string text(const Json& value) { return value.is_string() ? value.get<std::string>() : std::string(); }

template <std::size_t N>
bool numbers(const Json& list, std::array<double, N>& into) {
    if (!list.is_array() || list.size() != N) return false;
    for (std::size_t i = 0; i < N; ++i) {
        if (!list[i].is_number()) return false;
        into[i] = list[i].get<double>();
    }
    return true;
}

glm::dmat4 placed(const std::array<double, 3>& shift, const std::array<double, 4>& turn,
                  const std::array<double, 3>& scale) {
    const auto [x, y, z, w] = turn;
    glm::dmat4 matrix = glm::scale(glm::mat4_cast(glm::dquat(w, x, y, z)), glm::make_vec3(scale.data()));
    matrix[3] = {glm::make_vec3(shift.data()), 1.0};
    return matrix;
}

glm::dmat4 placement_of(const Json& node) {
    std::array<double, 16> columns{};
    if (numbers(in(node, "matrix"), columns)) return glm::make_mat4(columns.data());
    std::array<double, 3> shift{0, 0, 0}, scale{1, 1, 1};
    std::array<double, 4> turn{0, 0, 0, 1};
    numbers(in(node, "translation"), shift);
    numbers(in(node, "scale"), scale);
    numbers(in(node, "rotation"), turn);
    return placed(shift, turn, scale);
}

// A number type of an accessor. `most` is the divisor for normalised values.
struct Component {
    unsigned type;
    std::size_t size;
    double most;
    double (*read)(const char* bytes);
};
template <class T>
double read_as(const char* bytes) {
    T value{};
    std::memcpy(&value, bytes, sizeof(T));
    return static_cast<double>(value);
}
constexpr std::array kComponents{
    Component{5120, 1, 127.0, read_as<std::int8_t>},
    Component{5121, 1, 255.0, read_as<std::uint8_t>},
    Component{5122, 2, 32767.0, read_as<std::int16_t>},
    Component{5123, 2, 65535.0, read_as<std::uint16_t>},
    Component{5126, 4, 1.0, read_as<float>},
};

// True for extensions that this reader reads and for those that change only the appearance. A file that requires any
// other extension cannot be read correctly.
bool leaves_form_alone(std::string_view extension) {
    constexpr std::array<std::string_view, 11> kBegin{"KHR_mesh_quantization",
                                                      "EXT_mesh_gpu_instancing",
                                                      "KHR_materials_",
                                                      "KHR_texture_",
                                                      "EXT_texture_",
                                                      "MSFT_texture_",
                                                      "KHR_lights_",
                                                      "EXT_lights_",
                                                      "KHR_xmp",
                                                      "KHR_animation_",
                                                      "KHR_audio"};
    return std::any_of(kBegin.begin(), kBegin.end(),
                       [&](std::string_view begin) { return extension.starts_with(begin); });
}

std::string decoded_base64(std::string_view letters) {
    std::string bytes;
    std::uint32_t held = 0;
    int bits = 0;
    for (const char c : letters) {
        const int value = c >= 'A' && c <= 'Z'   ? c - 'A'
                          : c >= 'a' && c <= 'z' ? c - 'a' + 26
                          : c >= '0' && c <= '9' ? c - '0' + 52
                          : c == '+'             ? 62
                          : c == '/'             ? 63
                                                 : -1;
        if (value < 0) continue;  // skips padding characters and line ends
        held = held << 6 | static_cast<std::uint32_t>(value);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(held >> bits & 0xff);
    }
    return bytes;
}

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, 4);
    return word;
}

class GltfReader {
public:
    GltfReader(std::string_view bytes, const std::string& file_name, const ReadOptions& options)
        : bytes_(bytes), file_name_(file_name), options_(options) {
        file_.format = "gltf";
        // The unit of glTF is the metre. A unit that the person states takes precedence.
        file_.metres_per_unit = options.unit_is_known ? options.obj_metres_per_unit : 1.0;
    }

    Result<Scene> read() {
        if (auto opened = open(); !opened) return tl::unexpected(opened.error());
        for (const Json& name : in(document_, "extensionsRequired"))
            if (text(name).find("compression") != std::string::npos)
                return fail(phrase("mesh.compressed", {{"name", excerpt(text(name), 40)}}), file_name_);
            else if (!leaves_form_alone(text(name)))
                return fail(phrase("mesh.extension", {{"name", excerpt(text(name), 40)}}), file_name_);
        if (auto buffers = read_buffers(); !buffers) return tl::unexpected(buffers.error());
        const Json first = 0;
        const Json& named = in(document_, "scene");
        const Json& scene = entry(in(document_, "scenes"), named.is_null() ? first : named);
        const glm::dmat4 unit = glm::scale(glm::dmat4(1.0), Vec3(file_.metres_per_unit));
        for (const Json& node : in(scene, "nodes")) visit(node, unit, 0);
        if (options_.stop.stop_requested()) return fail(phrase("files.stopped"), file_name_);
        if (is_too_large()) return fail(phrase("mesh.too_large", {{"most", kMostMeshTriangles}}), file_name_);
        return scene_of_meshes(std::move(file_), Diagnostics(file_name_), file_name_, options_);
    }

private:
    Result<void> open() {
        std::string_view description = bytes_;
        if (bytes_.starts_with("glTF")) {
            if (bytes_.size() < 20 || word_at(bytes_, 8) > bytes_.size())
                return fail(phrase("mesh.cut_short"), file_name_);
            const std::size_t length = word_at(bytes_, 12);
            if (length > bytes_.size() - 20) return fail(phrase("mesh.cut_short"), file_name_);
            description = bytes_.substr(20, length);
            const std::string_view rest = bytes_.substr(20 + length);
            if (rest.size() >= 8 && word_at(rest, 0) <= rest.size() - 8) binary_ = rest.substr(8, word_at(rest, 0));
        }
        document_ = Json::parse(description, nullptr, false);
        const std::string version = text(in(in(document_, "asset"), "version"));
        if (document_.is_discarded() || !version.starts_with("2")) return fail(phrase("mesh.gltf_damaged"), file_name_);
        return {};
    }

    Result<void> read_buffers() {
        for (const Json& buffer : in(document_, "buffers")) {
            const std::string uri = text(in(buffer, "uri"));
            if (uri.empty()) {
                buffers_.push_back(binary_);
                continue;
            }
            if (uri.starts_with("data:")) {
                owned_.push_back(std::make_unique<std::string>(
                    decoded_base64(std::string_view(uri).substr(std::min(uri.find(','), uri.size())))));
            } else {
                Result<std::string> beside =
                    options_.read_next_to ? options_.read_next_to(uri) : Result<std::string>(fail(std::string()));
                if (!beside) return fail(phrase("mesh.no_buffer", {{"file", excerpt(uri, 60)}}), file_name_);
                owned_.push_back(std::make_unique<std::string>(std::move(*beside)));
            }
            buffers_.push_back(*owned_.back());
        }
        return {};
    }

    // The bytes of an accessor, with `size` bytes for each element and `stride` bytes from one element to the next.
    struct Numbers {
        std::string_view bytes;
        std::size_t count = 0, stride = 0;
    };
    std::optional<Numbers> numbers_of(const Json& accessor, std::size_t size) const {
        const Json& view = entry(in(document_, "bufferViews"), in(accessor, "bufferView"));
        const auto count = whole(in(accessor, "count")), length = whole(in(view, "byteLength")),
                   buffer = whole(in(view, "buffer"));
        const std::size_t skip = whole(in(accessor, "byteOffset")).value_or(0),
                          begin = whole(in(view, "byteOffset")).value_or(0),
                          stride = whole(in(view, "byteStride")).value_or(size);
        if (!count || !length || !buffer || *buffer >= buffers_.size() || stride < size || *count > kMostNumbers ||
            in(accessor, "sparse").is_object())
            return std::nullopt;
        const std::string_view bytes = buffers_[*buffer];
        if (begin > bytes.size() || *length > bytes.size() - begin || skip > *length) return std::nullopt;
        if (*count == 0 || stride * (*count - 1) + size > *length - skip) return std::nullopt;
        return Numbers{bytes.substr(begin + skip, *length - skip), *count, stride};
    }

    // Returns rows of N numbers. The numbers may be integers of one or two bytes (KHR_mesh_quantization).
    template <std::size_t N>
    std::optional<std::vector<std::array<double, N>>> rows_of(const Json& accessor) const {
        const auto* const kind = std::find_if(kComponents.begin(), kComponents.end(), [&](const Component& c) {
            return whole(in(accessor, "componentType")) == c.type;
        });
        if (kind == kComponents.end() || text(in(accessor, "type")) != "VEC" + std::to_string(N)) return std::nullopt;
        const auto raw = numbers_of(accessor, N * kind->size);
        if (!raw) return std::nullopt;
        const bool share = in(accessor, "normalized") == true;
        std::vector<std::array<double, N>> rows(raw->count);
        for (std::size_t i = 0; i < raw->count; ++i)
            for (std::size_t k = 0; k < N; ++k) {
                const double value = kind->read(raw->bytes.data() + i * raw->stride + k * kind->size);
                rows[i][k] = share ? std::max(value / kind->most, -1.0) : value;
            }
        return rows;
    }

    std::optional<std::vector<Vec3>> points_of(const Json& accessor, const glm::dmat4& at) const {
        const auto rows = rows_of<3>(accessor);
        if (!rows) return std::nullopt;
        std::vector<Vec3> points;
        for (const auto& [x, y, z] : *rows) points.push_back(to_world(at, {x, y, z}));
        return points;
    }

    // Returns the placements of the copies of a node's mesh, relative to the node (EXT_mesh_gpu_instancing). Without
    // that extension there is one copy.
    std::optional<std::vector<glm::dmat4>> copies_of(const Json& node) const {
        const Json& attributes = in(in(in(node, "extensions"), "EXT_mesh_gpu_instancing"), "attributes");
        if (!attributes.is_object()) return std::vector<glm::dmat4>{glm::dmat4(1.0)};
        const Json& accessors = in(document_, "accessors");
        const auto stated = [&](const char* key) { return !in(attributes, key).is_null(); };
        const auto shifts = rows_of<3>(entry(accessors, in(attributes, "TRANSLATION"))),
                   scales = rows_of<3>(entry(accessors, in(attributes, "SCALE")));
        const auto turns = rows_of<4>(entry(accessors, in(attributes, "ROTATION")));
        if ((stated("TRANSLATION") && !shifts) || (stated("SCALE") && !scales) || (stated("ROTATION") && !turns))
            return std::nullopt;
        const std::size_t count = shifts ? shifts->size() : scales ? scales->size() : turns ? turns->size() : 0;
        if (count > kMostNodes || (scales && scales->size() != count) || (turns && turns->size() != count))
            return std::nullopt;
        std::vector<glm::dmat4> copies;
        for (std::size_t i = 0; i < count; ++i)
            copies.push_back(placed(shifts ? (*shifts)[i] : std::array{0.0, 0.0, 0.0},
                                    turns ? (*turns)[i] : std::array{0.0, 0.0, 0.0, 1.0},
                                    scales ? (*scales)[i] : std::array{1.0, 1.0, 1.0}));
        return copies;
    }

    // Returns the corners of all triangles, three for each. If the file gives no indices, the corners are all points in
    // order.
    std::optional<std::vector<std::uint32_t>> corners_of(const Json& number, std::size_t points) const {
        std::vector<std::uint32_t> corners;
        if (number.is_null()) {
            for (std::uint32_t i = 0; i < points; ++i) corners.push_back(i);
            return corners;
        }
        const Json& accessor = entry(in(document_, "accessors"), number);
        const auto kind = whole(in(accessor, "componentType"));
        const std::size_t size = kind == 5121U ? 1 : kind == 5123U ? 2 : kind == 5125U ? 4 : 0;
        if (size == 0) return std::nullopt;
        const auto raw = numbers_of(accessor, size);
        if (!raw) return std::nullopt;
        for (std::size_t i = 0; i < raw->count; ++i) {
            std::uint32_t corner = 0;
            std::memcpy(&corner, raw->bytes.data() + i * raw->stride, size);
            corners.push_back(corner);
        }
        return corners;
    }

    bool is_too_large() const {
        return nodes_ > kMostNodes || triangles_ > kMostMeshTriangles || points_ > 4 * kMostMeshTriangles;
    }

    void add(const Json& primitive, std::size_t thing, const std::string& name, const glm::dmat4& at) {
        const std::size_t mode = whole(in(primitive, "mode")).value_or(4);
        auto points = points_of(entry(in(document_, "accessors"), in(in(primitive, "attributes"), "POSITION")), at);
        if (points) points_ += points->size();
        const auto corners = points ? corners_of(in(primitive, "indices"), points->size()) : std::nullopt;
        if (!corners || mode < 4 || mode > 6) {
            ++file_.parts_left_out;
            return;
        }
        MeshPart part;
        part.thing = static_cast<std::uint32_t>(thing);
        part.name = name;
        part.material = text(in(entry(in(document_, "materials"), in(primitive, "material")), "name"));
        const bool turned = turns_inside_out(at);
        const auto put = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            part.triangles.push_back(turned ? std::array{a, c, b} : std::array{a, b, c});
        };
        const std::vector<std::uint32_t>& c = *corners;
        if (mode == 4)
            for (std::size_t i = 2; i < c.size(); i += 3) put(c[i - 2], c[i - 1], c[i]);
        for (std::size_t i = 2; mode != 4 && i < c.size(); ++i)
            if (mode == 6) put(c[0], c[i - 1], c[i]);
            else i % 2 == 0 ? put(c[i - 2], c[i - 1], c[i]) : put(c[i - 1], c[i - 2], c[i]);
        triangles_ += part.triangles.size();
        part.points_m = std::move(*points);
        file_.parts.push_back(std::move(part));
    }

    void visit(const Json& number, const glm::dmat4& above, std::size_t depth) {
        const Json& node = entry(in(document_, "nodes"), number);
        if (is_too_large() || options_.stop.stop_requested()) return;
        ++nodes_;
        if (!node.is_object() || depth > kDeepest) return;
        const glm::dmat4 at = above * placement_of(node);
        const Json& mesh = entry(in(document_, "meshes"), in(node, "mesh"));
        const std::string name = text(in(node, "name"));
        const auto copies = copies_of(node);
        if (!copies) ++file_.parts_left_out;
        for (const glm::dmat4& copy : copies.value_or(std::vector<glm::dmat4>{})) {
            const std::size_t thing = nodes_;
            for (const Json& primitive : in(mesh, "primitives")) {
                if (is_too_large() || options_.stop.stop_requested()) return;
                ++nodes_;
                add(primitive, thing, name.empty() ? text(in(mesh, "name")) : name, at * copy);
            }
        }
        for (const Json& child : in(node, "children")) {
            if (is_too_large()) return;
            visit(child, at, depth + 1);
        }
    }

    std::string_view bytes_;
    const std::string& file_name_;
    const ReadOptions& options_;
    Json document_;
    std::string_view binary_;
    std::vector<std::unique_ptr<std::string>> owned_;
    std::vector<std::string_view> buffers_;
    MeshFile file_;
    std::size_t nodes_ = 0, triangles_ = 0, points_ = 0;
};

}  // namespace

Result<Scene> read_gltf(std::string_view bytes, const std::string& file_name, const ReadOptions& options) {
    return GltfReader(bytes, file_name, options).read();
}

}  // namespace handrail::readers
