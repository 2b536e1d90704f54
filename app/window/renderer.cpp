#include "app/window/renderer.h"

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>

#include "app/window/draw_plan.h"
#include "app/window/first_person.h"
#include "app/window/large_text.h"
#include "app/window/uploaded_scene.h"
#include "worlds/base/language.h"

namespace handrail::window {
namespace {

constexpr float kFontBaked_px = 64.0F;
// Height of names in the pictures, as a part of that of small text.
constexpr float kPlanTextPart = 0.8F;

// Loads a bold font with Latin letters from the folders in which Debian and related systems install such fonts. If
// there is none, enlarges ImGui's own small font.
ImFont* load_font(ImFontAtlas& atlas) {
    // Ranges of characters for the names in European buildings: Latin with its extensions, general punctuation, Greek
    // and Cyrillic.
    static constexpr std::array<ImWchar, 9> kRanges{0x20, 0x24F, 0x370, 0x3FF, 0x400, 0x45F, 0x2010, 0x2030, 0};
    for (const char* path :
         {"/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
          "/usr/share/fonts/truetype/liberation/LiberationSans-Bold.ttf",
          "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf", "/usr/share/fonts/TTF/DejaVuSans-Bold.ttf",
          "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans-Bold.ttf"}) {
        std::error_code none;
        if (!std::filesystem::is_regular_file(path, none)) continue;
        ImFontConfig config;
        config.OversampleH = 1;  // off, because letters are rasterised at about the size at which they are shown
        config.OversampleV = 1;
        if (ImFont* font = atlas.AddFontFromFileTTF(path, kFontBaked_px, &config, kRanges.data())) return font;
    }
    return atlas.AddFontDefault();
}

}  // namespace

class Renderer::Impl {
public:
    Result<void> start() {
        if (auto started = first_person_.start(); !started) return started;
        imgui_ = ImGui::CreateContext();
        ImGui::SetCurrentContext(imgui_);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;  // ImGui saves no settings file, because Handrail needs none of these settings
        font_ = load_font(*io.Fonts);
        if (!ImGui_ImplOpenGL3_Init("#version 330 core")) return fail(phrase("window.driver_no_text"));
        imgui_drawing_ = true;
        return {};
    }

    ~Impl() {
        if (!imgui_) return;
        ImGui::SetCurrentContext(imgui_);
        if (imgui_drawing_) ImGui_ImplOpenGL3_Shutdown();
        ImGui::DestroyContext(imgui_);
    }

    void draw(const core::ViewState& view, PixelSize size) {
        if (size.width < 1 || size.height < 1) return;
        glViewport(0, 0, size.width, size.height);
        glDisable(GL_SCISSOR_TEST);
        glDepthMask(GL_TRUE);
        const Palette& palette = palette_of(view.display.colours);
        glClearColor(static_cast<float>(palette.ground[0]) / 255.0F, static_cast<float>(palette.ground[1]) / 255.0F,
                     static_cast<float>(palette.ground[2]) / 255.0F, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (view.scene && (!uploaded_ || uploaded_->scene() != view.scene.get())) {
            uploaded_.reset();
            uploaded_ = std::make_unique<UploadedScene>(view.scene);
            plan_.forget_scene();
        }

        ImGui::SetCurrentContext(imgui_);
        ImGui::GetIO().DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
        ImGui_ImplOpenGL3_NewFrame();
        ImGui::NewFrame();
        const WindowLayout layout = lay_out_window(size, view.pictures, view.display.text_size);
        ImDrawList& texts = *ImGui::GetForegroundDrawList();
        // An open list or question covers the pictures, because a person who reads a list does not need them.
        if (view.dialogue.kind != core::DialogueView::Kind::None)
            draw_dialogue(texts, *font_, view.dialogue, {0.0F, 0.0F},
                          {static_cast<float>(layout.pictures.max_px.x), static_cast<float>(layout.pictures.max_px.y)},
                          layout.line_px, palette);
        else if (view.scene) draw_pictures(view, layout, size);
        const std::array<std::string, 2> status{view.texts.hand, view.texts.task};
        draw_status(texts, *font_, status, layout, palette);
        draw_messages(texts, *font_, view.texts.messages, layout, palette);
        ImGui::Render();
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    }

private:
    void draw_pictures(const core::ViewState& view, const WindowLayout& layout, PixelSize size) {
        if (!is_empty(layout.plan)) plan_.draw(view, *font_, layout.plan, kPlanTextPart * layout.small_px);
        if (!is_empty(layout.first_person))
            first_person_.draw(view, *uploaded_, layout.first_person, size, *font_, kPlanTextPart * layout.small_px);
    }

    FirstPerson first_person_;
    PlanDrawing plan_;
    std::unique_ptr<UploadedScene> uploaded_;
    ImGuiContext* imgui_ = nullptr;
    ImFont* font_ = nullptr;
    bool imgui_drawing_ = false;
};

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create() {
    if (epoxy_gl_version() < 33) return fail(phrase("window.driver_no_opengl"));
    auto impl = std::make_unique<Impl>();
    if (auto started = impl->start(); !started) return tl::unexpected(started.error());
    return std::unique_ptr<Renderer>(new Renderer(std::move(impl)));
}

void Renderer::draw(const core::ViewState& view, PixelSize size) { impl_->draw(view, size); }

Picture Renderer::read_back(PixelSize size) {
    Picture picture{size.width, size.height, {}};
    const std::size_t row = 3 * static_cast<std::size_t>(size.width), rows = static_cast<std::size_t>(size.height);
    std::vector<std::uint8_t> from_below(row * rows);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, from_below.data());
    picture.rgb.reserve(from_below.size());
    for (std::size_t y = rows; y-- > 0;)
        picture.rgb.insert(picture.rgb.end(), from_below.begin() + static_cast<std::ptrdiff_t>(y * row),
                           from_below.begin() + static_cast<std::ptrdiff_t>((y + 1) * row));
    return picture;
}

}  // namespace handrail::window
