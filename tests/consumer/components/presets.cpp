// What is built in.
#include <presets/catalogue.h>

#include "ends.h"

int main() {
    const auto presets = macula::presets::builtInPresets();
    if (!presets) return fail(presets.error());
    return expect(presets->size() > 10, "more than ten presets");
}
