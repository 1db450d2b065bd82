// Studies, views and errors for tests of the C interface.
#pragma once

#include <gtest/gtest.h>
#include <macula.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace macula::test {

struct Close {
    void operator()(macula_archive* handle) const { macula_archive_close(handle); }
    void operator()(macula_study* handle) const { macula_study_close(handle); }
    void operator()(macula_view* handle) const { macula_view_close(handle); }
    void operator()(macula_device* handle) const { macula_device_close(handle); }
    void operator()(macula_cancel* handle) const { macula_cancel_close(handle); }
    void operator()(macula_live* handle) const { macula_live_close(handle); }
    void operator()(macula_shared_image* handle) const { macula_shared_image_close(handle); }
};
template <class Handle>
using Owned = std::unique_ptr<Handle, Close>;

// The struct as C begins it: its size, the rest 0.
template <class T>
T sized() {
    T made{};
    made.size = sizeof made;
    return made;
}

inline macula_error lastError() {
    auto error = sized<macula_error>();
    EXPECT_EQ(macula_last_error(&error), MACULA_DONE);
    return error;
}

// That `status` is what was expected, and that the error says what is wrong and what to do.
inline void expectError(macula_status status, macula_status expected) {
    EXPECT_EQ(status, expected);
    const macula_error error = lastError();
    EXPECT_EQ(error.status, expected);
    ASSERT_NE(error.message, nullptr);
    EXPECT_STRNE(error.message, "");
    EXPECT_STRNE(error.advice, "") << error.message;
}

// One for all tests of a program.
inline macula_device* testDevice() {
    static const Owned<macula_device> opened = [] {
        macula_device* made = nullptr;
        EXPECT_EQ(macula_device_open(nullptr, &made), MACULA_DONE) << lastError().message;
        return Owned<macula_device>(made);
    }();
    return opened.get();
}

inline Owned<macula_view> viewOf(const Owned<macula_study>& study) {
    macula_view* made = nullptr;
    EXPECT_EQ(macula_view_create(study.get(), &made), MACULA_DONE) << lastError().message;
    return Owned<macula_view>(made);
}

inline std::vector<std::string> notesOf(const macula_study* study) {
    std::vector<std::string> notes;
    while (const char* note = macula_study_note(study, std::uint32_t(notes.size()))) notes.emplace_back(note);
    return notes;
}

// 24 voxels a side of 4 mm, in the middle of the patient's frame: air, and a large ball of bone on the
// patient's left, a small one on the right.
struct TwoBalls {
    static constexpr int kSide = 24;
    std::vector<std::int16_t> hu = std::vector<std::int16_t>(std::size_t(kSide) * kSide * kSide, -1000);

    TwoBalls() {
        for (int n = 0; n < kSide * kSide * kSide; ++n) {
            const auto mm = [&](int index) { return 4.0 * index - 46.0; };
            const double x = mm(n % kSide);
            const double y = mm(n / kSide % kSide);
            const double z = mm(n / kSide / kSide);
            const bool isLarge = std::hypot(x - 22.0, y, z) < 18.0;
            const bool isSmall = std::hypot(x + 34.0, y, z) < 7.0;
            if (isLarge || isSmall) hu[std::size_t(n)] = 1000;
        }
    }

    macula_voxels voxels() const {
        auto given = sized<macula_voxels>();
        given.type = MACULA_INT16;
        given.columns = given.rows = given.slices = kSide;
        given.unit = MACULA_UNIT_HOUNSFIELD;
        given.data = hu.data();
        given.bytes = hu.size() * sizeof(std::int16_t);
        for (int axis = 0; axis < 3; ++axis) {
            given.patient_from_voxel[5 * axis] = 4.0;
            given.patient_from_voxel[4 * axis + 3] = -46.0;
        }
        given.patient_from_voxel[15] = 1.0;
        return given;
    }

    Owned<macula_study> study() const {
        const macula_voxels given = voxels();
        macula_study* made = nullptr;
        EXPECT_EQ(macula_study_of_voxels(&given, nullptr, &made), MACULA_DONE) << lastError().message;
        return Owned<macula_study>(made);
    }
};

}  // namespace macula::test
