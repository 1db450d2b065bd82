// NIfTI, NRRD and MetaImage files of other makers: each type, each way to say where the image lies, and each
// way to be wrong.
#include <cmath>
#include <random>

#include "import_support.h"

namespace macula::formats::test {

using namespace dicom::test;  // what the tests of readers share
namespace {

namespace fs = std::filesystem;
using namespace dicom;
using namespace dicom::test;

// Of a file that may not be read nobody knows what it is.
TEST_F(Import, WhatMayNotBeReadIsNotCalledAnotherFormat) {
    const std::string header =
        "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nspace: left-posterior-superior\n"
        "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\n";
    for (const char* name : {"a.mha", "a.mhd", "a.nrrd", "a.nhdr", "a.nii", "a.nii.gz"}) {
        const fs::path path = write(name, "x");
        fs::permissions(path, fs::perms::none);
        const WithoutRootsRights nobody;
        EXPECT_EQ(refusal(path), "The file cannot be read.") << name;
        const auto info = readVolumeFileInfo(path);
        ASSERT_FALSE(info.ok()) << name;
        EXPECT_EQ(info.error().message, "The file cannot be read.") << name;
        EXPECT_SAYS(info.error().hint.english(), "permissions");
    }
    // The values beside a header that may be read.
    const fs::path values = write("b.raw", "eightval");
    const fs::path beside = write("b.nhdr", header + "data file: b.raw\n\n");
    EXPECT_NE(import(beside), nullptr);
    fs::permissions(values, fs::perms::none);
    const WithoutRootsRights nobody;
    Progress progress;
    const auto refused = readVolumeFile(beside, progress);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().message, "The file cannot be read.");
    EXPECT_EQ(refused.error().where, values.string());
}

TEST_F(Import, NiftiTypes) {
    const fs::path path = folder_ / "a.nii";
    checkNiftiType<std::uint8_t>(path, 2, 1, 255, VoxelFormat::stored16);
    checkNiftiType<std::int8_t>(path, 256, -128, 127, VoxelFormat::stored16);
    checkNiftiType<std::int16_t>(path, 4, -32768, 32767, VoxelFormat::stored16);
    checkNiftiType<std::uint16_t>(path, 512, 1, 65535, VoxelFormat::stored16);
    checkNiftiType<std::int32_t>(path, 8, -1024, 64511, VoxelFormat::stored16);
    checkNiftiType<std::int32_t>(path, 8, -1024, 64512, VoxelFormat::float32);
    checkNiftiType<std::uint32_t>(path, 768, 0, 4000000000u, VoxelFormat::float32);
    checkNiftiType<float>(path, 16, -1000.0f, 3000.0f, VoxelFormat::stored16);
    checkNiftiType<float>(path, 16, 0.25f, 1e30f, VoxelFormat::float32);
    checkNiftiType<double>(path, 64, -1000.0, 3000.0, VoxelFormat::stored16);
    checkNiftiType<double>(path, 64, 0.1, 1e30, VoxelFormat::float32);
}

TEST_F(Import, RoundingIsSaid) {
    NiftiBytes file = makeNifti(64, 8);
    file.set(352, 0.1);
    EXPECT_TRUE(anyContains(import(write("a.nii", file.bytes))->provenance().assumptions, "rounded"));
    file.set(352, 0.25);
    EXPECT_FALSE(anyContains(import(write("a.nii", file.bytes))->provenance().assumptions, "rounded"));
    file.set(352, 1e300);  // beyond float32: no measurement
    EXPECT_TRUE(std::isnan(import(write("a.nii", file.bytes))->value(0, 0, 0)));
}

TEST_F(Import, NiftiSlopeAndIntercept) {
    for (const auto& [slope, intercept] : {std::pair{0.5f, -3.0f}, {-2.0f, 10.0f}, {1.0f, -1024.0f}}) {
        NiftiBytes file = makeNifti(4, 2);
        file.set<std::int16_t>(352, 100);
        file.set<std::int16_t>(354, -7);
        file.set(112, slope);
        file.set(116, intercept);
        const auto volume = import(write("a.nii", file.bytes));
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->format(), VoxelFormat::stored16);
        EXPECT_EQ(volume->value(0, 0, 0), 100.0 * slope + intercept);
        EXPECT_EQ(volume->value(1, 0, 0), -7.0 * slope + intercept);
        EXPECT_EQ(volume->value(2, 0, 0), intercept);
    }
    // A slope of 0 or no number means that there is none, whatever the intercept.
    for (const float none : {0.0f, std::nanf(""), INFINITY}) {
        NiftiBytes file = makeNifti(4, 2);
        file.set<std::int16_t>(352, 100);
        file.set(112, none);
        file.set(116, 55.0f);
        EXPECT_EQ(import(write("a.nii", file.bytes))->value(0, 0, 0), 100.0);
    }
}

// A phase image of MR with slope 2 and intercept -4096 reaches as low as air, in whole numbers.
TEST_F(Import, NoUnitIsGuessed) {
    for (const float intercept : {0.0f, -4096.0f}) {
        NiftiBytes file = makeNifti(4, 2);
        file.set<std::int16_t>(352, -1024);
        if (intercept != 0.0f) file.set(112, 2.0f);
        file.set(116, intercept);
        const auto volume = import(write("a.nii", file.bytes));
        EXPECT_EQ(volume->unit(), Unit::raw);
        EXPECT_EQ(volume->modality(), "");
        EXPECT_TRUE(anyContains(volume->provenance().assumptions, "none was assumed"));
    }
}

// What Macula wrote about the values holds while they have the type it wrote.
TEST_F(Import, TheUnitMaculaWroteIsTakenUnlessTheTypeChanged) {
    for (const auto& [note, unit] :
         {std::pair("Macula|int16|HU|CT", Unit::hounsfield),
          std::pair("Macula|int16|Bq/mL|PT", Unit::becquerelsPerMillilitre),
          std::pair("Macula|float32|HU|CT", Unit::raw), std::pair("Macula|int16|HU", Unit::raw),
          std::pair("Other|int16|HU|CT", Unit::raw)}) {
        SCOPED_TRACE(note);
        NiftiBytes file = makeNifti(4, 2);
        file.bytes.replace(148, std::string(note).size(), note);
        EXPECT_EQ(import(write("a.nii", file.bytes))->unit(), unit);
        file.set(112, 2.0f);  // somebody's slope
        EXPECT_EQ(import(write("a.nii", file.bytes))->unit(), Unit::raw);
    }
}

// Other values do not calibrate what was not.
TEST_F(Import, UncalibratedStaysSoWhateverBecameOfTheValues) {
    for (const auto& [note, isCalibrated] :
         {std::pair("Macula|int16|HU|CT|uncalibrated", false),
          std::pair("Macula|float32|HU|CT|uncalibrated", false),
          std::pair("Macula|int16|||uncalibrated", false), std::pair("Other|int16|HU|CT|uncalibrated", true),
          std::pair("Macula|int16|HU|CT|", true), std::pair("Macula|int16|HU|CT", true)}) {
        SCOPED_TRACE(note);
        NiftiBytes file = makeNifti(4, 2);
        file.bytes.replace(148, std::string(note).size(), note);
        const auto volume = import(write("a.nii", file.bytes));
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->provenance().isCalibrated, isCalibrated);
        EXPECT_NE(anyContains(volume->provenance().assumptions, "not calibrated"), isCalibrated);
    }
}

// A millimetre that was only assumed is no measure.
TEST_F(Import, WithoutASpacingPixelsAreNotCalibrated) {
    const std::string voxels(2 * 2 * 2 * 2, '\1');
    const std::string nrrd =
        "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nendian: little\n";
    const std::string meta =
        "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nDimSize = 2 2 2\n";
    const std::string metaEnd = "ElementType = MET_SHORT\nElementDataFile = LOCAL\n";
    for (const bool isCalibrated : {true, false}) {
        SCOPED_TRACE(isCalibrated);
        const auto read = [&](const char* name, const std::string& bytes) {
            const auto volume = import(write(name, bytes));
            ASSERT_NE(volume, nullptr);
            EXPECT_EQ(volume->provenance().isCalibrated, isCalibrated) << name;
            EXPECT_NE(anyContains(volume->provenance().assumptions, "1 mm was assumed"), isCalibrated)
                << name;
        };
        read("a.nrrd", nrrd + (isCalibrated ? "spacings: 1 1 1\n\n" : "\n") + voxels);
        read("a.mha", meta + (isCalibrated ? "ElementSpacing = 1 1 1\n" : "") + metaEnd + voxels);
    }
}

TEST_F(Import, ValuesThatAreNoFiniteNumberAreCountedAndPadding) {
    NiftiBytes file = makeNifti(16, 4);
    file.set(352, std::nanf(""));
    file.set(356, INFINITY);
    file.set(360, -INFINITY);
    file.set(364, 0.5f);
    const auto volume = import(write("a.nii", file.bytes));
    ASSERT_NE(volume, nullptr);
    for (const int i : {0, 1, 2}) EXPECT_TRUE(volume->isPadding(i, 0, 0)) << i;
    EXPECT_TRUE(anyContains(volume->provenance().assumptions, "3 voxels hold no finite number"));
}

TEST_F(Import, NiftiBigEndianAndCompressed) {
    const NiftiBytes little = makeNifti(4, 2);
    std::string big = little.bytes;
    const auto swap = [&](std::size_t offset, std::size_t width) {
        std::reverse(big.begin() + std::ptrdiff_t(offset), big.begin() + std::ptrdiff_t(offset + width));
    };
    swap(0, 4);
    for (std::size_t at = 40; at < 56; at += 2) swap(at, 2);
    for (std::size_t at = 68; at < 76; at += 2) swap(at, 2);
    for (std::size_t at = 76; at < 120; at += 4) swap(at, 4);
    for (std::size_t at = 252; at < 256; at += 2) swap(at, 2);
    for (std::size_t at = 256; at < 328; at += 4) swap(at, 4);
    big.replace(352, 2, bytesOf<std::int16_t>(-321, true));
    for (const std::string name : {"a.nii", "b.NII.GZ"}) {
        const auto volume = import(write(name, name == "a.nii" ? big : gzipped(big)));
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->value(0, 0, 0), -321.0);
        EXPECT_EQ(volume->worldFromVoxel(), affine({-1, 0, 0}, {0, -2, 0}, {0, 0, 3}, {0, 0, 0}));
    }
}

TEST_F(Import, NiftiQformSpacingAloneAndUnits) {
    NiftiBytes file = makeNifti(4, 2);
    file.set<std::int16_t>(254, 0);
    // A quarter turn about z, left-handed: i leads to +y, j to -x, k down.
    file.set<std::int16_t>(252, 1);
    file.set(76, -1.0f);
    file.set(264, std::sqrt(0.5f));
    file.set(268, 10.0f);
    const auto turned = import(write("a.nii", file.bytes));
    EXPECT_LT(affineError(turned->worldFromVoxel(), affine({0, -1, 0}, {2, 0, 0}, {0, 0, -3}, {-10, 0, 0})),
              1e-6);
    EXPECT_EQ(turned->provenance().assumptions.size(), 1u);

    file.set<std::int16_t>(252, 0);
    const auto spaced = import(write("a.nii", file.bytes));
    EXPECT_EQ(spaced->worldFromVoxel(), affine({-1, 0, 0}, {0, -2, 0}, {0, 0, 3}, {0, 0, 0}));
    EXPECT_TRUE(anyContains(spaced->provenance().assumptions, "may be exchanged"));

    for (const auto& [units, mm] :
         {std::pair{char{1}, 1000.0}, {char{3}, 0.001}, {char{0}, 1.0}, {char{10}, 1.0}}) {
        NiftiBytes other = makeNifti(4, 2);
        other.set(123, units);
        other.set(292, 5.0f);
        const auto scaled = import(write("a.nii", other.bytes));
        EXPECT_LT(affineError(scaled->worldFromVoxel(),
                              affine({-mm, 0, 0}, {0, -2 * mm, 0}, {0, 0, 3 * mm}, {-5 * mm, 0, 0})),
                  1e-9);
    }
}

TEST_F(Import, NiftiFormsThatDisagreeAreSaid) {
    NiftiBytes file = makeNifti(4, 2);
    file.set<std::int16_t>(252, 1);  // the identity, with the same spacing
    EXPECT_FALSE(anyContains(import(write("a.nii", file.bytes))->provenance().assumptions, "differ"));
    file.set(268, 4.0f);
    const auto volume = import(write("a.nii", file.bytes));
    EXPECT_TRUE(anyContains(volume->provenance().assumptions, "differ by up to 4.0 mm"));
    EXPECT_EQ(volume->worldFromVoxel()[3].x, 0.0);
}

TEST_F(Import, NiftiThatIsNoVolume) {
    EXPECT_SAYS(refused("a.nii", ""), "no NIfTI file");
    EXPECT_SAYS(refused("a.nii", "hello"), "no NIfTI file");
    EXPECT_SAYS(refused("a.nii", makeNifti(4, 2).bytes.substr(0, 100)), "cut off");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.set<std::int32_t>(0, 540); }), "cut off");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) {
                    f.set<std::int32_t>(0, 540);
                    f.bytes += std::string(600, '\0');
                }),
                "damaged");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.bytes.replace(344, 3, "ni1"); }), "(.img) is missing");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.bytes.replace(344, 4, std::string(4, '\0')); }),
                "ANALYZE");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.set<std::int16_t>(70, 128); }), "colour");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.set<std::int16_t>(70, 1536); }), "data type 1536");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.set<std::int16_t>(40, 2), f.set<std::int16_t>(46, 1); }),
                "no volume");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.set<std::int16_t>(40, 5), f.set<std::int16_t>(50, 3); }),
                "several values");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.set<std::int16_t>(40, 9); }), "damaged");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.set<std::int16_t>(42, -3); }), "damaged");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.set(108, 0.0f); }), "damaged");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.set(108, std::nanf("")); }), "damaged");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.set(108, 400.0f); }), "cut off");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.set(280, 0.0f); }), "do not span");
    EXPECT_SAYS(refusedNifti([](NiftiBytes& f) { f.set(280, std::nanf("")); }), "do not span");
    // Trailing axes of one are none.
    NiftiBytes four = makeNifti(4, 2);
    four.set<std::int16_t>(40, 4);
    EXPECT_NE(import(write("a.nii", four.bytes)), nullptr);
}

TEST_F(Import, SizesThatTheFileCannotHold) {
    const auto huge = [](NiftiBytes& f) {
        for (const std::size_t at : {42, 44, 46}) f.set<std::int16_t>(at, 32767);
    };
    EXPECT_SAYS(refusedNifti(huge), "cut off");
    NiftiBytes file = makeNifti(4, 2);
    huge(file);
    EXPECT_SAYS(refused("a.nii.gz", gzipped(file.bytes)), "cut off");
    EXPECT_SAYS(refused("a.nii", makeNifti(4, 2).bytes.substr(0, 400)), "cut off");
    const std::string packed = gzipped(makeNifti(4, 2).bytes);
    EXPECT_SAYS(refused("a.nii.gz", packed.substr(0, packed.size() - 20)), "cut off");
    // What follows the stream and is none itself does not matter.
    for (const std::string& stray :
         {std::string(1, '\0'), std::string(512, '\0'), std::string("\x1F\x8Bno more")}) {
        Progress progress;
        EXPECT_TRUE(readVolumeFile(write("a.nii.gz", packed + stray), progress)) << stray.size();
    }
    EXPECT_SAYS(refused("a.nii.gz", packed.substr(0, packed.size() - 20) + std::string(512, '\0')), "");
    // Deflate could hold this many zeros, and does not.
    NiftiBytes more = makeNifti(4, 2);
    more.set<std::int16_t>(42, 100);
    EXPECT_SAYS(refused("a.nii.gz", gzipped(more.bytes)), "cut off");
}

// 2 x 3 x 2 voxels of 16 bits, 0 to 11.
std::string counted(bool bigEndian = false) {
    std::string bytes;
    for (std::int16_t n = 0; n < 12; ++n) bytes += bytesOf(n, bigEndian);
    return bytes;
}

std::string nrrd(const std::string& fields, const std::string& data) {
    return "NRRD0004\n# by hand\n" + fields + "\n" + data;
}

const std::string kNrrdCore = "type: short\ndimension: 3\nsizes: 2 3 2\n";
const std::string kNrrdRaw = kNrrdCore + "endian: little\nencoding: raw\n";
const std::string kNrrdPlace = "space directions: (2,0,0) (0,3,0) (0,1,4)\nspace origin: (5,6,7)\n";

TEST_F(Import, NrrdSpaces) {
    struct Case {
        const char* space;
        glm::dvec3 sign;
    };
    for (const Case& c :
         {Case{"left-posterior-superior", {1, 1, 1}}, Case{"right-anterior-superior", {-1, -1, 1}},
          Case{"left-anterior-superior", {1, -1, 1}}, Case{"RAS", {-1, -1, 1}}}) {
        const auto volume =
            import(write("a.nrrd", nrrd(kNrrdRaw + "space: " + c.space + "\n" + kNrrdPlace, counted())));
        ASSERT_NE(volume, nullptr);
        const glm::dmat4 wanted = affine(glm::dvec3(2, 0, 0) * c.sign, glm::dvec3(0, 3, 0) * c.sign,
                                         glm::dvec3(0, 1, 4) * c.sign, glm::dvec3(5, 6, 7) * c.sign);
        EXPECT_LT(affineError(volume->worldFromVoxel(), wanted), 1e-12) << c.space;
        EXPECT_EQ(volume->value(1, 2, 1), 11.0);
        EXPECT_EQ(volume->value(1, 0, 0), 1.0);
        EXPECT_FALSE(anyContains(volume->provenance().assumptions, "lies in the patient"));
    }
    const auto spaced = import(write("a.nrrd", nrrd(kNrrdRaw + "spacings: 2 3 4\n", counted())));
    EXPECT_LT(affineError(spaced->worldFromVoxel(), affine({2, 0, 0}, {0, 3, 0}, {0, 0, 4}, {0, 0, 0})),
              1e-12);
    EXPECT_TRUE(anyContains(spaced->provenance().assumptions, "may be exchanged"));
}

TEST_F(Import, NrrdEncodings) {
    const std::string place = "space: left-posterior-superior\n" + kNrrdPlace;
    const auto big =
        import(write("a.nrrd", nrrd(kNrrdCore + "endian: big\nencoding: raw\n" + place, counted(true))));
    EXPECT_EQ(big->value(1, 2, 1), 11.0);
    const auto packed = import(
        write("a.nrrd", nrrd(kNrrdCore + "endian: little\nencoding: gzip\n" + place, gzipped(counted()))));
    EXPECT_EQ(packed->value(1, 2, 1), 11.0);
    write("v.raw", "skip" + counted());
    const auto detached =
        import(write("a.nhdr", nrrd(kNrrdRaw + "byte skip: 4\ndata file: v.raw\n" + place, "")));
    EXPECT_EQ(detached->value(1, 2, 1), 11.0);
    const auto windows =
        import(write("a.nrrd",
                     "NRRD0004\r\ntype: short\r\ndimension: 3\r\nsizes: 2 3 2\r\nendian: little\r\n"
                     "encoding: raw\r\n\r\n" +
                         counted()));
    ASSERT_NE(windows, nullptr);
    EXPECT_EQ(windows->value(1, 2, 1), 11.0);
}

TEST_F(Import, NrrdThatIsNoVolume) {
    const auto says = [&](const std::string& fields) { return refused("a.nrrd", nrrd(fields, counted())); };
    EXPECT_SAYS(refused("a.nrrd", ""), "no NRRD");
    EXPECT_SAYS(refused("a.nrrd", "NRRD0004"), "damaged");
    EXPECT_SAYS(says("type: short\ndimension: 2\nsizes: 2 3\nendian: little\nencoding: raw\n"), "two axes");
    EXPECT_SAYS(says("type: short\ndimension: 4\nsizes: 2 3 2 1\nendian: little\nencoding: raw\n"), "4 axes");
    EXPECT_SAYS(says(kNrrdRaw + "kinds: RGB-color domain domain\n"), "several values");
    EXPECT_SAYS(says(kNrrdRaw + "space: left-posterior-superior\nspace directions: none (0,1,0) (0,0,1)\n"),
                "lie in space");
    EXPECT_SAYS(says("type: block\ndimension: 3\nsizes: 2 3 2\nblock size: 2\nencoding: raw\n"), "neither");
    EXPECT_SAYS(says(kNrrdCore + "encoding: ascii\n"), "does not read");
    EXPECT_SAYS(
        says(kNrrdRaw + "space: left-posterior-superior\n" + kNrrdPlace + "space units: \"m\" \"m\" \"m\"\n"),
        "millimetres");
    EXPECT_SAYS(says(kNrrdRaw + "sizes: 2 3 2\n"), "damaged");
    EXPECT_SAYS(says(kNrrdCore + "encoding: raw\n"), "damaged");  // which byte is first?
    EXPECT_SAYS(says("type: short\ndimension: 3\nsizes: 2 3 3000000\nendian: little\nencoding: raw\n"),
                "shown");
    EXPECT_SAYS(says("type: double\ndimension: 3\nsizes: 2000000000 2000000000 2000000000\nendian: little\n"
                     "encoding: raw\nbyte skip: -1\n"),
                "shown");
    EXPECT_SAYS(says("type: short\ndimension: 3\nsizes: 2 3 60000\nendian: little\nencoding: raw\n"),
                "cut off");
    EXPECT_SAYS(says("type: short\ndimension: 3\nsizes: 2 3 -2\nendian: little\nencoding: raw\n"), "damaged");
    EXPECT_SAYS(says(kNrrdRaw + "content: " + std::string(100000, 'x') + "\n"), "damaged");
    EXPECT_SAYS(
        says(kNrrdRaw + "space: left-posterior-superior\nspace directions: (0,0,0) (0,1,0) (0,0,1)\n"), "");
    EXPECT_SAYS(refused("a.nrrd", nrrd(kNrrdRaw, counted().substr(1))), "cut off");
    EXPECT_SAYS(refused("a.nrrd", nrrd(kNrrdCore + "endian: little\nencoding: gzip\n",
                                       gzipped(counted()).substr(0, 20))),
                "amaged");
    EXPECT_SAYS(
        refused("a.nrrd", nrrd(kNrrdCore + "endian: little\nencoding: gzip\n", gzipped(counted().substr(4)))),
        "amaged");
}

std::string meta(const std::string& fields, const std::string& data, const std::string& file = "LOCAL") {
    return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n" + fields +
           "ElementDataFile = " + file + "\n" + data;
}

const std::string kMetaCore =
    "DimSize = 2 3 2\nElementType = MET_SHORT\nElementSpacing = 2 3 4\nOffset = 5 6 7\n";
const std::string kMetaPlace = "TransformMatrix = 1 0 0 0 -1 0 0 0.6 0.8\n";

TEST_F(Import, MetaImage) {
    const auto volume = import(write("a.mha", meta(kMetaCore + kMetaPlace, counted())));
    ASSERT_NE(volume, nullptr);
    EXPECT_LT(affineError(volume->worldFromVoxel(), affine({2, 0, 0}, {0, -3, 0}, {0, 2.4, 3.2}, {5, 6, 7})),
              1e-12);
    EXPECT_EQ(volume->value(1, 2, 1), 11.0);
    EXPECT_FALSE(anyContains(volume->provenance().assumptions, "lies in the patient"));
    const auto plain = import(write("a.mha", meta(kMetaCore, counted())));
    EXPECT_TRUE(anyContains(plain->provenance().assumptions, "may be exchanged"));

    write("v.raw", counted());
    EXPECT_EQ(import(write("a.mhd", meta(kMetaCore, "", "v.raw")))->value(1, 2, 1), 11.0);

    const auto scaled = import(write(
        "a.mha",
        meta(kMetaCore + "ElementToIntensityFunctionSlope = 0.5\nElementToIntensityFunctionOffset = -3\n",
             counted())));
    EXPECT_EQ(scaled->value(1, 2, 1), 2.5);
    EXPECT_EQ(scaled->value(0, 0, 0), -3.0);
}

TEST_F(Import, MetaImageThatIsNoVolume) {
    const auto says = [&](const std::string& fields) { return refused("a.mha", meta(fields, counted())); };
    EXPECT_SAYS(refused("a.mha", ""), "no MetaImage");
    EXPECT_SAYS(refused("a.mha", "hello\n"), "no MetaImage");
    EXPECT_SAYS(
        refused("a.mha", "NDims = 2\nDimSize = 2 3\nElementType = MET_SHORT\nElementDataFile = LOCAL\n"),
        "two axes");
    EXPECT_SAYS(
        refused("a.mha", "NDims = 100000\nDimSize = 2 3\nElementType = MET_SHORT\nElementDataFile = LOCAL\n"),
        "100000 axes");
    EXPECT_SAYS(says(kMetaCore + "ElementNumberOfChannels = 3\n"), "several values");
    EXPECT_SAYS(says("DimSize = 2 3 2\nElementType = MET_USHORT_ARRAY\n"), "several values");
    EXPECT_SAYS(says("DimSize = 2 3 2\nElementType = MET_STRING\n"), "neither");
    EXPECT_SAYS(says("DimSize = 2 3 2\nElementType = MET_LONG_LONG\n"), "cut off");
    EXPECT_SAYS(says(kMetaCore + "DimSize = 2 3 2\n"), "damaged");
    EXPECT_SAYS(says("DimSize = 60000 60000 60000\nElementType = MET_SHORT\n"), "cut off");
    EXPECT_SAYS(says(kMetaCore + "CompressedData = True\nCompressedDataSize = 1152921504606846976\n"),
                "damaged");
    EXPECT_SAYS(says(kMetaCore + "CompressedData = True\nCompressedDataSize = 24\n"), "amaged");
    EXPECT_SAYS(says(kMetaCore + "HeaderSize = 99999999\n"), "damaged");
    EXPECT_SAYS(says(kMetaCore + "ElementToIntensityFunctionSlope = 0\n"), "map from stored");
    EXPECT_SAYS(says(kMetaCore + "Comment = " + std::string(100000, 'x') + "\n"), "damaged");
    EXPECT_SAYS(refused("a.mha", meta(kMetaCore, counted().substr(1))), "cut off");
    EXPECT_SAYS(refused("a.mha", "NDims = 3\nBinaryData = False\n" + kMetaCore +
                                     "ElementDataFile = LOCAL\n0 1 2 3 4 5 6 7 8 9 10 11\n"),
                "as text");
}

// A header that names a file elsewhere must not get it read.
TEST_F(Import, ValuesStayInTheFolderOfTheHeader) {
    fs::create_directories(folder_ / "inside");
    write("secret.raw", counted());
    fs::create_symlink(folder_ / "secret.raw", folder_ / "inside/link.raw");
    for (const std::string& name :
         {(folder_ / "secret.raw").string(), std::string("../secret.raw"), std::string("..\\secret.raw"),
          std::string("link.raw"), std::string(".."), std::string("%s%n.raw"), std::string("LIST"),
          std::string("v%d.raw 1 2 1"), std::string("missing.raw")}) {
        EXPECT_NE(refused("inside/a.nhdr", nrrd(kNrrdRaw + "data file: " + name + "\n", "")), "accepted")
            << name;
        EXPECT_NE(refused("inside/a.mhd", meta(kMetaCore, "", name)), "accepted") << name;
    }
}

TEST_F(Import, NothingIsPrinted) {
    ::testing::internal::CaptureStderr();
    ::testing::internal::CaptureStdout();
    refused("a.mha", meta(kMetaCore + "CompressedData = True\nCompressedDataSize = 24\n", counted()));
    refused("a.mha", meta("DimSize = 2 3 2\nElementType = MET_SHORT\nTransformMatrix = 1 0\n", counted()));
    refused("a.nrrd", nrrd(kNrrdCore + "endian: little\nencoding: gzip\n", gzipped(counted()).substr(0, 20)));
    refused("a.nrrd", nrrd(kNrrdRaw + "space: nowhere\nspace directions: (1,2\n", counted()));
    const std::string printed =
        ::testing::internal::GetCapturedStderr() + ::testing::internal::GetCapturedStdout();
    EXPECT_EQ(printed, "");
}

// Whatever a byte is changed to: a volume or a sentence, in bounded time and memory, and nothing printed.
TEST_F(Import, ChangedBytes) {
    const std::string place =
        "space: left-posterior-superior\n" + kNrrdPlace + "kinds: domain domain domain\n";
    const std::vector<std::pair<std::string, std::string>> seeds{
        {"a.nii", makeNifti(4, 2).bytes},
        {"a.nii.gz", gzipped(makeNifti(16, 4).bytes)},
        {"a.nrrd", nrrd(kNrrdRaw + place, counted())},
        {"b.nrrd", nrrd(kNrrdCore + "endian: little\nencoding: gzip\n" + place, gzipped(counted()))},
        {"a.mha", meta(kMetaCore + kMetaPlace, counted())},
        {"b.mha", meta(kMetaCore + kMetaPlace + "CompressedData = True\nCompressedDataSize = 30\n",
                       gzipped(counted()))}};
    ::testing::internal::CaptureStderr();
    ::testing::internal::CaptureStdout();
    std::mt19937 random(20240607);
    for (const auto& [name, seed] : seeds) {
        for (int turn = 0; turn < 1500; ++turn) {
            std::string bytes = seed;
            for (unsigned change = 0; change <= random() % 4; ++change) {
                const std::size_t at = random() % std::min<std::size_t>(bytes.size(), 400);
                switch (random() % 4) {
                    case 0:
                        bytes[at] = static_cast<char>(random());
                        break;
                    case 1:
                        bytes[at] = static_cast<char>('0' + random() % 10);
                        break;
                    case 2:
                        bytes.erase(at, random() % 8);
                        break;
                    default:
                        bytes.insert(at, bytes.substr(random() % bytes.size(), random() % 24));
                        break;
                }
            }
            Progress progress;
            const auto volume = readVolumeFile(write(name, bytes), progress);
            EXPECT_TRUE(volume.ok() || !volume.error().message.empty());
        }
    }
    const std::string printed =
        ::testing::internal::GetCapturedStderr() + ::testing::internal::GetCapturedStdout();
    EXPECT_EQ(printed, "");
}

}  // namespace
}  // namespace macula::formats::test
