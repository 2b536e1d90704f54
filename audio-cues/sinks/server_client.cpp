#include "audio-cues/sinks/server_client.h"

#include <pthread.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <utility>

#include "worlds/base/executor.h"

namespace handrail::sinks {

ServerClient::ServerClient() : wake(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}
ServerClient::~ServerClient() { ::close(wake); }

void ServerClient::rouse() const {
    const std::uint64_t one = 1;
    if (::write(wake, &one, sizeof one) < 0) {
        // The eventfd's counter is full, so the thread will wake anyway.
    }
}

void ServerClient::take_wake() const {
    std::uint64_t times = 0;
    if (::read(wake, &times, sizeof times) < 0) {
        // The wait timed out, because nobody called rouse().
    }
}

std::thread start_client(std::shared_ptr<ServerClient> shared, const char* name, std::function<void()> work) {
    return std::thread([shared = std::move(shared), name, work = std::move(work)] {
        name_this_thread(name);
        sigset_t pipe_signal;
        sigemptyset(&pipe_signal);
        sigaddset(&pipe_signal, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &pipe_signal, nullptr);
        work();
        {
            const std::lock_guard lock(shared->mutex);
            shared->ended = true;
        }
        shared->ended_changed.notify_all();
    });
}

void end_client(ServerClient& shared, std::thread& thread) {
    std::unique_lock lock(shared.mutex);
    shared.quit = true;
    shared.rouse();
    const auto patience = std::chrono::duration<double>(ServerClient::kPatienceAtTheEnd_s);
    bool ended = shared.ended_changed.wait_for(lock, patience, [&] { return shared.ended; });
    if (!ended && shared.socket >= 0) {
        ::shutdown(shared.socket, SHUT_RDWR);
        ended = shared.ended_changed.wait_for(lock, patience, [&] { return shared.ended; });
    }
    lock.unlock();
    if (ended) thread.join();
    else thread.detach();
}

}  // namespace handrail::sinks
