#include "tests/unit/sentences/text_session.h"

#include "app/terminal/terminal.h"
#include "worlds/base/language.h"
#include "worlds/base/typist.h"

namespace handrail::test {
namespace {

constexpr double kQuiet_s = 0.4;       // so long nothing is on its way
constexpr double kLongestWalk_s = 60;  // until then it is over

Settings text_settings() {
    Settings settings;
    settings.speech.language = std::string(spoken_language());
    return settings;
}

bool counts_by_itself(Command command) {
    return command == Command::Forward || command == Command::Back || command == Command::TurnLeft ||
           command == Command::TurnRight || command == Command::TrailLeft || command == Command::TrailRight ||
           command == Command::Retrace;
}

}  // namespace

TextSession::TextSession(std::shared_ptr<const Scene> world, bool first_start)
    : session_(text_settings(), HandFacts{}, audio_, speech_) {
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
        if (!session_.app().idle()) quiet_since_s = session_.now_s();
        if (session_.now_s() - quiet_since_s >= kQuiet_s) return;
    }
}

std::vector<std::string> TextSession::take() {
    std::vector<std::string> said;
    for (; taken_ < speech_.lines().size(); ++taken_) said.push_back(speech_.lines()[taken_].utterance.text);
    return said;
}

std::vector<std::string> TextSession::type(const std::string& line) {
    Session& app = session_.app();
    const double now_s = session_.now_s();
    const auto parsed = parse_terminal_line(line);
    const std::string word = parsed && parsed->command ? std::string(info(*parsed->command).word) : line;
    if (!app.apply(LineTyped{line}, now_s) && !(word != line && app.apply(LineTyped{word}, now_s))) {
        if (!parsed) return {parsed.error().message};
        if (parsed->command) {
            const bool counts = counts_by_itself(*parsed->command);
            for (int i = 0; i < (counts ? 1 : parsed->times); ++i) {
                app.apply(CommandDown{*parsed->command, counts ? parsed->times : 1}, session_.now_s());
                app.apply(CommandUp{*parsed->command}, session_.now_s());
                if (!counts) settle();
            }
            if (!parsed->choice.empty()) {
                settle();
                if (app.dialogue().is_open()) app.apply(LineTyped{parsed->choice}, session_.now_s());
            }
        }
    }
    settle();
    return take();
}

}  // namespace handrail::test
