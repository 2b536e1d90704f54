#include "app/window/renderer.h"

#include <ctime>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/window/draw_mesh.h"
#include "app/window/large_text.h"
#include "app/window/palette.h"
#include "app/window/plan.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/window/offscreen_gl.h"
#include "tests/window/small_room.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/models.h"

namespace handrail::test {
namespace renderer_test {

constexpr PixelSize kSize{960, 720};
// Height of the picture: the window's 720 pixels minus two lines of 60 for the newest message, four of 30 for older
// ones, two of 30 for the status, and four gaps of 4.
constexpr double kPictureHeight_px = 404.0;
constexpr double kMiddle_px = 0.5 * kPictureHeight_px;
constexpr double kStatusTop_px = kPictureHeight_px, kMessagesTop_px = 476.0;
// The plan of the small room, which is 4.4 m deep with its walls, fills 0.94 of the height of the picture.
constexpr double kPlanScale_px_per_m = 0.94 * kPictureHeight_px / 4.4;

// Returns the pixel of a place on the plan of the small room, whose middle is in the middle of the picture.
Vec2 plan_px(double x_m, double y_m) {
    return {480.0 + kPlanScale_px_per_m * (x_m - 3.0), kMiddle_px - kPlanScale_px_per_m * (y_m - 2.0)};
}

bool red(const Rgb& c) { return c[0] > 140 && c[1] < 60 && c[2] < 60; }
bool green(const Rgb& c) { return c[1] > 140 && c[0] < 60 && c[2] < 90; }
bool white(const Rgb& c) { return c[0] > 250 && c[1] > 250 && c[2] > 250; }
bool black(const Rgb& c) { return c[0] < 5 && c[1] < 5 && c[2] < 5; }
bool yellow(const Rgb& c) { return c[0] > 230 && c[1] > 230 && c[2] < 40; }
bool cyan(const Rgb& c) { return c[0] < 40 && c[1] > 230 && c[2] > 230; }

struct Counted {
    int count = 0;
    Vec2 mean_px{0.0};
};

template <class Test>
Counted count(const Picture& picture, Test test, double top_px = 0.0, double bottom_px = kPictureHeight_px) {
    Counted found;
    for (int y = static_cast<int>(top_px); y < static_cast<int>(bottom_px); ++y)
        for (int x = 0; x < picture.width; ++x)
            if (test(picture.at(x, y))) {
                ++found.count;
                found.mean_px += Vec2(x + 0.5, y + 0.5);
            }
    if (found.count) found.mean_px /= found.count;
    return found;
}

class RendererTest : public ::testing::Test {
protected:
    void SetUp() override {
        gl_ = OffscreenGl::open(kSize);
        if (!gl_) GTEST_SKIP() << "this machine cannot draw without a display (EGL surfaceless)";
        auto created = Renderer::create();
        ASSERT_TRUE(created.has_value()) << created.error().sentence();
        renderer_ = std::move(*created);
    }

    Picture draw(const ViewState& view) {
        Picture picture = gl_->draw(*renderer_, view);
        last_ = picture;
        return picture;
    }

    void TearDown() override {
        if (!HasFailure() || last_.rgb.empty()) return;
        const auto path =
            std::filesystem::temp_directory_path() /
            fmt::format("handrail_{}.png", ::testing::UnitTest::GetInstance()->current_test_info()->name());
        if (save_png(last_, path)) std::cout << "last picture: " << path << "\n";
    }

    // Returns the pixel at which the picture shows a point of the world. Uses a pinhole camera, computed independently
    // of the code under test.
    static Vec2 pixel_of(const ViewState& view, const Vec3& world_m) {
        const Vec3 to = world_m - view.eyes_m;
        const double ahead = glm::dot(to, forward_of_heading(view.heading_rad)),
                     right = glm::dot(to, right_of_heading(view.heading_rad));
        const double depth = ahead * std::cos(view.tilt_rad) + to.z * std::sin(view.tilt_rad);
        const double up = to.z * std::cos(view.tilt_rad) - ahead * std::sin(view.tilt_rad);
        const double focal_px = 0.5 * kPictureHeight_px / std::tan(radians_from_degrees(30.0));
        return {0.5 * kSize.width + focal_px * right / depth, 0.5 * kPictureHeight_px - focal_px * up / depth};
    }
    static Rgb at(const Picture& picture, const Vec2& px) {
        return picture.at(static_cast<int>(px.x), static_cast<int>(px.y));
    }
    static double brightness(const Picture& picture, const ViewState& view, const Vec3& world_m) {
        return luminance(at(picture, pixel_of(view, world_m)));
    }

    std::unique_ptr<OffscreenGl> gl_;
    std::unique_ptr<Renderer> renderer_;
    Picture last_;
};

TEST_F(RendererTest, walls_ceiling_and_floor_differ_only_in_brightness) {
    const ViewState view = view_in(small_room(), 3.5, 0.3, 0.0);
    const Picture picture = draw(view);
    const double wall = brightness(picture, view, {3.5, 4.0, 1.5});
    const double ceiling = brightness(picture, view, {3.5, 3.0, 2.5});
    const double floor = brightness(picture, view, {3.5, 3.0, 0.0});
    const double east_wall = brightness(picture, view, {6.0, 3.0, 1.5});
    EXPECT_GT(wall, ceiling + 40.0);
    EXPECT_GT(ceiling, floor + 40.0);
    EXPECT_GT(east_wall, wall + 20.0);
}

TEST_F(RendererTest, a_corner_has_a_white_line_with_black_next_to_it) {
    const ViewState view = view_in(small_room(), 3.5, 0.3, 0.0);
    const Picture picture = draw(view);
    const Vec2 corner = pixel_of(view, {6.0, 4.0, 1.6});
    int whites = 0, blacks = 0;
    for (int x = static_cast<int>(corner.x) - 6; x <= static_cast<int>(corner.x) + 6; ++x) {
        whites += white(picture.at(x, static_cast<int>(corner.y)));
        blacks += black(picture.at(x, static_cast<int>(corner.y)));
    }
    EXPECT_GE(whites, 1);
    EXPECT_GE(blacks, 2);
}

// Returns which flat face of the scene a ray meets first, as its plane: one face for all pieces of a wall. Tries every
// solid in turn, independently of the code that draws.
std::optional<Plane> face_met(const Scene& scene, const Vec3& eye_m, const Vec3& direction) {
    std::optional<Plane> met;
    double nearest = 1e9;
    for (const Solid& solid : scene.solids) {
        double enter = 0.0, leave = 1e9;
        const Plane* entered = nullptr;
        for (const Plane& plane : solid.shape.planes) {
            const double along = glm::dot(plane.normal, direction),
                         gap_m = plane.offset_m - glm::dot(plane.normal, eye_m);
            if (along < 0.0 && gap_m / along > enter) enter = gap_m / along, entered = &plane;
            if (along > 0.0) leave = std::min(leave, gap_m / along);
            if (along == 0.0 && gap_m < 0.0) leave = -1.0;
        }
        if (entered && enter < leave && enter < nearest) nearest = enter, met = *entered;
    }
    return met;
}

bool same_face(const std::optional<Plane>& a, const std::optional<Plane>& b) {
    return a.has_value() == b.has_value() &&
           (!a || (a->normal == b->normal && std::abs(a->offset_m - b->offset_m) < 1e-9));
}

constexpr int kOutline_px = 6, kWide_px = 16;  // half of an outline with its border; the width of a face to judge

// Returns the places in a row of pixels, given the face that each pixel shows, where one face ends and another begins,
// both of them wider than their outlines.
std::vector<int> borders_in(const std::vector<std::optional<Plane>>& faces) {
    std::vector<int> borders;
    int begin = 0, last = -1;
    for (int i = 1; i <= static_cast<int>(faces.size()); ++i) {
        const std::size_t at = static_cast<std::size_t>(i);
        if (at < faces.size() && same_face(faces[at - 1], faces[at])) continue;
        if (i - begin < kWide_px) last = -1;
        else if (last >= 0) borders.push_back(last);
        if (i - begin >= kWide_px) last = i;
        begin = i;
    }
    return borders;
}

// At a border between two faces, their colours differ by 3:1, or the outline differs by 3:1 from both.
bool set_apart(const std::vector<Rgb>& colours, int border) {
    const auto at = [&](int i) { return colours[static_cast<std::size_t>(i)]; };
    const Rgb before = at(border - kWide_px + 2), after = at(border + kWide_px - 2);
    bool apart = contrast(before, after) >= 3.0;
    for (int i = border - kOutline_px; i < border + kOutline_px; ++i)
        apart = apart || (contrast(at(i), before) >= 3.0 && contrast(at(i), after) >= 3.0);
    return apart;
}

TEST_F(RendererTest, neighbouring_faces_of_the_view_ahead_differ_by_three_to_one) {
    const double focal_px = 0.5 * kPictureHeight_px / std::tan(radians_from_degrees(30.0));
    const int height_px = static_cast<int>(kPictureHeight_px);
    for (const settings::ColourSet set : {settings::ColourSet::Dark, settings::ColourSet::Light,
                                          settings::ColourSet::HighContrast, settings::ColourSet::ColourSafe})
        for (const double heading_degrees : {0.0, 45.0, 90.0, 200.0, 300.0}) {
            ViewState view = view_in(small_room(), 3.5, 2.0, heading_degrees);
            view.display.colours = set;
            const Picture picture = draw(view);
            const Vec3 ahead = forward_of_heading(view.heading_rad), right = right_of_heading(view.heading_rad);
            int borders = 0;
            const auto face_at = [&](const glm::ivec2& px) {
                return face_met(*view.scene, view.eyes_m,
                                ahead + (px.x + 0.5 - 0.5 * kSize.width) / focal_px * right +
                                    Vec3(0.0, 0.0, (kMiddle_px - px.y - 0.5) / focal_px));
            };
            const auto check_row = [&](const glm::ivec2& from, const glm::ivec2& step, int length) {
                std::vector<std::optional<Plane>> faces;
                std::vector<Rgb> colours;
                for (int i = 0; i < length; ++i) {
                    faces.push_back(face_at(from + i * step));
                    colours.push_back(picture.at(from.x + i * step.x, from.y + i * step.y));
                }
                for (const int border : borders_in(faces)) {
                    const glm::ivec2 at = from + border * step, beside(2 * step.y, 2 * step.x);
                    // Rows meet level borders, and columns upright ones, at too small an angle.
                    if (!same_face(face_at(at - 3 * step + beside), face_at(at - 3 * step - beside)) ||
                        !same_face(face_at(at + 3 * step + beside), face_at(at + 3 * step - beside)))
                        continue;
                    ++borders;
                    EXPECT_TRUE(set_apart(colours, border)) << "set " << static_cast<int>(set) << ", heading "
                                                            << heading_degrees << ", pixel " << at.x << ", " << at.y;
                }
            };
            for (int y = 20; y < height_px - 20; y += 7) check_row({0, y}, {1, 0}, kSize.width);
            for (int x = 20; x < kSize.width - 20; x += 7) check_row({x, 0}, {0, 1}, height_px);
            EXPECT_GT(borders, 100) << "set " << static_cast<int>(set) << ", heading " << heading_degrees;
        }
}

TEST_F(RendererTest, a_line_that_continues_below_the_eye_keeps_its_white_core) {
    ViewState view = view_in(small_room(), 1.0, 1.0, 0.0);
    view.tilt_rad = -0.5;
    const Picture picture = draw(view);
    int seen = 0;
    for (double y_m = 1.5; y_m < 4.0; y_m += 0.1) {  // along the line where floor and west wall meet
        const Vec2 px = pixel_of(view, {0.0, y_m, 0.0});
        if (px.x < 10 || px.y < 10 || px.y > kPictureHeight_px - 10) continue;
        ++seen;
        int whites = 0;
        for (int dx = -5; dx <= 5; ++dx) whites += white(at(picture, px + Vec2(dx, 0.0)));
        EXPECT_GE(whites, 1) << y_m << " m north";
    }
    EXPECT_GE(seen, 10);
}

TEST_F(RendererTest, a_door_has_upright_stripes_and_is_brighter_than_its_wall) {
    const ViewState view = view_in(small_room(), 3.5, 2.0, 90.0);
    const Picture picture = draw(view);
    const double wall = brightness(picture, view, {6.0, 3.4, 1.5});
    const Vec2 left = pixel_of(view, {5.9, 2.4, 1.2}), right = pixel_of(view, {5.9, 1.6, 1.2});
    double brightest = 0.0;
    int changes = 0;
    bool was_bright = luminance(at(picture, left)) > 160.0;
    for (double x = left.x; x < right.x; ++x) {
        const double here = luminance(at(picture, {x, left.y}));
        brightest = std::max(brightest, here);
        if ((here > 160.0) != was_bright) {
            was_bright = !was_bright;
            ++changes;
        }
    }
    EXPECT_GT(brightest, wall + 20.0);
    EXPECT_GE(changes, 5) << "0.8 m of stripes 0.12 m wide";
}

TEST_F(RendererTest, things_under_water_shine_through) {
    auto with_bright_bottom = std::make_shared<Scene>(*small_room());
    add_box(*with_bright_bottom, {0.5, 0.5, 0.0}, {2.0, 1.5, 0.01}, FeatureKind::Object);
    ViewState view = view_in(small_room(), 1.2, 3.0, 180.0);
    view.tilt_rad = -0.6;
    const Vec3 in_water(1.2, 1.0, 0.05), on_floor(3.2, 1.5, 0.0);
    const Picture dark = draw(view);
    const double water = brightness(dark, view, in_water);
    EXPECT_GT(std::abs(water - brightness(dark, view, on_floor)), 10.0);
    view.scene = with_bright_bottom;
    EXPECT_GT(brightness(draw(view), view, in_water), water + 15.0);
}

TEST_F(RendererTest, proxy_is_green_when_free_and_red_inside_a_white_ring_when_touching) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    view.show_hand = true;
    view.proxy_m = {3.6, 2.0, 1.4};
    const Vec2 expected = pixel_of(view, view.proxy_m);
    const Picture free = draw(view);
    const Counted greens = count(free, green);
    EXPECT_GT(greens.count, 100);
    EXPECT_LT(glm::distance(greens.mean_px, expected), 2.0);
    EXPECT_EQ(count(free, red).count, 0);

    view.touching = true;
    const Picture touching = draw(view);
    const Counted reds = count(touching, red);
    EXPECT_NEAR(reds.count, greens.count, 0.25 * greens.count);
    EXPECT_LT(glm::distance(reds.mean_px, expected), 2.0);
    EXPECT_EQ(count(touching, green).count, 0);
    EXPECT_GT(count(touching, white).count, count(free, white).count + greens.count)
        << "the ring tells the contact to those who see no red";
}

TEST_F(RendererTest, proxy_is_hollow_while_forces_are_off_and_absent_without_a_hand) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    view.show_hand = true;
    view.proxy_m = {3.6, 2.0, 1.4};
    const Vec2 middle = pixel_of(view, view.proxy_m);
    EXPECT_TRUE(green(at(draw(view), middle)));
    view.forces_on = false;
    const Picture hollow = draw(view);
    EXPECT_FALSE(green(at(hollow, middle)));
    EXPECT_GT(count(hollow, green).count, 50);
    view.show_hand = false;
    EXPECT_EQ(count(draw(view), green).count, 0);
}

TEST_F(RendererTest, a_wall_between_eye_and_proxy_hides_it) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    view.show_hand = true;
    view.proxy_m = {3.6, 5.0, 1.6};
    EXPECT_EQ(count(draw(view), green).count, 0);
}

TEST_F(RendererTest, a_building_a_thousand_kilometres_from_the_origin_looks_the_same) {
    ViewState near = view_in(small_room(), 3.5, 1.0, 20.0);
    ViewState far = view_in(small_room({1e6, -1e6, 4000.0}), 3.5, 1.0, 20.0);
    const Picture a = draw(near), b = draw(far);
    int different = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) different += std::abs(a.rgb[i + 1] - b.rgb[i + 1]) > 8;
    EXPECT_LT(different, a.width * a.height / 500);
}

// Returns a hall with a crate. The crate's centre is at `at_m`, and the crate is turned by `turned_rad` about the
// vertical.
std::shared_ptr<const Scene> hall_with_crate(const Vec3& at_m, double turned_rad) {
    auto scene = read_quake_map(
        entity("worldspawn", key("building", "1"), room_brushes(0, 0, 0, 256, 256, 128)) +
            entity("info_player_start", key("origin", "128 32 24") + key("angle", "90")) +
            entity("thing", key("cs_name", "dynamic_box") + key("name", "Crate"), box_brush(112, 112, 0, 144, 144, 24)),
        "hall.map", {});
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().sentence());
    std::vector<int> things;
    Scene apart = with_bodies_apart(std::move(*scene), 16, things);
    move_placed(apart, 0, {at_m, rotation_about({0.0, 0.0, 1.0}, turned_rad), 1.0});
    return std::make_shared<const Scene>(std::move(apart));
}

TEST_F(RendererTest, moved_objects_are_drawn_at_their_new_place_in_the_plan_too) {
    for (const bool plan : {false, true}) {
        const Vec3 here(4.0, 4.0, 0.375), there(5.2, 3.1, 0.875);
        ViewState view = view_in(hall_with_crate(here, 0.0), 4.0, 1.0, 0.0);
        view.pictures = plan ? Pictures::Plan : Pictures::FirstPerson;
        const Picture stands = draw(view);
        Placement to = view.scene->placed.at(0).at;
        to.position_m = there;
        to.rotation = rotation_about({0.0, 0.0, 1.0}, 0.7);
        view.moved = {{0, to}};
        const Picture moved = draw(view);
        ViewState other = view_in(hall_with_crate(there, 0.7), 4.0, 1.0, 0.0);
        other.pictures = view.pictures;
        const Picture stood_there = draw(other);
        const auto differing = [](const Picture& a, const Picture& b) {
            int pixels = 0;
            for (std::size_t i = 0; i < a.rgb.size(); i += 3)
                pixels += std::abs(a.rgb[i] - b.rgb[i]) + std::abs(a.rgb[i + 1] - b.rgb[i + 1]) > 24 ? 1 : 0;
            return pixels;
        };
        EXPECT_GT(differing(stands, moved), plan ? 500 : 8000);
        EXPECT_LT(differing(stood_there, moved), plan ? 40 : 400);
    }
}

TEST_F(RendererTest, tilting_up_brings_the_ceiling_to_the_middle) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    const double ahead = luminance(at(draw(view), {480.5, kMiddle_px}));
    view.tilt_rad = radians_from_degrees(60.0);
    EXPECT_NEAR(luminance(at(draw(view), {480.5, kMiddle_px})), 0.36 * 255.0, 3.0);
    EXPECT_GT(ahead, 150.0);
}

TEST_F(RendererTest, a_new_scene_replaces_the_old_one) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    const double wall = luminance(at(draw(view), {480.5, kMiddle_px}));
    auto with_screen = std::make_shared<Scene>(*view.scene);
    add_box(*with_screen, {2.0, 2.0, 0.0}, {5.0, 2.1, 2.4}, FeatureKind::Door, SolidRole::Mover);
    view.scene = with_screen;
    EXPECT_GT(std::abs(luminance(at(draw(view), {480.5, kMiddle_px})) - wall), 20.0);
}

// Returns the first and the last row below `top_px` that contain a white pixel.
std::pair<int, int> text_rows(const Picture& picture, double top_px) {
    int first = -1, last = -1;
    for (int y = static_cast<int>(top_px); y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (white(picture.at(x, y))) {
                if (first < 0) first = y;
                last = y;
                break;
            }
    return {first, last};
}

TEST_F(RendererTest, the_newest_message_is_on_black_in_letters_of_a_twelfth_of_the_window) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    const Picture silent = draw(view);
    EXPECT_EQ(count(silent, black, kMessagesTop_px, kSize.height).count, kSize.width * (720 - 476));
    view.texts.messages = {"High wall"};
    const auto [first, last] = text_rows(draw(view), kMessagesTop_px);
    ASSERT_GE(first, 0);
    // The white rows reach from the top of H to the bottom of g. In DejaVu Sans, capital height and descender are 0.73
    // + 0.24, and a line is 1.16 high.
    EXPECT_GT(last - first, 0.75 * kTextLinePart * kSize.height);
    EXPECT_LT(last - first, 1.0 * kTextLinePart * kSize.height);
    view.display.text_size = 1.5;
    const WindowLayout large = lay_out_window(kSize, view.pictures, 1.5);
    const auto [top, bottom] = text_rows(draw(view), large.messages.min_px.y);
    EXPECT_GT(bottom - top, 1.3 * (last - first));
}

TEST_F(RendererTest, different_texts_look_different_even_with_accents_and_other_scripts) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    std::vector<Picture> pictures;
    for (const char* text : {"u", "ü", "é", "ł", "ж", "?", "\xEF\xBF\xBD"}) {
        view.texts.messages = {text};
        pictures.push_back(draw(view));
        EXPECT_GT(count(pictures.back(), white, kMessagesTop_px, kSize.height).count, 30) << text;
    }
    for (std::size_t i = 0; i < pictures.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            if (i == 6 && j == 5) continue;  // the font may show an unknown letter as a question mark
            EXPECT_NE(pictures[i].rgb, pictures[j].rgb) << i << " looks like " << j;
        }
}

TEST_F(RendererTest, no_message_of_any_length_covers_the_picture) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    const auto top_part = [&](const Picture& picture) {
        return std::vector<std::uint8_t>(picture.rgb.begin(),
                                         picture.rgb.begin() + 3 * kSize.width * static_cast<int>(kPictureHeight_px));
    };
    const auto before = top_part(draw(view));
    for (const int words : {1, 10, 40, 300}) {
        std::string text;
        for (int i = 0; i < words; ++i) text += "corridor ";
        view.texts.messages.assign(5, text);
        view.texts.hand = view.texts.task = text;
        EXPECT_TRUE(top_part(draw(view)) == before) << words;
    }
}

TEST_F(RendererTest, a_window_of_a_few_pixels_causes_no_crash) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    view.texts.messages = {"Wall, plaster."};
    for (const PixelSize size : {PixelSize{1, 1}, PixelSize{3, 200}, PixelSize{200, 3}, PixelSize{0, 10}})
        for (const bool plan : {false, true}) {
            view.pictures = plan ? Pictures::Plan : Pictures::Both;
            renderer_->draw(view, size);
            renderer_->draw(two_rooms_on_the_plan(), size);
        }
    view.pictures = Pictures::FirstPerson;
    EXPECT_GT(luminance(at(draw(view), {480.5, kMiddle_px})), 100.0);
}

// ---- lists and questions ----

ViewState with_list(std::size_t items, std::size_t at) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    view.dialogue.kind = DialogueView::Kind::List;
    view.dialogue.title = "Worlds";
    for (std::size_t i = 0; i < items; ++i) view.dialogue.items.push_back({fmt::format("World {}", i + 1), "", false});
    view.dialogue.at = at;
    return view;
}

// Returns the rows of the bar behind the chosen item. They are white in a column to the right of the text and to the
// left of the arrows.
std::pair<int, int> bar_rows(const Picture& picture) {
    int first = -1, last = -1;
    for (int y = 95; y < static_cast<int>(kPictureHeight_px); ++y)
        if (white(picture.at(850, y))) {
            if (first < 0) first = y;
            last = y;
        }
    return {first, last};
}

TEST_F(RendererTest, an_open_list_is_in_large_letters_with_the_chosen_item_inverted) {
    const Picture picture = draw(with_list(4, 0));
    const auto [first, last] = bar_rows(picture);
    ASSERT_GE(first, 0);
    EXPECT_EQ(last - first + 1, static_cast<int>(kTextLinePart * kSize.height));
    // The room must not be visible: there must be only black, white, and the greys at the borders of letters.
    EXPECT_EQ(count(picture, [](const Rgb& c) { return c[0] != c[1] || c[1] != c[2]; }).count, 0);
    const auto next = bar_rows(draw(with_list(4, 1)));
    EXPECT_EQ(next.first, first + static_cast<int>(kTextLinePart * kSize.height));
    EXPECT_EQ(next.second - next.first, last - first);
}

TEST_F(RendererTest, the_chosen_item_is_marked_by_a_pointer_as_well_as_by_colour) {
    const Picture picture = draw(with_list(4, 1));
    const auto [first, last] = bar_rows(picture);
    ASSERT_GE(first, 0);
    const auto in_pointers_column = [&](int top, int bottom, auto test) {
        int found = 0;
        for (int y = top; y <= bottom; ++y)
            for (int x = 18; x < 54; ++x) found += test(picture.at(x, y));
        return found;
    };
    EXPECT_GT(in_pointers_column(first, last, black), 300);
    const int line = last - first + 1;
    EXPECT_EQ(in_pointers_column(first - line, last - line, white), 0) << "the item above has none";
    EXPECT_EQ(in_pointers_column(first + line, last + line, white), 0) << "nor the one below";
}

TEST_F(RendererTest, a_long_list_follows_its_chosen_item_and_shows_on_which_side_it_continues) {
    const auto arrow = [&](const Picture& picture, int top, int bottom) {
        int found = 0;
        for (int y = top; y < bottom; ++y)
            for (int x = 905; x < 955; ++x) found += white(picture.at(x, y));
        return found;
    };
    for (const std::size_t at : {0U, 1U, 20U, 38U, 39U}) {
        const Picture picture = draw(with_list(40, at));
        const auto [first, last] = bar_rows(picture);
        ASSERT_GE(first, 0) << at;
        EXPECT_EQ(last - first + 1, static_cast<int>(kTextLinePart * kSize.height)) << at;
        EXPECT_EQ(arrow(picture, 100, 160) > 100, at > 10) << at;
        EXPECT_EQ(arrow(picture, 280, 404) > 100, at < 30) << at;
    }
    const Picture twenty = draw(with_list(40, 19));
    EXPECT_NE(twenty.rgb, draw(with_list(40, 20)).rgb) << "the items and the place are other ones";
}

TEST_F(RendererTest, a_chosen_item_too_long_for_a_line_is_shown_completely) {
    ViewState view = with_list(3, 1);
    view.dialogue.items[1].name = "Keys: give a command another key, or take one away from it again";
    const auto [first, last] = bar_rows(draw(view));
    EXPECT_GE(last - first + 1, 2 * static_cast<int>(kTextLinePart * kSize.height));
    view.dialogue.at = 0;
    const auto other = bar_rows(draw(view));
    EXPECT_EQ(other.second - other.first + 1, static_cast<int>(kTextLinePart * kSize.height));
}

TEST_F(RendererTest, a_question_shows_the_typed_text_with_a_cursor_bar) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    view.dialogue.kind = DialogueView::Kind::Text;
    view.dialogue.title = "What is its name?";
    // The rightmost white pixel inside the frame belongs to the cursor bar after the last letter.
    const auto bar = [&](const std::string& text) {
        view.dialogue.text = text;
        const Picture picture = draw(view);
        for (int x = 935; x > 25; --x)
            for (int y = 110; y < 160; ++y)
                if (white(picture.at(x, y))) return x;
        return -1;
    };
    const int empty = bar(""), one = bar("W"), two = bar("W\u00fc");
    EXPECT_GT(empty, 0);
    EXPECT_GT(one, empty + 20);
    EXPECT_GT(two, one + 20);
    std::string typed(100, 'W');
    const int full = bar(typed);
    EXPECT_GT(full, 850);
    EXPECT_LT(full, 945);
    const Picture without = last_;
    typed.back() = 'i';
    bar(typed);
    EXPECT_NE(without.rgb, last_.rgb) << "of a long line the end is in sight";
}

TEST_F(RendererTest, messages_stay_below_an_open_list_at_any_length) {
    ViewState view = with_list(3, 2);
    const auto before = bar_rows(draw(view));
    std::string text;
    for (int i = 0; i < 100; ++i) text += "corridor ";
    view.texts.messages = {text};
    EXPECT_EQ(bar_rows(draw(view)), before);
    EXPECT_GT(count(last_, white, kMessagesTop_px, kSize.height).count, 1000);
}

TEST_F(RendererTest, lists_in_a_window_of_a_few_pixels_cause_no_crash) {
    for (const PixelSize size :
         {PixelSize{1, 1}, PixelSize{3, 200}, PixelSize{200, 3}, PixelSize{60, 60}, PixelSize{2000, 90}})
        for (ViewState view : {with_list(0, 0), with_list(1, 0), with_list(300, 299)}) {
            renderer_->draw(view, size);
            view.dialogue.kind = DialogueView::Kind::Text;
            view.dialogue.text = "corridor";
            renderer_->draw(view, size);
        }
    EXPECT_GE(bar_rows(draw(with_list(3, 0))).first, 0);
}

TEST(ListWindow, shows_the_chosen_item_and_as_many_others_as_fit) {
    for (std::size_t items = 1; items < 12; ++items)
        for (std::size_t room = 1; room < 9; ++room)
            for (std::size_t at = 0; at < items; ++at)
                for (const std::size_t lines_of_chosen : {std::size_t{1}, std::min<std::size_t>(2, room)}) {
                    std::vector<std::size_t> lines(items, 1);
                    lines[at] = lines_of_chosen;
                    const ListWindow window = list_window(lines, at, room);
                    EXPECT_LE(window.first, at);
                    EXPECT_GT(window.first + window.count, at);
                    EXPECT_EQ(window.count, std::min(items, room - lines_of_chosen + 1))
                        << items << " items, room " << room << ", at " << at;
                    if (items >= 3 && at > 0 && at + 1 < items && room >= lines_of_chosen + 2) {
                        EXPECT_LT(window.first, at) << "a neighbour on either side";
                        EXPECT_GT(window.first + window.count, at + 1);
                    }
                }
    EXPECT_EQ(list_window({}, 0, 5).count, 0U);
}

TEST_F(RendererTest, the_plan_shows_an_arrow_that_turns_with_the_heading) {
    ViewState view = view_in(small_room(), 3.0, 2.0, 0.0);
    view.pictures = Pictures::Plan;
    view.feet_m = view.eyes_m = {3.0, 2.0, 0.0};
    // The feet are in the middle of the room, which is in the middle of the picture.
    const Vec2 feet_px = plan_px(3.0, 2.0);
    const auto tip = [&](double heading_degrees) {
        view.heading_rad = radians_from_degrees(heading_degrees);
        const Picture picture = draw(view);
        Vec2 farthest(0.0);
        int yellows = 0;
        for (int y = 0; y < static_cast<int>(kPictureHeight_px); ++y)
            for (int x = 0; x < picture.width; ++x)
                if (yellow(picture.at(x, y))) {
                    ++yellows;
                    const Vec2 from(x + 0.5 - feet_px.x, y + 0.5 - feet_px.y);
                    if (glm::length(from) > glm::length(farthest)) farthest = from;
                }
        EXPECT_GT(yellows, 150) << heading_degrees;
        return farthest;
    };
    const Vec2 north = tip(0.0), east = tip(90.0), south = tip(180.0);
    EXPECT_LT(north.y, -15.0);
    EXPECT_NEAR(north.x, 0.0, 3.0);
    EXPECT_GT(east.x, 15.0);
    EXPECT_NEAR(east.y, 0.0, 3.0);
    EXPECT_GT(south.y, 15.0);
    view.north_up = false;  // with the heading up, the world turns and the arrow does not
    EXPECT_LT(tip(90.0).y, -15.0);
    EXPECT_LT(tip(200.0).y, -15.0);
}

TEST_F(RendererTest, the_plan_shows_solid_walls_open_doors_and_the_walked_trail) {
    ViewState view = view_in(small_room(), 3.0, 2.0, 0.0);
    view.pictures = Pictures::Plan;
    const Picture before = draw(view);
    const auto px = plan_px;
    const Palette& palette = palette_of(settings::ColourSet::Dark);
    EXPECT_NEAR(luminance(at(before, px(3.0, 4.1))), luminance(palette.wall), 2.0);
    EXPECT_NEAR(luminance(at(before, px(4.0, 3.0))), luminance(palette.inside), 2.0) << "floor";
    EXPECT_TRUE(black(at(before, px(7.0, 2.0)))) << "outside";
    EXPECT_TRUE(black(at(before, px(5.95, 1.6)))) << "a door is not filled";
    EXPECT_EQ(count(before, cyan).count, 0);
    view.path_m = {{3.0, 1.0, 0.0}, {5.0, 1.0, 0.0}, {5.0, 3.0, 0.0}};
    const Picture after = draw(view);
    EXPECT_TRUE(cyan(at(after, px(4.0, 1.0))));
    EXPECT_TRUE(cyan(at(after, px(5.0, 2.0))));
    EXPECT_TRUE(cyan(at(after, px(4.5, 2.75)))) << "from the last step kept to the feet";
    EXPECT_GT(count(before, white).count, 300) << "scale and north";
}

TEST_F(RendererTest, the_plan_shows_outlines_and_names_of_rooms_and_highlights_the_current_one) {
    ViewState view = two_rooms_on_the_plan();
    const Picture with = draw(view);
    const auto px = plan_px;
    const auto whites_across = [&](const Picture& picture, double x_m, double y_m) {
        int whites = 0;
        const Vec2 line = px(x_m, y_m);
        for (int x = static_cast<int>(line.x) - 12; x <= static_cast<int>(line.x) + 12; ++x)
            whites += white(picture.at(x, static_cast<int>(line.y)));
        return whites;
    };
    for (const double y_m : {0.6, 1.2, 2.4, 3.3}) {
        const int here = whites_across(with, 0.25, y_m), beside = whites_across(with, 5.75,
                                                                                y_m > 2.0 && y_m < 3.0 ? 3.0
                                                                                : y_m < 2.0            ? 0.6
                                                                                                       : y_m);
        EXPECT_GE(here, 5) << y_m;
        EXPECT_GE(beside, 1) << y_m;
        EXPECT_GT(here, 2 * beside) << "the room that one is in stands out";
        EXPECT_TRUE(black(at(with, px(0.25, y_m) - Vec2(3.7, 0.0))) || black(at(with, px(0.25, y_m) + Vec2(3.7, 0.0))))
            << "and has a dark border";
    }
    // The name of a room must be black on white in the current room, and white on black elsewhere. The letters are a
    // twentieth of the picture's height.
    const auto colours = [&](const Picture& picture, const Vec2& middle) {
        int whites = 0, blacks = 0;
        for (int y = static_cast<int>(middle.y) - 14; y <= static_cast<int>(middle.y) + 14; ++y)
            for (int x = static_cast<int>(middle.x) - 40; x <= static_cast<int>(middle.x) + 40; ++x) {
                whites += white(picture.at(x, y));
                blacks += black(picture.at(x, y));
            }
        return std::pair(whites, blacks);
    };
    const auto [here_white, here_black] = colours(with, px(1.5, 2.0));
    const auto [there_white, there_black] = colours(with, px(4.5, 2.0));
    EXPECT_GT(here_white, here_black);
    EXPECT_GT(here_black, 150) << "letters";
    EXPECT_GT(there_black, there_white);
    EXPECT_GT(there_white, 150) << "letters";
    // The walker is now in the other room, and nothing else has changed.
    view.room = 1;
    const Picture other = draw(view);
    EXPECT_GT(whites_across(other, 5.75, 0.6), whites_across(other, 0.25, 0.6));
    const auto [now_white, now_black] = colours(other, px(4.5, 2.0));
    EXPECT_GT(now_white, now_black);
    // The plan must not show a room of another storey: without that room, the picture must be the same.
    std::vector<DrawnRoom> storey{(*view.rooms)[0], (*view.rooms)[1]};
    view.rooms = std::make_shared<const std::vector<DrawnRoom>>(std::move(storey));
    EXPECT_EQ(draw(view).rgb, other.rgb);
    // If the session knows no rooms yet, the plan must have no room outlines.
    view.rooms.reset();
    EXPECT_EQ(whites_across(draw(view), 0.25, 0.6), 0);
}

TEST_F(RendererTest, the_plan_separates_room_names_and_always_shows_that_of_the_current_room) {
    ViewState view = two_rooms_on_the_plan();
    std::vector<DrawnRoom> crowd;
    for (int i = 0; i < 40; ++i) {
        crowd.push_back((*view.rooms)[0]);
        crowd.back().area_m2 = 1.0 + i;
    }
    view.rooms = std::make_shared<const std::vector<DrawnRoom>>(crowd);
    view.room = 3;  // one of the smallest rooms
    const Picture many = draw(view);
    view.rooms = std::make_shared<const std::vector<DrawnRoom>>(1, crowd[3]);
    view.room = 0;
    const Picture one = draw(view);
    // The name of the room must be at the same place in the same letters as in the picture with one room.
    for (int y = 278; y <= 302; ++y)
        for (int x = 300; x <= 360; ++x) EXPECT_EQ(many.at(x, y), one.at(x, y)) << x << ", " << y;
}

// Prints the cost of drawing but does not assert it, because the cost depends on the machine.
TEST_F(RendererTest, a_whole_map_is_drawn_without_holes_and_its_cost_reported) {
    const auto maps = with_real_worlds({project_root() / "worlds/maps/school.map"}, {"quake-e1m1.map"});
    const auto path = maps.back();
    auto read = read_world(path);
    ASSERT_TRUE(read.has_value()) << read.error().sentence();
    const auto scene = std::make_shared<const Scene>(std::move(*read));
    const auto seconds =
        [](auto&& work) {  // processor time of all threads, which depends less on the load of the machine
            const std::clock_t begin = std::clock();
            work();
            return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        };
    DrawMesh mesh;
    const double build_s = seconds([&] { mesh = build_draw_mesh(*scene); });
    PlanCut cut;
    const double cut_s = seconds([&] { cut = cut_plan(*scene, scene->starts.at(0).feet_m.z); });

    ViewState view;
    view.scene = scene;
    view.feet_m = scene->starts.at(0).feet_m;
    view.eyes_m = view.feet_m + Vec3(0.0, 0.0, 1.6);
    view.texts.messages = {"The Slipgate Complex."};
    view.show_hand = true;
    const double first_s = seconds([&] { draw(view); });
    constexpr int kFrames = 16;
    double first_person_s = 0.0, plan_s = 0.0;
    for (const bool plan : {false, true})
        for (int i = 0; i < kFrames; ++i) {
            view.pictures = plan ? Pictures::Plan : Pictures::FirstPerson;
            view.heading_rad = scene->starts.at(0).heading_rad + i * 2.0 * kPi / kFrames;
            view.proxy_m = view.eyes_m + 0.5 * forward_of_heading(view.heading_rad);
            (plan ? plan_s : first_person_s) += seconds([&] { draw(view); });
            if (plan) continue;
            // The map is closed. So each direction from the start must show a surface or an outline. Black pixels may
            // only be next to white ones.
            const int holes = count(last_, black).count;
            EXPECT_LT(holes, 0.25 * kSize.width * kPictureHeight_px) << "looking in direction " << i;
        }
    std::cout << fmt::format(
        "{} polygons, {} edges: mesh built in {:.1f} ms, plan cut in {:.1f} ms, first picture {:.1f} ms, then {:.1f} "
        "ms in first person and {:.1f} ms as a "
        "plan "
        "({} by {} pixels, reading back included; processor time of all threads)\n",
        scene->surfaces.size(), mesh.edges.size(), 1e3 * build_s, 1e3 * cut_s, 1e3 * first_s,
        1e3 * first_person_s / kFrames, 1e3 * plan_s / kFrames, kSize.width, kSize.height);
}

}  // namespace renderer_test
}  // namespace handrail::test
