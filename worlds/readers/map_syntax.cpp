#include "worlds/readers/map_syntax.h"

#include <algorithm>
#include <span>

#include "worlds/base/text.h"
#include "worlds/readers/map_keys.h"

namespace handrail::readers {
namespace {

bool is_blank(char c) { return static_cast<unsigned char>(c) <= ' '; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

constexpr std::string_view kPunctuation = "{}()[]";

// True for each byte that ends a word. It is a lookup table for speed, because a line may be a hundred megabytes long.
constexpr std::array<bool, 256> kEndsWord = [] {
    std::array<bool, 256> ends{};
    for (std::size_t c = 0; c <= ' '; ++c) ends[c] = true;
    for (const char c : kPunctuation) ends[static_cast<unsigned char>(c)] = true;
    ends[static_cast<unsigned char>('"')] = true;
    return ends;
}();

enum class TokenKind { End, Punctuation, Quoted, Word };

struct Token {
    TokenKind kind = TokenKind::End;
    std::string_view text;
    TextPlace place;

    bool is(char c) const { return kind == TokenKind::Punctuation && text.front() == c; }
};

class Lexer {
public:
    Lexer(std::string_view bytes, Diagnostics& diagnostics) : bytes_(bytes), diagnostics_(diagnostics) {
        if (bytes_.starts_with("\xEF\xBB\xBF")) at_ = 3;
        line_start_ = at_;
    }

    const Token& peek() {
        if (!peeked_) {
            token_ = lex();
            peeked_ = true;
        }
        return token_;
    }
    Token take() {
        peek();
        peeked_ = false;
        return token_;
    }

    // Reads an unquoted texture name. The name extends to the next white space, whatever it contains. Do not call this
    // after peek().
    Token take_texture() {
        while (at_ < bytes_.size() && is_blank(bytes_[at_])) step();
        Token token{TokenKind::Word, {}, here()};
        if (at_ >= bytes_.size()) return {TokenKind::End, {}, here()};
        if (bytes_[at_] == '"') return quoted();
        const std::size_t begin = at_;
        while (at_ < bytes_.size() && !is_blank(bytes_[at_])) ++at_;
        token.text = bytes_.substr(begin, at_ - begin);
        return token;
    }

    // Skips the rest of a damaged face: up to the end of the line, or to a closing brace that stands alone.
    void skip_damaged_line() {
        if (peeked_) rewind_to_token();
        while (at_ < bytes_.size() && !is_line_end(bytes_[at_])) {
            if (bytes_[at_] == '}' && stands_alone()) return;
            ++at_;
        }
    }

    // Skips the rest of a block after its opening brace. Only braces that stand alone are matched, because texture
    // names may begin with a brace.
    void skip_block() {
        if (peeked_) rewind_to_token();
        for (int depth = 1; at_ < bytes_.size(); step()) {
            const char c = bytes_[at_];
            if (c == '/' && at_ + 1 < bytes_.size() && bytes_[at_ + 1] == '/') {
                while (at_ + 1 < bytes_.size() && !is_line_end(bytes_[at_ + 1])) ++at_;
            } else if ((c == '{' || c == '}') && stands_alone()) {
                depth += c == '{' ? 1 : -1;
                if (depth == 0) {
                    ++at_;
                    return;
                }
            }
        }
    }

private:
    TextPlace here() const { return {line_, static_cast<int>(at_ - line_start_) + 1}; }

    // Advances by one byte and counts lines. A line ends with LF, CR LF or a lone CR.
    void step() {
        const char c = bytes_[at_++];
        if (c == '\n' || (c == '\r' && (at_ >= bytes_.size() || bytes_[at_] != '\n'))) {
            ++line_;
            line_start_ = at_;
        }
    }

    bool stands_alone() const {
        const auto separates = [](char c) {
            return is_blank(c) || c == '{' || c == '}' || c == '(' || c == ')' || c == '"';
        };
        return (at_ == 0 || separates(bytes_[at_ - 1])) && (at_ + 1 >= bytes_.size() || separates(bytes_[at_ + 1]));
    }

    // Puts back a token that was only peeked at. A token contains no line end, so the position can return to the line
    // and column of the token.
    void rewind_to_token() {
        peeked_ = false;
        if (token_.kind == TokenKind::End) return;
        at_ = static_cast<std::size_t>(token_.text.data() - bytes_.data()) - (token_.kind == TokenKind::Quoted ? 1 : 0);
    }

    void skip_blanks_and_comments() {
        while (at_ < bytes_.size()) {
            const char c = bytes_[at_];
            if (is_blank(c)) {
                step();
            } else if (c == ';' || (c == '/' && at_ + 1 < bytes_.size() && bytes_[at_ + 1] == '/')) {
                while (at_ < bytes_.size() && !is_line_end(bytes_[at_])) ++at_;
            } else {
                return;
            }
        }
    }

    Token lex() {
        skip_blanks_and_comments();
        if (at_ >= bytes_.size()) return {TokenKind::End, {}, here()};
        const char c = bytes_[at_];
        if (c == '"') return quoted();
        Token token{TokenKind::Word, {}, here()};
        const std::size_t begin = at_;
        if (kPunctuation.find(c) != std::string_view::npos) {
            token.kind = TokenKind::Punctuation;
            ++at_;
        } else {
            while (at_ < bytes_.size() && !kEndsWord[static_cast<unsigned char>(bytes_[at_])]) ++at_;
        }
        token.text = bytes_.substr(begin, at_ - begin);
        return token;
    }

    // True if the quote at `quote`, which follows a backslash, ends the string. Usually the quote belongs to the
    // string. It ends the string if white space and then a quote, a brace or the end of the line follow it, as in
    // "c:\a\".
    bool closes_after_backslash(std::size_t quote) const {
        std::size_t i = quote + 1;
        while (i < bytes_.size() && is_blank(bytes_[i]) && !is_line_end(bytes_[i])) ++i;
        if (i >= bytes_.size() || is_line_end(bytes_[i])) return true;
        return i > quote + 1 && (bytes_[i] == '"' || bytes_[i] == '{' || bytes_[i] == '}');
    }

    Token quoted() {
        Token token{TokenKind::Quoted, {}, here()};
        const std::size_t begin = ++at_;
        std::size_t end = begin;
        while (end < bytes_.size() && !is_line_end(bytes_[end])) {
            if (bytes_[end] == '"' && (end == begin || bytes_[end - 1] != '\\' || closes_after_backslash(end))) break;
            ++end;
        }
        token.text = bytes_.substr(begin, end - begin);
        at_ = end;
        if (end < bytes_.size() && bytes_[end] == '"') ++at_;
        else diagnostics_.warn(token.place, "map.then_line_end", "map.open_quote");
        return token;
    }

    std::string_view bytes_;
    Diagnostics& diagnostics_;
    std::size_t at_ = 0;
    std::size_t line_start_ = 0;
    int line_ = 1;
    bool peeked_ = false;
    Token token_;
};

class Parser {
public:
    // Greatest number of points along one side of a patch; editors stop at 31.
    static constexpr double kMostPatchPoints = 1025;
    // Greatest number of keys of one entity; real entities have under 20.
    static constexpr std::size_t kMostKeys = 1000;

    Parser(std::string_view bytes, Diagnostics& diagnostics, const std::stop_token& stop)
        : lexer_(bytes, diagnostics), diagnostics_(diagnostics), stop_(stop) {}

    MapFile parse() {
        for (;;) {
            if (stop_.stop_requested()) return std::move(file_);
            const Token token = lexer_.take();
            if (token.kind == TokenKind::End) return std::move(file_);
            if (token.is('{')) read_entity(token.place);
            else if (token.text == "Version" && is_number(lexer_.peek())) read_version();
            else if (!complained_outside_) {
                // The fault is reported only once, because a file in another format would give thousands of such
                // warnings.
                complained_outside_ = true;
                diagnostics_.error(token.place, "map.then_passed_over", "map.no_entity",
                                   {{"found", excerpt(token.text)}, {"end", is_end(token)}});
            }
        }
    }

private:
    // Returns the value of {end} for texts about {found}. The texts need this value, because the end of the file cannot
    // be shown as a word.
    static const char* is_end(const Token& token) { return token.kind == TokenKind::End ? "yes" : "no"; }

    void read_version() {
        double version = 0.0;
        parse_finite(lexer_.take().text, version);
        file_.version = static_cast<int>(std::clamp(version, 0.0, 1000.0));
    }

    // Moves an entity to its origin. From version 2 of the format on, the coordinates of an entity are relative to its
    // own origin.
    void move_to_origin(MapEntity& entity) const {
        constexpr int kFirstRelative = 2;
        std::string_view words = entity.value("origin");
        if (file_.version < kFirstRelative || entity.value("classname") == "worldspawn") return;
        Vec3 origin(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            words = trimmed(words);
            const std::size_t end = std::min(words.find(' '), words.size());
            if (!parse_finite(words.substr(0, end), origin[axis])) return;
            words.remove_prefix(end);
        }
        for (MapBrush& brush : entity.brushes)
            for (MapFace& face : brush.faces)
                for (Vec3& p : face.points_units) p += origin;
        for (MapPatch& patch : entity.patches)
            for (Vec3& p : patch.grid_units.points_m) p += origin;
    }

    void read_entity(TextPlace place) {
        MapEntity entity;
        entity.place = place;
        bool complained = false;
        while (!stop_.stop_requested()) {
            const Token token = lexer_.peek();
            if (token.is('(')) {  // Faces without a brush: the file, or this part of it, has brushes without an entity.
                if (!complained_bare_) diagnostics_.warn(token.place, "map.then_building", "map.bare_brushes");
                complained_bare_ = true;
                read_faces(entity, place);
                file_.entities.push_back(std::move(entity));
                return;
            }
            lexer_.take();
            if (token.is('}')) break;
            if (token.kind == TokenKind::End) {
                diagnostics_.error(token.place, "map.then_kept", "map.open_entity", {{"line", place.line}});
                break;
            }
            if (token.is('{')) {
                read_brush(entity, token.place);
            } else if (token.kind == TokenKind::Quoted && lexer_.peek().kind == TokenKind::Quoted) {
                add_key(entity, token, lexer_.take());
            } else if (!complained) {
                complained = true;
                if (token.kind == TokenKind::Quoted)
                    diagnostics_.warn(token.place, "map.then_key_left_out", "map.no_value",
                                      {{"key", excerpt(token.text)}});
                else
                    diagnostics_.error(token.place, "map.then_passed_over", "map.no_key",
                                       {{"found", excerpt(token.text)}, {"end", is_end(token)}});
            }
        }
        move_to_origin(entity);
        if (!entity.keys.empty() || !entity.brushes.empty() || !entity.patches.empty())
            file_.entities.push_back(std::move(entity));
    }

    void add_key(MapEntity& entity, const Token& key, const Token& value) {
        for (MapKey& known : entity.keys) {
            if (known.key != key.text) continue;
            diagnostics_.warn(key.place, "map.then_last_value", "map.key_twice", {{"key", excerpt(key.text)}});
            known = {key.text, value.text, value.place};
            return;
        }
        if (entity.keys.size() >= kMostKeys) {
            diagnostics_.warn(key.place, "map.then_left_out", "map.many_keys", {{"most", kMostKeys}});
            return;
        }
        entity.keys.push_back({key.text, value.text, value.place});
    }

    // Reads a brush after its opening brace.
    void read_brush(MapEntity& entity, TextPlace place) {
        const Token first = lexer_.peek();
        if (first.kind == TokenKind::Word) {
            const std::string form = lower_ascii(first.text.substr(0, 12));
            if (form == "patchdef2" || form == "patchdef3") return read_patch(entity, first.place);
            if (form == "brushdef" || form == "brushdef3") {
                lexer_.take();
                if (lexer_.peek().is('{')) lexer_.take();
                read_faces(entity, place, form == "brushdef" ? FaceForm::PointsAndMatrix : FaceForm::PlaneAndMatrix);
                if (lexer_.peek().is('}')) lexer_.take();
                return;
            }
            ++file_.primitives;
            diagnostics_.warn(first.place, "map.then_left_out", "map.other_form", {{"form", excerpt(first.text)}});
            lexer_.skip_block();
            return;
        }
        read_faces(entity, place);
    }

    // Reads a patch and the closing brace of its brush. The form is patchDef2 { texture ( width height ... ) ( width
    // rows of ( height points of ( x y z u v ) ) ) }.
    void read_patch(MapEntity& entity, TextPlace place) {
        lexer_.take();
        MapPatch patch;
        patch.place = place;
        int open_braces = 1;
        Token found;
        const std::string_view wrong = patch_fault(patch, open_braces, found);
        if (wrong.empty()) {
            entity.patches.push_back(std::move(patch));
        } else {
            ++file_.curves_damaged;
            diagnostics_.error(found.place, "map.then_patch_left_out", wrong,
                               {{"found", excerpt(found.text)}, {"end", is_end(found)}});
        }
        for (; open_braces > 0; --open_braces) lexer_.skip_block();
    }

    // Reads the content of a patch. If the patch is damaged, returns the key of the text about what was expected, and
    // `found` receives the token that was there instead. Returns an empty text if everything was read. `open_braces`
    // counts the braces that are still open.
    std::string_view patch_fault(MapPatch& patch, int& open_braces, Token& found) {
        const auto take = [&](char c) {
            found = lexer_.peek();
            if (!found.is(c)) return false;
            lexer_.take();
            return true;
        };
        const auto number = [&](double& value) {
            found = lexer_.peek();
            if (found.kind != TokenKind::Word || !parse_finite(found.text, value)) return false;
            lexer_.take();
            return true;
        };
        if (!take('{')) return "map.patch_brace";
        ++open_braces;
        found = lexer_.take_texture();
        if (found.kind == TokenKind::End) return "map.patch_texture";
        patch.texture = found.text;
        if (!take('(')) return "map.patch_size_open";
        std::array<double, 2> size{};
        for (double& n : size) {
            if (!number(n)) return "map.patch_size";
            if (!(n >= 3.0 && n <= kMostPatchPoints) || std::fmod(n, 2.0) != 1.0) return "map.patch_odd_size";
        }
        for (double ignored = 0.0; !lexer_.peek().is(')');)
            if (!number(ignored)) return "map.patch_size_close";
        take(')');
        PatchGrid& grid = patch.grid_units;
        grid.rows = static_cast<int>(size[0]);
        grid.columns = static_cast<int>(size[1]);
        if (!take('(')) return "map.patch_points_open";
        for (int row = 0; row < grid.rows; ++row) {
            if (!take('(')) return "map.patch_rows";
            for (int column = 0; column < grid.columns; ++column) {
                if (!take('(')) return "map.patch_columns";
                Vec3 p(0.0);
                for (int axis = 0; axis < 3; ++axis)
                    if (!number(p[axis])) return "map.patch_point";
                for (double ignored = 0.0; !lexer_.peek().is(')');)
                    if (!number(ignored)) return "map.patch_point_close";
                take(')');
                grid.points_m.push_back(p);
            }
            if (!take(')')) return "map.patch_row_close";
        }
        if (!take(')')) return "map.patch_points_close";
        if (!take('}')) return "map.patch_end";
        --open_braces;
        return {};
    }

    enum class FaceForm { Points, PointsAndMatrix, PlaneAndMatrix };

    // Reads faces up to and including the closing brace, either plain faces or those of brushDef. If a face is damaged,
    // only its brush is lost, not the map.
    void read_faces(MapEntity& entity, TextPlace place, FaceForm form = FaceForm::Points) {
        MapBrush brush;
        brush.place = place;
        bool damaged = false;
        ++file_.brushes;
        for (;;) {
            const Token& token = lexer_.peek();
            if (token.is('(')) {
                MapFace face;
                if (read_face(face, damaged, form)) {
                    brush.faces.push_back(face);
                } else {
                    damaged = true;
                    lexer_.skip_damaged_line();
                }
                continue;
            }
            if (token.is('}')) {
                lexer_.take();
                break;
            }
            if (token.kind == TokenKind::End) {
                diagnostics_.error(token.place, "map.then_brush_left_out", "map.open_brush",
                                   {{"line", place.line}, {"before", brushes_before()}});
                damaged = true;
                break;
            }
            if (token.is('{') && !brush.faces.empty()) {
                diagnostics_.error(token.place, "map.then_ends_here", "map.endless_brush", {{"line", place.line}});
                break;
            }
            if (!damaged)
                diagnostics_.error(token.place, "map.then_brush_left_out", "map.no_face",
                                   {{"line", place.line},
                                    {"found", excerpt(token.text)},
                                    {"end", is_end(token)},
                                    {"before", brushes_before()}});
            damaged = true;
            if (token.is('{')) {  // a brace within a brush: this cannot be a brush
                lexer_.take();
                lexer_.skip_block();
                lexer_.skip_block();
                break;
            }
            lexer_.take();
            lexer_.skip_damaged_line();
        }
        if (!damaged && brush.faces.empty()) {
            diagnostics_.warn(place, "map.then_left_out", "map.no_faces");
            damaged = true;
        }
        if (damaged) ++file_.brushes_damaged;
        else entity.brushes.push_back(std::move(brush));
    }

    int brushes_before() const { return file_.brushes - file_.brushes_damaged - 1; }

    // Reads "( x y z ) ( x y z ) ( x y z ) TEXTURE" and then either numbers, or two axes in square brackets and
    // numbers. Games add further numbers, which are optional.
    bool read_face(MapFace& face, bool silent, FaceForm form) {
        face.place = lexer_.peek().place;
        const auto refuse = [&](const Token& found, std::string_view what, int point = 0) {
            if (!silent)
                diagnostics_.error(found.place, "map.then_brush_left_out", what,
                                   {{"found", excerpt(found.text)},
                                    {"end", is_end(found)},
                                    {"point", point},
                                    {"before", brushes_before()}});
            return false;
        };
        const auto bracket = [&](std::span<double> values, int point) {
            if (!lexer_.peek().is('(')) return refuse(lexer_.peek(), "map.face_open", point);
            lexer_.take();
            for (double& value : values) {
                const Token& number = lexer_.peek();
                if (number.kind != TokenKind::Word || !parse_finite(number.text, value))
                    return refuse(number, "map.face_number", point);
                lexer_.take();
            }
            if (!lexer_.peek().is(')')) return refuse(lexer_.peek(), "map.face_close", point);
            lexer_.take();
            return true;
        };
        if (form == FaceForm::PlaneAndMatrix) {
            std::array<double, 4> plane{};
            const Token first = lexer_.peek();
            if (!bracket(plane, 1)) return false;
            if (!points_of_plane(plane, face)) return refuse(first, "map.face_plane");
        } else {
            for (std::size_t point = 0; point < 3; ++point) {
                std::array<double, 3> p{};
                if (!bracket(p, static_cast<int>(point) + 1)) return false;
                face.points_units[point] = {p[0], p[1], p[2]};
            }
        }
        // The texture matrix is read only here, because elsewhere a bracket may be the beginning of a texture's name.
        if (form != FaceForm::Points && !skip_texture_matrix()) return refuse(lexer_.peek(), "map.face_matrix");
        const Token texture = lexer_.take_texture();
        if (texture.kind == TokenKind::End) return refuse(texture, "map.face_texture");
        face.texture = texture.text;
        while (lexer_.peek().is('[') || lexer_.peek().is(']') || is_number(lexer_.peek())) lexer_.take();
        return true;
    }

    // Turns "( a b c d )" of brushDef3 into three points on the plane ax + by + cz + d = 0. Their order is the order
    // seen from the side where the sum is positive. Returns false if the normal is zero.
    static bool points_of_plane(const std::array<double, 4>& plane, MapFace& face) {
        constexpr double kApart_units = 128.0;
        const Vec3 normal(plane[0], plane[1], plane[2]);
        const double length = glm::length(normal);
        if (!(length > 1e-9) || !std::isfinite(length)) return false;
        const Vec3 out = normal / length, u = any_perpendicular(out), v = glm::cross(out, u);
        const Vec3 at = out * (-plane[3] / length);
        face.points_units = {at + u * kApart_units, at, at + v * kApart_units};
        return true;
    }

    // Skips the texture matrix of brushDef, such as "( ( 1 0 0 ) ( 0 1 0 ) )".
    bool skip_texture_matrix() {
        if (!lexer_.peek().is('(')) return false;
        lexer_.take();
        for (int row = 0; row < 2; ++row) {
            if (!lexer_.peek().is('(')) return false;
            lexer_.take();
            while (is_number(lexer_.peek())) lexer_.take();
            if (!lexer_.peek().is(')')) return false;
            lexer_.take();
        }
        if (!lexer_.peek().is(')')) return false;
        lexer_.take();
        return true;
    }

    static bool is_number(const Token& token) {
        double ignored = 0.0;
        return token.kind == TokenKind::Word && parse_finite(token.text, ignored);
    }

    Lexer lexer_;
    Diagnostics& diagnostics_;
    std::stop_token stop_;
    MapFile file_;
    bool complained_outside_ = false;
    bool complained_bare_ = false;
};

}  // namespace

const MapKey* MapEntity::find(std::string_view key) const {
    for (const MapKey& known : keys)
        if (known.key == key) return &known;
    return nullptr;
}

std::string_view MapEntity::value(std::string_view key) const {
    const MapKey* found = find(key);
    return found ? found->value : std::string_view{};
}

std::string unquoted(std::string_view raw) {
    std::string text;
    text.reserve(raw.size());
    for (std::size_t i = 0; i < raw.size(); ++i) {
        if (raw[i] == '\\' && i + 1 < raw.size() && raw[i + 1] == '"') continue;
        text += raw[i];
    }
    return text;
}

MapFile parse_map(std::string_view bytes, Diagnostics& diagnostics, const std::stop_token& stop) {
    return Parser(bytes, diagnostics, stop).parse();
}

}  // namespace handrail::readers
