#include "audio-cues/sinks/text_speech.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <array>

#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"

namespace handrail {
namespace text_speech_test {

// A pipe that closes its ends however the test ends.
struct Pipe {
    Pipe() { EXPECT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0); }
    ~Pipe() {
        close_reader();
        ::close(ends[1]);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_reader() {
        if (ends[0] >= 0) ::close(ends[0]);
        ends[0] = -1;
    }
    // Returns the bytes that are in the pipe, without waiting for more.
    std::string read() const {
        ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
        std::string text;
        std::array<char, 65536> block{};
        for (ssize_t got = 0; (got = ::read(ends[0], block.data(), block.size())) > 0;)
            text.append(block.data(), static_cast<std::size_t>(got));
        return text;
    }
    std::array<int, 2> ends{-1, -1};
};

TEST(TextSpeech, writes_one_line_per_announcement_at_once_with_its_class) {
    const Pipe pipe;
    TextSpeech speech(pipe.ends[1]);
    speech.say({.text = "North wall, plaster", .speech_class = SpeechClass::Contact});
    EXPECT_EQ(pipe.read(), "say: North wall, plaster\n");
    speech.say({.text = "Café", .speech_class = SpeechClass::Answer});
    speech.say({.text = "The touch device was unplugged.", .speech_class = SpeechClass::Alarm});
    speech.write({.text = "Written only", .speech_class = SpeechClass::Answer});
    EXPECT_EQ(pipe.read(), "say: Café\nalert: The touch device was unplugged.\nsay: Written only\n");
    EXPECT_FALSE(speech.speaking());
}

TEST(TextSpeech, stops_quietly_without_sigpipe_when_its_reader_is_gone) {
    // Sets SIGPIPE to its default action, so that the signal would end the test program.
    ASSERT_EQ(::signal(SIGPIPE, SIG_DFL), SIG_DFL);
    Pipe pipe;
    TextSpeech speech(pipe.ends[1]);
    pipe.close_reader();
    for (int i = 0; i < 3; ++i) speech.say({.text = "Is anybody there?"});
    EXPECT_TRUE(speech.reader_left());
}

TEST(TextSpeech, stops_quietly_when_its_descriptor_is_closed) {
    const int closed = ::dup(1);
    ::close(closed);
    TextSpeech speech(closed);
    speech.say({.text = "Is anybody there?"});
    EXPECT_TRUE(speech.reader_left());
}

TEST(TextSpeech, stops_quietly_when_the_disk_is_full) {
    const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
    if (full < 0) GTEST_SKIP() << "there is no /dev/full here";
    TextSpeech speech(full);
    speech.say({.text = "Is there room?"});
    EXPECT_TRUE(speech.reader_left());
    ::close(full);
}

TEST(TextSpeech, never_waits_for_a_slow_reader_and_delivers_the_rest_later) {
    const Pipe pipe;
    TextSpeech speech(pipe.ends[1]);
    const std::string word(1000, 'x');
    // 100 kB: more than the 64 kB of a pipe, but less than the pipe and the backlog can hold together.
    constexpr int kLines = 100;
    for (int i = 0; i < kLines; ++i) speech.say({.text = word});
    std::string all = pipe.read();
    EXPECT_LT(all.size(), 100U * (word.size() + 6)) << "the pipe was not full, so this test shows nothing";
    for (int i = 0; i < 200; ++i) {
        speech.tick(0.0);
        all += pipe.read();
    }
    EXPECT_EQ(all.size(), kLines * (word.size() + 6));  // each line also has "say: " and a line end, which are 6 bytes
}

TEST(TextSpeech, keeps_a_limited_backlog_of_whole_lines) {
    const Pipe pipe;
    std::string all;
    {
        TextSpeech speech(pipe.ends[1]);
        for (int i = 0; i < 1000; ++i) speech.say({.text = std::string(1000, 'x')});
        for (int i = 0; i < 200; ++i) {
            all += pipe.read();
            speech.tick(0.0);
        }
        speech.say({.text = "still here"});
    }
    all += pipe.read();
    EXPECT_LT(all.size(), 200'000U);
    // What arrived is some whole lines of 1006 bytes, followed by the 16 bytes of "say: still here".
    EXPECT_EQ(all.size() % 1006, 16U);
    EXPECT_TRUE(all.ends_with("x\nsay: still here\n"));
}

// A sink that speaks and has one piece of news.
class ChattySpeech final : public SpeechSink {
public:
    void say(const Utterance&) override { speaking_ = true; }
    void stop() override { speaking_ = false; }
    bool speaking() const override { return speaking_; }
    std::optional<std::string> news() override { return std::exchange(news_, std::nullopt); }

private:
    bool speaking_ = false;
    std::optional<std::string> news_ = "The voice changed.";
};

TEST(TeeSpeech, passes_everything_on_to_each_sink) {
    auto first = std::make_unique<RecordingSpeech>(), second = std::make_unique<RecordingSpeech>();
    const RecordingSpeech &one = *first, &two = *second;
    std::vector<std::unique_ptr<SpeechSink>> sinks;
    sinks.push_back(std::move(first));
    sinks.push_back(std::make_unique<ChattySpeech>());
    sinks.push_back(std::move(second));
    TeeSpeech tee(std::move(sinks));
    EXPECT_FALSE(tee.speaking());
    tee.tick(2.0);
    tee.say({.text = "Hello"});
    EXPECT_TRUE(tee.speaking());
    tee.write({.text = "Written"});
    tee.stop();
    EXPECT_FALSE(tee.speaking());
    for (const RecordingSpeech* sink : {&one, &two}) {
        ASSERT_EQ(sink->lines().size(), 2U);
        EXPECT_EQ(sink->lines()[0].utterance.text, "Hello");
        EXPECT_EQ(sink->lines()[0].time_s, 2.0);
        EXPECT_FALSE(sink->lines()[1].voiced);
        EXPECT_EQ(sink->stops_s().size(), 1U);
    }
    EXPECT_EQ(tee.news(), "The voice changed.");
    EXPECT_EQ(tee.news(), std::nullopt);
}

}  // namespace text_speech_test
}  // namespace handrail
