// Studies of the C interface: opened, listed, read; and what is refused.
#include <cstring>
#include <filesystem>
#include <limits>
#include <set>

#include "c/c_fixture.h"

namespace macula::test {
namespace {

TEST(CStudy, OfVoxelsHasThemWhereTheyAre) {
    const TwoBalls balls;
    const auto study = balls.study();
    ASSERT_NE(study, nullptr);
    EXPECT_EQ(macula_study_volumes(study.get()), 1u);
    EXPECT_NE(macula_study_title(study.get(), 0), nullptr);
    EXPECT_EQ(macula_study_title(study.get(), 1), nullptr);

    auto volume = sized<macula_volume>();
    ASSERT_EQ(macula_study_volume(study.get(), &volume), MACULA_DONE);
    EXPECT_EQ(volume.columns, TwoBalls::kSide);
    EXPECT_EQ(volume.slices, TwoBalls::kSide);
    EXPECT_EQ(volume.unit, MACULA_UNIT_HOUNSFIELD);
    EXPECT_STREQ(volume.unit_name, "HU");
    EXPECT_DOUBLE_EQ(volume.low, -1000.0);
    EXPECT_DOUBLE_EQ(volume.high, 1000.0);
    EXPECT_DOUBLE_EQ(volume.spacing_mm[2], 4.0);
    EXPECT_EQ(std::memcmp(volume.patient_from_voxel, balls.voxels().patient_from_voxel,
                          sizeof volume.patient_from_voxel),
              0);

    std::vector<float> values(balls.hu.size());
    ASSERT_EQ(macula_study_values(study.get(), values.data(), values.size()), MACULA_DONE);
    EXPECT_TRUE(std::equal(values.begin(), values.end(), balls.hu.begin(),
                           [](float value, std::int16_t hu) { return value == float(hu); }));
    expectError(macula_study_values(study.get(), values.data(), values.size() - 1), MACULA_USAGE);
    expectError(macula_study_values(study.get(), nullptr, values.size()), MACULA_USAGE);
}

TEST(CStudy, EveryTypeGivesTheSameValues) {
    const auto check = [](std::int32_t type, auto zero) {
        const std::vector<decltype(zero)> voxels{0, 1, 2, 3, 4, 5, 6, 127};
        macula_voxels given = TwoBalls().voxels();
        given.type = type;
        given.columns = given.rows = given.slices = 2;
        given.data = voxels.data();
        given.bytes = voxels.size() * sizeof zero;
        given.slope = 2.0;
        given.intercept = -10.0;
        macula_study* made = nullptr;
        ASSERT_EQ(macula_study_of_voxels(&given, nullptr, &made), MACULA_DONE) << type;
        const Owned<macula_study> study(made);
        std::vector<float> values(voxels.size());
        ASSERT_EQ(macula_study_values(made, values.data(), values.size()), MACULA_DONE);
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_FLOAT_EQ(values[i], 2.0f * float(voxels[i]) - 10.0f) << type;
    };
    check(MACULA_INT8, std::int8_t());
    check(MACULA_UINT8, std::uint8_t());
    check(MACULA_INT16, std::int16_t());
    check(MACULA_UINT16, std::uint16_t());
    check(MACULA_INT32, std::int32_t());
    check(MACULA_UINT32, std::uint32_t());
    check(MACULA_FLOAT32, float());
    check(MACULA_FLOAT64, double());
}

TEST(CStudy, WithoutAUnitNoneIsAssumedAndItIsSaid) {
    macula_voxels given = TwoBalls().voxels();
    const TwoBalls balls;
    given.data = balls.hu.data();
    given.unit = MACULA_UNIT_NONE;
    macula_study* made = nullptr;
    ASSERT_EQ(macula_study_of_voxels(&given, nullptr, &made), MACULA_DONE);
    const Owned<macula_study> study(made);
    ASSERT_FALSE(notesOf(made).empty());
    EXPECT_NE(notesOf(made)[0].find("unit"), std::string::npos) << notesOf(made)[0];
}

// What is no volume is refused before it is read.
TEST(CStudy, VoxelsThatAreNoneAreRefused) {
    const TwoBalls balls;
    const auto refused = [&](macula_status expected, const auto& change) {
        macula_voxels given = balls.voxels();
        change(given);
        auto* made = reinterpret_cast<macula_study*>(1);
        expectError(macula_study_of_voxels(&given, nullptr, &made), expected);
        EXPECT_EQ(made, nullptr);
    };
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    refused(MACULA_USAGE, [](macula_voxels& v) { v.size = 0; });
    refused(MACULA_USAGE, [](macula_voxels& v) { v.type = 0; });
    refused(MACULA_USAGE, [](macula_voxels& v) { v.type = 9; });
    refused(MACULA_USAGE, [](macula_voxels& v) { v.unit = 2; });
    refused(MACULA_USAGE, [](macula_voxels& v) { v.data = nullptr; });
    refused(MACULA_USAGE, [](macula_voxels& v) { v.bytes -= 1; });
    refused(MACULA_USAGE, [](macula_voxels& v) { v.patient_from_voxel[0] = kNan; });
    refused(MACULA_USAGE, [](macula_voxels& v) { v.patient_from_voxel[0] = 0.0; });
    refused(MACULA_USAGE, [](macula_voxels& v) { v.patient_from_voxel[15] = 0.0; });
    refused(MACULA_USAGE, [](macula_voxels& v) { v.patient_from_voxel[12] = kNan; });
    refused(MACULA_INPUT, [](macula_voxels& v) { v.columns = 1; });
    refused(MACULA_INPUT, [](macula_voxels& v) { v.rows = -24; });
    refused(MACULA_INPUT, [](macula_voxels& v) { v.slices = std::numeric_limits<std::int32_t>::max(); });
    refused(MACULA_INPUT, [](macula_voxels& v) { v.slope = kNan; });
    expectError(macula_study_of_voxels(nullptr, nullptr, nullptr), MACULA_USAGE);
}

// A newer header has members that this library does not know: it takes what it knows, unless they are in use.
TEST(CStudy, AStructOfANewerHeaderIsTakenWhereItAsksForNothingNew) {
    struct Newer {
        macula_open known;
        std::int32_t unknown[4];
    };
    Newer newer{};
    newer.known.size = sizeof newer;
    macula_study* made = nullptr;
    EXPECT_EQ(macula_study_open("phantom:", &newer.known, nullptr, &made), MACULA_DONE)
        << lastError().message;
    macula_study_close(made);
    newer.unknown[3] = 1;
    expectError(macula_study_open("phantom:", &newer.known, nullptr, &made), MACULA_USAGE);

    struct NewerVolume {
        macula_volume known;
        std::int64_t unknown;
    };
    NewerVolume volume{sized<macula_volume>(), -1};
    volume.known.size = sizeof volume;
    const auto study = TwoBalls().study();
    ASSERT_EQ(macula_study_volume(study.get(), &volume.known), MACULA_DONE);
    EXPECT_EQ(volume.known.size, sizeof volume);
    EXPECT_EQ(volume.unknown, 0);

    // An older one has room for less, and nothing is written beyond it.
    auto older = sized<macula_volume>();
    older.size = offsetof(macula_volume, unit);
    older.unit = 77;
    ASSERT_EQ(macula_study_volume(study.get(), &older), MACULA_DONE);
    EXPECT_EQ(older.columns, TwoBalls::kSide);
    EXPECT_EQ(older.unit, 77);
}

TEST(CStudy, APathThatIsNoneIsAnErrorThatSaysWhere) {
    const std::string nowhere = (std::filesystem::temp_directory_path() / "macula-nothing/DOE^JOHN").string();
    macula_study* made = nullptr;
    expectError(macula_study_open(nowhere.c_str(), nullptr, nullptr, &made), MACULA_INPUT);
    const macula_error error = lastError();
    EXPECT_EQ(std::string(error.message).find("DOE"), std::string::npos) << error.message;
    EXPECT_EQ(std::string(error.advice).find("DOE"), std::string::npos) << error.advice;
    EXPECT_NE(std::string(error.place).find("DOE"), std::string::npos);
    expectError(macula_study_open(nullptr, nullptr, nullptr, &made), MACULA_USAGE);
    expectError(macula_study_open("", nullptr, nullptr, &made), MACULA_USAGE);
    expectError(macula_study_open("phantom:", nullptr, nullptr, nullptr), MACULA_USAGE);
    // Asking in a wrong way for the error does not change it.
    macula_error small{};
    EXPECT_EQ(macula_last_error(&small), MACULA_USAGE);
    EXPECT_EQ(macula_last_error(nullptr), MACULA_USAGE);
    EXPECT_NE(std::string(lastError().message).find("null"), std::string::npos);
}

struct Heard {
    int calls = 0;
    std::int32_t answer = 0;
};

std::int32_t hear(void* user, const char* stage, double fraction) {
    auto& heard = *static_cast<Heard*>(user);
    EXPECT_STRNE(stage, "");
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    ++heard.calls;
    return heard.answer;
}

TEST(CStudy, ProgressIsToldAndCancels) {
    Heard heard;
    auto progress = sized<macula_progress>();
    progress.told = hear;
    progress.user = &heard;
    macula_study* made = nullptr;
    ASSERT_EQ(macula_study_open("phantom:", nullptr, &progress, &made), MACULA_DONE);
    macula_study_close(made);
    EXPECT_GE(heard.calls, 2);

    heard.answer = 1;
    EXPECT_EQ(macula_study_open("phantom:", nullptr, &progress, &made), MACULA_CANCELLED);
    EXPECT_EQ(made, nullptr);

    macula_cancel* handle = nullptr;
    ASSERT_EQ(macula_cancel_create(&handle), MACULA_DONE);
    const Owned<macula_cancel> cancel(handle);
    macula_cancel_now(handle);
    auto stopped = sized<macula_progress>();
    stopped.cancel = handle;
    EXPECT_EQ(macula_study_open("phantom:", nullptr, &stopped, &made), MACULA_CANCELLED);
}

TEST(CStudy, HandlesThatAreNullAreNeverFollowed) {
    macula_study_close(nullptr);
    macula_view_close(nullptr);
    macula_device_close(nullptr);
    macula_cancel_close(nullptr);
    macula_cancel_now(nullptr);
    EXPECT_EQ(macula_study_volumes(nullptr), 0u);
    EXPECT_EQ(macula_study_title(nullptr, 0), nullptr);
    EXPECT_EQ(macula_study_note(nullptr, 0), nullptr);
    EXPECT_EQ(macula_view_note(nullptr, 0), nullptr);
    expectError(macula_study_choose(nullptr, 0, nullptr), MACULA_USAGE);
    expectError(macula_study_volume(nullptr, nullptr), MACULA_USAGE);
    expectError(macula_view_create(nullptr, nullptr), MACULA_USAGE);
    expectError(macula_view_set_preset(nullptr, "ct-bone", 0), MACULA_USAGE);
    expectError(macula_view_set_camera(nullptr, nullptr), MACULA_USAGE);
    expectError(macula_draw(nullptr, nullptr, nullptr, nullptr, nullptr), MACULA_USAGE);
    expectError(macula_cancel_create(nullptr), MACULA_USAGE);
    const auto study = TwoBalls().study();
    ASSERT_EQ(macula_study_choose(study.get(), 0, nullptr), MACULA_DONE) << "it is loaded";
    expectError(macula_study_choose(study.get(), 1, nullptr), MACULA_USAGE);
}

TEST(CLibrary, NamesWhatIsBuiltIn) {
    EXPECT_EQ(std::string(macula_version()).find_first_not_of("0123456789."), std::string::npos);
    for (const std::int32_t kind :
         {MACULA_PRESETS, MACULA_CLIPS, MACULA_LIGHTS, MACULA_LOOKS, MACULA_QUALITIES}) {
        std::set<std::string> names;
        while (const char* name = macula_name(kind, std::uint32_t(names.size()))) names.insert(name);
        EXPECT_GE(names.size(), 4u) << kind;
        EXPECT_EQ(macula_name(kind, std::uint32_t(names.size()) + 1), nullptr);
    }
    const char* all = nullptr;
    ASSERT_EQ(macula_built_in(&all), MACULA_DONE) << lastError().message;
    EXPECT_NE(std::string(all).find("\"cinematic-bone\""), std::string::npos);
    expectError(macula_built_in(nullptr), MACULA_USAGE);
    EXPECT_EQ(macula_name(5, 0), nullptr);
    EXPECT_EQ(macula_name(-1, 0), nullptr);
}

}  // namespace
}  // namespace macula::test
