// Makes a hall and a gallery, joined by stairs of a given form that the building states. For tests of walkers who climb
// these stairs.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "worlds/base/vec.h"
#include "worlds/scene/stated_building.h"

namespace handrail::test {

enum class StairForm {
    // A straight flight, a metre wide, between walls. The floor above ends over the third step of the flight. Most of
    // the other forms have such a floor, too.
    Straight,
    Steep,    // risers of 35 cm, as some programs export them; without a floor above
    Landing,  // two flights next to each other
    Winder3,  // a quarter turn with three winders; 80 cm wide, between walls
    Winder4,  // like Winder3, with four winders
    Sheets,   // like Winder4, but made of triangle sheets instead of solids
    Spiral,   // around a post, 74 cm from it to the railing, partly under the edge of the gallery
};
inline constexpr StairForm kStairForms[] = {StairForm::Straight, StairForm::Steep,   StairForm::Landing,
                                            StairForm::Winder3,  StairForm::Winder4, StairForm::Sheets,
                                            StairForm::Spiral};
inline const char* form_name(StairForm form) {
    switch (form) {
        case StairForm::Straight:
            return "straight";
        case StairForm::Steep:
            return "steep";
        case StairForm::Landing:
            return "landing";
        case StairForm::Winder3:
            return "winder of 3";
        case StairForm::Winder4:
            return "winder of 4";
        case StairForm::Sheets:
            return "winder of sheets";
        case StairForm::Spiral:
            return "spiral";
    }
    return "";
}

class StairHouse {
public:
    // `wall_tops_m` has the tops of the pieces of which the walls consist, from the lowest up.
    explicit StairHouse(StairForm form, std::vector<double> wall_tops_m = {3.8})
        : wall_tops_m_(std::move(wall_tops_m)) {
        b_.box({-6, -6, -0.2}, {8, 8, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
        switch (form) {
            case StairForm::Straight:
                straight(14, 0.27, 2.8 / 15.0);
                break;
            case StairForm::Steep:
                straight(7, 0.27, 0.35);
                break;
            case StairForm::Landing:
                landing();
                break;
            case StairForm::Winder3:
                winder(3);
                break;
            case StairForm::Winder4:
                winder(4);
                break;
            case StairForm::Sheets:
                sheets_ = true;
                winder(4);
                break;
            case StairForm::Spiral:
                spiral();
                break;
        }
        room("Hall", {-6, -6, 0}, {8, form == StairForm::Spiral ? 8 : 0, 0}, hall_m_);
        room("Gallery", gallery_low_m_, gallery_high_m_, gallery_m_);
        StatedPortal portal;
        portal.kind = StatedPortalKind::Stairs;
        portal.feature = stairs_;
        portal.rooms = {0, 1};
        stated_.portals.push_back(portal);
        b_.start(hall_m_, 0.0);
        b_.scene().stated = std::make_shared<const StatedBuilding>(stated_);
    }

    std::shared_ptr<const Scene> share() const { return b_.share(); }
    const Vec3& hall_m() const { return hall_m_; }
    const Vec3& gallery_m() const { return gallery_m_; }

private:
    static constexpr double kUp_m = 2.8, kThick_m = 0.2;

    void room(const std::string& name, const Vec3& low, const Vec3& high, const Vec3& at_m) {
        StatedRoom made;
        made.name = name;
        made.rings = {{{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}}};
        made.floor_m = low.z;
        made.height_m = 2.4;
        made.at_m = at_m;
        made.area_m2 = (high.x - low.x) * (high.y - low.y);
        stated_.rooms.push_back(made);
    }
    void floor(const Vec3& low, const Vec3& high) {
        b_.box({low.x, low.y, low.z - kThick_m}, {high.x, high.y, low.z}, "floor", SolidRole::Solid, {},
               FeatureKind::Floor);
    }
    void wall(const Vec2& low, const Vec2& high) {
        for (std::size_t i = 0; i < wall_tops_m_.size(); ++i)
            b_.box({low, i == 0 ? 0.0 : wall_tops_m_[i - 1]}, {high, wall_tops_m_[i]}, "wall", SolidRole::Solid, {},
                   FeatureKind::Wall);
    }
    // Adds a part of the stairs. All parts belong to one feature.
    void part(const std::vector<Vec2>& outline_m, double low_m, double high_m) {
        const FeatureId own = b_.prism(outline_m, low_m, high_m, "stairs");
        if (!stairs_) stairs_ = own;
        Scene& scene = b_.scene();
        scene.features[stairs_.value].bounds_m.include(scene.features[own.value].bounds_m);
        Solid& solid = scene.solids.back();
        solid.feature = stairs_;
        solid.face_features.assign(solid.shape.planes.size(), stairs_);
        if (!sheets_) return;
        for (const Polygon& face : solid.shape.faces)
            for (std::size_t k = 2; k < face.points_m.size(); ++k)
                scene.triangles.push_back({face.points_m[0], face.points_m[k - 1], face.points_m[k], stairs_,
                                           kDefaultMaterial, TouchSide::Both});
        scene.solids.pop_back();
    }
    void tread(const Vec2& low, const Vec2& high, double top_m) {
        part({low, {high.x, low.y}, high, {low.x, high.y}}, std::max(0.0, top_m - kThick_m), top_m);
    }
    void gallery(const Vec3& low, const Vec3& high, const Vec3& at_m) {
        gallery_low_m_ = low;
        gallery_high_m_ = high;
        gallery_m_ = at_m;
        floor(low, high);
    }

    // Adds the floor above. It ends over the third step of a flight that leads north, two metres above that step.
    void under_floor(double wide_m, double up_m) { floor({0, -1, up_m}, {wide_m, 0.6, up_m}); }

    // Adds a flight that leads up to the north.
    void straight(int treads, double going_m, double riser_m) {
        for (int k = 0; k < treads; ++k) tread({0, k * going_m}, {1, (k + 1) * going_m}, (k + 1) * riser_m);
        if (riser_m < 0.3) under_floor(1.0, kUp_m);
        const double end = treads * going_m, up_m = (treads + 1) * riser_m;
        wall({-0.1, 0}, {0, end});
        wall({1, 0}, {1.1, end});
        gallery({-3, end, up_m}, {4, end + 3.0, up_m}, {0.5, end + 1.5, up_m});
        hall_m_ = {0.5, -2, 0};
    }
    // Adds a flight that leads up to the north, then one from the landing to the south.
    void landing() {
        constexpr double kGoing_m = 0.27, kRiser_m = kUp_m / 16.0;
        for (int k = 0; k < 7; ++k) {
            tread({0, k * kGoing_m}, {1, (k + 1) * kGoing_m}, (k + 1) * kRiser_m);
            tread({1.1, (6 - k) * kGoing_m}, {2.1, (7 - k) * kGoing_m}, (k + 9) * kRiser_m);
        }
        const double turn = 7 * kGoing_m;
        tread({0, turn}, {2.1, turn + 1.1}, 8 * kRiser_m);
        wall({-0.1, 0}, {0, turn + 1.1});
        wall({1, 0}, {1.1, turn});
        wall({2.1, 0}, {2.2, turn + 1.1});
        wall({-0.1, turn + 1.1}, {2.2, turn + 1.2});
        under_floor(1.0, kUp_m);
        gallery({1.1, -5, kUp_m}, {6, 0, kUp_m}, {2, -2, kUp_m});
        hall_m_ = {0.5, -2, 0};
    }
    // Adds stairs that lead up to the north, around a corner of this many winders, and on to the east.
    void winder(int wedges) {
        constexpr double kWide_m = 0.8, kGoing_m = 0.26, kTurn_m = 5 * kGoing_m;
        const double riser_m = kUp_m / (12 + wedges);
        for (int k = 0; k < 5; ++k) tread({0, k * kGoing_m}, {kWide_m, (k + 1) * kGoing_m}, (k + 1) * riser_m);
        const Vec2 newel{kWide_m, kTurn_m};
        // Returns a point on the outer border of the corner, at this share of the quarter turn, which goes from the
        // west to the north.
        const auto border = [&](double part) {
            const double turn = part * 0.5 * kPi, far = kWide_m / std::max(std::cos(turn), std::sin(turn));
            return newel + Vec2(-std::cos(turn), std::sin(turn)) * far;
        };
        for (int k = 0; k < wedges; ++k) {
            const double from = static_cast<double>(k) / wedges, to = static_cast<double>(k + 1) / wedges;
            std::vector<Vec2> outline{newel, border(to)};
            if (from < 0.5 && to > 0.5) outline.push_back(newel + Vec2(-kWide_m, kWide_m));
            outline.push_back(border(from));
            part(outline, (6 + k) * riser_m - kThick_m, (6 + k) * riser_m);
        }
        for (int k = 0; k < 6; ++k)
            tread({kWide_m + k * kGoing_m, kTurn_m}, {kWide_m + (k + 1) * kGoing_m, kTurn_m + kWide_m},
                  (6 + wedges + k) * riser_m);
        const double end = kWide_m + 6 * kGoing_m;
        wall({-0.1, 0}, {0, kTurn_m + kWide_m + 0.1});
        wall({-0.1, kTurn_m + kWide_m}, {end, kTurn_m + kWide_m + 0.1});
        wall({kWide_m, 0}, {kWide_m + 0.1, kTurn_m});
        wall({kWide_m, kTurn_m - 0.1}, {end, kTurn_m});
        under_floor(kWide_m, kUp_m);
        gallery({end, -3, kUp_m}, {end + 3.0, 5, kUp_m}, {end + 1.5, kTurn_m + 0.4, kUp_m});
        hall_m_ = {0.4, -2, 0};
    }
    // Adds fifteen treads of 16 degrees each, counter-clockwise from the west-south-west to the north.
    void spiral() {
        constexpr int kTreads = 15;
        constexpr double kPost_m = 0.1, kOuter_m = 0.84, kRiser_m = 2.65 / kTreads;
        const auto at = [](double degrees, double radius_m) {
            return radius_m * Vec2(std::cos(degrees * kPi / 180.0), std::sin(degrees * kPi / 180.0));
        };
        const auto wedge = [&](double from, double to, double inner_m, double outer_m) {
            const double middle = 0.5 * (from + to);
            return std::vector<Vec2>{at(from, inner_m), at(from, outer_m), at(middle, outer_m), at(to, outer_m),
                                     at(to, inner_m)};
        };
        for (int k = 0; k < kTreads; ++k) {
            const double from = 210.0 + 16.0 * k, top_m = (k + 1) * kRiser_m;
            part(wedge(from, std::min(from + 20.0, 450.0), kPost_m, kOuter_m + 0.01), top_m - 0.06, top_m);
            if (k > 0 && k < kTreads - 1)
                for (const double part_from : {from, from + 8.0})
                    part({at(part_from, kOuter_m), at(part_from, kOuter_m + 0.03), at(part_from + 8.0, kOuter_m + 0.03),
                          at(part_from + 8.0, kOuter_m)},
                         top_m, top_m + 0.9);
        }
        std::vector<Vec2> post;
        for (int k = 0; k < 8; ++k) post.push_back(at(45.0 * k, kPost_m));
        part(post, 0.0, 3.5);
        floor({-5, -3, 2.7}, {-0.02, 0.9, 2.7});
        gallery({-5, 0.9, 2.7}, {5, 4, 2.7}, {-2, 2.5, 2.7});
        hall_m_ = {-2.5, -1, 0};
    }

    SceneBuilder b_;
    StatedBuilding stated_;
    std::vector<double> wall_tops_m_;
    FeatureId stairs_ = kNoFeature;
    bool sheets_ = false;
    Vec3 hall_m_{0.0}, gallery_m_{0.0}, gallery_low_m_{0.0}, gallery_high_m_{0.0};
};

}  // namespace handrail::test
