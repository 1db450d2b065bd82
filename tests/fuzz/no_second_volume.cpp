// In place of what draws a second volume: fuzz_state asks of no state what it leaves stale.
#include "base/check.h"
#include "scene/second/second_curve.h"

namespace macula::app {

bool isSecondIn3d(const SecondVolumeState&) {
    MACULA_CHECK(false);
    return false;
}

SecondVolumeState secondPartIn3d(SecondVolumeState state) {
    MACULA_CHECK(false);
    return state;
}

}  // namespace macula::app
