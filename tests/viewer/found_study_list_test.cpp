// A list of studies that a search found: what is selected, and what may be done with it.
#include "viewer/archive/found_study_list.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QElapsedTimer>
#include <QPushButton>
#include <QTest>
#include <QTreeView>
#include <optional>

#include "viewer/archive/read_marks.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

study::ListedStudy listed(const std::string& uid, const std::string& date, const char* archive = "Hospital") {
    study::ListedStudy study;
    study.study.studyInstanceUid = uid;
    study.study.date = date;
    study.study.patientName = "MEIER^ANNA";
    study.study.patientId = "P" + uid;
    study.study.modalities = {"CT"};
    study.study.instanceCount = 100;
    study.archive = archive;
    return study;
}

class FoundStudyListTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        list_.emplace(QStringLiteral("list"), QStringLiteral("Studies"));
    }
    void TearDown() override {
        list_.reset();
        OffscreenTest::TearDown();
    }
    bool isEnabled(const char* suffix) {
        return list_->findChild<QPushButton*>(QStringLiteral("list") + QLatin1String(suffix))->isEnabled();
    }
    std::string selected() {
        const auto study = list_->selected();
        return study ? study->study.studyInstanceUid : std::string();
    }

    std::optional<ReadMarks> marks_;  // outlives the list
    std::optional<FoundStudyList> list_;
};

TEST_F(FoundStudyListTest, TheLatestIsSelectedAndStaysSo) {
    EXPECT_EQ(selected(), "");
    list_->setStudies({listed("1", "20240101"), listed("2", "20260101")});
    EXPECT_EQ(selected(), "2");
    list_->setStudies({listed("2", "20260101"), listed("3", "20270101"), listed("1", "20240101")});
    EXPECT_EQ(selected(), "2") << "more came";
    list_->setStudies({listed("2", "20260101", "Cloud"), listed("1", "20240101")});
    EXPECT_EQ(list_->selected()->archive, "Cloud") << "another archive's, the first of the list";
    list_->setStudies({});
    EXPECT_EQ(selected(), "");
}

TEST_F(FoundStudyListTest, SpaceMarksTheSelectedStudyAsRead) {
    ReadMarks& marks = marks_.emplace(nullptr);
    list_->setStudies({listed("1", "20240101"), listed("2", "20260101")});
    auto* mark = list_->findChild<QAction*>(QStringLiteral("mark-study-read"));
    EXPECT_FALSE(mark->isEnabled()) << "no marks yet";
    list_->setMarks(&marks);
    list_->show();
    list_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&*list_));
    list_->view().setFocus();
    const auto shown = [&](int row) {
        return list_->view().model()->index(row, FoundStudyModel::mark).data().toString();
    };
    EXPECT_EQ(shown(0), QString());
    marks.noteOpened("2");
    QTest::keyClick(&list_->view(), Qt::Key_Space);
    EXPECT_EQ(marks.of("2"), ReadMark::read);
    EXPECT_EQ(marks.of("1"), ReadMark::unknown);
    EXPECT_EQ(shown(0), QStringLiteral("read"));
    EXPECT_EQ(mark->text(), QStringLiteral("Mark as Not Read"));
    list_->view().sortByColumn(FoundStudyModel::mark, Qt::AscendingOrder);
    EXPECT_EQ(shown(1), QStringLiteral("read")) << "what is read comes last";
    QTest::keyClick(&list_->view(), Qt::Key_Space);
    EXPECT_EQ(marks.of("2"), ReadMark::seen);
}

TEST_F(FoundStudyListTest, OffersWhatCanBeDone) {
    EXPECT_FALSE(isEnabled("-open") || isEnabled("-beside") || isEnabled("-fetch"));
    list_->setStudies({listed("1", "20240101")});
    EXPECT_TRUE(isEnabled("-open") && isEnabled("-fetch"));
    EXPECT_FALSE(isEnabled("-beside")) << "nothing is open that it could stand beside";
    list_->setCanOpenBeside(true);
    EXPECT_TRUE(isEnabled("-beside"));
    study::ListedStudy here = listed("1", "20240101");
    here.folder = "/somewhere";
    list_->setStudies({here});
    EXPECT_TRUE(isEnabled("-fetch")) << "a part of it is missing";
    here.isWhole = true;
    list_->setStudies({here});
    EXPECT_FALSE(isEnabled("-fetch"));
    here.archive.clear();
    here.isWhole = false;
    list_->setStudies({here});
    EXPECT_FALSE(isEnabled("-fetch")) << "from nowhere";
}

TEST_F(FoundStudyListTest, TenThousandStudiesAreSortedByDate) {
    std::vector<study::ListedStudy> studies;
    for (int i = 0; i < 10'000; ++i)
        studies.push_back(listed(std::to_string(i), std::to_string(20'000'000 + (i * 7919) % 100'000)));
    list_->resize(500, 600);
    list_->show();
    QElapsedTimer took;
    took.start();
    list_->setStudies(std::move(studies));
    QCoreApplication::processEvents();
    RecordProperty("milliseconds", int(took.elapsed()));
    const auto* model = list_->view().model();
    ASSERT_EQ(model->rowCount(), 10'000);
    for (int row = 1; row < model->rowCount(); ++row)
        ASSERT_GE(model->index(row - 1, FoundStudyModel::date).data(FoundStudyModel::sortRole).toString(),
                  model->index(row, FoundStudyModel::date).data(FoundStudyModel::sortRole).toString());
}

}  // namespace
}  // namespace macula::viewer
