#include "scene/transfer/same_transfer.h"

namespace macula::scene {

bool isSame(const TransferFunction& a, const TransferFunction& b) {
    const auto drawn = [](TransferFunction function) {
        function.document.clear();
        return function;
    };
    return drawn(a) == drawn(b);
}

}  // namespace macula::scene
