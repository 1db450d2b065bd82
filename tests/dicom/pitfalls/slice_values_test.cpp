// Slices whose values cannot be right beside their neighbours, and steps of the rescale: found in the pixels.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "opened.h"

namespace macula::dicom::test {
namespace {

using OddValues = Pitfall;
using RescaleSteps = Pitfall;
using NoFalseAlarm = Pitfall;

// Smooth in all directions, with noise that is the same in every run.
double anatomy(int i, int j, int k) {
    const auto mixed = (static_cast<unsigned>(i) * 73856093u) ^ (static_cast<unsigned>(j) * 19349663u) ^
                       (static_cast<unsigned>(k) * 83492791u);
    const double noise = static_cast<double>((mixed * 2654435761u) >> 16 & 31u) - 15.5;
    return std::round(400.0 * std::sin(0.3 * i + 0.11 * k) + 300.0 * std::cos(0.25 * j - 0.07 * k) + noise);
}

struct Kind {
    const char* modality;
    CellFormat format;
    double offset;    // added to the anatomy
    bool ownRescale;  // as PET has
};
const Kind kCt{"CT", {16, 16, 15, true}, 0.0, false};
const Kind kLung{"CT", {16, 16, 15, true}, -600.0, false};
const Kind kMr{"MR", {16, 16, 15, true}, -800.0, false};
const Kind kPet{"PT", {16, 16, 15, false}, 40000.0, true};
const Kind kUnsignedCt{"CT", {16, 16, 15, false}, 1024.0, false};

// A series of which the value of each voxel is anatomy() and an offset.
SyntheticSeries seriesOf(const Kind& kind) {
    SyntheticSeries series;
    series.modality = kind.modality;
    series.size = {24, 20, 24};
    series.format = kind.format;
    series.slope = 1.0;
    series.intercept = 0.0;
    series.shuffleNumbers = false;
    series.rawInstead = [offset = kind.offset](const Slice& slice, int i, int j) {
        return static_cast<int>(
            std::lround((anatomy(i, j, slice.place) + offset - slice.intercept) / slice.slope));
    };
    return series;
}

std::vector<Slice> slicesOf(const SyntheticSeries& series, const Kind& kind) {
    auto slices = test::slicesOf(series);
    for (Slice& slice : slices) slice.slope = kind.ownRescale ? 1.0 + 0.05 * (slice.place % 3) : 1.0;
    return slices;
}

void editCells(DcmItem& item, const std::function<void(std::vector<Uint16>&)>& edit) {
    const Uint16* cells = nullptr;
    unsigned long count = 0;
    ASSERT_TRUE(item.findAndGetUint16Array(DCM_PixelData, cells, &count).good());
    std::vector<Uint16> own(cells, cells + count);
    edit(own);
    ASSERT_TRUE(item.putAndInsertUint16Array(DCM_PixelData, own.data(), own.size()).good());
}

void takeOtherSign(DcmItem& item) {
    Uint16 sign = 0;
    ASSERT_TRUE(item.findAndGetUint16(DCM_PixelRepresentation, sign).good());
    putWord(item, DCM_PixelRepresentation, 1 - sign);
}

void swapBytes(DcmItem& item) {
    editCells(item, [](std::vector<Uint16>& cells) {
        for (Uint16& cell : cells) cell = static_cast<Uint16>(cell << 8 | cell >> 8);
    });
}

Edit blankFrom(double part) {
    return [part](DcmItem& item) {
        editCells(item, [&](std::vector<Uint16>& cells) {
            std::fill(cells.begin() + static_cast<std::ptrdiff_t>(part * double(cells.size())), cells.end(),
                      Uint16{0});
        });
    };
}

const Message* messageOf(const Volume& volume, std::string_view key) {
    const auto& told = volume.provenance().messages;
    const auto found = std::ranges::find(told, key, &Message::key);
    return found == told.end() ? nullptr : &*found;
}

constexpr std::string_view kAllKeys[]{key::kOddValues,   key::kOddValuesKept,     key::kUnlikeNeighbours,
                                      key::kRescaleStep, key::kAlternatingValues, key::kBitsMisplaced,
                                      key::kBitsDropped, key::kBitsExceeded};

// Voxels of slices that are images are those of `expected`, which gives values by place.
void expectValues(const Volume& volume, int firstPlace, const std::function<double(int, int, int)>& expected,
                  double tolerance = 0.01) {
    std::set<int> interpolated;
    for (const SliceRange& range : volume.provenance().interpolatedSlices) {
        for (int k = range.first; k <= range.last; ++k) interpolated.insert(k);
    }
    for (int k = 0; k < volume.size().z; ++k) {
        if (interpolated.contains(k)) continue;
        for (int j = 0; j < volume.size().y; ++j) {
            for (int i = 0; i < volume.size().x; ++i)
                ASSERT_NEAR(volume.value(i, j, k), expected(i, j, k + firstPlace), tolerance)
                    << i << " " << j << " " << k;
        }
    }
}

TEST_F(OddValues, AFewSlicesThatAreReadWronglyAreGapsAndNamed) {
    const std::pair<const char*, Edit> faults[]{
        {"sign", takeOtherSign}, {"bytes", swapBytes}, {"blank", blankFrom(0.0)}, {"cut", blankFrom(0.6)}};
    const std::vector<int> places[]{{9}, {9, 10}, {4, 15}, {0}, {23}};
    for (const Kind* kind : {&kLung, &kMr, &kPet}) {
        for (const auto& [name, fault] : faults) {
            for (const std::vector<int>& odd : places) {
                const bool atEnd = odd.front() == 0 || odd.front() == 23;
                if (atEnd && std::string_view(name).find_first_of("su") == std::string_view::npos)
                    continue;  // blank slices at an end may be real
                if (atEnd && std::string_view(name) == "cut") continue;
                SCOPED_TRACE(std::string(kind->modality) + " " + name + " " + std::to_string(odd.front()) +
                             " of " + std::to_string(odd.size()));
                const TemporaryFolder own;
                const SyntheticSeries s = seriesOf(*kind);
                auto slices = slicesOf(s, *kind);
                for (const int place : odd) slices[std::size_t(place)].edits.push_back(fault);
                writeFiles(own.path(), s, slices);
                const auto volume = Opened(own.path()).onlyVolume();
                ASSERT_NE(volume, nullptr);
                const Message* told = messageOf(*volume, key::kOddValues);
                ASSERT_NE(told, nullptr);
                EXPECT_EQ(told->severity, Severity::warning);
                EXPECT_EQ(numberArgument(*told, "count"), double(odd.size()));
                EXPECT_NE(told->sentence.english().find(std::to_string(odd.front() + 1)), std::string::npos)
                    << told->sentence;
                EXPECT_EQ(volume->size().z, atEnd ? 23 : 24);
                expectValues(*volume, odd.front() == 0 ? 1 : 0, [&](int i, int j, int k) {
                    const Slice& slice = slices[std::size_t(k)];
                    return rawAt(s, slice, i, j) * slice.slope;
                });
                for (const std::string_view key : kAllKeys) {
                    if (key != key::kOddValues) {
                        EXPECT_EQ(messageOf(*volume, key), nullptr) << key;
                    }
                }
            }
        }
    }
}

// Signed by mistake: bright values become negative.
TEST_F(OddValues, OneSliceOfUnsignedPixelsThatSaysSigned) {
    Kind bright = kUnsignedCt;
    bright.offset = 32768.0;
    const SyntheticSeries s = seriesOf(bright);
    auto slices = slicesOf(s, bright);
    slices[7].edits.push_back(takeOtherSign);
    writeFiles(folder.path(), s, slices);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->provenance().interpolatedSlices, (std::vector<SliceRange>{{7, 7}}));
    EXPECT_NE(messageOf(*volume, key::kOddValues), nullptr);
}

// The sign of values that none of the pixels needs is no fault.
TEST_F(OddValues, AnotherSignThatChangesNoValueIsNone) {
    const SyntheticSeries s = seriesOf(kUnsignedCt);
    auto slices = slicesOf(s, kUnsignedCt);
    slices[7].edits.push_back(takeOtherSign);
    writeFiles(folder.path(), s, slices);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    for (const std::string_view key : kAllKeys) EXPECT_EQ(messageOf(*volume, key), nullptr) << key;
    expectValues(*volume, 0, [](int i, int j, int k) { return anatomy(i, j, k) + 1024.0; });
}

TEST_F(OddValues, BlankSlicesAtAnEndMayBeReal) {
    const SyntheticSeries s = seriesOf(kCt);
    auto slices = slicesOf(s, kCt);
    for (const std::size_t place : {0u, 1u, 23u}) slices[place].edits.push_back(blankFrom(0.0));
    writeFiles(folder.path(), s, slices);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->size().z, 24);
    for (const std::string_view key : kAllKeys) EXPECT_EQ(messageOf(*volume, key), nullptr) << key;
}

// Where many are wrong nobody knows what to interpolate from: they stay, and it is said.
TEST_F(OddValues, OfManyIsSaid) {
    for (const int count : {10, 24}) {
        SCOPED_TRACE(count);
        const TemporaryFolder own;
        const SyntheticSeries s = seriesOf(kCt);
        auto slices = slicesOf(s, kCt);
        for (int place = 0; place < count; ++place) slices[std::size_t(place)].edits.push_back(swapBytes);
        writeFiles(own.path(), s, slices);
        const auto volume = Opened(own.path()).onlyVolume();
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->size().z, 24);
        const Message* told = messageOf(*volume, key::kOddValuesKept);
        ASSERT_NE(told, nullptr);
        EXPECT_EQ(numberArgument(*told, "count"), double(count));
        EXPECT_NE(told->sentence.english().find("wrong order"), std::string::npos) << told->sentence;
    }
}

TEST_F(OddValues, TwiceTheValuesOfBothNeighboursAreShownAndSaid) {
    for (const bool two : {false, true}) {
        SCOPED_TRACE(two);
        const TemporaryFolder own;
        SyntheticSeries s = seriesOf(kUnsignedCt);
        const auto isOdd = [two](int place) { return place == 11 || (two && place == 12); };
        const auto valueAt = [isOdd](int i, int j, int k) {
            return (anatomy(i, j, k) + 1024.0) * (isOdd(k) ? 2.0 : 1.0);
        };
        s.rawInstead = [valueAt](const Slice& slice, int i, int j) {
            return static_cast<int>(valueAt(i, j, slice.place));
        };
        writeFiles(own.path(), s);
        const auto volume = Opened(own.path()).onlyVolume();
        ASSERT_NE(volume, nullptr);
        const Message* told = messageOf(*volume, key::kUnlikeNeighbours);
        ASSERT_NE(told, nullptr);
        EXPECT_NE(told->sentence.english().find(two ? "12-13" : "12"), std::string::npos) << told->sentence;
        expectValues(*volume, 0, valueAt);
    }
}

TEST_F(RescaleSteps, AnInterceptThatChangesHalfwayWithTheSameStoredValues) {
    for (const double added : {1024.0, 100.0}) {
        SCOPED_TRACE(added);
        const TemporaryFolder own;
        const SyntheticSeries s = seriesOf(kCt);
        auto slices = slicesOf(s, kCt);
        for (Slice& slice : slices) {
            if (slice.place < 12) continue;
            slice.edits.push_back([&](DcmItem& item) { put(item, DCM_RescaleIntercept, decimal(added)); });
        }
        writeFiles(own.path(), s, slices);
        const Opened opened(own.path());
        EXPECT_TRUE(opened.says(key::kChangesAlongStack)) << opened.keys();
        const auto volume = opened.onlyVolume();
        ASSERT_NE(volume, nullptr);
        const Message* told = messageOf(*volume, key::kRescaleStep);
        ASSERT_NE(told, nullptr);
        EXPECT_EQ(told->severity, Severity::warning);
        EXPECT_EQ(numberArgument(*told, "slice"), 13.0);
        EXPECT_NEAR(numberArgument(*told, "step"), added, 25.0);
        expectValues(*volume, 0,
                     [&](int i, int j, int k) { return anatomy(i, j, k) + (k < 12 ? 0.0 : added); });
    }
}

// A slope for one half, as of another scanner, whose stored values do not go with it.
TEST_F(RescaleSteps, ASlopeThatChangesHalfwayWithTheSameStoredValues) {
    const SyntheticSeries s = seriesOf(kUnsignedCt);
    auto slices = slicesOf(s, kUnsignedCt);
    for (Slice& slice : slices) {
        if (slice.place >= 12) slice.edits.push_back([](DcmItem& item) { put(item, DCM_RescaleSlope, "3"); });
    }
    writeFiles(folder.path(), s, slices);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_NE(messageOf(*volume, key::kRescaleStep), nullptr);
}

TEST_F(RescaleSteps, AScannerThatStoresOtherNumbersAlongWithItHasNone) {
    const SyntheticSeries s = seriesOf(kCt);
    auto slices = slicesOf(s, kCt);
    for (Slice& slice : slices) slice.intercept = slice.place < 12 ? 0.0 : -1024.0;
    writeFiles(folder.path(), s, slices);
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kChangesAlongStack)) << opened.keys();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    for (const std::string_view key : kAllKeys) EXPECT_EQ(messageOf(*volume, key), nullptr) << key;
    expectValues(*volume, 0, anatomy);
}

// HU in one half and a concentration in the other are never one volume.
TEST_F(RescaleSteps, AnotherUnitIsAnotherVolume) {
    const SyntheticSeries s = seriesOf(kCt);
    auto slices = slicesOf(s, kCt);
    for (Slice& slice : slices) {
        if (slice.place >= 14) slice.edits.push_back([](DcmItem& i) { put(i, DCM_RescaleType, "MGML"); });
    }
    writeFiles(folder.path(), s, slices);
    const Opened opened = open();
    const auto volumes = opened.volumes();
    ASSERT_EQ(volumes.size(), 2u) << opened.keys();
    const auto first = opened.load(*volumes[0]);
    const auto second = opened.load(*volumes[1]);
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->unit(), Unit::hounsfield);
    EXPECT_EQ(first->size().z, 14);
    EXPECT_EQ(second->unit(), Unit::other);
    EXPECT_EQ(second->unitName(), "MGML");
    EXPECT_EQ(second->size().z, 10);
    const Message* told = opened.find(key::kInconsistentUnits);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_EQ(told->severity, Severity::warning);
    EXPECT_EQ(numberArgument(*told, "count"), 10.0);
}

// Every second slice without a type is no other unit, where HU is the definition.
TEST_F(RescaleSteps, ATypeThatSomeDoNotNameIsNoOtherUnit) {
    const SyntheticSeries s = seriesOf(kCt);
    auto slices = slicesOf(s, kCt);
    for (Slice& slice : slices) {
        if (slice.place % 2 == 0) slice.edits.push_back([](DcmItem& i) { erase(i, DCM_RescaleType); });
    }
    writeFiles(folder.path(), s, slices);
    const Opened opened = open();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->unit(), Unit::hounsfield);
    EXPECT_FALSE(opened.says(key::kInconsistentUnits)) << opened.keys();
}

TEST_F(NoFalseAlarm, OfSeriesThatAreRight) {
    struct Right {
        const char* name;
        Kind kind;
        std::function<double(int, int, int)> value;
    };
    const Right all[]{
        {"CT", kCt, anatomy},
        {"PET with a rescale for each slice", kPet, anatomy},
        {"an organ that begins and ends", kCt,
         [](int i, int j, int k) { return anatomy(i, j, k) + (k > 7 && k < 13 && i < 12 ? 900.0 : 0.0); }},
        {"a scan that ends in air", kCt,
         [](int i, int j, int k) { return k < 15 ? anatomy(i, j, k) : -1000.0; }},
        {"one slice of metal", kCt,
         [](int i, int j, int k) { return k == 9 && i > 8 && i < 12 && j < 4 ? 3000.0 : anatomy(i, j, k); }},
        // As of a dose or a map of few spots: empty slices between others.
        {"two spots far apart", kUnsignedCt,
         [](int i, int j, int k) { return (k < 4 || k > 12) && i > 8 && i < 12 && j < 4 ? 500.0 : -1024.0; }},
        {"a phantom that never changes", kCt, [](int i, int j, int) { return anatomy(i, j, 0); }},
        {"nothing at all", kCt, [](int, int, int) { return 0.0; }},
    };
    for (const Right& right : all) {
        SCOPED_TRACE(right.name);
        const TemporaryFolder own;
        SyntheticSeries s = seriesOf(right.kind);
        s.rawInstead = [&](const Slice& slice, int i, int j) {
            const double value = right.value(i, j, slice.place) + right.kind.offset;
            return static_cast<int>(std::lround((value - slice.intercept) / slice.slope));
        };
        const auto slices = slicesOf(s, right.kind);
        writeFiles(own.path(), s, slices);
        const auto volume = Opened(own.path()).onlyVolume();
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->size().z, 24);
        for (const std::string_view key : kAllKeys) EXPECT_EQ(messageOf(*volume, key), nullptr) << key;
    }
}

// Real series of CT, MR and PET: none of them has any of these faults.
TEST_F(NoFalseAlarm, OfRealSeries) {
    SKIP_WITHOUT_SHARED_DATA();
    for (const char* name : {"ct_chest_ricord", "ct_cta_rider", "mr_head_sag_hfs", "odd"}) {
        SCOPED_TRACE(name);
        const Opened opened(sharedData() / name);
        EXPECT_FALSE(opened.volumes().empty());
        for (const std::string_view key :
             {key::kRepeatedElement, key::kSurplusFrames, key::kContradictedSyntax, key::kInconsistentUnits})
            EXPECT_FALSE(opened.says(key)) << key;
        for (const Stack* stack : opened.volumes()) {
            SCOPED_TRACE(fmt::format("{} of {} frames, {}", stack->modality, stack->frames.size(),
                                     stack->frames.front().instance->file.string()));
            const auto volume = opened.load(*stack);
            ASSERT_NE(volume, nullptr);
            for (const std::string_view key : kAllKeys) {
                const Message* told = messageOf(*volume, key);
                EXPECT_EQ(told, nullptr) << (told ? told->sentence : Text());
            }
        }
    }
}

}  // namespace
}  // namespace macula::dicom::test
