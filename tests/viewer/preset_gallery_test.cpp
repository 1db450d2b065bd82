// The gallery of presets and what it keeps, with mouse and keys, without a display or a device.
#include "viewer/presets/preset_gallery.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QAction>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <vector>

#include "base/atomic_file.h"
#include "dicom/support.h"
#include "pipeline/volume/transfer_function_json.h"
#include "scene/choice/catalogue.h"
#include "viewer/offscreen.h"
#include "viewer/presets/preset_box.h"
#include "viewer/presets/preset_comparison.h"
#include "viewer/presets/preset_library.h"
#include "viewer/presets/preset_naming.h"

namespace macula::viewer {
namespace {

class PresetGalleryTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        session_.emplace(*scene::builtInCatalogue());
        library_.emplace(*session_, nullptr);
        makeGallery();
    }
    void TearDown() override {
        gallery_.reset();
        library_.reset();
        session_.reset();
        OffscreenTest::TearDown();
    }
    void makeGallery() {
        gallery_.emplace(*session_, *library_, [this] {
            scene::StudyState state = session_->state();
            state.camera = Camera{};
            return state;
        });
        QObject::connect(&*gallery_, &PresetGallery::useAsked, &*gallery_,
                         [this](const LibraryPreset& preset) { used_.push_back(preset.ref); });
        list_ = gallery_->findChild<QListView*>(QStringLiteral("presets"));
        filter_ = gallery_->findChild<QLineEdit*>(QStringLiteral("preset-filter"));
        note_ = gallery_->findChild<QLabel*>(QStringLiteral("preset-note"));
        ASSERT_TRUE(list_ && filter_ && note_);
        gallery_->resize(420, 800);
        gallery_->show();
        settle();
    }
    void openStudy(Unit unit = Unit::hounsfield, const char* modality = "CT", std::uint16_t value = 1000) {
        auto volume = Volume::create({.size = glm::ivec3(8), .unit = unit, .modality = modality},
                                     std::vector<std::uint16_t>(512, value));
        scene::StudyState state;
        state.preset = *scene::findPreset(session_->catalogue(), "ct-bone");
        session_->show({.volume = std::make_shared<const Volume>(*std::move(volume))}, state);
        settle();
    }
    QStringList headings() const {
        QStringList texts;
        for (int row = 0; row < gallery_->model().rowCount(); ++row) {
            const QModelIndex index = gallery_->model().index(row);
            if (index.data(PresetListModel::isHeadingRole).toBool())
                texts << index.data().toString().section(QLatin1String(" ("), 0, 0);
        }
        return texts;
    }
    QStringList titlesIn(PresetGroup group) const {
        QStringList titles;
        const auto& rows = gallery_->model().rows();
        for (std::size_t row = 0; row < rows.size(); ++row)
            if (rows[row].group == group && rows[row].preset)
                titles << gallery_->model().index(int(row)).data().toString();
        return titles;
    }
    QModelIndex heading(PresetGroup group) const {
        const auto& rows = gallery_->model().rows();
        for (std::size_t row = 0; row < rows.size(); ++row)
            if (rows[row].group == group && !rows[row].preset) return gallery_->model().index(int(row));
        return {};
    }
    QModelIndex preset(const QString& title) const {
        const auto& rows = gallery_->model().rows();
        for (std::size_t row = 0; row < rows.size(); ++row) {
            const QModelIndex index = gallery_->model().index(int(row));
            if (rows[row].preset && index.data().toString() == title) return index;
        }
        ADD_FAILURE() << "there is no preset " << title.toStdString();
        return {};
    }
    QPoint middleOf(const QModelIndex& index) {
        list_->scrollTo(index);
        settle();
        return list_->visualRect(index).center();
    }
    void select(const QString& title) {
        list_->setCurrentIndex(preset(title));
        list_->setFocus();
    }
    void press(Qt::Key key) { QTest::keyClick(list_, key); }
    void fromMenu(const QString& title, const char* action) {
        Q_EMIT list_->customContextMenuRequested(middleOf(preset(title)));
        auto* menu = gallery_->findChild<QMenu*>(QStringLiteral("preset-menu"));
        ASSERT_NE(menu, nullptr);
        auto* found = menu->findChild<QAction*>(QLatin1String(action));
        ASSERT_NE(found, nullptr) << action;
        const bool isEnabled = found->isEnabled();
        found->trigger();
        menu->close();
        delete menu;
        EXPECT_TRUE(isEnabled) << action;
    }
    bool isInMenu(const QString& title, const char* action) {
        Q_EMIT list_->customContextMenuRequested(middleOf(preset(title)));
        const std::unique_ptr<QMenu> menu(gallery_->findChild<QMenu*>(QStringLiteral("preset-menu")));
        return menu && menu->findChild<QAction*>(QLatin1String(action))->isEnabled();
    }
    PresetNameDialog* dialog() { return gallery_->findChild<PresetNameDialog*>(); }
    // In the dialog that asks for a name, which is there.
    void answer(const char* name) {
        PresetNameDialog* asked = dialog();
        ASSERT_NE(asked, nullptr);
        asked->findChild<QLineEdit*>(QStringLiteral("preset-name"))->setText(QString::fromUtf8(name));
        asked->accept();
        delete asked;
    }
    void keepCurve(const char* name) {
        gallery_->askToSaveCurve();
        answer(name);
    }

    std::optional<StudyEditor> session_;
    std::optional<PresetLibrary> library_;
    std::optional<PresetGallery> gallery_;
    QListView* list_ = nullptr;
    QLineEdit* filter_ = nullptr;
    QLabel* note_ = nullptr;
    std::vector<live::PresetRef> used_;
};

TEST_F(PresetGalleryTest, WhatFitsTheImagesStandsFirstAndTheOthersAreFolded) {
    openStudy();
    EXPECT_EQ(headings(),
              (QStringList{QStringLiteral("For such images"), QStringLiteral("For other images")}));
    const QStringList fitting = titlesIn(PresetGroup::fitting);
    EXPECT_TRUE(fitting.contains(QStringLiteral("CT-Bone")));
    EXPECT_FALSE(fitting.contains(QStringLiteral("uCT-Skull")));
    EXPECT_TRUE(titlesIn(PresetGroup::others).isEmpty());
    list_->setCurrentIndex(heading(PresetGroup::others));
    press(Qt::Key_Return);
    EXPECT_TRUE(titlesIn(PresetGroup::others).contains(QStringLiteral("uCT-Skull")));
    EXPECT_EQ(list_->currentIndex(), heading(PresetGroup::others)) << "it stays selected";
    QTest::mouseClick(list_->viewport(), Qt::LeftButton, {}, middleOf(heading(PresetGroup::others)));
    EXPECT_TRUE(titlesIn(PresetGroup::others).isEmpty());
    EXPECT_TRUE(used_.empty());

    openStudy(Unit::raw, "MR");
    EXPECT_TRUE(titlesIn(PresetGroup::fitting).contains(QStringLiteral("MR-Angio")));
    EXPECT_FALSE(titlesIn(PresetGroup::fitting).contains(QStringLiteral("CT-Bone")));
}

TEST_F(PresetGalleryTest, EnterAndADoubleClickUseAPreset) {
    openStudy();
    select(QStringLiteral("CT-Lung"));
    press(Qt::Key_Return);
    EXPECT_EQ(used_, std::vector<live::PresetRef>{"ct-lung"});
    const QPoint at = middleOf(preset(QStringLiteral("CT-Bone")));
    QTest::mouseClick(list_->viewport(), Qt::LeftButton, {}, at);
    EXPECT_EQ(used_.size(), 1u) << "one click selects";
    QTest::mouseDClick(list_->viewport(), Qt::LeftButton, {}, at);
    EXPECT_EQ(used_.back(), "ct-bone");
    EXPECT_TRUE(preset(QStringLiteral("CT-Bone")).data(PresetListModel::isShownRole).toBool());
    EXPECT_FALSE(preset(QStringLiteral("CT-Lung")).data(PresetListModel::isShownRole).toBool());
}

TEST_F(PresetGalleryTest, TheFilterFindsFoldedOnesTooAndSaysWhereThereIsNone) {
    openStudy();
    QTest::keyClicks(filter_, QStringLiteral("skull"));
    EXPECT_EQ(titlesIn(PresetGroup::others), QStringList{QStringLiteral("uCT-Skull")});
    EXPECT_TRUE(titlesIn(PresetGroup::fitting).isEmpty());
    QTest::keyClick(filter_, Qt::Key_Return);
    EXPECT_EQ(list_->currentIndex(), preset(QStringLiteral("uCT-Skull")));
    filter_->setText(QStringLiteral("no such thing"));
    EXPECT_FALSE(list_->isVisible());
    EXPECT_TRUE(gallery_->findChild<QLabel*>(QStringLiteral("preset-nothing"))
                    ->text()
                    .contains(QStringLiteral("no such thing")));
    QTest::keyClick(filter_, Qt::Key_Escape);
    EXPECT_TRUE(filter_->text().isEmpty());
    EXPECT_TRUE(list_->isVisible());
    EXPECT_TRUE(titlesIn(PresetGroup::others).isEmpty());
}

TEST_F(PresetGalleryTest, FavouritesAndThoseUsedLastHaveGroupsOfTheirOwn) {
    openStudy();
    fromMenu(QStringLiteral("CT-Fat"), "preset-favourite");
    EXPECT_EQ(titlesIn(PresetGroup::favourites), QStringList{QStringLiteral("CT-Fat")});
    EXPECT_TRUE(preset(QStringLiteral("CT-Fat")).data(PresetListModel::isFavouriteRole).toBool());
    library_->noteUsed("ct-lung");
    library_->noteUsed("ct-bone");
    EXPECT_EQ(titlesIn(PresetGroup::lastUsed),
              (QStringList{QStringLiteral("CT-Bone"), QStringLiteral("CT-Lung")}));
    openStudy(Unit::raw, "MR");
    EXPECT_TRUE(titlesIn(PresetGroup::lastUsed).isEmpty()) << "of other images";
    EXPECT_EQ(titlesIn(PresetGroup::favourites), QStringList{QStringLiteral("CT-Fat")});
    fromMenu(QStringLiteral("CT-Fat"), "preset-favourite");
    EXPECT_TRUE(titlesIn(PresetGroup::favourites).isEmpty());
}

TEST_F(PresetGalleryTest, ACurveIsKeptUnderANameThatNoneHas) {
    openStudy();
    gallery_->askToSaveCurve();
    ASSERT_NE(dialog(), nullptr);
    auto* name = dialog()->findChild<QLineEdit*>(QStringLiteral("preset-name"));
    auto* why = dialog()->findChild<QLabel*>(QStringLiteral("preset-name-trouble"));
    EXPECT_EQ(name->text(), QStringLiteral("CT-Bone (2)"));
    EXPECT_TRUE(why->text().isEmpty());
    for (const char* refused : {"", "  ", "ct-bone", "a\u202e"}) {
        name->setText(QString::fromUtf8(refused));
        EXPECT_FALSE(why->text().isEmpty()) << refused;
    }
    answer("Мой скелет");
    EXPECT_EQ(titlesIn(PresetGroup::own), QStringList{QStringLiteral("Мой скелет")});
    EXPECT_EQ(session_->state().preset->title, "Мой скелет") << "what is shown has that name now";
    EXPECT_EQ(session_->catalogue().presets.back()->title, "Мой скелет");
    EXPECT_TRUE(preset(QStringLiteral("Мой скелет")).data(PresetListModel::isShownRole).toBool());
    session_->undo();
    EXPECT_EQ(session_->state().preset->name, "ct-bone");
    EXPECT_EQ(titlesIn(PresetGroup::own).size(), 1) << "it is kept all the same";
}

TEST_F(PresetGalleryTest, OwnOnesAreRenamedCopiedAndDeletedAndBuiltInOnesAreNot) {
    openStudy();
    for (const char* action : {"preset-rename", "preset-delete"})
        EXPECT_FALSE(isInMenu(QStringLiteral("CT-Bone"), action)) << action;
    fromMenu(QStringLiteral("CT-Lung"), "preset-copy");
    answer("Lung A");
    fromMenu(QStringLiteral("Lung A"), "preset-rename");
    answer("Lung B");
    EXPECT_EQ(titlesIn(PresetGroup::own), QStringList{QStringLiteral("Lung B")});

    auto* undo = gallery_->findChild<QPushButton*>(QStringLiteral("preset-undo"));
    EXPECT_FALSE(undo->isVisible());
    select(QStringLiteral("Lung B"));
    press(Qt::Key_Delete);
    EXPECT_TRUE(titlesIn(PresetGroup::own).isEmpty());
    EXPECT_TRUE(note_->text().contains(QStringLiteral("“Lung B” is deleted"))) << note_->text().toStdString();
    ASSERT_TRUE(undo->isVisible());
    QTest::mouseClick(undo, Qt::LeftButton);
    EXPECT_EQ(titlesIn(PresetGroup::own), QStringList{QStringLiteral("Lung B")});
    EXPECT_FALSE(undo->isVisible());
    // Of a built-in one the key does nothing.
    select(QStringLiteral("CT-Lung"));
    press(Qt::Key_Delete);
    EXPECT_TRUE(titlesIn(PresetGroup::fitting).contains(QStringLiteral("CT-Lung")));
}

TEST_F(PresetGalleryTest, AllThatIsSeenIsKeptToo) {
    openStudy();
    session_->change(QStringLiteral("Look"),
                     [](scene::StudyState& next) { next.settings.look = trace::Look::dvr; });
    gallery_->askToSaveSeen();
    answer("As I like it");
    const std::vector<LibraryPreset> own = library_->own();
    ASSERT_EQ(own.size(), 1u);
    ASSERT_TRUE(own.front().own->seen.has_value());
    EXPECT_EQ(own.front().own->seen->state.settings.look, trace::Look::dvr);
    EXPECT_TRUE(own.front().own->seen->camera.has_value());
    EXPECT_TRUE(preset(QStringLiteral("As I like it"))
                    .data(PresetListModel::aboutRole)
                    .toString()
                    .contains(QStringLiteral("all that was seen")));
}

TEST_F(PresetGalleryTest, WithoutAStudyThereIsNothingToKeepAndItSaysSo) {
    gallery_->askToSaveCurve();
    EXPECT_EQ(dialog(), nullptr);
    EXPECT_TRUE(note_->text().contains(QStringLiteral("Open a study first")));
    int told = 0;
    QObject::connect(&*gallery_, &PresetGallery::failed, &*gallery_, [&] { ++told; });
    gallery_->hide();
    gallery_->askToSaveSeen();
    EXPECT_EQ(told, 1) << "nobody sees the note of a hidden gallery";
}

TEST_F(PresetGalleryTest, PicturesOfTheVolumeAreDrawnOfWhatIsSeenAndAnewForAnotherStudy) {
    EXPECT_FALSE(gallery_->isDrawing());
    openStudy();
    const auto picture = [&] {
        return preset(QStringLiteral("Cinematic bone")).data(Qt::DecorationRole).value<QImage>();
    };
    ASSERT_TRUE(waitUntil([&] { return !picture().isNull() && !gallery_->isDrawing(); }));
    const QImage first = picture();
    EXPECT_EQ(first.size(), QSize(pictures::kPresetThumbnailPx, pictures::kPresetThumbnailPx));
    EXPECT_NE(first.pixel(first.width() / 2, first.height() / 2), qRgb(0, 0, 0));
    openStudy(Unit::hounsfield, "CT", 250);
    EXPECT_TRUE(waitUntil([&] { return !picture().isNull() && picture() != first; }));
}

TEST_F(PresetGalleryTest, AVolumeOfNothingHasNoPicturesAndSaysSo) {
    auto volume = Volume::create({.size = glm::ivec3(4), .padding = StoredRange{5, 5}},
                                 std::vector<std::uint16_t>(64, 5));
    session_->show({.volume = std::make_shared<const Volume>(*std::move(volume))}, {});
    EXPECT_TRUE(waitUntil([&] { return note_->text().contains(QStringLiteral("nothing in this volume")); }));
    EXPECT_FALSE(gallery_->isDrawing());
}

TEST_F(PresetGalleryTest, ControlsHaveNamesAndToolTipsAndTheModelKeepsItsWord) {
    const QAbstractItemModelTester tester(&gallery_->model(),
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    openStudy();
    keepCurve("Mine");
    library_->setFavourite("ct-bone", true);
    filter_->setText(QStringLiteral("bone"));
    filter_->clear();
    for (const auto* control : gallery_->findChildren<QWidget*>()) {
        if (control->focusPolicy() == Qt::NoFocus || control->objectName().isEmpty() ||
            control->objectName().startsWith(QLatin1String("qt_")) ||
            control->objectName().startsWith(QLatin1Char('_')))
            continue;
        EXPECT_FALSE(control->accessibleName().isEmpty()) << control->objectName().toStdString();
        EXPECT_FALSE(control->toolTip().isEmpty()) << control->objectName().toStdString();
    }
    for (int row = 0; row < gallery_->model().rowCount(); ++row)
        EXPECT_FALSE(gallery_->model().index(row).data(Qt::AccessibleTextRole).toString().isEmpty());
    EXPECT_FALSE(gallery_->grab().isNull());
}

// What is kept. --------------------------------------------------------------------------------------

TEST_F(PresetGalleryTest, WithoutAStoreItSaysThatPresetsLiveForTheRun) {
    EXPECT_TRUE(note_->text().contains(QStringLiteral("until this window closes")))
        << note_->text().toStdString();
    openStudy();
    keepCurve("Mine");
    EXPECT_EQ(titlesIn(PresetGroup::own), QStringList{QStringLiteral("Mine")});
}

TEST_F(PresetGalleryTest, AnotherRunFindsWhatWasKept) {
    const dicom::test::TemporaryFolder folder;
    const auto run = [&] {
        auto keeper = std::make_shared<live::StudyKeeper>(
            session::StoreOptions{.folder = folder.path() / "sessions"}, nullptr);
        gallery_.reset();
        library_.emplace(*session_, keeper);
        makeGallery();
        keeper->waitUntilIdle();
        settle();
        return keeper;
    };
    {
        const auto keeper = run();
        EXPECT_FALSE(note_->isVisible()) << note_->text().toStdString();
        openStudy();
        keepCurve("Mine");
        library_->setFavourite("ct-fat", true);
        library_->noteUsed("ct-lung");
        gallery_.reset();
        library_.reset();  // before all is written
    }
    const auto keeper = run();
    openStudy();
    EXPECT_EQ(titlesIn(PresetGroup::own), QStringList{QStringLiteral("Mine")});
    EXPECT_EQ(titlesIn(PresetGroup::favourites), QStringList{QStringLiteral("CT-Fat")});
    EXPECT_EQ(titlesIn(PresetGroup::lastUsed), QStringList{QStringLiteral("CT-Lung")});
    gallery_.reset();
    library_.reset();
}

TEST_F(PresetGalleryTest, AStoreThatCannotBeUsedIsAsNone) {
    const dicom::test::TemporaryFolder folder;
    std::ofstream(folder.path() / "sessions") << "no folder";
    gallery_.reset();
    const auto keeper = std::make_shared<live::StudyKeeper>(
        session::StoreOptions{.folder = folder.path() / "sessions"}, nullptr);
    library_.emplace(*session_, keeper);
    makeGallery();
    EXPECT_TRUE(
        waitUntil([&] { return note_->text().contains(QStringLiteral("until this window closes")); }));
    gallery_.reset();
    library_.reset();
}

TEST_F(PresetGalleryTest, FilesAreImportedAndExported) {
    const dicom::test::TemporaryFolder folder;
    const std::string path = (folder.path() / "bone.json").string();
    ASSERT_TRUE(library_->exportTo(path, "ct-bone").ok());
    EXPECT_FALSE(library_->exportTo(path, "no-such-preset").ok());
    QStringList titles;
    std::vector<Error> errors;
    QObject::connect(&*library_, &PresetLibrary::imported, &*library_,
                     [&](const QStringList& all) { titles << all; });
    QObject::connect(&*library_, &PresetLibrary::failed, &*library_,
                     [&](const Error& error) { errors.push_back(error); });
    const auto import = [&](const std::string& file) {
        library_->importFile(file);
        EXPECT_TRUE(waitUntil([&] { return !library_->isImporting(); }));
    };
    import(path);
    import(path);
    EXPECT_EQ(titles, (QStringList{QStringLiteral("CT-Bone (2)"), QStringLiteral("CT-Bone (3)")}));
    EXPECT_EQ(titlesIn(PresetGroup::own).size(), 2);
    const std::string broken = (folder.path() / "broken.json").string();
    ASSERT_TRUE(writeTextAtomically(broken, "{ \"volumeProperties\": [").ok());
    import(broken);
    import((folder.path() / "missing.json").string());
    EXPECT_EQ(errors.size(), 2u);
    EXPECT_EQ(titlesIn(PresetGroup::own).size(), 2);
}

// The tool bar's list. -------------------------------------------------------------------------------

TEST_F(PresetGalleryTest, TheBoxOffersWhatFitsAndNamesWhatWasChosenElsewhere) {
    PresetBox box(*library_);
    EXPECT_FALSE(qobject_cast<QListView*>(box.view())->isRowHidden(box.count() - 1)) << "without a study";
    openStudy();
    box.fillAnew();
    std::vector<live::PresetRef> chosen;
    QObject::connect(&box, &PresetBox::chosen, &box,
                     [&](const LibraryPreset& preset) { chosen.push_back(preset.ref); });
    auto* view = qobject_cast<QListView*>(box.view());
    ASSERT_NE(view, nullptr);
    const auto row = [&](const char* name) { return box.findData(QLatin1String(name), Qt::ToolTipRole); };
    EXPECT_TRUE(view->isRowHidden(row("uct-skull")));
    EXPECT_FALSE(view->isRowHidden(row("ct-bone")));
    const auto& all = session_->catalogue().presets;
    const auto skull = *scene::findPreset(session_->catalogue(), "uct-skull");
    box.choose(skull.get());
    EXPECT_EQ(box.currentText(), QStringLiteral("uCT-Skull"));
    EXPECT_TRUE(chosen.empty()) << "nobody has chosen";
    TransferFunction edited = *all.front();
    edited.title = "Edited";
    box.choose(&edited);
    EXPECT_EQ(box.currentIndex(), -1);
    EXPECT_EQ(box.placeholderText(), QStringLiteral("Edited"));
    Q_EMIT box.activated(row("ct-lung"));
    EXPECT_EQ(chosen, std::vector<live::PresetRef>{"ct-lung"});

    keepCurve("Mine");
    box.fillAnew();
    EXPECT_EQ(box.itemText(0), QStringLiteral("Mine"));
    Q_EMIT box.activated(1);  // the line below one's own
    EXPECT_EQ(chosen.size(), 1u);
}

// Two pictures. --------------------------------------------------------------------------------------

TEST_F(PresetGalleryTest, TheCurtainShowsTheFirstAtTheLeftOfItsLine) {
    PictureCurtain curtain;
    curtain.resize(400, 300);
    QImage first(400, 300, QImage::Format_RGB32);
    first.fill(qRgb(255, 0, 0));
    QImage second(400, 300, QImage::Format_RGB32);
    second.fill(qRgb(0, 0, 255));
    curtain.show();
    settle();
    EXPECT_FALSE(curtain.grab().isNull()) << "there is no picture yet";
    curtain.setPictures(first, second);
    const auto at = [&](int x) { return curtain.grab().toImage().pixel(x, 150) & 0xffffffu; };
    EXPECT_EQ(at(100), 0xff0000u);
    EXPECT_EQ(at(300), 0x0000ffu);
    std::vector<double> moved;
    QObject::connect(&curtain, &PictureCurtain::partMoved, &curtain, [&](double p) { moved.push_back(p); });
    QTest::mousePress(&curtain, Qt::LeftButton, {}, QPoint(360, 100));
    ASSERT_EQ(moved.size(), 1u);
    EXPECT_NEAR(moved.front(), 0.9, 0.01);
    EXPECT_EQ(at(300), 0xff0000u);
    curtain.setPart(-5.0);
    EXPECT_EQ(at(100), 0x0000ffu);
    curtain.setBesideEachOther(true);
    EXPECT_EQ(at(100), 0xff0000u);
    EXPECT_EQ(at(300), 0x0000ffu);
}

// The thread has a device to start; the window does not wait for it.
TEST_F(PresetGalleryTest, ClosingAComparisonLeavesTheWorkToTheWindow) {
    QWidget window;
    pictures::ViewPicture picture;
    picture.volume = smallStudy().volume;
    picture.sizePx = {8, 8};
    auto* dialog = new PresetComparison({QStringLiteral("a"), picture}, {QStringLiteral("b"), picture},
                                        "no such device", &window);
    EXPECT_TRUE(dialog->isDrawing());
    delete dialog;
    EXPECT_EQ(window.children().size(), 1) << "it was joined";
    EXPECT_TRUE(waitUntil([&] {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return window.children().isEmpty();
    }));
}

}  // namespace
}  // namespace macula::viewer
