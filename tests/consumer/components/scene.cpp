// What the phantom is shown with when nobody chose.
#include <scene/choice/catalogue.h>
#include <study/open/opened_study.h>

#include "ends.h"

int main() {
    const auto catalogue = macula::scene::builtInCatalogue();
    if (!catalogue) return fail(catalogue.error());
    macula::Progress progress;
    const auto study = macula::study::openStudy(std::nullopt, progress);
    if (!study) return fail(study.error());
    return expect(macula::scene::presetFor(*catalogue, *study->volume) != nullptr,
                  "a preset for the phantom");
}
