// D9 rescale, D10 cells: what a voxel is worth (PS3.3 C.11.1, C.7.6.16.2.11; PS3.5 8.1).
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cmath>

#include "../synthetic_pet.h"
#include "dicom/loader.h"
#include "opened.h"

namespace macula::dicom::test {
namespace {

using D09Rescale = Pitfall;
using D10Cells = Pitfall;

// Each slice uses its whole range, as PET does: the coarsest slope decides nothing for the others.
TEST_F(D09Rescale, SlopePerSliceIsExactInEverySlice) {
    series.modality = "PT";
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.slope = 0.0371 * (1.0 + slice.place);
        slice.intercept = 0.0;
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kPerSliceRescale)) << opened.keys();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->unit(), Unit::raw);  // Units (0054,1001) are not there
    expectGrid(*volume, series.size, series.expectedAffine());
    // The oblique grid keeps place and k alike.
    for (const Slice& slice : slices) {
        for (int j = 0; j < series.size.y; ++j) {
            for (int i = 0; i < series.size.x; ++i) {
                const double exact = rawAt(series, slice, i, j) * slice.slope;
                ASSERT_NEAR(volume->value(i, j, slice.place), exact, 1e-6 * std::abs(exact));
            }
        }
    }
}

TEST_F(D09Rescale, OneIntegralSlopeStaysSixteenBits) {
    writeFiles(folder.path(), series);
    const Opened opened = open();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->format(), VoxelFormat::stored16);
    EXPECT_EQ(volume->unit(), Unit::hounsfield);
    EXPECT_FALSE(opened.says(key::kPerSliceRescale));
    for (const Slice& slice : slicesOf(series))
        EXPECT_EQ(volume->value(3, 2, slice.place), rawAt(series, slice, 3, 2) - 1024.0);
}

// Different intercepts, one slope: still whole numbers, still exact.
TEST_F(D09Rescale, InterceptPerSlice) {
    auto slices = slicesOf(series);
    for (Slice& slice : slices) slice.intercept = slice.place % 2 ? -1024.0 : 0.0;
    writeFiles(folder.path(), series, slices);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->unit(), Unit::hounsfield);
    for (const Slice& slice : slices)
        EXPECT_EQ(volume->value(3, 2, slice.place), rawAt(series, slice, 3, 2) + slice.intercept);
}

TEST_F(D09Rescale, MissingTagsAreOneAndZeroAndSaid) {
    series.writeRescale = false;
    series.intercept = 0.0;
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kMissingRescale)) << opened.keys();
    expectOnlyVolume(opened, series);
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->unit(), Unit::raw);  // whether they are HU nobody knows
    // MR has no rescale in its definition: nothing is missing there.
    const TemporaryFolder mr;
    series.modality = "MR";
    writeFiles(mr.path(), series);
    EXPECT_FALSE(Opened(mr.path()).says(key::kMissingRescale));
}

TEST_F(D09Rescale, NegativeSlope) {
    series.slope = -1.0;
    series.intercept = 5000.0;
    writeFiles(folder.path(), series);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->unit(), Unit::hounsfield);
}

TEST_F(D09Rescale, TinyAndHugeSlopes) {
    for (const double slope : {1e-6, 1e6}) {
        SCOPED_TRACE(slope);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.slope = slope;
        s.intercept = 0.0;
        s.ramp = Ramp{.value = 2000 * slope,
                      .throughMm = s.rampOf().throughMm,
                      .perMm = glm::dvec3(11, 23, 47) * slope};
        writeFiles(own.path(), s);
        const auto volume = Opened(own.path()).onlyVolume();
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->unit(), Unit::hounsfield);
        for (const Slice& slice : slicesOf(s)) {
            const double exact = rawAt(s, slice, 4, 3) * slope;
            EXPECT_NEAR(volume->value(4, 3, slice.place), exact, 1e-6 * exact);
        }
    }
}

TEST_F(D09Rescale, NonsenseIsNoValue) {
    for (const char* text : {"0", "NaN", "many", "1e999", "inf"}) {
        SCOPED_TRACE(text);
        const TemporaryFolder own;
        auto slices = slicesOf(series);
        for (Slice& slice : slices)
            slice.edits.push_back([&](DcmItem& item) { put(item, DCM_RescaleSlope, text); });
        writeFiles(own.path(), series, slices);
        const Opened opened(own.path());
        EXPECT_TRUE(opened.says(key::kInvalidRescale)) << opened.keys();
        EXPECT_TRUE(opened.volumes().empty());
        EXPECT_EQ(opened.frames(), 12u);
    }
}

// A CT image object is of CT, whether it says so or not: its values follow the rules of CT, and it is told.
TEST_F(D09Rescale, CtImagesWithoutModalityAreCtAndToldSo) {
    for (const bool isEmpty : {true, false}) {
        SCOPED_TRACE(isEmpty);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.edits.push_back([&](DcmItem& item) {
            erase(item, DCM_Modality);
            if (isEmpty) put(item, DCM_Modality, "");
        });
        writeFiles(own.path(), s);
        const Opened opened(own.path());
        const Message* told = opened.find(key::kMissingModality);
        ASSERT_NE(told, nullptr) << opened.keys();
        EXPECT_EQ(told->severity, Severity::warning);
        EXPECT_EQ(numberArgument(*told, "count"), 12.0);
        EXPECT_EQ(numberArgument(*told, "total"), 12.0);
        EXPECT_NE(told->sentence.english().find("CT"), std::string::npos) << told->sentence;
        const auto volume = opened.onlyVolume();
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->modality(), "CT");
        EXPECT_EQ(volume->unit(), Unit::hounsfield);
        const auto& assumed = volume->provenance().assumptions;
        EXPECT_NE(std::ranges::find(assumed, told->sentence), assumed.end());
    }
}

// The class says CT, and not that values are HU: a type that says otherwise, and a missing rescale, count.
TEST_F(D09Rescale, CtImagesWithoutModalityAreNotHounsfieldWhereNothingSaysSo) {
    for (const bool hasRescale : {true, false}) {
        SCOPED_TRACE(hasRescale);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.writeRescale = hasRescale;
        s.edits.push_back([&](DcmItem& item) {
            erase(item, DCM_Modality);
            if (hasRescale) put(item, DCM_RescaleType, "US");
        });
        if (!hasRescale) s.intercept = 0.0;
        writeFiles(own.path(), s);
        const Opened opened(own.path());
        EXPECT_TRUE(opened.says(key::kMissingModality)) << opened.keys();
        EXPECT_TRUE(opened.says(key::kNoHounsfield)) << opened.keys();
        EXPECT_EQ(opened.says(key::kMissingRescale), !hasRescale) << opened.keys();
        const auto volume = opened.onlyVolume();
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->unit(), Unit::raw);
    }
}

// A capture may be of any device: it is told, and values are HU only where their type says so.
TEST_F(D09Rescale, CapturesWithoutModalityAreOfAnUnknownDevice) {
    for (const auto& [type, unit] : {std::pair("", Unit::raw), std::pair("HU", Unit::hounsfield)}) {
        SCOPED_TRACE(type);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.sopClassUid = UID_SecondaryCaptureImageStorage;
        s.edits.push_back([type = std::string(type)](DcmItem& item) {
            erase(item, DCM_Modality);
            erase(item, DCM_RescaleType);
            if (!type.empty()) put(item, DCM_RescaleType, type);
        });
        writeFiles(own.path(), s);
        const Opened opened(own.path());
        const Message* told = opened.find(key::kMissingModality);
        ASSERT_NE(told, nullptr) << opened.keys();
        EXPECT_NE(told->sentence.english().find("unknown device"), std::string::npos) << told->sentence;
        const auto volume = opened.onlyVolume();
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->modality(), "");
        EXPECT_EQ(volume->unit(), unit);
    }
}

TEST_F(D09Rescale, ImagesThatSayTheirModalityAreNotToldOf) {
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_FALSE(opened.says(key::kMissingModality)) << opened.keys();
}

// Only who asks for it gets SUV; values and windows then have one factor.
TEST_F(D09Rescale, PetInSuvHasOneFactorForAll) {
    series = petSeries();
    writeFiles(folder.path(), series);
    const Opened opened = open();
    ASSERT_EQ(opened.volumes().size(), 1u);
    const Stack& stack = *opened.volumes().front();
    EXPECT_NEAR(stack.suvFactor.value_or(0.0), kSuvPerBqPerMl, 1e-12);
    Progress progress;
    const auto inFile = loadVolume(*opened.series().front(), stack, progress);
    const auto inSuv = loadVolume(*opened.series().front(), stack, progress, {.onCoarse = {}, .inSuv = true});
    ASSERT_TRUE(inFile.ok() && inSuv.ok());
    EXPECT_EQ((*inFile)->unit(), Unit::becquerelsPerMillilitre);
    EXPECT_EQ((*inSuv)->unit(), Unit::suvBodyWeight);
    EXPECT_EQ((*inSuv)->unitName(), "SUV bw");
    for (const Slice& slice : slicesOf(series)) {
        const double becquerels = rawAt(series, slice, 3, 2) * 10.0;
        EXPECT_NEAR((*inFile)->value(3, 2, slice.place), becquerels, 1e-6);
        EXPECT_NEAR((*inSuv)->value(3, 2, slice.place), becquerels * kSuvPerBqPerMl, 1e-9 * becquerels);
    }
    ASSERT_EQ((*inSuv)->windows().size(), 1u);
    const DisplayWindow& window = (*inSuv)->windows().front();
    EXPECT_NEAR(window.center + 0.5 * window.width, 65535.0 * kSuvPerBqPerMl, 1e-9);
    EXPECT_NEAR(window.center - 0.5 * window.width, 0.0, 1e-9);
}

// In floats too, where slopes differ, and as every fourth slice; without a dose it stays what it is.
TEST_F(D09Rescale, PetOfFloatsInSuv) {
    for (const bool hasDose : {true, false}) {
        const TemporaryFolder there;
        SyntheticSeries pet = petSeries(hasDose);
        pet.size.z = 20;
        auto slices = slicesOf(pet);
        for (Slice& slice : slices) slice.slope = 7.0 + 0.0371 * slice.place;
        writeFiles(there.path(), pet, slices);
        const Opened opened(there.path());
        ASSERT_EQ(opened.volumes().size(), 1u);
        std::shared_ptr<const Volume> coarse;
        Progress progress;
        const auto volume = loadVolume(*opened.series().front(), *opened.volumes().front(), progress,
                                       {.onCoarse = [&](auto made) { coarse = made; }, .inSuv = true});
        ASSERT_TRUE(volume.ok());
        ASSERT_NE(coarse, nullptr);
        const double factor = hasDose ? kSuvPerBqPerMl : 1.0;
        EXPECT_EQ((*volume)->unit(), hasDose ? Unit::suvBodyWeight : Unit::becquerelsPerMillilitre);
        EXPECT_EQ((*volume)->format(), VoxelFormat::float32);
        for (const Slice& slice : slices) {
            const double exact = rawAt(pet, slice, 4, 3) * slice.slope * factor;
            EXPECT_NEAR((*volume)->value(4, 3, slice.place), exact, 1e-6 * exact);
            if (slice.place % 4 == 0) {
                EXPECT_NEAR(coarse->value(4, 3, slice.place / 4), exact, 1e-6 * exact);
            }
        }
    }
}

// SUVbw by the file's own word: the mapping takes stored values, not rescaled ones.
TEST_F(D09Rescale, RealWorldValuesOfPet) {
    series.modality = "PT";
    series.slope = 2.0;
    series.intercept = 0.0;
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back([n = slice.place](DcmItem& item) {
            DcmItem& map = nested(item, DCM_RealWorldValueMappingSequence);
            putWord(map, DCM_RealWorldValueFirstValueMapped, 0);
            putWord(map, DCM_RealWorldValueLastValueMapped, 65535);
            putNumber(map, DCM_RealWorldValueSlope, 0.001 * (1 + n % 3));
            putNumber(map, DCM_RealWorldValueIntercept, 0.25);
            put(map, DCM_LUTLabel, "SUVbw");
            DcmItem& unit = nested(map, DCM_MeasurementUnitsCodeSequence);
            put(unit, DCM_CodeValue, "{SUVbw}g/ml");
            put(unit, DCM_CodingSchemeDesignator, "UCUM");
            put(unit, DCM_CodeMeaning, "Standardized Uptake Value body weight");
        });
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kRealWorldValues)) << opened.keys();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->unit(), Unit::suvBodyWeight);
    for (const Slice& slice : slices) {
        const double exact = rawAt(series, slice, 4, 3) * 0.001 * (1 + slice.place % 3) + 0.25;
        EXPECT_NEAR(volume->value(4, 3, slice.place), exact, 1e-6 * exact);
    }
}

// A parametric map (PS3.3 A.75) is worth what its mapping says; that of an MR image is for display.
TEST_F(D09Rescale, RealWorldValuesOfParametricMaps) {
    for (const bool isMap : {true, false}) {
        SCOPED_TRACE(isMap);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.modality = "MR";
        if (isMap) s.sopClassUid = "1.2.840.10008.5.1.4.1.1.30";
        s.intercept = 0.0;
        const auto slices = slicesOf(s);
        writeMultiFrame(own / "map", s, slices,
                        {.edits = {[](DcmItem& item) {
                             DcmItem& shared = nested(item, DCM_SharedFunctionalGroupsSequence);
                             DcmItem& map = nested(shared, DCM_RealWorldValueMappingSequence);
                             putNumber(map, DCM_RealWorldValueSlope, 0.001);
                             putNumber(map, DCM_RealWorldValueIntercept, -0.5);
                             DcmItem& unit = nested(map, DCM_MeasurementUnitsCodeSequence);
                             put(unit, DCM_CodeValue, "mm2/s");
                             put(unit, DCM_CodingSchemeDesignator, "UCUM");
                             put(unit, DCM_CodeMeaning, "square millimeter per second");
                         }}});
        const Opened opened(own.path());
        EXPECT_EQ(opened.says(key::kRealWorldValues), isMap) << opened.keys();
        const auto volume = opened.onlyVolume();
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->unitName(), isMap ? "mm2/s" : "");
        for (const Slice& slice : slices) {
            const double raw = rawAt(s, slice, 4, 3);
            EXPECT_NEAR(volume->value(4, 3, slice.place), isMap ? 0.001 * raw - 0.5 : raw, 1e-4);
        }
    }
}

// Entry n of the table is worth 3 n^2 + 10; raw values below the first are worth the first entry, those above
// the last the last (PS3.3 C.11.1.1).
TEST_F(D09Rescale, ModalityLookupTable) {
    series.writeRescale = false;
    series.size.z = 3;
    series.rawInstead = [](const Slice& slice, int i, int j) { return 90 + i + 8 * j + slice.place; };
    series.edits.push_back([](DcmItem& item) {
        DcmItem& lut = nested(item, DCM_ModalityLUTSequence);
        const std::vector<Uint16> descriptor{40, 100, 16};
        lut.putAndInsertUint16Array(DcmTag(DCM_LUTDescriptor, EVR_US), descriptor.data(), 3);
        std::vector<Uint16> entries;
        for (Uint16 n = 0; n < 40; ++n) entries.push_back(static_cast<Uint16>(3 * n * n + 10));
        lut.putAndInsertUint16Array(DcmTag(DCM_LUTData, EVR_US), entries.data(), 40);
        put(lut, DCM_ModalityLUTType, "HU");
    });
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kModalityLut)) << opened.keys();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->unit(), Unit::hounsfield);
    for (int k = 0; k < 3; ++k) {
        for (int j = 0; j < 7; ++j) {
            for (int i = 0; i < 8; ++i) {
                const int n = std::clamp(90 + i + 8 * j + k - 100, 0, 39);
                ASSERT_EQ(volume->value(i, j, k), 3.0 * n * n + 10.0) << i << " " << j << " " << k;
            }
        }
    }
}

TEST_F(D09Rescale, BrokenLookupTableIsNoValue) {
    series.writeRescale = false;
    series.intercept = 0.0;
    series.edits.push_back([](DcmItem& item) {
        DcmItem& lut = nested(item, DCM_ModalityLUTSequence);
        const std::vector<Uint16> descriptor{4000, 0, 16};
        lut.putAndInsertUint16Array(DcmTag(DCM_LUTDescriptor, EVR_US), descriptor.data(), 3);
        const std::vector<Uint16> entries{1, 2, 3};
        lut.putAndInsertUint16Array(DcmTag(DCM_LUTData, EVR_US), entries.data(), 3);
    });
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kInvalidModalityLut)) << opened.keys();
    EXPECT_TRUE(opened.volumes().empty());
}

// PS3.3 C.8.8.3: the value is the stored one times DoseGridScaling. Raw numbers must not pass for a dose.
TEST_F(D09Rescale, DoseGrid) {
    series.modality = "RTDOSE";
    series.sopClassUid = "1.2.840.10008.5.1.4.1.1.481.2";
    series.writeRescale = false;
    series.intercept = 0.0;
    series.slope = 0.125;
    series.size = {6, 5, 4};
    series.worldFromVoxel = affine({2, 0, 0}, {0, 2.5, 0}, {0, 0, 3}, {-10, -20, -30});
    writeMultiFrame(folder / "dose", series, slicesOf(series),
                    {.functionalGroups = false,
                     .dimensions = false,
                     .edits = {[](DcmItem& item) {
                         put(item, DCM_PixelSpacing, "2.5\\2");
                         put(item, DCM_ImagePositionPatient, "-10\\-20\\-30");
                         put(item, DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0");
                         put(item, DCM_GridFrameOffsetVector, "0\\3\\6\\9");
                         put(item, DCM_DoseUnits, "GY");
                         put(item, DCM_DoseGridScaling, "0.125");
                     }}});
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->unit(), Unit::other);
    EXPECT_EQ(volume->unitName(), "Gy");
    expectGrid(*volume, series.size, series.worldFromVoxel);
    for (const Slice& slice : slicesOf(series))
        EXPECT_EQ(volume->value(3, 2, slice.place), rawAt(series, slice, 3, 2) * 0.125);
}

TEST_F(D09Rescale, FloatPixelDataAreTheValues) {
    series.size.z = 4;
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back([&](DcmItem& item) {
            std::vector<Float32> values;
            for (int n = 0; n < series.size.x * series.size.y; ++n)
                values.push_back(static_cast<Float32>(slice.place + 1.0 / (n + 3)));
            erase(item, DCM_PixelData);
            for (const DcmTagKey& tag : {DCM_BitsStored, DCM_HighBit, DCM_PixelRepresentation,
                                         DCM_RescaleSlope, DCM_RescaleIntercept, DCM_RescaleType})
                erase(item, tag);
            putWord(item, DCM_BitsAllocated, 32);
            put(item, DCM_SOPClassUID, "1.2.840.10008.5.1.4.1.1.30");  // Parametric Map
            item.putAndInsertFloat32Array(DCM_FloatPixelData, values.data(), values.size());
        });
    }
    writeFiles(folder.path(), series, slices);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->unit(), Unit::raw);
    EXPECT_EQ(volume->format(), VoxelFormat::float32);
    for (int k = 0; k < 4; ++k) {
        for (int n = 0; n < 56; ++n)
            ASSERT_EQ(volume->value(n % 8, n / 8, k), static_cast<float>(k + 1.0 / (n + 3)));
    }
}

TEST_F(D10Cells, EveryFormat) {
    const CellFormat formats[] = {
        {16, 12, 11, false}, {16, 12, 11, true},  {16, 12, 15, false}, {16, 12, 15, true},
        {16, 16, 15, true},  {16, 16, 15, false}, {16, 10, 11, false}, {16, 15, 14, true},
    };
    for (const CellFormat& format : formats) {
        SCOPED_TRACE(fmt::format("{} bits up to {}{}", format.bitsStored, format.highBit,
                                 format.isSigned ? ", signed" : ""));
        const TemporaryFolder own;
        SyntheticSeries s;
        s.format = format;
        s.cellNoise = 0xFFFF;  // overlays in the bits that are not stored
        s.intercept = format.isSigned ? 1500.0 : 1000.0;
        s.slope = 4.0;
        writeFiles(own.path(), s);
        expectOnlyVolume(Opened(own.path()), s);
    }
}

TEST_F(D10Cells, EightBits) {
    for (const bool isSigned : {false, true}) {
        const TemporaryFolder own;
        SyntheticSeries s;
        s.format = {8, 8, 7, isSigned};
        s.slope = 8.0;
        s.intercept = isSigned ? 2000.0 : 1000.0;
        writeFiles(own.path(), s);
        expectOnlyVolume(Opened(own.path()), s);
    }
}

// Some exporters decide on sign and bits slice by slice.
TEST_F(D10Cells, AnotherFormatInEverySlice) {
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.format.isSigned = slice.place % 2 == 1;
        slice.format.bitsStored = 12 + slice.place % 5;
        slice.format.highBit = slice.format.bitsStored - 1;
        slice.intercept = slice.format.isSigned ? 2000.0 : -10.0;
        slice.slope = 1.0;
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_EQ(opened.stacks().size(), 1u);
}

TEST_F(D10Cells, ThirtyTwoBitWholeNumbers) {
    series.size.z = 3;
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back([&](DcmItem& item) {
            std::vector<Uint16> halves;
            for (int n = 0; n < 56; ++n) {
                const auto raw = static_cast<Uint32>(70000 * (slice.place + 1) + n);
                halves.push_back(static_cast<Uint16>(raw));
                halves.push_back(static_cast<Uint16>(raw >> 16));
            }
            putWord(item, DCM_BitsAllocated, 32);
            putWord(item, DCM_BitsStored, 32);
            putWord(item, DCM_HighBit, 31);
            item.putAndInsertUint16Array(DCM_PixelData, halves.data(), halves.size());
        });
    }
    writeFiles(folder.path(), series, slices);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    for (int k = 0; k < 3; ++k) {
        for (int n = 0; n < 56; ++n)
            ASSERT_EQ(volume->value(n % 8, n / 8, k), 70000.0 * (k + 1) + n - 1024.0);
    }
}

}  // namespace
}  // namespace macula::dicom::test
