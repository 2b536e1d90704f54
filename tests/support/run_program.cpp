#include "tests/support/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace handrail::test {
namespace {

using SteadyTime = std::chrono::steady_clock;

// Appends what can be read now to `into`. Returns false at the end of the output.
bool drain(int fd, std::string& into) {
    char block[4096];
    const ssize_t got = ::read(fd, block, sizeof block);
    if (got > 0) into.append(block, static_cast<std::size_t>(got));
    return got > 0 || (got < 0 && errno == EINTR);
}

// Writes a settings file that says that the introduction of the first minutes is done, because only a new person gets
// it. Existing settings that a test wrote are left alone.
void write_not_first(const std::filesystem::path& config, bool voice) {
    std::error_code ec;
    std::filesystem::create_directories(config / "handrail", ec);
    const std::filesystem::path file = config / "handrail" / "settings.toml";
    if (!ec && !std::filesystem::exists(file, ec))
        std::ofstream(file) << "[welcome]\ndone = true\n" << (voice ? "" : "[speech]\nthrough = \"text\"\n");
}

}  // namespace

std::map<std::string, std::string> bare_environment(const std::string& home, bool voice) {
    write_not_first(std::filesystem::path(home) / ".config", voice);
    return {{"HOME", home},           {"XDG_CACHE_HOME", ""},     {"XDG_CONFIG_HOME", ""},
            {"DISPLAY", ""},          {"WAYLAND_DISPLAY", ""},    {"LC_ALL", "C"},
            {"NO_AT_BRIDGE", "1"},    {"ALSOFT_DRIVERS", "null"}, {"SPEECHD_ADDRESS", "unix_socket:/nonexistent"},
            {"BRLAPI_HOST", ":99999"}};
}

ProgramRun run_program(const ProgramCall& call) {
    char home[] = "/tmp/handrail-test-home-XXXXXX";
    if (!::mkdtemp(home)) return {};
    std::map<std::string, std::string> environment = bare_environment(home, call.voice);
    if (call.first_start)
        std::filesystem::remove(std::filesystem::path(home) / ".config" / "handrail" / "settings.toml");
    for (const auto& [name, value] : call.environment) environment[name] = value;
    if (!call.first_start)
        write_not_first(
            environment["XDG_CONFIG_HOME"].empty() ? std::string(home) + "/.config" : environment["XDG_CONFIG_HOME"],
            call.voice);

    int in[2], out[2], err[2];
    if (::pipe(in) != 0 || ::pipe(out) != 0 || ::pipe(err) != 0) return {};
    std::vector<char*> words{const_cast<char*>(call.program.c_str())};
    for (const std::string& word : call.arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(in[0], 0);
        ::dup2(out[1], 1);
        ::dup2(err[1], 2);
        for (const int fd : {in[0], in[1], out[0], out[1], err[0], err[1]}) ::close(fd);
        for (const auto& [name, value] : environment) {
            if (value.empty()) ::unsetenv(name.c_str());
            else ::setenv(name.c_str(), value.c_str(), 1);
        }
        ::execv(words[0], words.data());
        ::_exit(127);
    }
    ::close(in[0]);
    ::close(out[1]);
    ::close(err[1]);
    ::signal(SIGPIPE, SIG_IGN);
    if (!call.input.empty() && ::write(in[1], call.input.data(), call.input.size()) < 0) {
    }
    if (call.close_input) ::close(in[1]);

    ProgramRun run;
    bool out_open = true, err_open = true, signalled = false;
    const auto deadline = SteadyTime::now() + std::chrono::duration<double>(call.allowed_s);
    while (out_open || err_open) {
        pollfd wait[2] = {{out_open ? out[0] : -1, POLLIN, 0}, {err_open ? err[0] : -1, POLLIN, 0}};
        ::poll(wait, 2, 100);
        if (wait[0].revents) out_open = drain(out[0], run.out);
        if (wait[1].revents) err_open = drain(err[0], run.err);
        if (call.signal_when_said && !signalled && run.out.find(call.signal_after) != std::string::npos) {
            ::kill(child, call.signal_when_said);
            signalled = true;
        }
        if (SteadyTime::now() > deadline) {
            run.timed_out = true;
            ::kill(child, SIGKILL);
            break;
        }
    }
    if (!call.close_input) ::close(in[1]);
    ::close(out[0]);
    ::close(err[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    run.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    std::error_code ec;
    std::filesystem::remove_all(home, ec);
    return run;
}

}  // namespace handrail::test
