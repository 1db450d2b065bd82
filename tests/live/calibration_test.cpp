// How fast a machine is: measured once, kept, and made again where it is of something else.
#include "live/quality/calibration.h"

#include <cmath>

#include "gpu/gpu_test.h"
#include "live/store/machine_documents.h"
#include "support.h"

namespace macula::live {
namespace {

class CalibrationTest : public gpu::GpuTest {
  protected:
    std::filesystem::path folder() const { return folder_.path() / "sessions"; }
    session::DocumentId id() const {
        return {.kind = session::DocumentKind::calibration, .study = {}, .name = "live frame"};
    }
    const dicom::test::TemporaryFolder folder_;
};

TEST(Calibration, IsTextAndBack) {
    const Calibration calibration{.traceMs = 12.5, .device = "Card, driver 1", .version = "0.1"};
    const auto back = calibrationFromJson(toJson(calibration));
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(*back, calibration);
    for (const char* bad : {"", "{}", "[]", R"({"traceMs":0,"device":"a","version":"b"})",
                            R"({"traceMs":"1","device":"a","version":"b"})"})
        EXPECT_FALSE(calibrationFromJson(bad).ok()) << bad;
}

// The one test that measures: the rest of them go by what it has kept.
TEST_F(CalibrationTest, IsMeasuredOnceForADeviceAndAVersion) {
    Progress progress;
    const auto first = calibrationOf({}, folder(), false, progress);
    ASSERT_TRUE(first.ok()) << first.error().message;
    EXPECT_GT(first->traceMs, 0.0);
    EXPECT_TRUE(std::isfinite(first->traceMs));
    EXPECT_FALSE(first->device.empty());

    // What is kept is taken, and not measured again.
    Calibration kept = *first;
    kept.traceMs = 1234.5;
    ASSERT_TRUE(keepMachineDocument(folder(), id(), 1, toJson(kept)).ok());
    Progress stopped;
    stopped.token().cancel();
    const auto second = calibrationOf({}, folder(), false, stopped);
    ASSERT_TRUE(second.ok());
    EXPECT_EQ(*second, kept);
    // Of another driver or version, or when it is asked for, it would be measured: who has stopped it sees.
    EXPECT_EQ(calibrationOf({}, folder(), true, stopped).error().code, ErrorCode::cancelled);
    for (const bool isOtherVersion : {false, true}) {
        Calibration other = kept;
        (isOtherVersion ? other.version : other.device) += " of before";
        ASSERT_TRUE(keepMachineDocument(folder(), id(), 1, toJson(other)).ok());
        EXPECT_EQ(calibrationOf({}, folder(), false, stopped).error().code, ErrorCode::cancelled);
    }
    ASSERT_TRUE(keepMachineDocument(folder(), id(), 1, R"({"traceMs": "fast"})").ok());
    EXPECT_EQ(calibrationOf({}, folder(), false, stopped).error().code, ErrorCode::cancelled);
    EXPECT_EQ(calibrationOf("no such device", folder(), false, stopped).error().code, ErrorCode::usage);
}

}  // namespace
}  // namespace macula::live
