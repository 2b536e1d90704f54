// Tests a speech server that knows the protocol but refuses single commands, as a server without a voice for a language
// does.
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "audio-cues/sinks/speechd_speech.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace refusing_server_test {

class RefusingServer {
public:
    RefusingServer(const std::filesystem::path& path, std::string refused)
        : refused_(std::move(refused)), listener_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        path.string().copy(address.sun_path, sizeof address.sun_path - 1);
        bound_ = ::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 &&
                 ::listen(listener_, 4) == 0;
        thread_ = std::thread([this] { run(); });
    }
    ~RefusingServer() {
        ends_ = true;
        thread_.join();
        ::close(listener_);
    }
    bool bound() const { return bound_; }
    int clients() const { return clients_; }
    std::string spoken() {
        const std::lock_guard lock(mutex_);
        return spoken_;
    }

private:
    bool ready(int file) const {
        pollfd waited{file, POLLIN, 0};
        return ::poll(&waited, 1, 20) == 1;
    }
    void run() {
        while (!ends_) {
            if (!ready(listener_)) continue;
            const int client = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
            ++clients_;
            serve(client);
            ::close(client);
        }
    }
    void serve(int client) {
        std::string unread;
        bool text = false;
        while (!ends_) {
            if (!ready(client)) continue;
            char bytes[4096];
            const ssize_t size = ::read(client, bytes, sizeof bytes);
            if (size <= 0) return;
            unread.append(bytes, static_cast<std::size_t>(size));
            for (std::size_t end = unread.find("\r\n"); end != std::string::npos; end = unread.find("\r\n")) {
                const std::string line = unread.substr(0, end);
                unread.erase(0, end + 2);
                const std::string answer = answer_to(line, text);
                if (!answer.empty() && ::send(client, answer.data(), answer.size(), MSG_NOSIGNAL) < 0) return;
            }
        }
    }
    std::string answer_to(const std::string& line, bool& text) {
        if (text && line != ".") {
            const std::lock_guard lock(mutex_);
            spoken_ += line;
            return {};
        }
        if (text) return text = false, "225-1\r\n225 OK MESSAGE QUEUED\r\n";
        if (line.find(refused_) != std::string::npos) return "409 ERR PARAMETER NOT KNOWN\r\n";
        if (line == "speak" || line == "SPEAK") return text = true, "230 OK RECEIVING DATA\r\n";
        if (line.starts_with("HISTORY GET")) return "245-1\r\n245 OK CLIENT ID SENT\r\n";
        return "208 OK DONE\r\n";
    }

    std::string refused_;
    int listener_;
    bool bound_ = false;
    std::atomic<bool> ends_{false};
    std::atomic<int> clients_{0};
    std::mutex mutex_;
    std::string spoken_;  // guarded by `mutex_`
    std::thread thread_;
};

double steady_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Earlier, the program treated such a server as gone. After three attempts it fell silent without a message.
TEST(SpeechServerThatRefuses, a_language_still_speaks_with_the_current_voice) {
    const test::TemporaryFolder folder;
    RefusingServer server(folder.path() / "speech.sock", "LANGUAGE");
    ASSERT_TRUE(server.bound());
    ::setenv("SPEECHD_ADDRESS", ("unix_socket:" + (folder.path() / "speech.sock").string()).c_str(), 1);
    {
        SpeechdSpeech voice(Settings::Speech{});
        voice.want(true);
        const auto speaks = [&](const std::string& words) {
            return test::eventually(
                [&] {
                    voice.tick(steady_s());
                    if (voice.state() != VoiceState::Ready) return false;
                    if (!voice.speaking()) voice.say({.text = words});
                    return server.spoken().find(words) != std::string::npos;
                },
                30.0);
        };
        EXPECT_TRUE(speaks("North wall"));
        EXPECT_EQ(voice.news(), "The speech server has no voice for English. It uses the voice it has instead.");
        EXPECT_EQ(voice.news(), std::nullopt) << "once";
        Settings::Speech german;
        german.language = "de";
        voice.set_speech(german);
        EXPECT_TRUE(speaks("Nordwand")) << "nor when the language changes";
        EXPECT_EQ(server.clients(), 1) << "the connection stays";
    }
    ::setenv("SPEECHD_ADDRESS", "unix_socket:/nonexistent", 1);
}

}  // namespace refusing_server_test
}  // namespace handrail
