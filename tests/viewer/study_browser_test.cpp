// The browser of studies with mouse and keys, without a display.
#include "viewer/browser/study_browser.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QAction>
#include <QHash>
#include <QScrollBar>
#include <QTest>
#include <QTranslator>
#include <functional>
#include <optional>
#include <vector>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "study/found_by_hand.h"
#include "viewer/browser/recent_menu.h"
#include "viewer/browser/study_tree_model.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class StudyBrowserTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        browser_.emplace();
        QObject::connect(&*browser_, &StudyBrowser::chosen, &*browser_,
                         [this](std::size_t index) { chosen_.push_back(index); });
        tree_ = browser_->findChild<QTreeView*>(QStringLiteral("studies"));
        search_ = browser_->findChild<QLineEdit*>(QStringLiteral("search"));
        nothing_ = browser_->findChild<QLabel*>(QStringLiteral("nothing"));
        ASSERT_NE(tree_, nullptr);
        ASSERT_NE(search_, nullptr);
        ASSERT_NE(nothing_, nullptr);
        browser_->resize(420, 700);
        browser_->show();
        settle();
    }
    void TearDown() override {
        browser_.reset();
        OffscreenTest::TearDown();
    }

    // Every index that is shown by the model, folded away or not.
    std::vector<QModelIndex> allRows() const {
        std::vector<QModelIndex> rows;
        const std::function<void(const QModelIndex&)> add = [&](const QModelIndex& parent) {
            for (int n = 0; n < tree_->model()->rowCount(parent); ++n) {
                rows.push_back(tree_->model()->index(n, 0, parent));
                add(QModelIndex(rows.back()));
            }
        };
        add({});
        return rows;
    }
    QModelIndex rowTitled(const QString& title) const {
        for (const QModelIndex& index : allRows()) {
            if (index.data().toString() == title) return index;
        }
        ADD_FAILURE() << "there is no row " << title.toStdString();
        return {};
    }
    QStringList titles() const {
        QStringList titles;
        for (const QModelIndex& index : allRows()) titles << index.data().toString();
        return titles;
    }
    static bool isOpen(const QModelIndex& index) { return index.data(StudyTreeModel::isOpenRole).toBool(); }
    QPoint middleOf(const QModelIndex& index) const {
        tree_->scrollTo(index);
        return tree_->visualRect(index).center();
    }
    void type(const char* text) { QTest::keyClicks(search_, QString::fromUtf8(text)); }

    std::optional<StudyBrowser> browser_;
    QTreeView* tree_ = nullptr;
    QLineEdit* search_ = nullptr;
    QLabel* nothing_ = nullptr;
    std::vector<std::size_t> chosen_;
};

using Chosen = std::vector<std::size_t>;

TEST_F(StudyBrowserTest, SaysThatThereIsNoFolder) {
    EXPECT_TRUE(nothing_->isVisible());
    EXPECT_FALSE(nothing_->text().isEmpty());
    EXPECT_FALSE(tree_->isVisible());
    browser_->setFound(study::test::twoPatients(), 0);
    EXPECT_FALSE(nothing_->isVisible());
    EXPECT_TRUE(tree_->isVisible());
    browser_->setFound(nullptr, std::nullopt);
    EXPECT_TRUE(nothing_->isVisible());
    EXPECT_TRUE(allRows().empty());
}

TEST_F(StudyBrowserTest, ControlsHaveNamesAndToolTips) {
    for (const QWidget* control : {static_cast<QWidget*>(tree_), static_cast<QWidget*>(search_)}) {
        EXPECT_FALSE(control->accessibleName().isEmpty());
        EXPECT_FALSE(control->toolTip().isEmpty());
    }
    browser_->setFound(study::test::twoPatients(), 0);
    for (const QModelIndex& index : allRows())
        EXPECT_TRUE(index.data(Qt::AccessibleTextRole).toString().startsWith(index.data().toString()));
    const QString scout =
        rowTitled(QStringLiteral("Series 1: Scout")).data(Qt::AccessibleTextRole).toString();
    EXPECT_TRUE(scout.contains(QStringLiteral("Shown as images")));
    EXPECT_FALSE(scout.contains(QStringLiteral("Cannot be opened")));
}

TEST_F(StudyBrowserTest, TheModelKeepsItsWord) {
    browser_->setFound(study::test::twoPatients(), 0);
    const QAbstractItemModelTester tester(tree_->model(),
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    type("echo");
    search_->clear();
    browser_->showNames(false);
    browser_->setShown(3);
    browser_->setStored({1, 3});
    browser_->setFound(study::test::manySeries(20), 7);
    type("thorax 1");
    browser_->setFound(nullptr, std::nullopt);
}

TEST_F(StudyBrowserTest, WhatIsOpenIsSelectedAndSeen) {
    browser_->setFound(study::test::twoPatients(), 2);
    const QModelIndex open = rowTitled(QStringLiteral("TE 9.2 ms, phase 2 of 2"));
    EXPECT_TRUE(isOpen(open));
    EXPECT_EQ(tree_->currentIndex(), open);
    EXPECT_TRUE(tree_->isExpanded(open.parent()));
    EXPECT_TRUE(tree_->viewport()->rect().intersects(tree_->visualRect(open)));
}

TEST_F(StudyBrowserTest, WhatIsSelectedIsOpenedBesideUnlessItIsOpen) {
    std::vector<std::size_t> asked;
    QObject::connect(&*browser_, &StudyBrowser::secondAsked, &*browser_,
                     [&](std::size_t index) { asked.push_back(index); });
    auto* beside = tree_->findChild<QAction*>(QStringLiteral("open-beside-row"));
    ASSERT_NE(beside, nullptr);
    beside->trigger();
    EXPECT_FALSE(browser_->selectedOther()) << "there is no folder";
    browser_->setFound(study::test::twoPatients(), 2);
    beside->trigger();
    EXPECT_TRUE(asked.empty()) << "it is open already";
    browser_->setShown(0);
    tree_->setCurrentIndex(rowTitled(QStringLiteral("TE 9.2 ms, phase 2 of 2")));
    EXPECT_EQ(browser_->selectedOther(), 2U);
    beside->trigger();
    EXPECT_EQ(asked, (std::vector<std::size_t>{2}));
    EXPECT_TRUE(chosen_.empty()) << "the study stays";
}

TEST_F(StudyBrowserTest, AClickSelectsAndADoubleClickChooses) {
    browser_->setFound(study::test::twoPatients(), 3);
    const QModelIndex portal = rowTitled(QStringLiteral("Series 2: Portal venous"));
    QTest::mouseClick(tree_->viewport(), Qt::LeftButton, {}, middleOf(portal));
    EXPECT_EQ(tree_->currentIndex(), portal);
    EXPECT_EQ(chosen_, Chosen{});
    QTest::mouseDClick(tree_->viewport(), Qt::LeftButton, {}, middleOf(portal));
    EXPECT_EQ(chosen_, Chosen{0});
    EXPECT_FALSE(isOpen(portal)) << "it is not open yet";
    browser_->setShown(0);
    EXPECT_TRUE(isOpen(portal));
    EXPECT_FALSE(isOpen(rowTitled(QStringLiteral("Series 4: Lung <b>sharp</b>"))));
    QTest::mouseDClick(tree_->viewport(), Qt::LeftButton, {}, middleOf(portal));
    EXPECT_EQ(chosen_, Chosen{0}) << "it is open already";
}

TEST_F(StudyBrowserTest, ArrowsAndEnterChoose) {
    browser_->setFound(study::test::manySeries(5), 1);
    EXPECT_TRUE(isOpen(tree_->currentIndex()));
    QTest::keyClick(tree_, Qt::Key_Down);
    EXPECT_EQ(chosen_, Chosen{});
    QTest::keyClick(tree_, Qt::Key_Return);
    QTest::keyClick(tree_, Qt::Key_Up);
    QTest::keyClick(tree_, Qt::Key_Up);
    QTest::keyClick(tree_, Qt::Key_Enter);
    EXPECT_EQ(chosen_, (Chosen{2, 0}));
}

TEST_F(StudyBrowserTest, LettersFindTheNextRowThatBeginsSo) {
    QApplication::setKeyboardInputInterval(60'000);  // letters are of one word, however slow this machine is
    browser_->setFound(study::test::manySeries(5), 1);
    QTest::keyClicks(tree_, QStringLiteral("Series 4"));
    EXPECT_EQ(tree_->currentIndex().data().toString(), QStringLiteral("Series 4: Thorax 3"));
}

TEST_F(StudyBrowserTest, WhatCannotBeOpenedIsNotChosen) {
    browser_->setFound(study::test::twoPatients(), 3);
    for (const char* title :
         {"Series 1: Scout", "Series 9: Report of Jane", "Müller, Jörg", "4 files left out"}) {
        const QModelIndex row = rowTitled(QString::fromUtf8(title));
        tree_->setCurrentIndex(row);
        QTest::keyClick(tree_, Qt::Key_Return);
        QTest::mouseDClick(tree_->viewport(), Qt::LeftButton, {}, middleOf(row));
    }
    EXPECT_EQ(chosen_, Chosen{});
}

TEST_F(StudyBrowserTest, ASeriesOfSeveralVolumesUnfolds) {
    browser_->setFound(study::test::twoPatients(), 3);
    const QModelIndex series = rowTitled(QStringLiteral("Series 3: T2 two echoes"));
    EXPECT_FALSE(tree_->isExpanded(series));
    tree_->setCurrentIndex(series);
    QTest::keyClick(tree_, Qt::Key_Return);
    EXPECT_TRUE(tree_->isExpanded(series));
    QTest::keyClick(tree_, Qt::Key_Down);
    QTest::keyClick(tree_, Qt::Key_Return);
    EXPECT_EQ(chosen_, Chosen{1});
}

TEST_F(StudyBrowserTest, SearchLeavesWhatMatches) {
    browser_->setFound(study::test::twoPatients(), 3);
    type("muller portal");
    EXPECT_EQ(titles(),
              (QStringList{QStringLiteral("Müller, Jörg"), QStringLiteral("2019-02-03, Abdomen of Jörg"),
                           QStringLiteral("Series 2: Portal venous")}));
    EXPECT_EQ(tree_->currentIndex().data().toString(), QStringLiteral("Series 2: Portal venous"));
    QTest::keyClick(search_, Qt::Key_Return);
    EXPECT_EQ(browser_->focusWidget(), tree_);
    EXPECT_EQ(chosen_, Chosen{}) << "the first Enter only goes there";
    QTest::keyClick(tree_, Qt::Key_Return);
    EXPECT_EQ(chosen_, Chosen{0});
}

TEST_F(StudyBrowserTest, SearchUnfoldsWhatItFound) {
    browser_->setFound(study::test::twoPatients(), 3);
    type("9.2");
    const QModelIndex found = rowTitled(QStringLiteral("TE 9.2 ms, phase 2 of 2"));
    EXPECT_TRUE(tree_->isExpanded(found.parent()));
    EXPECT_EQ(tree_->currentIndex(), found);
}

TEST_F(StudyBrowserTest, NothingMatchesIsSaidAndEscEndsTheSearch) {
    browser_->setFound(study::test::twoPatients(), 3);
    const QStringList before = titles();
    const QModelIndex patient = rowTitled(QStringLiteral("Müller, Jörg"));
    tree_->collapse(patient);
    type("muller lung");
    EXPECT_TRUE(nothing_->isVisible());
    EXPECT_TRUE(nothing_->text().contains(QStringLiteral("muller lung")));
    EXPECT_FALSE(tree_->isVisible());
    QTest::keyClick(search_, Qt::Key_Down);
    EXPECT_TRUE(allRows().empty());
    QTest::keyClick(search_, Qt::Key_Escape);
    EXPECT_FALSE(nothing_->isVisible());
    EXPECT_EQ(titles(), before);
    EXPECT_FALSE(tree_->isExpanded(rowTitled(QStringLiteral("Müller, Jörg")))) << "as it was left";
    EXPECT_TRUE(tree_->isExpanded(rowTitled(QStringLiteral("DOE, JANE"))));
}

TEST_F(StudyBrowserTest, FocusSearchSelectsWhatWasTyped) {
    browser_->setFound(study::test::twoPatients(), 3);
    type("lung");
    tree_->setFocus();
    browser_->focusSearch();
    EXPECT_EQ(browser_->focusWidget(), search_);
    EXPECT_EQ(search_->selectedText(), QStringLiteral("lung"));
}

TEST_F(StudyBrowserTest, ANewFolderIsNotSearched) {
    browser_->setFound(study::test::twoPatients(), 3);
    type("lung");
    browser_->setFound(study::test::manySeries(3), 0);
    EXPECT_TRUE(search_->text().isEmpty());
    EXPECT_EQ(allRows().size(), 5u);
}

TEST_F(StudyBrowserTest, TheSameFolderKeepsItsSearchWhenAnotherVolumeIsOpen) {
    const auto found = study::test::twoPatients();
    browser_->setFound(found, 3);
    type("muller");
    browser_->setFound(found, 0);
    EXPECT_EQ(search_->text(), QStringLiteral("muller"));
    EXPECT_TRUE(isOpen(rowTitled(QStringLiteral("Series 2: Portal venous"))));
}

TEST_F(StudyBrowserTest, NamesAreHiddenEverywhere) {
    browser_->setFound(study::test::twoPatients(), 3);
    type("Doe");
    browser_->showNames(false);
    EXPECT_TRUE(search_->text().isEmpty()) << "what was typed is a name";
    EXPECT_TRUE(isOpen(rowTitled(QStringLiteral("Series 4")))) << "and what is open is still told";
    for (const QModelIndex& index : allRows()) {
        QString all = index.data(StudyTreeModel::detailsRole).toStringList().join(QLatin1Char(' '));
        for (const int role : {int(Qt::DisplayRole), int(Qt::ToolTipRole), int(Qt::AccessibleTextRole),
                               int(StudyTreeModel::whyNotRole)})
            all += index.data(role).toString();
        for (const char* name : {"ller", "Jörg", "DOE", "Jane", "ID0", "Abdomen", "Lung", "1970"})
            EXPECT_FALSE(all.contains(QString::fromUtf8(name))) << all.toStdString();
    }
    browser_->showNames(true);
    EXPECT_TRUE(titles().contains(QStringLiteral("DOE, JANE")));
}

TEST_F(StudyBrowserTest, TextOfFilesIsNoHtmlAndTurnsNothingRound) {
    dicom::Scan scan;
    scan.studies.push_back(
        study::test::studyOf(0, "DOE\u202e^JANE", "20200102", "a\nb",
                             {study::test::seriesOf(1, "<b>x</b>", {study::test::volumeOf(3)})}));
    browser_->setFound(std::make_shared<const study::FoundVolumes>(std::move(scan)), std::nullopt);
    const QString tip = rowTitled(QStringLiteral("Series 1: <b>x</b>")).data(Qt::ToolTipRole).toString();
    EXPECT_TRUE(tip.contains(QStringLiteral("&lt;b&gt;x"))) << tip.toStdString();
    EXPECT_EQ(titles().first(), QStringLiteral("DOE, JANE"));
    EXPECT_EQ(titles().at(1), QStringLiteral("2020-01-02, a b"));
}

// A language of which all is X.
class Xs : public QTranslator {
  public:
    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* source, const char*, int) const override {
        static const QHash<QString, QString> known{{"DOE, JANE", "X"},
                                                   {"Tracing", "X"},
                                                   {"Series {}", "X"},
                                                   {"Series {}: {}", "X: {1}"},
                                                   {"2020-01-02, Tracing", "X"}};
        return QLatin1String(context) == QLatin1String("core") ? known.value(QString::fromUtf8(source))
                                                               : QString();
    }
};

// A name may be a word of ours.
TEST_F(StudyBrowserTest, OnlyWordsOfTheProgramAreInItsLanguage) {
    Xs language;
    QCoreApplication::installTranslator(&language);
    dicom::Scan scan;
    scan.studies.push_back(
        study::test::studyOf(0, "DOE^JANE", "20200102", "Tracing",
                             {study::test::seriesOf(1, "Tracing", {study::test::volumeOf(3)})}));
    browser_->setFound(std::make_shared<const study::FoundVolumes>(std::move(scan)), std::nullopt);
    const QStringList shown = titles();
    QCoreApplication::removeTranslator(&language);
    EXPECT_EQ(shown, (QStringList{QStringLiteral("DOE, JANE"), QStringLiteral("2020-01-02, Tracing"),
                                  QStringLiteral("X: Tracing")}));
}

TEST_F(StudyBrowserTest, WhatIsKeptOfIsTold) {
    browser_->setFound(study::test::manySeries(3), 0);
    const QModelIndex second = rowTitled(QStringLiteral("Series 2: Thorax 1"));
    const qsizetype before = second.data(StudyTreeModel::detailsRole).toStringList().size();
    browser_->setStored({1});
    EXPECT_EQ(second.data(StudyTreeModel::detailsRole).toStringList().size(), before + 1);
    browser_->setStored({});
    EXPECT_EQ(second.data(StudyTreeModel::detailsRole).toStringList().size(), before);
}

// Left half dark, right half bright.
std::shared_ptr<const study::FoundVolumes> foundOf(const std::filesystem::path& folder) {
    dicom::test::SyntheticSeries series;
    series.size = {40, 20, 5};
    series.rawInstead = [](const dicom::test::Slice&, int i, int) -> std::optional<int> {
        return i < 20 ? 100 : 2000;
    };
    dicom::test::writeFiles(folder, series);
    auto scan = dicom::test::scan(folder);
    if (!scan) return nullptr;
    return std::make_shared<const study::FoundVolumes>(std::move(*scan));
}

TEST_F(StudyBrowserTest, PicturesComeByThemselvesAndAreNotMirrored) {
    const dicom::test::TemporaryFolder folder;
    const auto found = foundOf(folder.path());
    ASSERT_NE(found, nullptr);
    browser_->setFound(found, 0);
    const QModelIndex row = tree_->currentIndex();
    const auto picture = [&] { return row.data(StudyTreeModel::pictureRole).value<QImage>(); };
    ASSERT_TRUE(waitUntil([&] { return !picture().isNull(); }));
    const int middle = picture().height() / 2;
    EXPECT_EQ(picture().width(), 40);
    EXPECT_EQ(qGray(picture().pixel(4, middle)), 0);
    EXPECT_EQ(qGray(picture().pixel(35, middle)), 255);
    settle();
    // On the screen the left is dark, too.
    const QImage screen = tree_->viewport()->grab().toImage();
    const QRect box = tree_->visualRect(row);
    const int y = box.top() + 4 + 48;
    EXPECT_LT(qGray(screen.pixel(box.left() + 4 + 20, y)), 60);
    EXPECT_GT(qGray(screen.pixel(box.left() + 4 + 75, y)), 200);
}

TEST_F(StudyBrowserTest, OnlyRowsThatAreSeenHavePicturesMade) {
    browser_->setFound(study::test::manySeries(2000), 0);
    auto* model = static_cast<StudyTreeModel*>(tree_->model());
    const auto asked = [&] {
        std::size_t count = 0;
        for (const study::StudyRow& row : model->tree().rows)
            count += row.picture != nullptr && model->isAsked(row.picture) ? 1 : 0;
        return count;
    };
    // There is no file, so that none can be made, and nobody hears of it.
    ASSERT_TRUE(waitUntil([&] { return asked() >= 3; }));
    for (int n = 0; n < 20; ++n) QTest::qWait(5);
    EXPECT_LT(asked(), 40u);
}

TEST_F(StudyBrowserTest, AHiddenBrowserMakesNoPictures) {
    browser_->hide();
    const dicom::test::TemporaryFolder folder;
    const auto found = foundOf(folder.path());
    ASSERT_NE(found, nullptr);
    browser_->setFound(found, 0);
    for (int n = 0; n < 20; ++n) QTest::qWait(5);
    EXPECT_FALSE(static_cast<StudyTreeModel*>(tree_->model())->isAsked(found->volumes().at(0).stack));
}

TEST_F(StudyBrowserTest, MayGetAnotherFolderAndEndWhilePicturesAreMade) {
    const dicom::test::TemporaryFolder folder;
    const auto found = foundOf(folder.path());
    ASSERT_NE(found, nullptr);
    for (int n = 0; n < 10; ++n) {
        browser_->setFound(n % 2 == 0 ? found : study::test::manySeries(5), 0);
        settle();
    }
    browser_->setFound(found, 0);
    settle();
    browser_.reset();
}

std::shared_ptr<const study::FoundVolumes> glimpseOf(std::size_t series) {
    dicom::Scan scan = study::test::manySeries(series)->scan();
    for (dicom::Series& each : scan.studies[0].series) {
        each.instances = each.stacks[0].frames.size();
        each.stacks.clear();
    }
    return std::make_shared<const study::FoundVolumes>(std::move(scan), study::FoundVolumes::Extent::soFar);
}

TEST_F(StudyBrowserTest, ShowsAFolderWhileItIsReadAndKeepsTheSearch) {
    const auto* reading = browser_->findChild<QLabel*>(QStringLiteral("reading"));
    ASSERT_NE(reading, nullptr);
    EXPECT_FALSE(reading->isVisible());
    browser_->setFound(glimpseOf(3), std::nullopt);
    EXPECT_TRUE(reading->isVisible());
    EXPECT_EQ(allRows().size(), 5u);
    const QModelIndex series = rowTitled(QStringLiteral("Series 1: Thorax 0"));
    EXPECT_TRUE(series.data(StudyTreeModel::whyNotRole).toString().isEmpty());
    QTest::mouseDClick(tree_->viewport(), Qt::LeftButton, {}, middleOf(series));
    EXPECT_TRUE(chosen_.empty());

    type("3:");
    const QStringList searched = titles();
    EXPECT_EQ(searched.size(), 3);
    browser_->setFound(glimpseOf(4), std::nullopt);
    EXPECT_EQ(titles(), searched);
    browser_->setFound(study::test::manySeries(4), std::nullopt);
    EXPECT_EQ(titles(), searched);
    EXPECT_FALSE(reading->isVisible());
    settle();
    tree_->setCurrentIndex(rowTitled(QStringLiteral("Series 3: Thorax 2")));
    QTest::keyClick(tree_, Qt::Key_Return);
    EXPECT_EQ(chosen_, Chosen{2});

    browser_->setFound(study::test::twoPatients(), 0);  // another folder
    EXPECT_TRUE(search_->text().isEmpty());
}

// As after an open that failed: what is on screen is of another folder, and no row here is lit for it.
TEST_F(StudyBrowserTest, OfAFolderThatNothingIsOpenOfNoRowIsLit) {
    const auto* elsewhere = browser_->findChild<QLabel*>(QStringLiteral("elsewhere"));
    ASSERT_NE(elsewhere, nullptr);
    browser_->setFound(study::test::twoPatients(), 0);
    EXPECT_TRUE(tree_->selectionModel()->hasSelection());
    EXPECT_FALSE(elsewhere->isVisible());
    browser_->setFound(glimpseOf(3), std::nullopt);
    EXPECT_FALSE(tree_->selectionModel()->hasSelection());
    EXPECT_FALSE(elsewhere->isVisible()) << "it may be on its way";
    const auto found = study::test::manySeries(3);
    browser_->setFound(found, std::nullopt);
    EXPECT_FALSE(tree_->selectionModel()->hasSelection());
    EXPECT_EQ(browser_->selectedOther(), std::nullopt);
    EXPECT_TRUE(elsewhere->isVisible());
    for (const QModelIndex& index : allRows()) EXPECT_FALSE(isOpen(index));
    // What a person selects is lit.
    QTest::mouseClick(tree_->viewport(), Qt::LeftButton, {},
                      middleOf(rowTitled(QStringLiteral("Series 2: Thorax 1"))));
    EXPECT_TRUE(tree_->selectionModel()->hasSelection());
    EXPECT_EQ(browser_->selectedOther(), std::optional<std::size_t>(1));
    browser_->setFound(found, 1);
    EXPECT_FALSE(elsewhere->isVisible());
    EXPECT_TRUE(isOpen(tree_->currentIndex()));
}

TEST_F(StudyBrowserTest, WhatIsLookedAtStaysInItsPlaceWhileMoreIsFound) {
    browser_->setFound(glimpseOf(60), std::nullopt);
    settle();
    tree_->verticalScrollBar()->setValue(tree_->verticalScrollBar()->maximum() / 2);
    const int before = tree_->verticalScrollBar()->value();
    ASSERT_GT(before, 0);
    browser_->setFound(glimpseOf(61), std::nullopt);
    settle();
    EXPECT_EQ(tree_->verticalScrollBar()->value(), before);
}

TEST_F(StudyBrowserTest, TheMenuOfWhatWasOpenedHasTheLastFirst) {
    RecentMenu menu;
    QStringList asked;
    QObject::connect(&menu, &RecentMenu::chosen, &menu, [&](const QString& path) { asked << path; });
    EXPECT_FALSE(menu.isEnabled());
    for (int n = 0; n < 12; ++n) menu.add("/data/exports/" + std::to_string(n));
    menu.add("/data/exports/5/");  // the same folder
    ASSERT_TRUE(menu.isEnabled());
    QList<QAction*> actions = menu.actions();
    ASSERT_EQ(actions.size(), 12);  // ten, a line, and what forgets them
    EXPECT_EQ(actions[0]->toolTip(), QStringLiteral("/data/exports/5"));
    EXPECT_EQ(actions[1]->toolTip(), QStringLiteral("/data/exports/11"));
    EXPECT_EQ(actions[9]->toolTip(), QStringLiteral("/data/exports/2"));
    actions[1]->trigger();
    EXPECT_EQ(asked, QStringList{QStringLiteral("/data/exports/11")});

    menu.showNames(false);
    EXPECT_FALSE(menu.isEnabled());
    EXPECT_TRUE(menu.actions().isEmpty());
    menu.showNames(true);
    menu.actions().back()->trigger();
    settle();
    EXPECT_FALSE(menu.isEnabled());
}

// A series, a presentation state of it, and one of another series.
std::shared_ptr<const study::FoundVolumes> withPresentations() {
    dicom::Scan scan;
    dicom::Series images = study::test::seriesOf(2, "Thorax", {study::test::volumeOf(4)});
    images.seriesInstanceUid = "1.2";
    dicom::Series states = study::test::seriesOf(9, "Views", {}, "PR");
    for (const std::string uid : {"1.2", "7.7"}) {
        dicom::OtherObject object{.file = "/doe/" + uid,
                                  .sopClassUid = "1.2.840.10008.5.1.4.1.1.11.9",
                                  .kind = Text("Presentation state of a 3D view"),
                                  .referencedSeriesUids = {uid},
                                  .label = "OF " + uid};
        object.presentation =
            dicom::PresentationHeading{"OF " + uid, "Of <b>Jane</b>", "20240229", "", "", {}};
        states.objects.push_back(std::move(object));
    }
    scan.studies.push_back(
        study::test::studyOf(0, "DOE^JANE", "20210405", "Chest", {std::move(images), std::move(states)}));
    scan.patients = 1;
    return std::make_shared<const study::FoundVolumes>(std::move(scan));
}

TEST_F(StudyBrowserTest, APresentationStateIsChosenByMouseAndKeys) {
    std::vector<std::string> presented;
    std::vector<std::string> refused;
    QObject::connect(&*browser_, &StudyBrowser::presentationChosen, &*browser_,
                     [&](const study::StudyRow::Presentation& chosen) {
                         presented.push_back(chosen.file.string());
                         EXPECT_EQ(chosen.volume, 0u);
                     });
    QObject::connect(&*browser_, &StudyBrowser::presentationRefused, &*browser_,
                     [&](const Text& whyNot) { refused.push_back(whyNot.english()); });
    browser_->setFound(withPresentations(), std::nullopt);
    settle();
    const QModelIndex known = rowTitled(QStringLiteral("3D view: OF 1.2"));
    const QModelIndex lost = rowTitled(QStringLiteral("3D view: OF 7.7"));
    ASSERT_TRUE(known.isValid() && lost.isValid());
    EXPECT_TRUE(tree_->isExpanded(known.parent())) << "they are all that is in their series";
    QTest::mouseClick(tree_->viewport(), Qt::LeftButton, {}, middleOf(known));
    QTest::mouseDClick(tree_->viewport(), Qt::LeftButton, {}, middleOf(known));
    EXPECT_EQ(presented, std::vector<std::string>{"/doe/1.2"});
    // By keys alone: down from the one to the other.
    tree_->setFocus();
    tree_->setCurrentIndex(known);
    QTest::keyClick(tree_, Qt::Key_Return);
    EXPECT_EQ(presented.size(), 2u);
    tree_->setCurrentIndex(lost);
    QTest::keyClick(tree_, Qt::Key_Enter);
    ASSERT_EQ(refused.size(), 1u);
    EXPECT_NE(refused[0].find("not in this folder"), std::string::npos);
    EXPECT_TRUE(chosen_.empty()) << "no volume was asked for";
    EXPECT_FALSE(browser_->selectedOther()) << "and none can stand beside";
}

TEST_F(StudyBrowserTest, APresentationStateIsSpokenAndSaysWhatOpensIt) {
    browser_->setFound(withPresentations(), 0);
    const QModelIndex known = rowTitled(QStringLiteral("3D view: OF 1.2"));
    EXPECT_FALSE(isOpen(known)) << "the volume is, and not the view";
    EXPECT_EQ(known.data(Qt::AccessibleTextRole).toString(),
              QStringLiteral("3D view: OF 1.2, Of <b>Jane</b> \u00b7 2024-02-29"));
    const QString tip = known.data(Qt::ToolTipRole).toString();
    EXPECT_TRUE(tip.contains(QStringLiteral("opens its series")));
    EXPECT_FALSE(tip.contains(QStringLiteral("<b>")));
    const QModelIndex lost = rowTitled(QStringLiteral("3D view: OF 7.7"));
    EXPECT_TRUE(lost.data(Qt::AccessibleTextRole).toString().contains(QStringLiteral("not in this folder")));
    browser_->showNames(false);
    for (const QModelIndex& index : allRows()) {
        EXPECT_FALSE(index.data(Qt::AccessibleTextRole).toString().contains(QStringLiteral("Jane")));
        EXPECT_FALSE(index.data(Qt::ToolTipRole).toString().contains(QStringLiteral("OF ")));
    }
}

}  // namespace
}  // namespace macula::viewer
