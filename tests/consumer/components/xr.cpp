// Where there is no loader of OpenXR, that is said and nothing ends.
#include <xr/runtime.h>

#include "ends.h"

int main() {
    const macula::xr::Check check = macula::xr::checkHeadset("libno-loader-of-this-name.so");
    return expect(check.missing && check.missing->code == macula::ErrorCode::deviceNotUsable,
                  "no headset, and it is said");
}
