// Preliminary results of a folder while it is being read.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "dicom/scan.h"
#include "dicom/stack/examination.h"

namespace macula::dicom {

// Collects the studies and series of the headers read so far, and calls the listener now and then: first as
// soon as there is a series, then at most every kGlimpseEvery, and never for more than a tenth of the time.
// Thread-safe; calls of the listener never overlap, and come from the threads that call add.
class ScanGlimpses {
  public:
    explicit ScanGlimpses(GlimpseListener listener) : listener_(std::move(listener)) {}

    void add(const Examination& found);

  private:
    using Clock = std::chrono::steady_clock;
    struct StudySeen {
        Study study;
        std::map<std::string, Series> series;  // by UID
    };

    Scan seen() const;

    const GlimpseListener listener_;
    std::mutex mutex_;
    std::map<std::pair<std::string, PatientIdentity>, StudySeen> studies_;  // as the scan groups them
    PatientNumbers patients_;                                               // in the order they were met
    Clock::time_point due_{};
};

}  // namespace macula::dicom
