#include "tests/unit/sentences/text_session.h"

#include "tests/support/names.h"
#include "tests/support/worlds_once.h"
#include "worlds/base/language.h"
#include "worlds/base/typist.h"

namespace handrail::test {
namespace {

constexpr double kQuiet_s = 0.4;       // if nothing happens for this long, the session is treated as quiet
constexpr double kLongestWalk_s = 60;  // every walk ends within this time

Settings text_settings() {
    Settings settings;
    settings.speech.language = std::string(spoken_language());
    return settings;
}

}  // namespace

TextSession::TextSession(std::shared_ptr<const Scene> world, bool first_start)
    : session_(text_settings(), HandFacts{}, audio_, speech_, with_known_rooms()) {
    speak_to(ActsBy::Lines);
    if (first_start) session_.app().apply(FirstMinutesBegun{phrase("voice.text_alone"), false}, 0.0);
    session_.app().apply(WorldEntered{make_ready(std::move(world))}, 0.0);
    settle();
    greeting_ = take();
}

TextSession::~TextSession() { speak_to(ActsBy::WindowKeys); }

void TextSession::settle() {
    const double begun_s = session_.now_s();
    for (double quiet_since_s = begun_s; session_.now_s() < begun_s + kLongestWalk_s;) {
        session_.advance();
        if (!session_.lines().done() || !session_.app().idle()) quiet_since_s = session_.now_s();
        if (session_.now_s() - quiet_since_s >= kQuiet_s) return;
    }
}

std::vector<std::string> TextSession::take() {
    std::vector<std::string> said;
    for (; taken_ < speech_.lines().size(); ++taken_) said.push_back(speech_.lines()[taken_].utterance.text);
    return said;
}

std::vector<std::string> TextSession::type(const std::string& line) {
    session_.type(line);
    settle();
    return take();
}

}  // namespace handrail::test
