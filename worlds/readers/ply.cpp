// Reads PLY, as text and in binary of both byte orders. It reads points and faces with z up, without unit or names.
// Other elements and properties are ignored.
#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

#include "worlds/base/text.h"
#include "worlds/readers/map_keys.h"
#include "worlds/readers/mesh_scene.h"

namespace handrail::readers {
namespace {

struct PlyType {
    std::string_view name, other_name;
    std::size_t bytes;
    bool is_float, is_signed;
};
constexpr std::array kTypes{
    PlyType{"char", "int8", 1, false, true},    PlyType{"uchar", "uint8", 1, false, false},
    PlyType{"short", "int16", 2, false, true},  PlyType{"ushort", "uint16", 2, false, false},
    PlyType{"int", "int32", 4, false, true},    PlyType{"uint", "uint32", 4, false, false},
    PlyType{"float", "float32", 4, true, true}, PlyType{"double", "float64", 8, true, true},
};
const PlyType* type_named(std::string_view name) {
    for (const PlyType& type : kTypes)
        if (type.name == name || type.other_name == name) return &type;
    return nullptr;
}

struct PlyProperty {
    std::string name;
    const PlyType* type = nullptr;
    const PlyType* count = nullptr;  // for a list: the type of the number that states its length
};
struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return words;
}

class PlyReader {
public:
    PlyReader(std::string_view bytes, const std::string& file_name, const ReadOptions& options)
        : bytes_(bytes), file_name_(file_name), options_(options) {}

    Result<Scene> read() {
        if (auto head = read_head(); !head) return tl::unexpected(head.error());
        MeshFile file{"ply", options_.obj_metres_per_unit, {}, 0, 0};
        MeshPart part;
        for (const PlyElement& element : elements_)
            if (auto body = read_element(element, part, file); !body) return tl::unexpected(body.error());
        file.parts.push_back(std::move(part));
        return scene_of_meshes(std::move(file), Diagnostics(file_name_), file_name_, options_);
    }

private:
    enum class Form : std::uint8_t { Words, Little, Big };

    tl::unexpected<Error> bad_head() const { return fail(phrase("mesh.ply_head"), file_name_, line_); }
    tl::unexpected<Error> cut_short() const { return fail(phrase("mesh.cut_short"), file_name_, line_); }

    std::optional<std::string_view> next_line() {
        if (at_ >= bytes_.size()) return std::nullopt;
        const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
        const std::string_view line = bytes_.substr(at_, end - at_);
        at_ = std::min(end + 1, bytes_.size());
        ++line_;
        return trimmed(line);
    }

    Result<void> read_head() {
        bool has_form = false;
        for (;;) {
            const auto line = next_line();
            if (!line || line_ > 1000) return bad_head();
            const std::vector<std::string_view> words = words_of(*line);
            if (words.empty() || words[0] == "comment" || words[0] == "obj_info" || (line_ == 1 && words[0] == "ply"))
                continue;
            if (words[0] == "end_header") break;
            if (words[0] == "format" && words.size() >= 2) {
                has_form = words[1] == "ascii" || words[1] == "binary_little_endian" || words[1] == "binary_big_endian";
                form_ = words[1] == "ascii" ? Form::Words : words[1] == "binary_big_endian" ? Form::Big : Form::Little;
            } else if (words[0] == "element" && words.size() == 3) {
                double count = 0.0;
                if (!parse_finite(words[2], count) || count < 0.0 || count > 1e9) return bad_head();
                elements_.push_back({std::string(words[1]), static_cast<std::size_t>(count), {}});
            } else if (words[0] == "property" && !elements_.empty() && words.size() == 3) {
                elements_.back().properties.push_back({std::string(words[2]), type_named(words[1]), nullptr});
                if (!elements_.back().properties.back().type) return bad_head();
            } else if (words[0] == "property" && !elements_.empty() && words.size() == 5 && words[1] == "list") {
                elements_.back().properties.push_back(
                    {std::string(words[4]), type_named(words[3]), type_named(words[2])});
                const PlyProperty& list = elements_.back().properties.back();
                if (!list.type || !list.count || list.count->is_float) return bad_head();
            } else {
                return bad_head();
            }
        }
        if (!has_form) return bad_head();
        return {};
    }

    // Reads one number. Empty if the file ends or no number follows.
    std::optional<double> number(const PlyType& type) {
        if (form_ == Form::Words) {
            while (at_ < bytes_.size() && static_cast<unsigned char>(bytes_[at_]) <= ' ')
                line_ += bytes_[at_++] == '\n';
            std::size_t end = at_;
            while (end < bytes_.size() && static_cast<unsigned char>(bytes_[end]) > ' ') ++end;
            double value = 0.0;
            if (!parse_finite(bytes_.substr(at_, end - at_), value)) return std::nullopt;
            at_ = end;
            return value;
        }
        if (bytes_.size() - at_ < type.bytes) return std::nullopt;
        std::array<char, 8> raw{};
        std::memcpy(raw.data(), bytes_.data() + at_, type.bytes);
        if (form_ == Form::Big) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(type.bytes));
        at_ += type.bytes;
        std::uint64_t whole = 0;
        std::memcpy(&whole, raw.data(), 8);
        if (type.is_float)
            return type.bytes == 8 ? std::bit_cast<double>(whole)
                                   : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(whole)));
        const std::size_t bits = 8 * type.bytes;
        if (type.is_signed && (whole >> (bits - 1)) & 1U)
            return static_cast<double>(whole) - static_cast<double>(std::uint64_t{1} << bits);
        return static_cast<double>(whole);
    }

    Result<void> read_element(const PlyElement& element, MeshPart& part, MeshFile& file) {
        const bool points = element.name == "vertex", faces = element.name == "face";
        // Each element must occupy at least one byte of the file, so that a large count in the header cannot fill the
        // memory.
        if (element.properties.empty() && element.count > 0) return bad_head();
        for (std::size_t i = 0; i < element.count; ++i) {
            if ((i & 0xfff) == 0 && options_.stop.stop_requested()) return fail(phrase("files.stopped"), file_name_);
            Vec3 p{0.0};
            for (const PlyProperty& property : element.properties) {
                if (property.count) {
                    if (auto list = read_list_of(property, faces, part, file); !list) return list;
                    continue;
                }
                const auto value = number(*property.type);
                if (!value) return cut_short();
                if (property.name == "x") p.x = *value;
                else if (property.name == "y") p.y = *value;
                else if (property.name == "z") p.z = *value;
            }
            if (points) part.points_m.push_back(p * options_.obj_metres_per_unit);
        }
        return {};
    }

    Result<void> read_list_of(const PlyProperty& property, bool faces, MeshPart& part, MeshFile& file) {
        const auto count = number(*property.count);
        if (!count || *count < 0.0 || *count > static_cast<double>(bytes_.size() - at_)) return cut_short();
        const bool corners = faces && (property.name == "vertex_indices" || property.name == "vertex_index");
        std::vector<std::uint32_t> face;
        for (std::size_t k = 0; k < static_cast<std::size_t>(*count); ++k) {
            const auto value = number(*property.type);
            if (!value) return cut_short();
            if (corners) face.push_back(*value >= 0.0 && *value < 4e9 ? static_cast<std::uint32_t>(*value) : kNoPoint);
        }
        if (!corners) return {};
        if (face.size() < 3) {
            ++file.faces_left_out;
            return {};
        }
        for (std::size_t k = 2; k < face.size(); ++k) part.triangles.push_back({face[0], face[k - 1], face[k]});
        if (part.triangles.size() > kMostMeshTriangles)
            return fail(phrase("mesh.too_large", {{"most", kMostMeshTriangles}}), file_name_);
        return {};
    }

    static constexpr std::uint32_t kNoPoint = 0xffffffffU;
    std::string_view bytes_;
    const std::string& file_name_;
    const ReadOptions& options_;
    Form form_ = Form::Words;
    std::vector<PlyElement> elements_;
    std::size_t at_ = 0;
    int line_ = 0;
};

}  // namespace

Result<Scene> read_ply(std::string_view bytes, const std::string& file_name, const ReadOptions& options) {
    return PlyReader(bytes, file_name, options).read();
}

}  // namespace handrail::readers
