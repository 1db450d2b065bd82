// In place of what draws a second volume: fuzz_state asks of no state what it leaves stale.
#include "base/check.h"
#include "scene/second/second_curve.h"

namespace macula::app {

bool isIn3d(const BesideState&) {
    MACULA_CHECK(false);
    return false;
}

BesideState partIn3d(BesideState state) {
    MACULA_CHECK(false);
    return state;
}

}  // namespace macula::app
