// Combines several lambdas into one visitor for std::visit, as in std::visit(Overloaded{[](int) {...}, [](bool) {...}},
// value).
#pragma once

namespace handrail {

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;  // clang up to version 16 needs this deduction guide

}  // namespace handrail
