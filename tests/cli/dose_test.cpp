// `macula dose`: the figures of a plan.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/run_command.h"
#include "dicom/support.h"
#include "study/dose/made_plan.h"

namespace macula::cli {
namespace {

class Dose : public CommandTest {
  protected:
    void SetUp() override {
        CommandTest::SetUp();
        study::test::writePlan(at("plan"));
    }
};

TEST_F(Dose, PrintsTheFiguresOfEachRegion) {
    const Ran ran = runMacula({"dose", at("plan")});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE(ran.out.find("BOX"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("24.00"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("40 Gy (prescription)"), std::string::npos) << ran.out;
    EXPECT_NE(ran.err.find("40 Gy prescribed in 20 fractions"), std::string::npos) << ran.err;
    EXPECT_EQ(ran.out.find("SYNTHETIC"), std::string::npos) << "no patient";
}

TEST_F(Dose, WritesJsonAndATable) {
    const Ran ran = runMacula({"dose", at("plan"), "--json", "-", "--csv", at("dose.csv")});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    EXPECT_EQ(json["unit"], "Gy");
    EXPECT_EQ(json["reference"]["value"], 40.0);
    ASSERT_EQ(json["regions"].size(), 3u);
    EXPECT_NEAR(json["regions"][0]["mean"].get<double>(), 24.0, 1e-4);
    EXPECT_TRUE(json["regions"][2]["mean"].is_null());
    EXPECT_TRUE(readAll(at("dose.csv")).starts_with("set,region,volume_ml,"));
    const Ran again = runMacula({"dose", at("plan"), "--csv", at("dose.csv")});
    EXPECT_EQ(again.exitCode, 2) << "it is there already";
}

TEST_F(Dose, WithoutADoseOrRegionsThereIsAnError) {
    ASSERT_EQ(runMacula({"phantom", at("study")}).exitCode, 0);
    const Ran none = runMacula({"dose", at("study")});
    EXPECT_EQ(none.exitCode, 3);
    EXPECT_EQ(none.errorLines(), 1u) << none.err;
    EXPECT_NE(none.err.find("RTDOSE"), std::string::npos) << none.err;
    std::filesystem::remove(at("plan/structures.dcm"));
    const Ran noRegions = runMacula({"dose", at("plan")});
    EXPECT_EQ(noRegions.exitCode, 3) << noRegions.err;
    EXPECT_NE(noRegions.err.find("RTSTRUCT"), std::string::npos) << noRegions.err;
    EXPECT_EQ(runMacula({"dose", at("nowhere")}).exitCode, 3);
    EXPECT_EQ(runMacula({"dose"}).exitCode, 2);
}

}  // namespace
}  // namespace macula::cli
