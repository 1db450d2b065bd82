#include "viewer/browser/browser_controller.h"

#include <QMainWindow>
#include <QMenu>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QToolBar>
#include <set>

#include "live/store/study_keeper.h"
#include "study/spool/spool.h"
#include "viewer/browser/recent_menu.h"
#include "viewer/browser/study_browser.h"
#include "viewer/editor/study_editor.h"
#include "viewer/jobs/post.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/status/study_texts.h"
#include "viewer/volume/opening_controller.h"

namespace macula::viewer {

namespace {

constexpr int kLettersAtLeast = 20;

}  // namespace

VolumeChoice::VolumeChoice(QWidget* parent) : QComboBox(parent) {
    setAccessibleName(tr("Volume"));
    setToolTip(tr("Which volume of the folder is open; choose another one here"));
    // Long names must not make the window wider.
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(kLettersAtLeast);
    connect(this, &QComboBox::activated, this, [this](int index) {
        setCurrentIndex(shown_);
        if (index != shown_) Q_EMIT chosen(std::size_t(index));
    });
}

// Like any combo box, but elides long text: text that is cut off could show the wrong series number.
void VolumeChoice::paintEvent(QPaintEvent*) {
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    const QRect field =
        style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    constexpr int kBesideTextPx = 4;
    option.currentText =
        option.fontMetrics.elidedText(option.currentText, Qt::ElideRight, field.width() - 2 * kBesideTextPx);
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

void VolumeChoice::setVolumes(const std::vector<Text>& titles, std::size_t shown) {
    clear();
    shown_ = int(shown);
    if (titles.size() < 2) return;
    for (std::size_t i = 0; i < titles.size(); ++i) {
        const QString title = inWindowsLanguage(titles[i]).simplified();
        addItem(tr("%1 of %2: %3").arg(i + 1).arg(titles.size()).arg(title));
        setItemData(count() - 1, title, Qt::ToolTipRole);
    }
    setCurrentIndex(shown_);
}

BrowserController::BrowserController(const WindowContext& context, OpeningController& opening,
                                     live::StudyKeeper* keeper)
    : QObject(&context.window),
      context_(context),
      opening_(opening),
      keeper_(keeper),
      browser_(new StudyBrowser),
      recent_(new RecentMenu(&context.window)) {
    // The browser may list a folder from which no volume has been opened yet.
    connect(browser_, &StudyBrowser::chosen, this,
            [this](std::size_t index) { opening_.openFound(browser_->found(), index); });
    connect(recent_, &RecentMenu::chosen, this,
            [this](const QString& path) { opening_.open(path.toStdString()); });
    connectLoader();
}

void BrowserController::connectLoader() {
    const StudyLoader& loader = opening_.loader();
    connect(
        &loader, &StudyLoader::found, this,
        [this](const std::shared_ptr<const study::FoundVolumes>& found) { showFound(found, std::nullopt); });
    connect(&loader, &StudyLoader::loaded, this, [this, &loader] {
        const study::StudySource& source = loader.source();
        // The folder of a fetched study has no name for people; the panel Archive lists it.
        if (source && source->parent_path() != study::spoolFolder()) recent_->add(*source);
    });
    // Keeps the list of a folder that was read to its end, so that another series can be chosen from it.
    const auto goBack = [this] {
        if (browser_->found() && !browser_->found()->isWhole()) showOpen();
    };
    connect(&loader, &StudyLoader::failed, this, goBack);
    connect(&loader, &StudyLoader::askedToJoin, this, goBack);
    connect(&loader, &StudyLoader::cancelled, this, goBack);
}

std::optional<std::size_t> BrowserController::selectedOther() const {
    return shown_ != nullptr && shown_->isChecked() ? browser_->selectedOther() : std::nullopt;
}

void BrowserController::addFindAction(QMenu& edit) {
    QAction* find = edit.addAction(tr("&Find a Study…"), this, [this] {
        if (!shown_->isChecked()) shown_->trigger();
        browser_->focusSearch();
    });
    find->setShortcut(keyOf(KeyAction::find));
}

void BrowserController::addVolumes(QToolBar& bar) {
    volumes_ = new VolumeChoice(&bar);
    volumesInBar_ = bar.addWidget(volumes_);
    volumesInBar_->setObjectName(QStringLiteral("volumes-in-bar"));
    volumesInBar_->setVisible(false);
    connect(volumes_, &VolumeChoice::chosen, this,
            [this](std::size_t index) { opening_.openFound(context_.session.study().found, index); });
}

void BrowserController::showVolumes() {
    volumesInBar_->setVisible(textsOf(context_.session.study(), namesShown_).listsVolumes);
}

void BrowserController::showNames(bool shown) {
    browser_->showNames(shown);
    recent_->showNames(shown);
    namesShown_ = shown;
    showVolumes();
}

void BrowserController::onStudyShown() {
    const study::OpenedStudy& study = context_.session.study();
    showOpen();
    volumes_->setVolumes(study.volumeTitles, study.volumeIndex);
    showVolumes();
}

void BrowserController::showOpen() {
    const study::OpenedStudy& study = context_.session.study();
    showFound(study.found, study.volumeIndex);
}

// Asks which volumes were seen before only once the folder is read: partial lists have no volumes yet.
void BrowserController::showFound(const std::shared_ptr<const study::FoundVolumes>& found,
                                  std::optional<std::size_t> open) {
    const bool isNew = found != browser_->found();
    browser_->setFound(found, open);
    if (!keeper_ || !found || !found->isWhole() || !isNew) return;
    keeper_->askWhatWasSeen(found, [this, found](const std::set<std::size_t>& seen) {
        post(&context_.window, [this, found, seen] {
            if (browser_->found() == found) browser_->setStored(seen);
        });
    });
}

}  // namespace macula::viewer
