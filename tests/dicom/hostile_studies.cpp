#include "hostile_studies.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include "support.h"

namespace macula::dicom::test {

namespace {

namespace fs = std::filesystem;
using Truths = std::vector<SyntheticSeries>;

constexpr double kThicknessMm = 2.3;

Edit text(const DcmTagKey& tag, std::string value) {
    return [tag, value = std::move(value)](DcmItem& item) { put(item, tag, value); };
}

// The second of two acquisitions in one series: moved along the slices, and 100 HU brighter.
SyntheticSeries second(const SyntheticSeries& first, double offsetSteps) {
    SyntheticSeries other = first;
    other.worldFromVoxel[3] += offsetSteps * first.worldFromVoxel[2];
    other.ramp = first.rampOf().plus(100.0);
    other.number = 2;  // for the file names
    other.edits.push_back(text(DCM_SeriesNumber, std::to_string(first.number)));
    return other;
}

void writeSecond(const fs::path& folder, const SyntheticSeries& series) {
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.sopInstanceUid += ".2";
        slice.instanceNumber += series.size.z;
    }
    writeFiles(folder, series, slices);
}

// Two acquisitions that differ in one element, or in nothing when `tag` is empty.
std::function<Truths(const fs::path&)> interleaved(double offsetSteps, std::optional<DcmTagKey> tag = {},
                                                   std::string a = {}, std::string b = {},
                                                   double stepMm = kThicknessMm) {
    return [=](const fs::path& folder) {
        SyntheticSeries first;
        first.worldFromVoxel[2] *= stepMm / glm::length(glm::dvec3(first.worldFromVoxel[2]));
        first.ramp = first.rampOf();
        SyntheticSeries other = second(first, offsetSteps);
        if (tag) {
            first.edits.push_back(text(*tag, a));
            other.edits.push_back(text(*tag, b));
        }
        writeFiles(folder, first);
        writeSecond(folder, other);
        return Truths{first, other};
    };
}

// One acquisition at half the distance: what an even volume of 24 slices is.
SyntheticSeries fine() {
    SyntheticSeries series;
    series.size.z = 24;
    series.worldFromVoxel[2] *= 0.5;
    series.ramp = series.rampOf();
    return series;
}

using SliceEdit = std::function<void(Slice&, std::size_t)>;

// A series whose slices are changed one by one.
std::function<Truths(const fs::path&)> edited(SyntheticSeries series, SliceEdit edit) {
    return [series = std::move(series), edit = std::move(edit)](const fs::path& folder) {
        auto slices = slicesOf(series);
        for (std::size_t n = 0; n < slices.size(); ++n) edit(slices[n], n);
        writeFiles(folder, series, slices);
        return Truths{series};
    };
}

SliceEdit fromSlice(std::size_t from, const DcmTagKey& tag, std::string before, std::string after) {
    return [=](Slice& slice, std::size_t n) { slice.edits.push_back(text(tag, n < from ? before : after)); };
}

std::string uid(int root, std::size_t n) {
    return fmt::format("2.25.{}{}", root, n + 1);
}

// Numbered along the slices.
SyntheticSeries numbered() {
    SyntheticSeries series;
    series.shuffleNumbers = false;
    return series;
}

Edit withCommas(const DcmTagKey& tag) {
    return [tag](DcmItem& item) {
        OFString value;
        item.findAndGetOFStringArray(tag, value);
        std::string changed = value.c_str();
        std::ranges::replace(changed, '\\', ',');
        put(item, tag, changed);
    };
}

Truths mixedWithoutAWord(const fs::path& folder) {
    interleaved(0.5)(folder);
    return {};
}

Truths interleavedByTime(const fs::path& folder) {
    SyntheticSeries first;
    first.ramp = first.rampOf();
    const SyntheticSeries other = second(first, 0.5);
    for (const auto& [series, minute] : {std::pair<const SyntheticSeries*, int>(&first, 0),
                                         std::pair<const SyntheticSeries*, int>(&other, 3)}) {
        auto slices = slicesOf(*series);
        for (std::size_t n = 0; n < slices.size(); ++n) {
            if (minute > 0) slices[n].sopInstanceUid += ".2";
            slices[n].instanceNumber += minute > 0 ? series->size.z : 0;
            slices[n].edits.push_back(text(DCM_AcquisitionDate, "20200102"));
            slices[n].edits.push_back(
                text(DCM_AcquisitionTime, fmt::format("10{:02}{:02}.5", minute, 2 * n)));
        }
        writeFiles(folder, *series, slices);
    }
    return {first, other};
}

Truths alternatingSeriesWithoutUid(const fs::path& folder) {
    SyntheticSeries first;
    first.ramp = first.rampOf();
    SyntheticSeries other = second(first, 0.5);
    for (SyntheticSeries* series : {&first, &other}) {
        const bool isFirst = series == &first;
        series->edits.push_back([](DcmItem& item) { erase(item, DCM_SeriesInstanceUID); });
        series->edits.push_back(text(DCM_SeriesNumber, isFirst ? "4" : "5"));
        series->edits.push_back(text(DCM_SeriesDescription, isFirst ? "Native" : "Venous"));
    }
    writeFiles(folder, first);
    writeSecond(folder, other);
    return {first, other};
}

// Odd slices first, then the even ones, as 2D MR is acquired.
Truths oneInterleavedAcquisition(const fs::path& folder) {
    SyntheticSeries series = fine();
    series.modality = "MR";
    return edited(series, [](Slice& slice, std::size_t n) {
        slice.edits.push_back(text(DCM_AcquisitionNumber, n % 2 == 0 ? "1" : "2"));
        slice.edits.push_back(text(DCM_AcquisitionTime, fmt::format("10{:02}{:02}", n % 2 == 0 ? 1 : 4, n)));
        slice.edits.push_back(text(DCM_SliceThickness, "1"));
    })(folder);
}

// A series of which a few slices name another coordinate system.
Truths sliceInAnotherFrame(const fs::path& folder) {
    SyntheticSeries series;
    return edited(series, [](Slice& slice, std::size_t n) {
        if (n == 5) slice.edits.push_back(text(DCM_FrameOfReferenceUID, "2.25.77"));
    })(folder);
}

Truths twoBlocks(const fs::path& folder) {
    SyntheticSeries first;
    first.ramp = first.rampOf();
    SyntheticSeries other = second(first, 150.3);
    other.size.z = 9;
    other.ramp = Ramp{.value = 2500.0, .throughMm = glm::dvec3(other.worldFromVoxel[3])};
    writeFiles(folder, first);
    writeSecond(folder, other);
    return {first, other};
}

Truths sameSlicesTwice(const fs::path& folder) {
    const SyntheticSeries series;
    writeFiles(folder, series);
    auto again = slicesOf(series);
    for (Slice& slice : again) {
        slice.sopInstanceUid += ".9";
        slice.fileName += "b";
    }
    writeFiles(folder, series, again);
    return {series};
}

Truths enhancedLacksFrames(const fs::path& folder) {
    SyntheticSeries series;
    writeMultiFrame(folder / "enhanced", series, slicesOf(series));
    editFile(folder / "enhanced", text(DCM_NumberOfFrames, "15"));
    return {series};
}

Truths frameCountIsNoNumber(const fs::path& folder) {
    const SyntheticSeries series;
    writeFiles(folder, series);
    SyntheticSeries other = series;
    other.seriesUid = "2.25.1003";
    writeMultiFrame(folder / "enhanced", other, slicesOf(other));
    editFile(folder / "enhanced", text(DCM_NumberOfFrames, "twelve"));
    return {series};
}

Truths enhancedHoldsMoreFrames(const fs::path& folder) {
    SyntheticSeries series;
    series.shuffleNumbers = false;
    writeMultiFrame(folder / "enhanced", series, slicesOf(series));
    editFile(folder / "enhanced", text(DCM_NumberOfFrames, "9"));
    return {};
}

// Values in the lowest bits of each cell, which the images say lie in the highest.
Truths highBitIsWrong(const fs::path& folder) {
    SyntheticSeries series;
    series.format = {16, 12, 11, false};
    for (const auto& file : writeFiles(folder, series))
        editFile(file, [](DcmItem& item) { putWord(item, DCM_HighBit, 15); });
    return {series};
}

// Changes the cells of one slice.
SliceEdit cellsOfSlice(std::size_t n, std::function<Uint16(Uint16)> change) {
    return [=](Slice& slice, std::size_t at) {
        if (at != n) return;
        slice.edits.push_back([change](DcmItem& item) {
            const Uint16* cells = nullptr;
            unsigned long count = 0;
            ASSERT_TRUE(item.findAndGetUint16Array(DCM_PixelData, cells, &count).good());
            std::vector<Uint16> changed(cells, cells + count);
            for (Uint16& cell : changed) cell = change(cell);
            ASSERT_TRUE(item.putAndInsertUint16Array(DCM_PixelData, changed.data(), changed.size()).good());
        });
    };
}

// From the seventh slice on one attribute is another, and the stored values are not.
std::function<Truths(const fs::path&)> changesAtSeven(const DcmTagKey& tag, std::string after) {
    return [tag, after = std::move(after)](const fs::path& folder) {
        edited({}, [&](Slice& slice, std::size_t n) {
            if (n >= 7) slice.edits.push_back(text(tag, after));
        })(folder);
        return Truths{};
    };
}

// The identifiers of these levels are made anew for each slice.
std::function<Truths(const fs::path&)> scattered(std::vector<DcmTagKey> levels) {
    return [levels = std::move(levels)](const fs::path& folder) {
        edited({}, [&](Slice& slice, std::size_t n) {
            for (std::size_t i = 0; i < levels.size(); ++i)
                slice.edits.push_back(text(levels[i], uid(700 + static_cast<int>(i), n)));
        })(folder);
        return Truths{};
    };
}

// Each slice of each phase has a time of its own, and one slice is missing.
Truths phasesWithAGap(const fs::path& folder) {
    SyntheticSeries series;
    series.phases = 3;
    auto slices = slicesOf(series);
    for (std::size_t n = 0; n < slices.size(); ++n)
        slices[n].edits.push_back(text(DCM_AcquisitionTime, fmt::format("1000{:02}", n)));
    slices.erase(slices.begin() + 12);  // the first of the second phase
    writeFiles(folder, series, slices);
    return {};
}

std::vector<HostileStudy> make() {
    std::vector<HostileStudy> all;
    const auto add = [&](HostileStudy study) { all.push_back(std::move(study)); };
    const auto pair = [&](std::string_view name, std::string_view about, const DcmTagKey& tag, const char* a,
                          const char* b) {
        add({name, about, "two volumes, half a step apart", {}, 2, interleaved(0.5, tag, a, b)});
    };
    pair("interleaved-acquisition-number", "two acquisitions, half a step apart, with numbers of their own",
         DCM_AcquisitionNumber, "1", "2");
    pair("interleaved-series-number", "two series under one UID, half a step apart", DCM_SeriesNumber, "4",
         "5");
    pair("interleaved-description", "the same, told apart by SeriesDescription", DCM_SeriesDescription,
         "Native", "Venous");
    pair("interleaved-manufacturer", "two scanners under one UID", DCM_Manufacturer, "A", "B");
    pair("interleaved-serial-number", "the same, told apart by DeviceSerialNumber", DCM_DeviceSerialNumber,
         "17", "18");
    pair("interleaved-body-part", "two body parts under one UID", DCM_BodyPartExamined, "CHEST", "HEAD");
    add({"interleaved-without-uid",
         "two series without UID in one folder",
         "two volumes, half a step apart",
         {},
         2,
         alternatingSeriesWithoutUid});
    add({"interleaved-times",
         "two acquisitions, one after the other, told apart by AcquisitionTime",
         "two volumes, half a step apart",
         {},
         2,
         interleavedByTime});
    add({"interleaved-unnamed",
         "two acquisitions, half a step apart, that nothing tells apart",
         "one volume whose values alternate",
         {key::kAlternatingValues},
         1,
         mixedWithoutAWord});
    add({"interleaved-mr",
         "one 2D acquisition of MR in two passes",
         "one volume",
         {},
         1,
         oneInterleavedAcquisition});
    for (const auto& [name, offset] :
         {std::pair("offset-0.3", 0.3), std::pair("offset-0.9", 0.9), std::pair("offset-0.95", 0.95)}) {
        add({name,
             "two acquisitions of 1 mm, that far apart, that nothing else tells apart",
             "two volumes",
             {key::kInterleavedPositions},
             2,
             interleaved(offset, {}, {}, {}, 1.0)});
    }
    add({"offset-0.3-numbered",
         "the same with AcquisitionNumber",
         "two volumes",
         {},
         2,
         interleaved(0.3, DCM_AcquisitionNumber, "1", "2", 1.0)});
    add({"offset-0.95-numbered",
         "the same",
         "two volumes",
         {},
         2,
         interleaved(0.95, DCM_AcquisitionNumber, "1", "2", 1.0)});
    const auto changing = [&](std::string_view name, std::string_view about, const DcmTagKey& tag,
                              const char* a, const char* b) {
        add({name,
             about,
             "one volume",
             {key::kChangesAlongStack},
             1,
             edited(fine(), fromSlice(10, tag, a, b))});
    };
    changing("kernel-changes", "one stack, the kernel changes in the middle", DCM_ConvolutionKernel, "B30f",
             "B70f");
    changing("contrast-changes", "one stack, contrast from the middle on", DCM_ContrastBolusAgent, "none",
             "Iodine");
    changing("acquisition-changes", "one stack of two acquisitions, one above the other",
             DCM_AcquisitionNumber, "1", "2");
    add({"frame-of-reference-per-slice",
         "every slice names a coordinate system of its own",
         "one volume",
         {key::kFrameOfReferencePerSlice},
         1,
         edited({}, [](Slice& slice, std::size_t n) {
             slice.edits.push_back(text(DCM_FrameOfReferenceUID, uid(88, n)));
         })});
    add({"frame-of-reference-missing",
         "three slices name no coordinate system",
         "one volume",
         {key::kFrameOfReferenceMissing},
         1,
         edited({}, [](Slice& slice, std::size_t n) {
             if (n % 4 == 1) slice.edits.push_back([](DcmItem& i) { erase(i, DCM_FrameOfReferenceUID); });
         })});
    add({"slice-in-another-frame",
         "one slice names another coordinate system",
         "one volume in which that slice is interpolated",
         {key::kInconsistentPosition, key::kGapInterpolated},
         1,
         sliceInAnotherFrame});
    add({"sparse-slices",
         "slices of 0.2 mm, 2.3 mm apart",
         "one volume",
         {key::kSparseSlices},
         1,
         edited({},
                [](Slice& slice, std::size_t) { slice.edits.push_back(text(DCM_SliceThickness, "0.2")); })});
    add({"two-blocks",
         "two body regions in one series",
         "two volumes",
         {key::kSeparateBlocks},
         2,
         twoBlocks});
    add({"one-instance-uid",
         "all slices have one SOPInstanceUID",
         "one volume",
         {key::kSharedInstanceUid},
         1,
         edited({}, [](Slice& slice, std::size_t) { slice.sopInstanceUid = "2.25.99"; })});
    add({"same-slices-twice",
         "every slice again under a new SOPInstanceUID",
         "one volume",
         {key::kRepeatedImages},
         1,
         sameSlicesTwice});
    add({"frames-missing",
         "an enhanced object of 12 frames that claims 15",
         "one volume",
         {key::kMissingFrames},
         1,
         enhancedLacksFrames});
    add({"copy-stopped",
         "the first 12 of the 20 images that the series says it has",
         "one volume",
         {key::kMissingAtEnds},
         1,
         edited(numbered(), [](Slice& slice, std::size_t) {
             slice.edits.push_back(text(DCM_NumberOfSeriesRelatedInstances, "20"));
         })});
    add({"begins-late",
         "12 images, numbered from 9 on",
         "one volume",
         {key::kMissingAtEnds},
         1,
         edited(numbered(), [](Slice& slice, std::size_t) { slice.instanceNumber += 8; })});
    add({"commas-for-backslashes",
         "positions and pixel spacings with commas between their numbers",
         "one volume",
         {key::kRepairedNumbers},
         1,
         edited({}, [](Slice& slice, std::size_t) {
             slice.edits.push_back(withCommas(DCM_ImagePositionPatient));
             slice.edits.push_back(withCommas(DCM_PixelSpacing));
         })});
    add({"frame-count-no-number",
         "an enhanced object whose NumberOfFrames is a word, beside a good series",
         "one volume, of the good series",
         {key::kInvalidFrameCount},
         1,
         frameCountIsNoNumber});
    add({"phases-with-a-gap",
         "three phases, told apart by time, one slice is missing",
         "three volumes",
         {key::kIncompletePhases},
         3,
         phasesWithAGap});
    const auto odd = [&](std::string_view name, std::string_view about, std::string_view said, Edit edit) {
        add({name,
             about,
             "one volume in which that slice is interpolated",
             {said, key::kGapInterpolated},
             1,
             edited({}, [edit = std::move(edit)](Slice& slice, std::size_t n) {
                 if (n == 5) slice.edits.push_back(edit);
             })});
    };
    odd("intercept-missing", "one slice has no rescale intercept", key::kOddRescale,
        [](DcmItem& item) { erase(item, DCM_RescaleIntercept); });
    odd("intercept-absurd", "one slice has an intercept of 1e30", key::kOddRescale,
        text(DCM_RescaleIntercept, "1e30"));
    add({"intercept-deviates",
         "one slice has an intercept that is 24 less",
         "one volume, with the values that slice says",
         {key::kDeviatingRescale},
         1,
         edited({}, [](Slice& slice, std::size_t n) {
             if (n == 5) slice.intercept = -1048.0;
         })});
    odd("slope-negative", "one slice has a slope of the other sign", key::kOddRescale,
        text(DCM_RescaleSlope, "-1"));
    odd("position-far-away", "one slice lies a kilometre away", key::kOddPosition,
        text(DCM_ImagePositionPatient, "0\\0\\1000000"));
    odd("position-not-finite", "one slice has a position that is no number", key::kOddPosition,
        text(DCM_ImagePositionPatient, "nan\\0\\0"));
    odd("bits-stored-too-few", "one slice says that 8 bits hold its values, which need 12",
        key::kBitsExceeded, [](DcmItem& item) {
            putWord(item, DCM_BitsStored, 8);
            putWord(item, DCM_HighBit, 7);
        });
    add({"high-bit-wrong",
         "values in the lowest 12 bits, of images that say the highest",
         "one volume",
         {key::kBitsMisplaced},
         1,
         highBitIsWrong});
    const auto oddCells = [&](std::string_view name, std::string_view about,
                              std::function<Uint16(Uint16)> change) {
        add({name,
             about,
             "one volume in which that slice is interpolated",
             {key::kOddValues, key::kGapInterpolated},
             1,
             edited({}, cellsOfSlice(5, std::move(change)))});
    };
    oddCells("slice-bytes-swapped", "the bytes of the pixels of one slice are exchanged",
             [](Uint16 cell) { return static_cast<Uint16>(cell << 8 | cell >> 8); });
    oddCells("slice-blank", "one slice is empty between others", [](Uint16) { return Uint16{0}; });
    add({"intercept-changes",
         "the rescale intercept changes by 1024 along the stack, and the stored values do not",
         "one volume, with the values that each slice says",
         {key::kChangesAlongStack, key::kRescaleStep},
         1,
         changesAtSeven(DCM_RescaleIntercept, "0")});
    add({"unit-changes",
         "Hounsfield units in one part, a concentration in the other",
         "two volumes",
         {key::kInconsistentUnits},
         2,
         changesAtSeven(DCM_RescaleType, "MGML")});
    add({"frames-beyond",
         "an enhanced object of 12 frames that claims 9",
         "one volume of 9 slices",
         {key::kSurplusFrames},
         1,
         enhancedHoldsMoreFrames});
    const auto perSlice = [&](std::string_view name, std::string_view about, std::vector<DcmTagKey> levels) {
        add({name,
             about,
             "nothing, until the folder is opened with `--join`",
             {key::kUidPerSlice},
             0,
             scattered(std::move(levels))});
    };
    perSlice("series-uid-per-slice", "every slice has a series UID of its own", {DCM_SeriesInstanceUID});
    perSlice("study-uid-per-slice", "every slice has study and series UIDs of its own",
             {DCM_StudyInstanceUID, DCM_SeriesInstanceUID});
    perSlice("patient-id-per-slice", "every slice has a patient ID of its own", {DCM_PatientID});
    for (HostileStudy& study : hostileAcquisitions()) add(std::move(study));
    return all;
}

}  // namespace

const std::vector<HostileStudy>& hostileStudies() {
    static const std::vector<HostileStudy> all = make();
    return all;
}

}  // namespace macula::dicom::test
