// Reads IFC shape representations as solids and sheets, in metres and in the product's own frame. Classes that are not
// supported are counted by name. Used on the reading thread only.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "worlds/ifc/body.h"
#include "worlds/ifc/exact_cut.h"

namespace handrail::ifc {

class IfcShapes {
public:
    // Greatest depth of nested mapped items and second operands. The depth of first operands is not limited.
    static constexpr int kDeepest = 200;
    static constexpr std::size_t kMostItems = 400'000;  // greatest number of items that are read in the whole file
    static constexpr std::size_t kMostFaces = 3'000'000;

    IfcShapes(const IfcModel& model, std::stop_token stop) : model_(model), stop_(std::move(stop)) {}

    // Returns the shape of an IfcProductDefinitionShape: its solid representation, or else any other representation
    // that encloses a volume.
    Body body_of(std::uint64_t shape);
    // The account of the last call of body_of. It compares the volume that the file states for sweeps and closed
    // shells, computed from outlines and faces, with the volume of the solids that were built. Neither volume is
    // reduced by cuts.
    struct Account {
        double stated_m3 = 0.0, made_m3 = 0.0;
        double stated_m2 = 0.0, made_m2 = 0.0;  // the areas of the faces of open skins, stated and built
        int lost_faces = 0;                     // number of faces with too many corners, or with missing corners
        std::string unread;                     // name of a class that the shape uses and that is not supported
        // The share of the volume of boolean results that is missing. Negative: there is too much volume.
        double result_share = 0.0;
        std::string uncut;    // IFC class of an operand that could not be subtracted
        bool formed = false;  // the file has a solid representation of this shape
    };
    const Account& account() const { return account_; }
    const std::map<std::string, int, std::less<>>& not_read() const { return not_read_; }
    // Returns the number of curved faces, and of cuts of shapes that enclose no volume.
    int approximated() const { return approximated_; }
    bool too_large() const { return items_ >= kMostItems || faces_ >= kMostFaces; }
    // Returns the remaining budget for exact cuts, which all parts of the file share.
    ExactLimits& exact_limits() { return exact_limits_; }

private:
    struct Cutter {
        std::vector<std::vector<Plane>> parts;  // convex regions that together are the operand; each may be unbounded
        bool known = true;
        Body skin;  // the skin of the whole operand, if convex parts cannot represent it
    };
    Body item(std::uint64_t id, int depth);
    Body read_item(std::uint64_t id, int depth);
    void weigh(std::string_view kind, const Values& values, const Body& body);
    double swept_m3(std::string_view kind, const Values& values) const;
    double turned_m3(const Values& values) const;
    void weigh_faces(const std::vector<FlatFace>& faces, const Body& body);
    void note_unread(std::string_view kind);
    Body representation(std::uint64_t id, int depth);
    Body mapped(const Values& values, int depth);
    Body extruded(std::string_view kind, const Values& values);
    Body revolved(const Values& values);
    Body swept_disk(const Values& values);
    Body boolean(std::uint64_t id, int depth);
    void combine(Body& body, const Values& values, int depth);
    bool combine_exactly(Body& first, const Cutter& second, ExactCut cut);
    struct Form;
    std::optional<Form> form_of(std::uint64_t id, int depth);
    std::optional<Form> skin_form(const std::vector<FlatFace>& faces) const;
    std::optional<Form> solid_form(std::string_view kind, const Values& values) const;
    std::optional<Form> result_form(std::uint64_t id, int depth);
    void compare_result(std::uint64_t id, const Body& body, Aabb box);
    Body primitive(std::string_view kind, const Values& values);
    Cutter cutter(std::uint64_t id, int depth);
    Cutter half_space(std::string_view kind, const Values& values);
    Body body_of_skin(const std::vector<FlatFace>& faces);
    Body shells(const std::vector<std::uint64_t>& shells);
    void add_faces(std::uint64_t shell, std::vector<FlatFace>& faces);
    FlatFace face(std::uint64_t id);
    std::vector<Vec3> loop(std::uint64_t id);
    std::vector<FlatFace> tessellated_faces(std::string_view kind, const Values& values);
    std::vector<Vec3> point_list(std::uint64_t id) const;
    bool spent() const { return too_large() || stop_.stop_requested(); }

    const IfcModel& model_;
    std::stop_token stop_;
    struct Mapped {
        Body body;
        Account account;
    };
    // Mapped representations by their id, in their own frames.
    std::map<std::uint64_t, std::shared_ptr<const Mapped>> maps_;
    Account account_;
    std::map<std::string, int, std::less<>> not_read_;
    ExactLimits exact_limits_;
    std::size_t items_ = 0, faces_ = 0;
    int approximated_ = 0;
    bool within_result_ = false;  // true while operands are read, because a boolean result is compared only as a whole
};

}  // namespace handrail::ifc
