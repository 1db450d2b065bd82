// The phantom as a study.
#include <study/open/opened_study.h>

#include "ends.h"

int main() {
    macula::Progress progress;
    const auto study = macula::study::openStudy(std::nullopt, progress);
    if (!study) return fail(study.error());
    return expect(study->identity.isOfNobody, "a phantom of nobody");
}
