// One function object of several, for std::visit. Only for the sources of this folder.
#pragma once

namespace macula::slices {

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace macula::slices
