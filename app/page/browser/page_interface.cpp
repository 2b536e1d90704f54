// The C interface through which the page's worker calls the session. Texts are UTF-8. A returned text is valid until
// the next call.
#include <emscripten.h>

#include <optional>
#include <string>

#include "app/page/page_session.h"
#include "worlds/base/typist.h"

namespace {

using namespace handrail;

std::unique_ptr<page::PageSession> running;
std::string returned;

const char* give(std::string text) {
    returned = std::move(text);
    return returned.c_str();
}
double now_s() { return running->session().now_s(); }

}  // namespace

extern "C" {

// Begins a session in a packed world. `typed`: the person types lines, so texts name words instead of keys. Keys act as
// in a terminal: steps are counted in words, because a page has no sound of footsteps. Returns a sentence if the world
// cannot be entered, or an empty text.
EMSCRIPTEN_KEEPALIVE const char* page_begin(const char* scene, int scene_size, const char* navigation,
                                            int navigation_size, const char* language, int typed) {
    speak_to(typed != 0 ? ActsBy::Lines : ActsBy::TerminalKeys);
    if (const auto spoken = speak_language(language); !spoken) return give(spoken.error().sentence());
    auto made = page::PageSession::begin({scene, static_cast<std::size_t>(scene_size)},
                                         {navigation, static_cast<std::size_t>(navigation_size)});
    if (!made) return give(made.error().sentence());
    running = std::move(*made);
    return give("");
}
// Carries out a typed line after the lines before it.
EMSCRIPTEN_KEEPALIVE void page_line(const char* line) { running->session().type(line); }
// Presses and releases a key by its name, such as "Shift+F2". Returns 0 if the key has no meaning.
EMSCRIPTEN_KEEPALIVE int page_key(const char* name) { return running->session().tap_key(name); }
// Types characters into an open list or question. Returns 0 if nothing is open.
EMSCRIPTEN_KEEPALIVE int page_text(const char* utf8) {
    return running->session().app().apply(core::TextTyped{utf8}, now_s());
}
// Chooses an item of the open list (`act` 0), or makes an adjustable one less (1) or more (2).
EMSCRIPTEN_KEEPALIVE int page_item(int act, int item, const char* name) {
    using Kind = core::ItemAct::Kind;
    const Kind kind = act == 1 ? Kind::Less : act == 2 ? Kind::More : Kind::Choose;
    return running->session().app().apply(core::ItemActed{{kind, static_cast<std::size_t>(item), name}}, now_s());
}
// Advances the session. Returns 0 if nothing is under way any more.
EMSCRIPTEN_KEEPALIVE int page_advance(int ms) { return running->advance(ms); }
EMSCRIPTEN_KEEPALIVE const char* page_said() { return give(running->take_said()); }
EMSCRIPTEN_KEEPALIVE const char* page_view() { return give(running->view()); }
EMSCRIPTEN_KEEPALIVE const char* page_commands() { return give(page::commands_json()); }
}
