// What the bench of the window is made of: steps and their stalls, files out of the cache, and the table.
#include "viewer/driven/driven_steps.h"

#include <QJsonObject>
#include <QThread>
#include <ctime>
#include <fstream>

#include "support.h"
#include "viewer/driven/workday_script.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

using DrivenStepsTest = test::OffscreenTest;

DrivenStep step(const char* name, std::function<void()> begin, std::function<bool()> isDone = {}) {
    DrivenStep made;
    made.name = QString::fromLatin1(name);
    made.begin = std::move(begin);
    made.isDone = std::move(isDone);
    made.patienceMs = 150;
    made.restMs = 10;
    return made;
}

TEST_F(DrivenStepsTest, EachIsMeasuredByItself) {
    int asked = 0;
    DrivenSteps steps({step("deaf", [] { QThread::msleep(600); }), step("quick", {}),
                       step("later", {}, [&] { return ++asked > 2; }),
                       step("never", {}, [] { return false; })});
    QStringList ended;
    bool isFinished = false;
    QObject::connect(&steps, &DrivenSteps::ended, &steps, [&](const MeasuredStep& s) { ended << s.name; });
    QObject::connect(&steps, &DrivenSteps::finished, &steps, [&] { isFinished = true; });
    steps.start();
    ASSERT_TRUE(waitUntil([&] { return isFinished; }));
    EXPECT_EQ(ended, (QStringList{"deaf", "quick", "later", "never"}));
    const auto& measured = steps.measured();
    ASSERT_EQ(measured.size(), 4u);
    EXPECT_GT(measured[0].longestStallMs, 500.0) << "what it begins with counts";
    EXPECT_LT(measured[1].longestStallMs, measured[0].longestStallMs);
    EXPECT_TRUE(measured[2].isDone);
    EXPECT_EQ(asked, 3);
    EXPECT_FALSE(measured[3].isDone);
    EXPECT_EQ(longestStallMs(measured), measured[0].longestStallMs);
    EXPECT_EQ(toJson(measured).size(), 4);
}

double processorMsOfThisThread() {
    timespec worked{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &worked);
    return 1e3 * double(worked.tv_sec) + 1e-6 * double(worked.tv_nsec);
}

// Of a hold-up it is told how much of it the thread worked, however busy the machine is.
TEST_F(DrivenStepsTest, WhoWaitsDoesNotWork) {
    DrivenSteps steps({step("waits", [] { QThread::msleep(600); }), step("works", [] {
                           const double before = processorMsOfThisThread();
                           while (processorMsOfThisThread() < before + 600.0) {
                           }
                       })});
    bool isFinished = false;
    QObject::connect(&steps, &DrivenSteps::finished, &steps, [&] { isFinished = true; });
    steps.start();
    ASSERT_TRUE(waitUntil([&] { return isFinished; }));
    ASSERT_EQ(steps.measured().size(), 2u);
    EXPECT_GT(steps.measured()[0].longestStallMs, 500.0);
    EXPECT_LT(steps.measured()[0].ownWorkInItMs, 300.0);
    EXPECT_GT(steps.measured()[1].ownWorkInItMs, 500.0);
}

TEST_F(DrivenStepsTest, NothingFollowsOnceStopped) {
    bool isFinished = false;
    DrivenSteps steps({step("one", {}), step("two", {})});
    QObject::connect(&steps, &DrivenSteps::ended, &steps, [&] { steps.stop(); });
    QObject::connect(&steps, &DrivenSteps::finished, &steps, [&] { isFinished = true; });
    steps.start();
    ASSERT_TRUE(waitUntil([&] { return steps.measured().size() == 1; }));
    QThread::msleep(60);
    settle();
    EXPECT_EQ(steps.measured().size(), 1u);
    EXPECT_FALSE(isFinished);
}

TEST_F(DrivenStepsTest, OfNoStepsTheEndComesAtOnce) {
    bool isFinished = false;
    DrivenSteps steps({});
    QObject::connect(&steps, &DrivenSteps::finished, &steps, [&] { isFinished = true; });
    steps.start();
    EXPECT_TRUE(isFinished);
    EXPECT_EQ(longestStallMs(steps.measured()), 0.0);
}

TEST(ColdFiles, AreCountedWithAllThatIsBelow) {
    const dicom::test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "a");
    std::ofstream(folder / "a" / "one") << std::string(10'000, 'x');
    std::ofstream(folder / "two") << std::string(500, 'y');
    std::ofstream(folder / "none").flush();
    std::filesystem::create_symlink("/dev/zero", folder / "link");
    const ColdFiles cold = dropFromCache(folder.path());
    EXPECT_EQ(cold.files, 3u);
    EXPECT_EQ(cold.bytes, 10'500u);
    EXPECT_LE(cold.bytesStillCached, cold.bytes);
    EXPECT_EQ(dropFromCache(folder / "two").bytes, 500u);
    EXPECT_EQ(dropFromCache(folder / "gone").files, 0u);
}

TEST(SessionTable, SaysWhatIsNotMet) {
    EXPECT_GE(processAgeMs(), 0.0);
    const QJsonObject session{
        {"startMs", 100},
        {"cold", QJsonObject{{"files", 3}, {"mib", 1.5}, {"stillCachedShare", 0.25}}},
        {"opening", QJsonObject{{"windowMs", 950}, {"sliceMs", 900}, {"pictureMs", 5000}, {"modelMs", -1}}},
        {"longestUiStallMs", 61.0},
        {"steps", QJsonArray{QJsonObject{{"step", "clip"}, {"longestUiStallMs", 12.0}},
                             QJsonObject{{"step", "gallery"}, {"longestUiStallMs", 61.0}}}},
        {"orbit", QJsonObject{{"width", 1280}, {"height", 720}, {"framesPerSecond", 18.5}}}};
    const QJsonObject resumed{{"opening", QJsonObject{{"studyReadMs", 700}, {"pictureMs", 1500}}}};
    const QString table = sessionTable(session, resumed);
    const auto rowOf = [&](const char* what) {
        for (const QString& line : table.split(QLatin1Char('\n'))) {
            if (line.contains(QLatin1String(what))) return line;
        }
        ADD_FAILURE() << what << " is not in " << table.toStdString();
        return QString();
    };
    const auto isMet = [&](const char* what) { return !rowOf(what).contains(QStringLiteral("not met")); };
    EXPECT_FALSE(isMet("window, since")) << "1050 ms, with what passed before";
    EXPECT_TRUE(isMet("first slice"));
    EXPECT_FALSE(isMet("first 3D picture, cold"));
    EXPECT_TRUE(isMet("resumed: first 3D picture")) << "800 ms after the study was read";
    EXPECT_TRUE(rowOf("preview sharp enough to be shown |").contains(QStringLiteral("none")));
    EXPECT_FALSE(isMet("longest UI stall (gallery)"));
    EXPECT_TRUE(isMet("orbit at 1280 x 720"));
    EXPECT_TRUE(rowOf("files taken").contains(QStringLiteral("25 % still in it")));
}

}  // namespace
}  // namespace macula::viewer
