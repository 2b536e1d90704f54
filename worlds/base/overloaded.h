// Several lambdas as one visitor for std::visit: std::visit(Overloaded{[](int) {...}, [](bool) {...}}, value).
#pragma once

namespace handrail {

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};

}  // namespace handrail
