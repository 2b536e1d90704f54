// Reads IFC shape representations as solids and sheets, in metres and in the product's own frame. Unsupported classes
// are counted by name. One reading thread uses it.
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
    // Greatest depth of nested mapped items and second operands. First operands may be nested without limit.
    static constexpr int kDeepest = 200;
    static constexpr std::size_t kMostItems = 400'000;  // items read in the whole file
    static constexpr std::size_t kMostFaces = 3'000'000;

    IfcShapes(const IfcModel& model, std::stop_token stop) : model_(model), stop_(std::move(stop)) {}

    // The shape of an IfcProductDefinitionShape: its solid representation, else any other that encloses a volume.
    Body body_of(std::uint64_t shape);
    // Accounts for the last call of body_of: the volume of sweeps and closed shells by their outlines and faces, and
    // the volume of the solids built. Neither includes cuts.
    struct Account {
        double stated_m3 = 0.0, made_m3 = 0.0;
        double stated_m2 = 0.0, made_m2 = 0.0;  // the same for the faces of open skins
        int lost_faces = 0;                     // with too many corners, or with missing corners
        std::string unread;                     // name of a class that is not supported
        double result_share = 0.0;  // Share of the boolean results' volume that is missing; negative: surplus.
        std::string uncut;          // class of an operand that could not be taken away
        bool formed = false;        // there is a solid representation
    };
    const Account& account() const { return account_; }
    const std::map<std::string, int, std::less<>>& not_read() const { return not_read_; }
    int approximated() const { return approximated_; }  // curved faces, and cuts of shapes that enclose no volume
    bool too_large() const { return items_ >= kMostItems || faces_ >= kMostFaces; }
    // The remaining budget for exact cuts, shared by all parts of the file.
    ExactLimits& exact_limits() { return exact_limits_; }

private:
    struct Cutter {
        std::vector<std::vector<Plane>> parts;  // each is a convex region, which may be unbounded
        bool known = true;
        Body skin;  // the whole operand, if convex parts cannot represent it
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
    std::map<std::uint64_t, std::shared_ptr<const Mapped>> maps_;  // mapped representations, in their own frames
    Account account_;
    std::map<std::string, int, std::less<>> not_read_;
    ExactLimits exact_limits_;
    std::size_t items_ = 0, faces_ = 0;
    int approximated_ = 0;
    bool within_result_ = false;  // set while reading operands: a boolean result is compared as a whole
};

}  // namespace handrail::ifc
