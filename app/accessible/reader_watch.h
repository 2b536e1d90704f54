// Watches which programs listen on the accessibility bus. Accessibility thread.
#pragma once

#include <gio/gio.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace handrail::accessible {

// Returns whether there is a session bus. Call it first: without a session bus, GLib and libdbus would start one and
// leave it running.
bool session_bus_is_there();

// Reports whether a program on the accessibility bus listens to names and focus, as screen readers do.
class ReaderWatch {
public:
    // `news` is called from GLib's default context when such a listener appears or ends.
    explicit ReaderWatch(std::function<void()> news) : news_(std::move(news)) {}
    ~ReaderWatch() { forget(); }
    ReaderWatch(const ReaderWatch&) = delete;
    ReaderWatch& operator=(const ReaderWatch&) = delete;

    bool listens();

private:
    bool connect();
    void forget();

    std::function<void()> news_;
    struct Unref {
        void operator()(GDBusConnection* bus) const { g_object_unref(bus); }
    };
    std::unique_ptr<GDBusConnection, Unref> session_, bus_;
    std::vector<guint> subscriptions_;
};

}  // namespace handrail::accessible
