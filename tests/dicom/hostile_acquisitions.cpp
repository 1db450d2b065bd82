// Studies of several acquisitions or phases whose times, numbers and places contradict each other.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "dicom/messages/messages.h"
#include "hostile_studies.h"

namespace macula::dicom::test {

namespace {

namespace fs = std::filesystem;
using Truths = std::vector<SyntheticSeries>;
using SliceEdit = std::function<void(Slice&)>;

Edit text(const DcmTagKey& tag, std::string value) {
    return [tag, value = std::move(value)](DcmItem& item) { put(item, tag, value); };
}

std::string clock(double seconds) {
    const int whole = static_cast<int>(seconds);
    return fmt::format("{:02}{:02}{:09.6f}", 10 + whole / 3600, whole / 60 % 60,
                       seconds - 60.0 * (whole / 60));
}

// A volume for each phase, with the values of that phase.
Truths truthsOf(const SyntheticSeries& series) {
    Truths truths;
    for (int phase = 0; phase < series.phases; ++phase) {
        SyntheticSeries truth = series;
        truth.ramp = series.rampOf(phase);
        truth.phases = 1;
        truths.push_back(std::move(truth));
    }
    return truths;
}

// Phases with numbers in order, whose slices are changed one by one.
std::function<Truths(const fs::path&)> phases(int count, SliceEdit edit, bool shuffle = false) {
    return [count, shuffle, edit = std::move(edit)](const fs::path& folder) {
        SyntheticSeries series;
        series.phases = count;
        series.phaseStep = 1000.0;
        series.shuffleNumbers = shuffle;
        auto slices = slicesOf(series);
        for (Slice& slice : slices) edit(slice);
        writeFiles(folder, series, slices);
        return truthsOf(series);
    };
}

// Acquisitions, each `offsetSteps` further along the slices and `minutes` later than the one before.
std::function<Truths(const fs::path&)> acquisitions(std::vector<double> offsetSteps,
                                                    std::vector<double> minutes,
                                                    std::optional<DcmTagKey> tag = DCM_AcquisitionTime) {
    return [=](const fs::path& folder) {
        Truths truths;
        for (std::size_t n = 0; n < offsetSteps.size(); ++n) {
            SyntheticSeries series;
            series.shuffleNumbers = !tag || *tag != DCM_InstanceNumber;
            series.ramp = series.rampOf().plus(100.0 * double(n));
            series.worldFromVoxel[3] += offsetSteps[n] * series.worldFromVoxel[2];
            series.number = static_cast<int>(n) + 1;  // for the file names
            series.edits.push_back(text(DCM_SeriesNumber, "1"));
            auto slices = slicesOf(series);
            for (Slice& slice : slices) {
                slice.sopInstanceUid += fmt::format(".{}", n + 1);
                slice.instanceNumber += static_cast<int>(n) * series.size.z;
                if (tag && *tag == DCM_AcquisitionTime)
                    slice.edits.push_back(text(DCM_AcquisitionTime, clock(60.0 * minutes[n])));
                if (tag && *tag == DCM_AcquisitionDateTime) {
                    slice.edits.push_back(text(DCM_AcquisitionDateTime, "20200102"));
                    slice.edits.push_back(text(DCM_AcquisitionTime, clock(60.0 * minutes[n])));
                }
            }
            writeFiles(folder, series, slices);
            truths.push_back(std::move(series));
        }
        return truths;
    };
}

}  // namespace

std::vector<HostileStudy> hostileAcquisitions() {
    std::vector<HostileStudy> all;
    const auto add = [&](HostileStudy study) { all.push_back(std::move(study)); };
    // Reconstructions begin every three seconds and take half a second for each slice.
    const auto contentTime = [](const Slice& s) { return 3.0 * s.phase + 0.5 * s.place; };
    add({"phase-reconstructed-late",
         "three phases by ContentTime; one image of the second was reconstructed once more, later",
         "three volumes",
         {key::kPhasesByNumber},
         3,
         phases(3, [=](Slice& s) {
             const bool isLate = s.phase == 1 && s.place == 5;
             s.edits.push_back(text(DCM_ContentTime, clock(contentTime(s) + (isLate ? 30.0 : 0.0))));
         })});
    add({"phase-trigger-wrong",
         "three phases by TriggerTime; one image of the second has that of a later one",
         "three volumes",
         {key::kPhasesByNumber},
         3,
         phases(3, [](Slice& s) {
             const double late = s.phase == 1 && s.place == 5 ? 150.0 : 0.0;
             s.edits.push_back([ms = 100.0 * s.phase + 5.0 * s.place + late](DcmItem& item) {
                 putNumber(item, DCM_TriggerTime, ms);
             });
         })});
    add({"phases-in-parallel",
         "three phases whose images were reconstructed in any order",
         "three volumes, by their numbers",
         {key::kPhasesAssumed},
         3,
         phases(3, [](Slice& s) {
             const int any = (s.phase * 31 + s.place * 17 + s.phase * s.place * 7) % 37;
             s.edits.push_back(text(DCM_ContentTime, clock(1.7 * any + 0.01 * s.instanceNumber)));
         })});
    add({"phase-reacquired",
         "three phases by AcquisitionTime; one slice of the first was taken again, with the last number",
         "three volumes, that slice interpolated in the first",
         {key::kUnclearAcquisition},
         3,
         phases(3, [](Slice& s) {
             const bool isAgain = s.phase == 0 && s.place == 5;
             if (isAgain) s.instanceNumber = 99;
             s.edits.push_back(
                 text(DCM_AcquisitionTime, clock(isAgain ? 200.0 : 30.0 * s.phase + 0.4 * s.place)));
         })});
    add({"phases-across-offsets",
         "four phases, the clock goes back an hour between them (AcquisitionDateTime with offsets)",
         "four volumes in order",
         {},
         4,
         phases(4, [](Slice& s) {
             const char* times[] = {"20201025025900+0200", "20201025025930+0200", "20201025020000+0100",
                                    "20201025020030+0100"};
             s.edits.push_back(text(DCM_AcquisitionDateTime, times[s.phase]));
         })});
    add({"phases-across-midnight",
         "three phases at midnight, by AcquisitionTime without a date",
         "three volumes in order",
         {},
         3,
         phases(3, [](Slice& s) {
             const char* times[] = {"235930", "235959", "000028"};
             s.edits.push_back([](DcmItem& item) { erase(item, DCM_AcquisitionDate); });
             s.edits.push_back(text(DCM_AcquisitionTime, times[s.phase]));
         })});
    add({"three-acquisitions",
         "three acquisitions 0.3 of a step apart, at 10:00, 10:05 and 10:30",
         "three volumes",
         {},
         3,
         acquisitions({0.0, 0.3, 0.6}, {0.0, 5.0, 30.0})});
    add({"three-acquisitions-unnamed",
         "the same, and nothing tells them apart",
         "three volumes",
         {key::kInterleavedPositions},
         3,
         acquisitions({0.0, 0.3, 0.6}, {}, std::nullopt)});
    add({"overlapping-acquisitions",
         "two acquisitions that overlap by six slices, a tenth of a step off",
         "two volumes",
         {},
         2,
         acquisitions({0.0, 6.1}, {0.0, 5.0})});
    add({"overlapping-on-the-grid",
         "the same at the same positions",
         "two volumes, and no phases",
         {},
         2,
         acquisitions({0.0, 6.0}, {0.0, 5.0})});
    add({"date-without-time",
         "two acquisitions half a step apart; AcquisitionDateTime holds a date only",
         "two volumes",
         {},
         2,
         acquisitions({0.0, 0.5}, {0.0, 15.0}, DCM_AcquisitionDateTime)});
    add({"acquisitions-by-number",
         "two acquisitions half a step apart that only their numbers tell apart",
         "two volumes",
         {key::kSplitByNumber},
         2,
         acquisitions({0.0, 0.5}, {}, DCM_InstanceNumber)});
    add({"phases-that-drift",
         "three phases by TemporalPositionIdentifier, each 0.002 mm further",
         "three volumes",
         {},
         3,
         [](const fs::path& folder) {
             SyntheticSeries series;
             series.phases = 3;
             series.phaseStep = 1000.0;
             auto slices = slicesOf(series);
             for (Slice& s : slices) {
                 s.positionMm += 0.002 * s.phase * s.normal();
                 s.edits.push_back(text(DCM_TemporalPositionIdentifier, std::to_string(s.phase + 1)));
             }
             writeFiles(folder, series, slices);
             Truths truths = truthsOf(series);
             for (std::size_t n = 0; n < truths.size(); ++n)
                 truths[n].worldFromVoxel[3] += glm::dvec4(0.002 * double(n) * slices[0].normal(), 0.0);
             return truths;
         }});
    add({"numbers-without-order",
         "two images at each position, with numbers in no order and nothing else",
         "nothing: it asks",
         {key::kDuplicatePositions},
         0,
         [](const fs::path& folder) {
             phases(
                 2, [](Slice& s) { s.instanceNumber = s.instanceNumber * 29 % 101; }, true)(folder);
             return Truths{};
         }});
    add({"orientation-drifts",
         "directions that differ by up to 0.00014 rad from slice to slice",
         "one volume",
         {},
         1,
         [](const fs::path& folder) {
             SyntheticSeries series;
             series.ramp = Ramp{.throughMm = series.rampOf().throughMm, .perMm = {1.1, 2.3, 4.7}};
             auto slices = slicesOf(series);
             for (Slice& s : slices) {
                 const double angle = 0.00007 * ((s.place * 5) % 7 - 3) / 3.0;
                 const glm::dvec3 row = s.rowDirection;
                 s.rowDirection = std::cos(angle) * row + std::sin(angle) * s.columnDirection;
                 s.columnDirection = std::cos(angle) * s.columnDirection - std::sin(angle) * row;
             }
             writeFiles(folder, series, slices);
             return Truths{series};
         }});
    add({"attribute-in-every-other-slice",
         "every other slice lacks SeriesNumber, and nothing else differs",
         "one volume",
         {key::kChangesAlongStack},
         1,
         [](const fs::path& folder) {
             SyntheticSeries series;
             auto slices = slicesOf(series);
             for (Slice& s : slices) {
                 if (s.place % 2 == 0) s.edits.push_back([](DcmItem& i) { erase(i, DCM_SeriesNumber); });
             }
             writeFiles(folder, series, slices);
             return Truths{series};
         }});
    add({"middle-acquired-later",
         "one volume, the middle of which was acquired ten minutes later",
         "one volume",
         {key::kAcquiredApart},
         1,
         [](const fs::path& folder) {
             SyntheticSeries series;
             auto slices = slicesOf(series);
             for (Slice& s : slices) {
                 const bool isLater = s.place >= 4 && s.place < 8;
                 s.edits.push_back(text(DCM_AcquisitionTime, clock((isLater ? 600.0 : 0.0) + 0.5 * s.place)));
             }
             writeFiles(folder, series, slices);
             return Truths{series};
         }});
    return all;
}

}  // namespace macula::dicom::test
