// Packs values into bytes and reads them back bit for bit. The bytes use the number formats of this machine and must
// not leave it. One function template serves both directions, so that these cannot differ. Reading is safe for any
// bytes: it always ends, never gives an invalid enumerator, and needs at most some hundred times their size in memory.
// Any thread may use these classes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail::stored {

template <class T, class U>
concept Is = std::is_same_v<std::remove_const_t<T>, U>;

// The value of an enumeration's last enumerator. Every stored enumeration must specialise it.
template <class E>
inline constexpr int kLastOf = -1;

class Packer {
public:
    static constexpr bool kReads = false;

    Packer() = default;
    // With `full`, passes the bytes on in pieces, in order, instead of keeping all of them. take() then returns the
    // last piece.
    explicit Packer(std::function<void(std::string_view)> full) : full_(std::move(full)) {}

    template <class... T>
    void operator()(const T&... values);
    void raw(const void* from, std::size_t size) {
        bytes_.append(static_cast<const char*>(from), size);
        if (!full_ || bytes_.size() < kPiece) return;
        full_(bytes_);
        bytes_.clear();
    }
    std::string take() { return std::move(bytes_); }

    // Returns the number of a shared value, and whether this is its first use.
    template <class T>
    std::pair<std::uint32_t, bool> number_of(const std::shared_ptr<const T>& value) {
        const auto [at, is_new] = known_.emplace(value.get(), static_cast<std::uint32_t>(known_.size() + 1));
        return {at->second, is_new};
    }

private:
    static constexpr std::size_t kPiece = 1 << 16;

    std::string bytes_;
    std::function<void(std::string_view)> full_;
    std::map<const void*, std::uint32_t> known_;
};

class Unpacker {
public:
    static constexpr bool kReads = true;
    static constexpr int kDeepest = 4;  // greatest depth of scenes within scenes; default of descend()

    explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}
    template <class... T>
    void operator()(T&... values);
    void raw(void* into, std::size_t size) {
        if (size > bytes_.size() || !good_) return spoil();
        if (size > 0) std::memcpy(into, bytes_.data(), size);
        bytes_.remove_prefix(size);
    }
    void spoil() { good_ = false; }
    bool good() const { return good_; }
    std::string_view rest() const { return bytes_; }

    bool descend(int deepest = kDeepest) {
        good_ = good_ && ++depth_ <= deepest;
        return good_;
    }
    void ascend() { --depth_; }
    // Returns the shared values of one type that have been read, indexed by their numbers.
    std::map<std::uint32_t, std::shared_ptr<const void>>& known(const void* kind) { return known_[kind]; }

private:
    std::string_view bytes_;
    bool good_ = true;
    int depth_ = 0;
    std::map<const void*, std::map<std::uint32_t, std::shared_ptr<const void>>> known_;  // by type and then by number
};

namespace archive {

template <class T>
struct Kind {
    static constexpr bool vector = false, optional = false, variant = false, shared = false;
};
template <class T>
struct Kind<std::vector<T>> : Kind<void> {
    static constexpr bool vector = true;
};
template <class T>
struct Kind<std::optional<T>> : Kind<void> {
    static constexpr bool optional = true;
};
template <class... T>
struct Kind<std::variant<T...>> : Kind<void> {
    static constexpr bool variant = true;
};
template <class T>
struct Kind<std::shared_ptr<const T>> : Kind<void> {
    static constexpr bool shared = true;
};

// True for types whose parts have no gaps between them. Such values are copied as they are in memory.
template <class T>
inline constexpr bool kFlat = std::is_same_v<T, Vec2> || std::is_same_v<T, Vec3> ||
                              (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>);

// True for types whose width depends on the machine, so that another machine would misread them: std::size_t, for which
// there is count(), and long if it differs from std::int64_t.
template <class T>
inline constexpr bool kWidthVaries = std::is_same_v<T, unsigned long> ||
                                     (std::is_same_v<T, long> && !std::is_same_v<T, std::int64_t>);

template <class A, class T>
void one(A& a, T& value);

template <class A>
std::uint64_t count(A& a, std::uint64_t size) {
    a.raw(&size, sizeof size);
    return size;
}

template <class A, class T>
void list(A& a, T& values) {
    using Element = typename T::value_type;
    static_assert(!kWidthVaries<Element>);
    const std::uint64_t size = count(a, values.size());
    if constexpr (A::kReads) {
        // Each element takes at least one byte, so a larger size must be wrong.
        if (!a.good() || size > a.rest().size()) return a.spoil();
        values.clear();
        if constexpr (kFlat<Element>) {
            if (size > a.rest().size() / sizeof(Element)) return a.spoil();
            values.resize(size);
            a.raw(values.data(), size * sizeof(Element));
        } else {
            values.reserve(std::min<std::uint64_t>(size, a.rest().size() / sizeof(Element) + 1));
            for (std::uint64_t i = 0; i < size && a.good(); ++i) {
                Element value{};
                one(a, value);
                values.push_back(std::move(value));
            }
        }
    } else if constexpr (kFlat<Element>) {
        a.raw(values.data(), size * sizeof(Element));
    } else {
        for (const auto& value : values) one(a, value);
    }
}

template <std::size_t I, class A, class V>
void alternative(A& a, V& value, std::size_t wanted) {
    if constexpr (I < std::variant_size_v<std::remove_const_t<V>>) {
        if (wanted != I) return alternative<I + 1>(a, value, wanted);
        if constexpr (A::kReads) value.template emplace<I>();
        if constexpr (!std::is_same_v<std::variant_alternative_t<I, std::remove_const_t<V>>, std::monostate>)
            one(a, *std::get_if<I>(&value));
    } else if constexpr (A::kReads) {
        a.spoil();
    }
}

template <class T>
inline constexpr char kTypeTag = 0;

template <class A, class T>
void shared(A& a, T& pointer) {
    using Value = std::remove_const_t<typename std::remove_const_t<T>::element_type>;
    std::uint32_t number = 0;
    if constexpr (A::kReads) {
        a(number);
        if (number == 0 || !a.good()) return;
        auto& known = a.known(&kTypeTag<Value>);
        if (const auto found = known.find(number); found != known.end()) {
            pointer = std::static_pointer_cast<const Value>(found->second);
            return;
        }
        const auto made = std::make_shared<Value>();
        if (a.descend()) one(a, *made);
        a.ascend();
        known.emplace(number, made);
        pointer = made;
    } else {
        if (!pointer) return a(number);
        const auto [of_it, is_new] = a.number_of(pointer);
        a(of_it);
        if (is_new) one(a, *pointer);
    }
}

template <class A, class T>
void one(A& a, T& value) {
    using V = std::remove_const_t<T>;
    static_assert(!kWidthVaries<V>);
    if constexpr (std::is_enum_v<V> || std::is_same_v<V, bool>) {
        constexpr int last = [] {
            if constexpr (std::is_enum_v<V>) return kLastOf<V>;
            else return 1;
        }();
        static_assert(last >= 0, "an enumeration whose last one is not said");
        auto byte = static_cast<std::uint8_t>(value);
        a.raw(&byte, 1);
        if constexpr (A::kReads) {
            if (byte > last) return a.spoil();
            value = static_cast<V>(byte);
        }
    } else if constexpr (kFlat<V>) {
        a.raw(&value, sizeof value);
    } else if constexpr (std::is_same_v<V, std::string>) {
        const std::uint64_t size = count(a, value.size());
        if constexpr (A::kReads) {
            if (!a.good() || size > a.rest().size()) return a.spoil();
            value.resize(size);
        }
        a.raw(value.data(), size);
    } else if constexpr (std::is_same_v<V, std::vector<bool>>) {
        const std::uint64_t size = count(a, value.size());
        if constexpr (A::kReads) {
            if (!a.good() || size > a.rest().size()) return a.spoil();
            value.resize(size);
        }
        for (std::uint64_t i = 0; i < size; ++i) {
            bool bit = value[i];
            one(a, bit);
            if constexpr (A::kReads) value[i] = bit;
        }
    } else if constexpr (Kind<V>::vector) {
        list(a, value);
    } else if constexpr (Kind<V>::optional) {
        bool there = value.has_value();
        one(a, there);
        if constexpr (A::kReads) {
            if (there) value.emplace();
            else value.reset();
        }
        if (there && value) one(a, *value);
    } else if constexpr (Kind<V>::variant) {
        auto index = static_cast<std::uint8_t>(value.index());
        a.raw(&index, 1);
        alternative<0>(a, value, index);
    } else if constexpr (Kind<V>::shared) {
        shared(a, value);
    } else {
        // The function fields() is found in the namespace of the type. Its structured binding names all members, so
        // that none is forgotten.
        fields(a, value);
    }
}

}  // namespace archive

template <class... T>
void Packer::operator()(const T&... values) {
    (archive::one(*this, values), ...);
}
template <class... T>
void Unpacker::operator()(T&... values) {
    (archive::one(*this, values), ...);
}

}  // namespace handrail::stored
