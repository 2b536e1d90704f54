// Draws whole windows of real sessions at several sizes, and checks what they show: the route, the beacon, marks, the
// hand with its force, the state and the messages. Saves the pictures under build/.../pictures, for people to look at.
#include <cstdlib>
#include <filesystem>

#include "app/core/session/headless_session.h"
#include "app/window/large_text.h"
#include "app/window/palette.h"
#include "app/window/renderer.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "haptic/device/device_spec.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/worlds_once.h"
#include "tests/window/offscreen_gl.h"
#include "tests/window/small_room.h"

namespace handrail::test {
namespace pictures_test {

// Returns the sizes of screens to try. A large picture takes seconds without a graphics card, so it is drawn only with
// HANDRAIL_LARGE_PICTURES=1.
std::vector<PixelSize> sizes() {
    std::vector<PixelSize> sizes{{800, 600}, {1280, 720}, {1920, 1080}};
    if (std::getenv("HANDRAIL_LARGE_PICTURES")) sizes.push_back({3840, 2160});
    return sizes;
}

HandFacts falcon() {
    HandFacts facts;
    facts.present = true;
    facts.spec = *device::find_device_spec("falcon");
    return facts;
}

// A person with a hand device in one of our worlds.
class Explorer {
public:
    explicit Explorer(const char* world) {
        session_.app().apply(WorldEntered{make_ready(world_once(project_root() / "worlds" / "maps" / world))}, 0.0);
        type({});
    }
    void type(const std::string& line) {
        if (!line.empty()) session_.type(line);
        for (int quiet_ms = 0; quiet_ms < 500 && session_.now_s() < 120.0; ++quiet_ms) {
            session_.advance();
            if (!session_.lines().done() || !session_.app().idle()) quiet_ms = 0;
        }
    }
    // Moves the hand slowly to this place in the device frame, and holds it there.
    void move_hand(const Vec3& to_m) {
        HandCommand command;
        command.mode = device::HandMode::Move;
        command.target_m = to_m;
        command.speed_m_per_s = 0.05;
        session_.hand().command.publish(command);
        type({});
        for (int i = 0; i < 2000; ++i) session_.advance();
    }
    ViewState view() {
        ViewState view = session_.app().view(session_.tool());
        const auto& lines = speech_.lines();
        for (std::size_t i = lines.size() - std::min(lines.size(), kShownMessages); i < lines.size(); ++i)
            view.texts.messages.push_back(lines[i].utterance.text);
        return view;
    }
    Session& app() { return session_.app(); }
    double now_s() const { return session_.now_s(); }

private:
    RecordingAudio audio_;
    RecordingSpeech speech_;
    HeadlessSession session_{Settings{}, falcon(), audio_, speech_};
};

class Pictures : public ::testing::Test {
protected:
    Picture draw(const ViewState& view, PixelSize size, const std::string& name) {
        auto gl = OffscreenGl::open(size);
        if (!gl) return {};
        auto renderer = Renderer::create();
        EXPECT_TRUE(renderer);
        Picture picture = gl->draw(**renderer, view);
        const auto folder = build_root() / "pictures";
        std::filesystem::create_directories(folder);
        EXPECT_TRUE(save_png(picture, folder / fmt::format("{}-{}x{}.png", name, size.width, size.height)));
        renderer->reset();
        return picture;
    }
    void SetUp() override {
        if (!OffscreenGl::open({8, 8})) GTEST_SKIP() << "this machine cannot draw without a display (EGL surfaceless)";
    }
};

// Returns how many pixels in the box are close to the colour.
int pixels_of(const Picture& picture, const Rgb& colour, const PixelBox& box, int off = 6) {
    int found = 0;
    for (int y = static_cast<int>(box.min_px.y); y < static_cast<int>(box.max_px.y); ++y)
        for (int x = static_cast<int>(box.min_px.x); x < static_cast<int>(box.max_px.x); ++x) {
            const Rgb at = picture.at(x, y);
            bool close = true;
            for (std::size_t i = 0; i < 3; ++i) close = close && std::abs(at[i] - colour[i]) <= off;
            found += close;
        }
    return found;
}

// The newest message is in letters of the promised height, and the text has the contrast of its two colours.
void check_texts(const Picture& picture, const ViewState& view, const WindowLayout& layout) {
    const Palette& palette = palette_of(view.display.colours);
    const PixelBox newest{layout.messages.min_px,
                          Vec2(layout.messages.max_px.x, layout.messages.min_px.y + layout.line_px)};
    EXPECT_GT(pixels_of(picture, palette.text, newest), 100);
    EXPECT_GT(pixels_of(picture, palette.ground, newest), 100);
    EXPECT_GT(pixels_of(picture, palette.text, layout.status), 100);
    for (const PixelBox& box : {layout.messages, layout.status})
        EXPECT_GE(pixels_of(picture, palette.text, box) + pixels_of(picture, palette.ground, box),
                  0.8 * (box.max_px.x - box.min_px.x) * (box.max_px.y - box.min_px.y))
            << "texts are drawn in these two colours only, apart from the borders of letters";
}

TEST_F(Pictures, of_a_route_in_the_school_show_route_beacon_mark_hand_and_texts) {
    Explorer person("school.map");
    person.type("mark");
    person.type("Meeting point");
    person.type("route to library");
    person.app().guide().call_from({"Library", point_box(person.app().guide().way_m().back()), kNoFeature});
    person.move_hand({0.03, 0.04, 0.0});
    const ViewState view = person.view();
    ASSERT_GE(view.guidance.route_m.size(), 2U);
    ASSERT_EQ(view.guidance.marks.size(), 1U);
    EXPECT_FALSE(view.texts.hand.empty());
    EXPECT_THAT(view.texts.task, ::testing::HasSubstr("Route: "));
    for (const PixelSize size : sizes()) {
        const Picture picture = draw(view, size, "school-route");
        const WindowLayout layout = lay_out_window(size, view.pictures, view.display.text_size);
        check_texts(picture, view, layout);
        const Palette& palette = palette_of(view.display.colours);
        for (const auto& [name, colour] :
             {std::pair("inside", palette.inside), std::pair("outside", palette.outside),
              std::pair("wall", palette.wall), std::pair("route and walker", palette.route)})
            EXPECT_GT(pixels_of(picture, colour, layout.plan), 50) << name << " at " << size.width;
    }
}

// The plan shows one storey, so the route ends on the picture where the person leaves the storey.
TEST_F(Pictures, of_a_route_to_another_storey_name_its_goal_where_the_route_leaves_the_storey) {
    Explorer person("house.map");
    person.type("route to bedroom");
    const double floor_m = person.view().feet_m.z;
    std::vector<Vec3> whole_m = person.app().guide().way_m();
    ASSERT_GT(std::abs(whole_m.back().z - floor_m), 2.0) << "the bedroom is on another storey";
    const ViewState below = person.view();
    ASSERT_TRUE(below.guidance.goal);
    EXPECT_EQ(below.guidance.goal->name, "Bedroom, upstairs");
    EXPECT_EQ(below.guidance.goal->place_m, below.guidance.route_m.back());
    for (const Vec3& at_m : below.guidance.route_m) EXPECT_LE(std::abs(at_m.z - floor_m), 1.51);
    EXPECT_EQ(below.guidance.route_m.front(), whole_m.front());
    person.app().apply(Placed{whole_m.back(), 0.0}, person.now_s());
    const ViewState above = person.view();
    ASSERT_TRUE(above.guidance.goal);
    EXPECT_EQ(above.guidance.goal->name, "Bedroom");
    for (const Vec3& at_m : above.guidance.route_m) EXPECT_LE(std::abs(at_m.z - whole_m.back().z), 1.51);
}

TEST_F(Pictures, of_a_beacon_alone_show_no_route_that_has_ended) {
    Explorer person("house.map");
    person.type("route to kitchen");
    EXPECT_FALSE(person.view().guidance.route_m.empty());
    EXPECT_TRUE(person.view().guidance.goal);
    person.app().guide().leave_route();
    person.app().guide().call_from({"Here", point_box(person.view().feet_m + Vec3(3.0, 0.0, 0.0)), kNoFeature});
    const ViewState view = person.view();
    EXPECT_TRUE(view.guidance.beacon);
    EXPECT_TRUE(view.guidance.route_m.empty());
    EXPECT_FALSE(view.guidance.goal);
    EXPECT_EQ(view.texts.task, "");
}

TEST_F(Pictures, of_a_hand_at_a_wall_show_its_force_in_newtons) {
    Explorer person("first_room.map");
    person.move_hand({0.0, 0.08, 0.0});
    const ViewState view = person.view();
    ASSERT_TRUE(view.touching) << view.texts.hand;
    EXPECT_GT(glm::length(view.force_n), 0.05);
    EXPECT_THAT(view.texts.hand, ::testing::HasSubstr("newtons"));
    ViewState still = view;
    still.force_n = Vec3(0.0);
    for (const PixelSize size : sizes()) {
        const WindowLayout layout = lay_out_window(size, view.pictures, 1.0);
        const Picture with = draw(view, size, "hand-at-wall"), without = draw(still, size, "hand-without-force");
        const Palette& palette = palette_of(view.display.colours);
        for (const PixelBox& box : {layout.plan, layout.first_person})
            EXPECT_GT(pixels_of(with, palette.force, box), pixels_of(without, palette.force, box) + 20);
        check_texts(with, view, layout);
    }
}

TEST_F(Pictures, of_a_lesson_show_what_it_asks_for) {
    Explorer person("first_room.map");
    person.type("lessons");
    person.type("1");
    const ViewState view = person.view();
    const std::string& asked = view.texts.messages.back();
    EXPECT_FALSE(view.texts.task.empty());
    EXPECT_THAT(asked, ::testing::HasSubstr(view.texts.task)) << "what was said last";
    draw(view, {1280, 720}, "lesson");
}

TEST_F(Pictures, in_each_set_of_colours_and_text_size_keep_their_contrast) {
    Explorer person("house.map");
    person.type("route to kitchen");
    person.move_hand({0.02, 0.03, -0.01});
    for (const auto& [name, set] :
         {std::pair("dark", settings::ColourSet::Dark), std::pair("light", settings::ColourSet::Light),
          std::pair("high-contrast", settings::ColourSet::HighContrast),
          std::pair("colour-safe", settings::ColourSet::ColourSafe)})
        for (const double text_size : {1.0, 1.5}) {
            ViewState view = person.view();
            view.display.colours = set;
            view.display.text_size = text_size;
            const PixelSize size{1280, 720};
            const Picture picture = draw(view, size, fmt::format("house-{}-{}", name, text_size));
            check_texts(picture, view, lay_out_window(size, view.pictures, text_size));
        }
}

TEST_F(Pictures, with_high_contrast_are_black_white_and_yellow) {
    Explorer person("house.map");
    ViewState view = person.view();
    view.display.colours = settings::ColourSet::HighContrast;
    const PixelSize size{1280, 720};
    const Picture picture = draw(view, size, "house-bare");
    const PixelBox all{Vec2(0.0), Vec2(size.width, size.height)};
    const int pure = pixels_of(picture, {0, 0, 0}, all) + pixels_of(picture, {255, 255, 255}, all) +
                     pixels_of(picture, {255, 255, 0}, all);
    EXPECT_GT(pure, 0.93 * size.width * size.height) << "the rest is at the borders of letters and lines";
    for (int y = 0; y < size.height; y += 3)
        for (int x = 0; x < size.width; x += 3) {
            const Rgb at = picture.at(x, y);
            EXPECT_EQ(at[0], at[1]) << x << ", " << y << ": mixtures of the three colours have as much red as green";
        }
}

TEST_F(Pictures, show_a_hand_behind_the_person_in_an_inset) {
    ViewState view = view_in(small_room(), 3.0, 1.0, 0.0);
    view.show_hand = true;
    view.proxy_m = view.eyes_m + Vec3(0.3, 1.0, -0.2);
    const PixelSize size{960, 720};
    const WindowLayout layout = lay_out_window(size, view.pictures, 1.0);
    const Vec2 third = (layout.first_person.max_px - layout.first_person.min_px) / 3.0;
    const PixelBox corner{Vec2(layout.first_person.max_px.x - third.x, layout.first_person.min_px.y),
                          Vec2(layout.first_person.max_px.x, layout.first_person.min_px.y + third.y)};
    const Picture ahead = draw(view, size, "hand-ahead");
    view.proxy_m = view.eyes_m + Vec3(0.3, -0.6, -0.2);
    const Picture behind = draw(view, size, "hand-behind");
    const auto greens = [&](const Picture& picture, const PixelBox& box) {
        int found = 0;
        for (int y = static_cast<int>(box.min_px.y); y < static_cast<int>(box.max_px.y); ++y)
            for (int x = static_cast<int>(box.min_px.x); x < static_cast<int>(box.max_px.x); ++x)
                found += picture.at(x, y)[1] > 140 && picture.at(x, y)[0] < 60 && picture.at(x, y)[2] < 90;
        return found;
    };
    EXPECT_GT(greens(ahead, layout.first_person), 50);
    EXPECT_EQ(greens(ahead, corner), 0);
    EXPECT_GT(greens(behind, corner), 100);
}

TEST_F(Pictures, of_the_plan_fit_the_storey_the_room_or_the_surroundings) {
    Explorer person("house.map");
    ViewState view = person.view();
    view.pictures = core::Pictures::Plan;
    std::vector<double> scales;
    for (const auto& [name, scale] :
         {std::pair("building", NamedScale::Building), std::pair("storey", NamedScale::Floor),
          std::pair("room", NamedScale::Room), std::pair("detail", NamedScale::Detail)}) {
        view.plan_scale = scale;
        const PixelSize size{1280, 720};
        draw(view, size, fmt::format("house-plan-{}", name));
        const WindowLayout layout = lay_out_window(size, view.pictures, 1.0);
        const PlanLayout plan = lay_out_plan(plan_extent(view), view.feet_m, view.heading_rad, true, layout.plan);
        scales.push_back(plan.pixels_per_m);
        const Vec2 feet = plan.to_pixels(view.feet_m);
        EXPECT_TRUE(feet.x > layout.plan.min_px.x && feet.x < layout.plan.max_px.x && feet.y > layout.plan.min_px.y &&
                    feet.y < layout.plan.max_px.y)
            << name;
        if (scale != NamedScale::Room) continue;
        for (const auto& loop : (*view.rooms)[view.room].outline.loops_m)
            for (const Vec2& corner : loop) {
                const Vec2 at = plan.to_pixels(corner);
                EXPECT_TRUE(at.x > layout.plan.min_px.x && at.x < layout.plan.max_px.x && at.y > layout.plan.min_px.y &&
                            at.y < layout.plan.max_px.y);
            }
    }
    EXPECT_NEAR(scales[1], scales[0], 0.1 * scales[0]) << "the garden belongs to the storey";
    EXPECT_LT(scales[0], scales[2]);
    EXPECT_LT(scales[2], scales[3]);
}

TEST_F(Pictures, of_the_plan_dot_visited_rooms_and_tint_the_inside) {
    ViewState view = two_rooms_on_the_plan();
    const PixelSize size{960, 720};
    const WindowLayout layout = lay_out_window(size, view.pictures, 1.0);
    const Palette& palette = palette_of(view.display.colours);
    const Picture neither = draw(view, size, "rooms-not-visited");
    view.visited = {true, false, false};
    const Picture one = draw(view, size, "rooms-one-visited");
    EXPECT_GT(pixels_of(one, palette.room_outline, layout.plan),
              pixels_of(neither, palette.room_outline, layout.plan) + 50);
    EXPECT_GT(pixels_of(neither, palette.inside, layout.plan), 20000);
    auto rooms = *view.rooms;
    for (DrawnRoom& room : rooms) room.outside = true;
    view.rooms = std::make_shared<const std::vector<DrawnRoom>>(rooms);
    EXPECT_LT(pixels_of(draw(view, size, "rooms-outside"), palette.inside, layout.plan), 100);
}

TEST_F(Pictures, of_a_labyrinth_fill_the_plan) {
    Explorer person("labyrinth1.map");
    ViewState view = person.view();
    view.pictures = core::Pictures::Plan;
    const WindowLayout layout = lay_out_window({1280, 720}, view.pictures, 1.0);
    ASSERT_TRUE(view.camera_m);
    const PlanLayout plan = lay_out_plan(plan_extent(view), *view.camera_m, view.heading_rad, true, layout.plan);
    const Vec3 size_px = plan.pixels_per_m * plan_extent(view).bounds_m.size_m();
    EXPECT_GT(std::min(size_px.x / (layout.plan.max_px.x - layout.plan.min_px.x),
                       size_px.y / (layout.plan.max_px.y - layout.plan.min_px.y)),
              0.9)
        << "along both axes";
    const Palette& palette = palette_of(view.display.colours);
    view.plan_scale = core::NamedScale::Building;
    const Picture whole = draw(view, {1280, 720}, "labyrinth");
    EXPECT_GT(pixels_of(whole, palette.beacon, layout.plan), 50) << "the goal";
    // Without colour, the ball is a bright disc with a dark dot in its middle.
    const PlanLayout all = lay_out_plan(plan_extent(view), *view.camera_m, view.heading_rad, true, layout.plan);
    const Vec2 ball_px = all.to_pixels(*view.camera_m);
    const auto around_ball = [&](double from_px, double to_px) {
        return PixelBox{ball_px + Vec2(from_px, -2.0), ball_px + Vec2(to_px, 2.0)};
    };
    const double radius_px = 0.05 * all.pixels_per_m;
    EXPECT_GT(pixels_of(whole, palette.ground, around_ball(-2.0, 2.0)), 4) << "the dot";
    EXPECT_GT(pixels_of(whole, palette.text, around_ball(0.45 * radius_px, 0.9 * radius_px)), 4) << "the disc";
}

TEST_F(Pictures, of_a_labyrinth_follow_the_camera_up_to_the_edge_of_the_table) {
    Explorer person("labyrinth1.map");
    ViewState view = person.view();
    const PixelBox box{Vec2(0.0), Vec2(300.0, 700.0)};
    const Aabb table = plan_extent(view).bounds_m;
    for (const double share : {0.0, 0.5, 1.0}) {
        const Vec3 at = table.min_m + share * table.size_m();
        const PlanLayout plan = lay_out_plan(plan_extent(view), at, 0.0, true, box);
        const double half_m = 0.5 * 300.0 / plan.pixels_per_m;
        EXPECT_GE(plan.centre_m.x - half_m, table.min_m.x - 1e-9);
        EXPECT_LE(plan.centre_m.x + half_m, table.max_m.x + 1e-9);
        EXPECT_TRUE(share != 0.5 || std::abs(plan.centre_m.x - at.x) < 1e-9);
    }
}

}  // namespace pictures_test
}  // namespace handrail::test
