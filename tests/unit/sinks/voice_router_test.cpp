#include "audio-cues/sinks/voice_router.h"
#include "tests/support/names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace handrail {
namespace voice_router_test {

using testing::ElementsAre;
using testing::IsEmpty;

// A voice that the test controls. Logs what it received.
class PlayedVoice final : public Voice {
public:
    explicit PlayedVoice(SpeechThrough through) : through_(through) {}
    SpeechThrough through() const override { return through_; }
    VoiceState state() const override { return wanted ? is : VoiceState::Unavailable; }
    void want(bool w) override { wanted = w; }
    void say(const Utterance& utterance) override {
        said.push_back(utterance.text);
        busy = true;
    }
    void stop() override {
        ++stops;
        busy = false;
    }
    bool speaking() const override { return busy && is == VoiceState::Ready; }

    VoiceState is = VoiceState::Ready;
    bool wanted = false, busy = false;
    int stops = 0;
    std::vector<std::string> said;

private:
    SpeechThrough through_;
};

class PlayedLine final : public BrailleSink {
public:
    void want(bool w) override { wanted = w; }
    void say(const Utterance& utterance) override { write(utterance); }
    void write(const Utterance& utterance) override { lines.push_back(utterance.text); }
    void stop() override {}
    bool speaking() const override { return false; }

    bool wanted = true;
    std::vector<std::string> lines;
};

struct VoiceRouterTest : testing::Test {
    void open(SpeechThrough through = SpeechThrough::Auto) {
        settings.through = through;
        auto r = std::make_unique<PlayedVoice>(SpeechThrough::ScreenReader);
        auto s = std::make_unique<PlayedVoice>(SpeechThrough::SpeechDispatcher);
        auto e = std::make_unique<PlayedVoice>(SpeechThrough::Embedded);
        auto t = std::make_unique<PlayedLine>();
        auto b = std::make_unique<PlayedLine>();
        reader = r.get(), server = s.get(), embedded = e.get(), text = t.get(), braille = b.get();
        reader->is = reader_at_first;
        server->is = server_at_first;
        std::vector<std::unique_ptr<Voice>> voices;
        voices.push_back(std::move(r));
        voices.push_back(std::move(s));
        voices.push_back(std::move(e));
        router = std::make_unique<VoiceRouter>(std::move(voices), std::move(t), std::move(b), settings);
    }
    void tick(double by_s = 0.005) { router->tick(now_s += by_s); }
    std::vector<std::vector<std::string>> heard() const { return {reader->said, server->said, embedded->said}; }

    Settings::Speech settings;
    VoiceState reader_at_first = VoiceState::Unavailable, server_at_first = VoiceState::Ready;
    PlayedVoice *reader = nullptr, *server = nullptr, *embedded = nullptr;
    PlayedLine *text = nullptr, *braille = nullptr;
    std::unique_ptr<VoiceRouter> router;
    double now_s = 10.0;
};

TEST_F(VoiceRouterTest, only_the_best_voice_speaks_while_text_and_braille_get_everything) {
    open();
    tick();
    router->say({.text = "Welcome"});
    EXPECT_THAT(heard(), ElementsAre(IsEmpty(), ElementsAre("Welcome"), IsEmpty()));
    EXPECT_THAT(text->lines, ElementsAre("Welcome"));
    EXPECT_THAT(braille->lines, ElementsAre("Welcome"));
    EXPECT_FALSE(router->news()) << "the first choice is no news";
}

TEST_F(VoiceRouterTest, a_screen_reader_gets_speech_and_braille_exclusively) {
    reader_at_first = VoiceState::Ready;
    open();
    tick();
    router->say({.text = "Welcome"});
    EXPECT_THAT(heard(), ElementsAre(ElementsAre("Welcome"), IsEmpty(), IsEmpty()));
    EXPECT_FALSE(braille->wanted);
}

TEST_F(VoiceRouterTest, the_first_words_wait_a_second_for_an_opening_voice_and_then_go_to_the_next) {
    server_at_first = VoiceState::Opening;
    open();
    tick();
    router->say({.text = "Welcome"});
    EXPECT_TRUE(router->speaking()) << "still to be said";
    EXPECT_THAT(text->lines, ElementsAre("Welcome")) << "text waits for nobody";
    tick(0.9);
    EXPECT_THAT(heard(), ElementsAre(IsEmpty(), IsEmpty(), IsEmpty()));
    tick(0.2);
    EXPECT_THAT(heard(), ElementsAre(IsEmpty(), IsEmpty(), ElementsAre("Welcome")));
    EXPECT_THAT(text->lines, ElementsAre("Welcome"));
}

TEST_F(VoiceRouterTest, the_next_voice_explains_the_loss_and_speaks_what_the_lost_voice_left) {
    open();
    tick();
    router->say({.text = "You are at the base"});
    server->is = VoiceState::Unavailable;
    tick();
    ASSERT_EQ(router->news(), "The speech server is no longer available; speech now uses the built-in voice.");
    EXPECT_TRUE(router->speaking());
    tick();
    EXPECT_THAT(embedded->said, ElementsAre("You are at the base"));
    embedded->busy = false;
    tick();
    EXPECT_FALSE(router->speaking());
    tick();
    EXPECT_THAT(embedded->said, ElementsAre("You are at the base")) << "once";
    EXPECT_THAT(text->lines, ElementsAre("You are at the base")) << "once";
}

TEST_F(VoiceRouterTest, a_finished_message_is_not_repeated_when_its_voice_is_lost) {
    open();
    tick();
    router->say({.text = "North"});
    server->busy = false;
    tick();
    server->is = VoiceState::Unavailable;
    tick();
    EXPECT_TRUE(router->news());
    tick();
    EXPECT_THAT(embedded->said, IsEmpty());
}

TEST_F(VoiceRouterTest, without_any_voice_it_reports_so_in_text_and_nobody_waits) {
    open();
    tick();
    router->say({.text = "North"});
    server->is = embedded->is = VoiceState::Unavailable;
    tick();
    EXPECT_EQ(router->news(), "The speech server is no longer available; there is only text now.");
    EXPECT_FALSE(router->speaking());
    server->is = VoiceState::Ready;
    tick();
    EXPECT_EQ(router->news(), "Speech now uses the speech server.");
}

TEST_F(VoiceRouterTest, a_better_voice_takes_over_on_arrival_and_the_worse_one_falls_silent) {
    open();
    tick();
    router->say({.text = "North"});
    reader->is = VoiceState::Ready;
    tick();
    EXPECT_EQ(server->stops, 1);
    EXPECT_EQ(router->news(), "Speech now uses the screen reader.");
    tick();
    EXPECT_THAT(reader->said, ElementsAre("North")) << "it was cut, so it is owed";
}

TEST_F(VoiceRouterTest, silence_drops_pending_messages) {
    open();
    tick();
    router->say({.text = "North"});
    server->is = VoiceState::Unavailable;
    tick();
    router->stop();
    EXPECT_TRUE(router->news());
    tick();
    EXPECT_THAT(embedded->said, IsEmpty());
}

TEST_F(VoiceRouterTest, the_setting_chooses_the_voice_and_can_be_changed_while_it_speaks) {
    reader_at_first = VoiceState::Ready;
    open(SpeechThrough::Embedded);
    tick();
    router->say({.text = "North"});
    EXPECT_THAT(heard(), ElementsAre(IsEmpty(), IsEmpty(), ElementsAre("North")));
    EXPECT_FALSE(reader->wanted) << "what is passed over holds no connection";
    settings.through = SpeechThrough::Text;
    router->set_speech(settings);
    tick();
    EXPECT_EQ(router->news(), "There is no speech now, only text.");
    EXPECT_FALSE(router->speaking());
    settings.through = SpeechThrough::SpeechDispatcher;
    router->set_speech(settings);
    tick();
    EXPECT_EQ(router->news(), "Speech now uses the speech server.");
    router->say({.text = "South"});
    EXPECT_THAT(server->said, ElementsAre("South"));
    EXPECT_THAT(text->lines, ElementsAre("North", "South"));
}

TEST_F(VoiceRouterTest, a_missing_voice_named_in_the_settings_is_reported) {
    server_at_first = VoiceState::Unavailable;
    open(SpeechThrough::SpeechDispatcher);
    tick();
    EXPECT_EQ(router->news(), "The speech server cannot be reached; speech uses the built-in voice instead.");
}

}  // namespace voice_router_test
}  // namespace handrail
