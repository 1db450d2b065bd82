// Whom the window names, outside of its panes: the study that is open, in every layout and whatever happens.
#include <gtest/gtest.h>

#include <QAction>
#include <QStatusBar>
#include <QTreeView>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>

#include "base/atomic_file.h"
#include "study/open/found_volumes.h"
#include "support.h"
#include "synthetic.h"
#include "viewer/browser/study_browser.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

// The name that its files have, the one that people read, and how many slices it has, which no other has.
struct Patient {
    const char* inFiles;
    QString shown;
    int slices;
};
const Patient kAlpha{"ALPHA^ADA", QStringLiteral("ALPHA, ADA"), 9};
const Patient kBeta{"BETA^BEN", QStringLiteral("BETA, BEN"), 11};
const Patient kGamma{"GAMMA^GUS", QStringLiteral("GAMMA, GUS"), 10};

class NamedPlacesTest : public WindowTest {
  protected:
    NamedPlacesTest() {
        layout_ = scene::Layout::axial;
        refusesRaw_ = false;
    }

    // Two series, so that there is a list of volumes.
    std::filesystem::path write(const Patient& patient) const {
        for (const int number : {1, 2}) {
            dicom::test::SyntheticSeries series;
            series.studyUid = std::string("2.25.") + std::to_string(patient.slices);
            series.seriesUid = series.studyUid + "." + std::to_string(number);
            series.frameOfReferenceUid = series.studyUid + ".3";
            series.patientName = patient.inFiles;
            series.patientId = patient.inFiles;
            series.number = number;
            series.size.z = patient.slices - number + 1;
            series.transferSyntaxUid = "1.2.840.10008.1.2.5";
            std::vector<dicom::test::Slice> slices = dicom::test::slicesOf(series);
            for (std::size_t k = 0; k < slices.size(); ++k)
                slices[k].sopInstanceUid = series.seriesUid + ".4." + std::to_string(k);
            const auto folder = folder_ / patient.inFiles / std::to_string(number);
            std::filesystem::create_directories(folder);
            dicom::test::writeFiles(folder, series, slices);
        }
        return folder_ / patient.inFiles;
    }
    // As a folder of which nothing can be shown, which is found out only when it is decoded.
    static void damage(const std::filesystem::path& folder) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            if (!entry.is_regular_file()) continue;
            std::string bytes = readText(entry.path()).value();
            const std::size_t header = bytes.find(std::string("\2\0\0\0\x40\0\0\0", 8));  // of RLE
            ASSERT_NE(header, std::string::npos);
            bytes.replace(header + 4, 4, "\x7F\x7F\x7F\x7F");
            std::ofstream(entry.path(), std::ios::binary) << bytes;
        }
    }
    void open(const std::filesystem::path& folder) {
        window_->open(folder);
        ASSERT_TRUE(waitUntil([&] { return !window_->loading(); }));
    }
    QTreeView& tree() const { return *window_->findChild<QTreeView*>(QStringLiteral("studies")); }
    // The titles of the rows that are marked as open, each below that of its patient.
    QStringList openRows() const {
        QStringList open;
        const std::function<void(const QModelIndex&, const QString&)> look = [&](const QModelIndex& parent,
                                                                                 const QString& patient) {
            for (int n = 0; n < tree().model()->rowCount(parent); ++n) {
                const QModelIndex index = tree().model()->index(n, 0, parent);
                const QString top = parent.isValid() ? patient : index.data().toString();
                if (index.data(StudyTreeModel::isOpenRole).toBool()) open << top;
                look(index, top);
            }
        };
        look({}, {});
        return open;
    }
    QAction& action(const char* name) {
        auto* found = window_->findChild<QAction*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }

    // Title (and so task bar), status line, and where the list is of its folder the row there.
    void expectNamed(const Patient& patient, bool names = true, bool isInList = true) {
        const QString title = window_->windowTitle();
        if (names) {
            EXPECT_TRUE(title.startsWith(patient.shown)) << title.toStdString();
        } else {
            EXPECT_EQ(title, QStringLiteral("Macula"));
        }
        EXPECT_EQ(action("volumes-in-bar").isVisible(), names);
        EXPECT_TRUE(window_->voxels().contains(QStringLiteral("×%1,").arg(patient.slices)))
            << window_->voxels().toStdString();
        EXPECT_NE(window_->fidelity(), QStringLiteral("No study is open"));
        const QStringList rows = openRows();
        if (!isInList) {
            EXPECT_TRUE(rows.isEmpty()) << rows.join(QLatin1Char(';')).toStdString();
            EXPECT_FALSE(tree().selectionModel()->hasSelection()) << "a row of somebody else is lit";
            return;
        }
        ASSERT_EQ(rows.size(), 1);
        EXPECT_EQ(rows.front() == patient.shown, names) << rows.front().toStdString();
        for (const Patient& other : {kAlpha, kBeta, kGamma})
            EXPECT_TRUE(other.shown == patient.shown || rows.front() != other.shown);
    }
    void show(scene::Layout layout) {
        window_->session().change(QStringLiteral("Panes"),
                                  [&](scene::StudyState& next) { next.layout = layout; });
    }
    void walk(scene::Layout layout, const std::filesystem::path& alpha, const std::filesystem::path& beta,
              const std::filesystem::path& broken);

    const dicom::test::TemporaryFolder folder_;
};

void NamedPlacesTest::walk(scene::Layout layout, const std::filesystem::path& alpha,
                           const std::filesystem::path& beta, const std::filesystem::path& broken) {
    show(layout);
    open(alpha);
    expectNamed(kAlpha);
    open(beta);
    expectNamed(kBeta);
    // Failed: the list may be that of the other folder, but nothing of it is open, or looks so.
    open(broken);
    EXPECT_TRUE(window_->message().contains(QStringLiteral("still of the study that was open before")))
        << window_->message().toStdString();
    expectNamed(kBeta, true, false);
    open("/no/such/folder");
    expectNamed(kBeta, true, false);
    open(beta);
    expectNamed(kBeta);
    window_->open(alpha);
    expectNamed(kBeta);
    window_->cancelLoading();
    ASSERT_TRUE(waitUntil([&] { return window_->loaderAtRest(); }));
    EXPECT_TRUE(window_->windowTitle().startsWith(kBeta.shown));
    EXPECT_TRUE(window_->voxels().contains(QStringLiteral("×%1,").arg(kBeta.slices)));
    open(beta);

    // A second volume, here of the same patient: the study is still that which is open.
    Progress progress;
    const auto second = study::openFoundVolume(window_->session().study().found, 1, progress);
    ASSERT_TRUE(second.ok());
    window_->secondVolume().offer(*second);
    ASSERT_NE(window_->secondVolume().second(), nullptr);
    expectNamed(kBeta);
    action("flip").trigger();
    expectNamed(kBeta);
    action("flip").trigger();
    action("close-second").trigger();
    expectNamed(kBeta);
    show(layout);  // two beside each other are shown alone

    // Hidden at once, and for what is opened afterwards.
    action("names").trigger();
    expectNamed(kBeta, false);
    open(alpha);
    expectNamed(kAlpha, false);
    action("names").trigger();
    expectNamed(kAlpha);
}

TEST_F(NamedPlacesTest, AreOfTheStudyThatIsOpenInEveryLayout) {
    const auto alpha = write(kAlpha);
    const auto beta = write(kBeta);
    const auto broken = write(kGamma);
    damage(broken);
    EXPECT_EQ(window_->windowTitle(), QStringLiteral("Macula"));
    for (const scene::Layout layout : {scene::Layout::axial, scene::Layout::coronal, scene::Layout::sagittal,
                                       scene::Layout::fourPanes, scene::Layout::volume}) {
        SCOPED_TRACE(std::string(nameOf(layout)));
        walk(layout, alpha, beta, broken);
    }
}

// The picture in 3D is told of by itself: while it is not shown, nothing is said of it.
TEST_F(NamedPlacesTest, TheStatusLineTellsOfThePictureIn3dOnlyWhileThatIsShown) {
    EXPECT_TRUE(waitUntil([&] { return window_->fidelity() == QStringLiteral("No study is open"); }));
    open(write(kAlpha));
    EXPECT_EQ(window_->fidelity(), QStringLiteral("Axial slices; 3D is not shown"));
    show(scene::Layout::fourPanes);
    ASSERT_TRUE(waitForConverged());
    const QString told = window_->fidelity();
    EXPECT_TRUE(told.contains(QStringLiteral("samples"))) << told.toStdString();
    auto* badge = window_->findChild<FidelityBadge*>();
    ASSERT_NE(badge, nullptr);
    EXPECT_TRUE(badge->isVisible());
    show(scene::Layout::sagittal);
    EXPECT_EQ(window_->fidelity(), QStringLiteral("Sagittal slices; 3D is not shown"));
    EXPECT_FALSE(badge->isVisible());
    EXPECT_EQ(window_->rate(), QString());
    // Another patient meanwhile.
    open(write(kBeta));
    EXPECT_EQ(window_->fidelity(), QStringLiteral("Sagittal slices; 3D is not shown"));
    show(scene::Layout::volume);
    EXPECT_NE(window_->fidelity(), told) << "that was said of another patient's picture";
    EXPECT_FALSE(badge->isVisible());
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(badge->isVisible());
}

// Once it stayed for each later study, with the badge over it.
TEST_F(NamedPlacesTest, WhyASeriesWasChosenIsSaidOnlyWhereThePointerIs) {
    open(write(kAlpha));
    show(scene::Layout::volume);
    ASSERT_TRUE(waitForConverged());
    auto* badge = window_->findChild<FidelityBadge*>();
    window_->statusBar()->showMessage(QStringLiteral("Shifted by 3 HU"));
    badge->show();
    EXPECT_FALSE(badge->isVisible()) << "it would lie over the message";
    window_->statusBar()->clearMessage();
    EXPECT_TRUE(badge->isVisible());
    for (const QWidget* widget : window_->findChildren<QWidget*>())
        EXPECT_EQ(widget->statusTip(), QString()) << widget->metaObject()->className();
}

}  // namespace
}  // namespace macula::viewer
