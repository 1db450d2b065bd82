// bench_registration: ours beside ITK's, on the same pairs, on all cores; a table of how far each is off and
// how long it took. No arguments. docs/registration.md has its numbers.
#include <cstdio>

#include "registration/compared_pairs.h"
#include "registration/itk_registration.h"
#include "registration/moved_volumes.h"
#include "registration/rigid_registration.h"

#include <chrono>

namespace {

using namespace macula;
using namespace macula::registration;
using namespace macula::registration::test;

struct Measured {
    double errorMm = -1.0;  // below 0: there is no answer
    double seconds = 0.0;
};

template <class Register>
Measured measured(const ComparedPair& pair, const Register& registers) {
    const auto begun = std::chrono::steady_clock::now();
    const auto found = registers();
    Measured result;
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    if (found.ok()) {
        result.errorMm = errorMm(found->movingFromFixed, pair.truth);
    } else {
        std::fprintf(stderr, "%s: %s\n", pair.name.c_str(), found.error().message.english().c_str());
    }
    return result;
}

}  // namespace

int main() {
    std::printf("| pair | off before, mm | Macula, mm | s | ITK, mm | s |\n|---|---|---|---|---|---|\n");
    for (const ComparedPair& pair : comparedPairs()) {
        Progress progress;
        const Measured ours =
            measured(pair, [&] { return registerRigid(*pair.fixed, *pair.moving, progress); });
        const Measured itks = measured(pair, [&] { return registerByItk(*pair.fixed, *pair.moving); });
        std::printf("| %s | %.1f | %.2f | %.1f | %.2f | %.1f |\n", pair.name.c_str(),
                    errorMm(glm::dmat4(1.0), pair.truth), ours.errorMm, ours.seconds, itks.errorMm,
                    itks.seconds);
        std::fflush(stdout);
    }
    return 0;
}
