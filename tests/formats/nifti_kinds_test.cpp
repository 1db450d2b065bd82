// NIfTI-2, pairs, points in time and whole numbers of 64 bits.
#include "import_support.h"

namespace macula::formats::test {
namespace {

namespace fs = std::filesystem;
using namespace dicom::test;

// What version 2 has in other places and widths, by its definition alone.
std::string asNifti2(const NiftiBytes& narrow, bool bigEndian = false, const std::string& magic = "n+2") {
    std::string wide(540, '\0');
    const auto put = [&](std::size_t at, const auto value) {
        const std::string bytes = bytesOf(value, bigEndian);
        wide.replace(at, bytes.size(), bytes);
    };
    put(0, std::int32_t{540});
    wide.replace(4, 8, magic + std::string("\0\r\n\x1a\n", 5));
    put(12, narrow.get<std::int16_t>(70));
    put(14, narrow.get<std::int16_t>(72));
    for (std::size_t n = 0; n < 8; ++n) {
        put(16 + 8 * n, std::int64_t{narrow.get<std::int16_t>(40 + 2 * n)});
        put(104 + 8 * n, double(narrow.get<float>(76 + 4 * n)));
    }
    put(168, std::int64_t{magic == "n+2" ? 544 : 0});
    put(176, 2.0);   // slope
    put(184, 10.0);  // intercept
    put(348, std::int32_t{narrow.get<std::int16_t>(254)});
    for (std::size_t n = 0; n < 12; ++n) put(400 + 8 * n, double(narrow.get<float>(280 + 4 * n)));
    put(500, std::int32_t{2});
    return wide;
}

TEST_F(Import, Nifti2) {
    NiftiBytes narrow = makeNifti(4, 2);
    narrow.set(292, -5.0f);  // srow_x[3]
    std::string values(3 * 4 * 5 * 2, '\0');
    for (const bool bigEndian : {false, true}) {
        values.replace(2, 2, bytesOf(std::int16_t{-300}, bigEndian));
        const std::string file = asNifti2(narrow, bigEndian) + std::string(4, '\0') + values;
        for (const auto& [name, bytes] :
             {std::pair(std::string("a.nii"), file), {"a.nii.gz", gzipped(file)}}) {
            const auto volume = import(write(name, bytes));
            ASSERT_NE(volume, nullptr);
            EXPECT_EQ(volume->size(), glm::ivec3(3, 4, 5));
            EXPECT_EQ(volume->value(1, 0, 0), -590.0);
            EXPECT_EQ(volume->value(0, 0, 0), 10.0);
            EXPECT_EQ(volume->worldFromVoxel(), affine({-1, 0, 0}, {0, -2, 0}, {0, 0, 3}, {5, 0, 0}));
        }
    }
    std::string huge = asNifti2(narrow) + std::string(4, '\0') + values;
    huge.replace(24, 8, bytesOf(std::int64_t{1} << 40));
    EXPECT_SAYS(refused("a.nii", huge), "damaged");
}

TEST_F(Import, PairsOfHeaderAndImage) {
    NiftiBytes narrow = makeNifti(4, 2);
    std::string values(3 * 4 * 5 * 2, '\0');
    values.replace(2, 2, bytesOf(std::int16_t{77}));
    narrow.bytes.resize(348);
    narrow.bytes.replace(344, 3, "ni1");
    narrow.set(108, 0.0f);
    for (const std::string& header : {narrow.bytes, asNifti2(narrow, false, "ni2")}) {
        const bool isWide = header.size() == 540;
        for (const auto& [name, bytes] :
             {std::pair(std::string("p.img"), values), {"p.img.gz", gzipped(values)}}) {
            const fs::path image = write(name, bytes);
            const fs::path path = write("p.hdr", header);
            const auto volume = import(path);
            ASSERT_NE(volume, nullptr);
            EXPECT_EQ(volume->value(1, 0, 0), isWide ? 164.0 : 77.0);
            EXPECT_EQ(valuesFileOf(path), image) << "which is not to be overwritten";
            fs::remove(image);
        }
    }
    EXPECT_SAYS(refused("p.hdr", narrow.bytes), "missing");
    write("p.img", values.substr(0, 60));
    EXPECT_SAYS(refused("p.hdr", narrow.bytes), "cut off");
    EXPECT_FALSE(filesOfVolumeFile(folder_ / "p.hdr").ok()) << "they are not written";
}

// One volume for each point in time: each can be had, and what is not there is an error.
TEST_F(Import, VolumesOfSeveralTimes) {
    NiftiBytes file = makeNifti(4, 2);
    file.set<std::int16_t>(40, 4);
    file.set<std::int16_t>(48, 3);
    constexpr std::size_t kVolume = 3 * 4 * 5 * 2;
    file.bytes.resize(352 + 3 * kVolume);
    std::string lists =
        "NRRD0004\ntype: short\ndimension: 4\nspace: left-posterior-superior\nsizes: 3 4 5 3\n"
        "space directions: (1,0,0) (0,2,0) (0,0,3) none\nkinds: domain domain domain list\n"
        "endian: little\nencoding: raw\nspace origin: (0,0,0)\n\n";
    for (std::size_t t = 0; t < 3; ++t)
        file.set(352 + t * kVolume + 2, static_cast<std::int16_t>(10 * (t + 1)));
    lists += file.bytes.substr(352);
    for (const fs::path& path :
         {write("t.nii", file.bytes), write("t.nii.gz", gzipped(file.bytes)), write("t.nrrd", lists)}) {
        for (std::size_t t = 0; t < 3; ++t) {
            Progress progress;
            const auto volume = readVolumeFile(path, progress, t + 1);
            ASSERT_TRUE(volume) << volume.error().message;
            EXPECT_EQ((*volume)->value(1, 0, 0), 10.0 * double(t + 1));
            EXPECT_EQ((*volume)->size(), glm::ivec3(3, 4, 5));
            EXPECT_TRUE(
                anyContains((*volume)->provenance().assumptions,
                            fmt::format("3 volumes, one for each point in time; this is number {}", t + 1)));
        }
        const auto info = readVolumeFileInfo(path);
        ASSERT_TRUE(info);
        EXPECT_EQ(info->volumes, 3u);
        for (const std::size_t none : {0, 4}) {
            Progress progress;
            const auto volume = readVolumeFile(path, progress, none);
            ASSERT_FALSE(volume);
            EXPECT_EQ(volume.error().code, ErrorCode::usage);
            EXPECT_SAYS(volume.error().message.english(), "3 volumes");
        }
    }
    // What is cut off in the last is whole in the first.
    write("t.nii", file.bytes.substr(0, file.bytes.size() - 10));
    Progress progress;
    EXPECT_TRUE(readVolumeFile(folder_ / "t.nii", progress, 2));
    const auto cut = readVolumeFile(folder_ / "t.nii", progress, 3);
    ASSERT_FALSE(cut);
    EXPECT_SAYS(cut.error().message.english(), "cut off");
}

TEST_F(Import, WholeNumbersOf64Bits) {
    const fs::path path = folder_ / "a.nii";
    checkNiftiType<std::int64_t>(path, 1024, -1000, 3000, VoxelFormat::stored16);
    checkNiftiType<std::uint64_t>(path, 1280, 7, 4'000'000, VoxelFormat::float32);
    NiftiBytes file = makeNifti(1024, 8);
    file.set(352, (std::int64_t{1} << 53) + 1);
    const auto rounded = import(write("b.nii", file.bytes));
    ASSERT_NE(rounded, nullptr);
    EXPECT_TRUE(anyContains(rounded->provenance().assumptions, "beyond 2^53 were rounded"));
    // The long of MetaImage: 4 bytes by its definition, and 8 where the file has so many.
    const std::string header =
        "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nTransformMatrix = 1 0 0 0 1 "
        "0 0 0 1\n"
        "ElementType = MET_LONG\nElementDataFile = LOCAL\n";
    std::string four;
    std::string eight;
    for (std::int32_t n = 0; n < 8; ++n) {
        four += bytesOf(n - 4);
        eight += bytesOf(std::int64_t{n - 4});
    }
    for (const auto& [values, isAssumed] : {std::pair(four, false), std::pair(eight, true)}) {
        const auto volume = import(write("l.mha", header + values));
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->value(0, 0, 0), -4.0);
        EXPECT_EQ(volume->value(1, 1, 1), 3.0);
        EXPECT_EQ(anyContains(volume->provenance().assumptions, "8 bytes each"), isAssumed);
    }
    const auto nrrd = import(write("l.nrrd",
                                   "NRRD0004\ntype: int64\ndimension: 3\nsizes: 2 2 2\nendian: little\n"
                                   "encoding: raw\nspace: left-posterior-superior\n"
                                   "space directions: (1,0,0) (0,1,0) (0,0,1)\n\n" +
                                       eight));
    ASSERT_NE(nrrd, nullptr);
    EXPECT_EQ(nrrd->value(1, 0, 0), -3.0);
}

}  // namespace
}  // namespace macula::formats::test
