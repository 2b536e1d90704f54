// A std::variant of strings, lists and similar types that can be copied safely even when memory runs out. libstdc++
// assumes that such a variant always holds a value. If copying a value throws, std::variant later destroys a value that
// was never made, and the program jumps to a random address (seen with GCC 12 and 14). This class first copies the
// value and then moves the copy into the variant, and that move cannot throw.
#pragma once

#include <utility>
#include <variant>

namespace handrail {

template <class... T>
struct CopyableVariant : std::variant<T...> {
    using Plain = std::variant<T...>;
    using Plain::Plain;
    using Plain::operator=;

    CopyableVariant() = default;
    ~CopyableVariant() = default;
    CopyableVariant(CopyableVariant&&) noexcept = default;
    CopyableVariant& operator=(CopyableVariant&&) noexcept = default;
    CopyableVariant(const CopyableVariant& from) : Plain(copied(from)) {}
    CopyableVariant& operator=(const CopyableVariant& from) {
        Plain::operator=(copied(from));
        return *this;
    }

    Plain& plain() { return *this; }
    const Plain& plain() const { return *this; }

private:
    static Plain copied(const Plain& from) {
        return std::visit(
            []<class Held>(const Held& held) {
                Held copy = held;
                return Plain(std::in_place_type<Held>, std::move(copy));
            },
            from);
    }
};

}  // namespace handrail
