// How work on a picture learns that it is to be interrupted.
#pragma once

#include <functional>

namespace macula::live {

// Asked between dispatches. Both must be cheap.
struct Interrupts {
    std::function<bool()> newInput;
    std::function<bool()> stopping;

    bool any() const { return newInput() || stopping(); }
};

}  // namespace macula::live
