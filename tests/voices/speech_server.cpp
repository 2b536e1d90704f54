#include "tests/voices/speech_server.h"

#include <signal.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {

namespace fs = std::filesystem;

std::unique_ptr<SpeechServer> SpeechServer::start(const fs::path& folder, int word_ms) {
    fs::create_directories(folder / "speech" / "modules");
    std::ofstream(folder / "speech" / "speechd.conf")
        << "LogLevel 3\nTimeout 0\nAddModule \"recorder\" \"" << test::built_program("recording_module")
        << "\" \"recorder.conf\"\nDefaultModule recorder\n";
    std::ofstream(folder / "speech" / "modules" / "recorder.conf") << "";
    std::unique_ptr<SpeechServer> server(new SpeechServer(folder, word_ms));
    server->start_again();
    return server;
}

Environment SpeechServer::environment() const {
    return {{"SPEECHD_ADDRESS", "unix_socket:" + (folder_ / "speech.sock").string()}};
}

void SpeechServer::freeze() const { process_->send(SIGSTOP); }

bool SpeechServer::start_again() {
    const fs::path socket = folder_ / "speech.sock";
    fs::remove(socket);
    process_ = ChildProcess::start(
        {"speech-dispatcher", "-s", "-C", (folder_ / "speech").string(), "-c", "unix_socket", "-S", socket.string(),
         "-P", (folder_ / "speech.pid").string(), "-L", folder_.string(), "-t", "0"},
        {{"HOME", folder_.string()},
         {"RECORDED", (folder_ / "recorded").string()},
         {"RECORDED_WORD_MS", std::to_string(word_ms_)},
         {"DBUS_SESSION_BUS_ADDRESS", ""}},
        folder_ / "speech.out");
    return process_ && eventually([&] { return fs::exists(socket) || !process_->running(); }) && process_->running();
}

std::vector<Recorded> SpeechServer::recorded() const {
    std::vector<Recorded> all;
    std::istringstream lines(content_of(folder_ / "recorded"));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        Recorded entry;
        words >> entry.time_s >> entry.event;
        std::getline(words >> std::ws, entry.words);
        all.push_back(std::move(entry));
    }
    return all;
}

bool SpeechServer::spoke(const std::string& words) const {
    const auto all = recorded();
    return std::any_of(all.begin(), all.end(), [&](const Recorded& entry) {
        return entry.event == "speak" && entry.words.find(words) != std::string::npos;
    });
}

std::string SpeechServer::everything() const {
    return "recorded:\n" + content_of(folder_ / "recorded") + "\nserver:\n" + content_of(folder_ / "speech.out") +
           content_of(folder_ / "speech-dispatcher.log");
}

}  // namespace handrail::test
