#include "tests/support/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace handrail::test {

std::unique_ptr<ChildProcess> ChildProcess::start(const std::vector<std::string>& words, const Environment& environment,
                                                  const std::filesystem::path& output) {
    int input[2];
    if (::pipe2(input, O_CLOEXEC) != 0) return nullptr;
    const int out = ::open(output.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != parent) ::_exit(1);
        ::setpgid(0, 0);
        ::dup2(input[0], 0);
        ::dup2(out, 1);
        ::dup2(out, 2);
        for (const auto& [name, value] : environment) {
            if (value.empty()) ::unsetenv(name.c_str());
            else ::setenv(name.c_str(), value.c_str(), 1);
        }
        ::execvp(arguments[0], arguments.data());
        ::_exit(127);
    }
    ::close(input[0]);
    ::close(out);
    if (child < 0) {
        ::close(input[1]);
        return nullptr;
    }
    ::setpgid(child, child);  // called in both processes, because either may run first and the group must then exist
    ::signal(SIGPIPE, SIG_IGN);
    return std::unique_ptr<ChildProcess>(new ChildProcess(child, input[1]));
}

ChildProcess::~ChildProcess() {
    kill();
    end_input();
}

void ChildProcess::type(const std::string& text) {
    if (::write(input_, text.data(), text.size()) < 0) {
        // The child has ended, and the test notices that in another way, so the error is ignored.
    }
}

void ChildProcess::end_input() {
    if (input_ >= 0) ::close(input_);
    input_ = -1;
}

void ChildProcess::send(int signal) const {
    if (!ended_) ::kill(-pid_, signal);
}

void ChildProcess::kill() {
    ::kill(-pid_, SIGKILL);  // kills the whole group, because processes that the child started may outlive it
    exit_status();
}

bool ChildProcess::running() {
    if (!ended_ && ::waitpid(pid_, &status_, WNOHANG) == pid_) ended_ = true;
    return !ended_;
}

int ChildProcess::exit_status() {
    while (!ended_ && ::waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
    }
    ended_ = true;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
}

bool eventually(const std::function<bool()>& holds, double most_s) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(most_s);
    while (!holds()) {
        if (std::chrono::steady_clock::now() > deadline) return holds();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

std::string why_no_preload() {
#if defined(HANDRAIL_SANITIZED)
    return "the sanitizers' own library has to come first";
#else
    return {};
#endif
}

bool installed(const std::string& program) {
    for (const char* folder : {"/usr/bin/", "/usr/local/bin/", "/bin/", "/sbin/", "/usr/sbin/", "/usr/libexec/"})
        if (::access((folder + program).c_str(), X_OK) == 0) return true;
    return false;
}

}  // namespace handrail::test
