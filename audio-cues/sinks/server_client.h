// What a client of a server that may hang shares with the thread that speaks to it: how that thread is woken, told to
// end and cut loose. Held by a shared_ptr of both sides, since a thread whose server never answers outlives its owner.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace handrail {

struct ServerClient {
    static constexpr double kPatienceAtTheEnd_s = 0.5;

    ServerClient();
    ~ServerClient();
    ServerClient(const ServerClient&) = delete;
    ServerClient& operator=(const ServerClient&) = delete;

    const int wake;  // an eventfd, for the thread to wait for

    std::mutex mutex;  // guards all below, and what its owner adds
    std::condition_variable ended_changed;
    bool quit = false, ended = false;
    int socket = -1;  // of the open connection; shut down from outside where the server does not answer

    // Any thread. Wakes it; takes what woke it.
    void rouse() const;
    void take_wake() const;
};

// `work` runs on a thread of that name, on which a server that has gone is an error code and no signal, until `quit` is
// set.
std::thread start_client(std::shared_ptr<ServerClient> shared, const char* name, std::function<void()> work);
// Tells it to quit and waits twice kPatienceAtTheEnd_s at most, the second time with its connection shut down; what
// then still waits ends by itself.
void end_client(ServerClient& shared, std::thread& thread);

}  // namespace handrail
