// Watches who listens on the accessibility bus. Accessibility thread.
#pragma once

#include <gio/gio.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace handrail::accessible {

// Call this first: without a session bus, GLib and libdbus would start one and leave it behind.
bool session_bus_is_there();

// Reports whether somebody on the accessibility bus listens to names and focus, as a screen reader does.
class ReaderWatch {
public:
    // `news` is called from GLib's default context when a listener comes or goes.
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
