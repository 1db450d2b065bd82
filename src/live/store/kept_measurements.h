// What was measured on studies that are not open, from the states that are kept of them, and which of their
// lesions a person called gone.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "session/store.h"
#include "slices/measurement.h"

namespace macula::live {

struct StudyToRead {
    std::string study;  // session::studyIdentity
    std::string exceptVolume =
        {};  // the digest of a volume whose measurements are not wanted; empty: all are
};

struct KeptMeasurements {
    std::vector<slices::Measurement> measurements;  // of all its volumes, in the order of their digests
    std::size_t volumes = 0;                        // that have a state
    std::size_t unreadable = 0;                     // states that are damaged, or of a newer program
    std::vector<std::string> gone;                  // lesions, as keepGone was given them
};

// One for each of `studies`; without a kept state it is empty. Errors: those of Store::listDocuments and
// getDocument.
Result<std::vector<KeptMeasurements>> keptMeasurements(session::Store& store,
                                                       std::span<const StudyToRead> studies);

// Keeps which lesions a person called gone in a study (scene::keyOfLesion), in the place of those before.
// Errors: those of Store::putDocument.
Result<void> keepGone(session::Store& store, const std::string& study, std::span<const std::string> lesions);

}  // namespace macula::live
