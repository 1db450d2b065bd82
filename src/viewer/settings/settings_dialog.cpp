#include "viewer/settings/settings_dialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>
#include <array>
#include <utility>

#include "scene/choice/quality_choice.h"
#include "session/store.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/settings/mouse_profile.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

constexpr int kCapStepMb = 500;
constexpr double kFontStep = 0.1;

QLabel* remark(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    return label;
}

}  // namespace

SettingsDialog::SettingsDialog(Settings settings, QList<KeyEntry> keys, bool isKept, QWidget* parent)
    : QDialog(parent),
      before_(std::move(settings)),
      languages_(new QComboBox(this)),
      highContrast_(new QCheckBox(tr("&High contrast: black, white and yellow"), this)),
      fontScale_(new QDoubleSpinBox(this)),
      showsNames_(new QCheckBox(tr("&Patient and study over pictures"), this)),
      mouse_(new QComboBox(this)),
      qualities_(new QComboBox(this)),
      deidentifies_(new QCheckBox(tr("DICOM pictures &without patient and study"), this)),
      folder_(new QLineEdit(before_.storeFolder, this)),
      keepDays_(new QSpinBox(this)),
      modelCap_(new QSpinBox(this)),
      priors_(new QComboBox(this)),
      receive_(new ReceivePage(before_.receiving, this)),
      keys_(new KeysPage(std::move(keys), before_.keys, this)) {
    setWindowTitle(tr("Settings"));
    auto* pages = new QTabWidget(this);
    pages->setObjectName(QStringLiteral("settings-pages"));
    pages->tabBar()->setAccessibleName(tr("Pages of settings"));
    pages->tabBar()->setToolTip(tr("Left and Right go from page to page"));
    pages->addTab(makeLook(), tr("Look"));
    pages->addTab(makePictures(), tr("Pictures"));
    pages->addTab(makeSessions(), tr("Sessions"));
    pages->addTab(makeArchives(), tr("Archives"));
    pages->addTab(receive_, tr("Receiving"));
    pages->addTab(keys_, tr("Keys"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setToolTip(tr("Take all pages as they are"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Change nothing"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(pages, 1);
    column->addWidget(
        remark(isKept ? tr("What was chosen on the command line counts more, until the program ends.")
                      : tr("These settings are not kept: the program was started so."),
               this));
    column->addWidget(buttons);
}

QWidget* SettingsDialog::makeLook() {
    auto* page = new QWidget(this);
    describe(*languages_, "settings-language", tr("Language"),
             tr("Of the window, and how numbers are written; from the next start on"));
    languages_->addItem(tr("As the desktop"), QString());
    for (const LanguageRow& row : kLanguages)
        languages_->addItem(QString::fromUtf8(row.title), QString::fromLatin1(row.code));
    languages_->setCurrentIndex(
        languages_->findData(before_.language ? codeOf(*before_.language) : QString()));
    describe(*highContrast_, "settings-high-contrast", tr("High contrast"),
             tr("Instead of the dark window; at once"));
    highContrast_->setChecked(before_.highContrast);
    describe(*fontScale_, "settings-font-scale", tr("Size of letters, times that of the desktop"),
             tr("Times the size of the desktop's letters, 0.8 to 2; at once"));
    fontScale_->setRange(kSmallestFontScale, kLargestFontScale);
    fontScale_->setSingleStep(kFontStep);
    fontScale_->setPrefix(QStringLiteral("× "));
    fontScale_->setValue(before_.fontScale);
    describe(*showsNames_, "settings-names", tr("Patient and study over pictures"),
             tr("When the window opens; N hides and shows them at any time"));
    showsNames_->setChecked(before_.showsNames);
    describe(
        *mouse_, "settings-mouse", tr("Mouse on slices and images"),
        tr("What dragging does; at once. On slices tools other than the cross-hair keep the left button"));
    const std::array titles{tr("Cross-hair left, move middle, window right"),
                            tr("Window left, move middle, zoom right"),
                            tr("Slices left, window middle, zoom right")};
    static_assert(titles.size() == kMouseProfiles.size());
    for (std::size_t i = 0; i < titles.size(); ++i)
        mouse_->addItem(titles[i], QLatin1String(kMouseProfiles[i].name));
    mouse_->setCurrentIndex(std::max(0, mouse_->findData(before_.mouse)));
    auto* form = new QFormLayout(page);
    form->addRow(tr("&Language"), languages_);
    form->addRow(tr("Letters"), fontScale_);
    form->addRow(tr("&Mouse"), mouse_);
    form->addRow(highContrast_);
    form->addRow(showsNames_);
    return page;
}

QWidget* SettingsDialog::makePictures() {
    auto* page = new QWidget(this);
    describe(*qualities_, "settings-quality", tr("Quality of saved pictures"),
             tr("What Save Picture begins with: more samples per pixel take more time"));
    if (const auto all = scene::builtInQualities()) {
        for (const trace::Quality& quality : *all)
            qualities_->addItem(tr("%1: %n samples", nullptr, int(quality.samplesPerPixel))
                                    .arg(titleInWindowsLanguage(quality.title)),
                                QString::fromStdString(quality.name));
    }
    qualities_->setCurrentIndex(qualities_->findData(before_.quality));
    describe(*deidentifies_, "settings-deidentify", tr("DICOM pictures without patient and study"),
             tr("What Save Picture begins with: nothing of the patient is written, and all UIDs are new"));
    deidentifies_->setChecked(before_.deidentifies);
    auto* form = new QFormLayout(page);
    form->addRow(tr("&Quality"), qualities_);
    form->addRow(deidentifies_);
    return page;
}

QWidget* SettingsDialog::makeSessions() {
    auto* page = new QWidget(this);
    describe(*folder_, "settings-folder", tr("Folder of stored sessions"),
             tr("Where previews, and how studies were left, are kept; empty: the usual folder. From the next "
                "start on; what is in the old folder stays there."));
    folder_->setPlaceholderText(QString::fromStdString(session::defaultFolder().string()));
    folder_->setClearButtonEnabled(true);
    auto* browse = new QPushButton(tr("&Choose…"), page);
    describe(*browse, "settings-browse", tr("Choose the folder of stored sessions"),
             tr("Choose a folder; it must be empty, or one that Macula made"));
    connect(browse, &QPushButton::clicked, this, &SettingsDialog::askForFolder);
    describe(
        *keepDays_, "settings-keep-days", tr("Days that studies are kept"),
        tr("What was not opened for so many days is deleted at the start, 1 to %1 days; nothing is deleted "
           "with 0")
            .arg(kMostKeptDays));
    keepDays_->setRange(0, kMostKeptDays);
    keepDays_->setSpecialValueText(tr("for ever"));
    keepDays_->setSuffix(tr(" days"));
    keepDays_->setValue(before_.keepDays.value_or(0));
    describe(
        *modelCap_, "settings-model-cap", tr("Room for stored previews in MB"),
        tr("Of all stored previews together, in MB; above it those that were not used for longest go. From "
           "the next start on."));
    modelCap_->setRange(kLeastModelCapMb, kMostModelCapMb);
    modelCap_->setSingleStep(kCapStepMb);
    modelCap_->setSuffix(tr(" MB"));
    modelCap_->setValue(before_.modelCapMb);
    auto* row = new QHBoxLayout;
    row->addWidget(folder_, 1);
    row->addWidget(browse);
    auto* form = new QFormLayout(page);
    form->addRow(tr("&Folder"), row);
    form->addRow(tr("&Keep"), keepDays_);
    form->addRow(tr("&Previews"), modelCap_);
    form->addRow(
        remark(tr("Names and IDs are not kept, but previews and views tell as much of a patient as pictures "
                  "do."),
               page));
    return page;
}

QWidget* SettingsDialog::makeArchives() {
    auto* page = new QWidget(this);
    describe(*priors_, "settings-priors", tr("Other studies of the patient"),
             tr("When a study from an archive is open, its archive is asked for others of this patient"));
    priors_->addItem(tr("Do not search"), int(PriorSearch::none));
    priors_->addItem(tr("List them"), int(PriorSearch::list));
    priors_->addItem(tr("List them, and fetch the last two to compare with"), int(PriorSearch::fetch));
    priors_->setCurrentIndex(priors_->findData(int(before_.priors)));
    auto* form = new QFormLayout(page);
    form->addRow(tr("&Other studies of the patient"), priors_);
    form->addRow(remark(tr("Macula fetches earlier studies of the last five years that hold the same kind of "
                           "images. The panel "
                           "Archive is where archives are set up."),
                        page));
    return page;
}

void SettingsDialog::askForFolder() {
    auto* dialog = new QFileDialog(this, tr("Folder of stored sessions"), folder_->text());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, folder_, &QLineEdit::setText);
    dialog->open();  // exec() would run a second event loop
}

Settings SettingsDialog::settings() const {
    Settings now = before_;
    now.language = languageOf(languages_->currentData().toString());
    now.highContrast = highContrast_->isChecked();
    now.fontScale = fontScale_->value();
    now.showsNames = showsNames_->isChecked();
    if (mouse_->currentIndex() > 0 || !before_.mouse.isEmpty()) now.mouse = mouse_->currentData().toString();
    if (qualities_->currentIndex() >= 0) now.quality = qualities_->currentData().toString();
    now.deidentifies = deidentifies_->isChecked();
    // Absolute, because the next run may start in another folder.
    const QString folder = folder_->text().trimmed();
    now.storeFolder = folder.isEmpty() ? QString() : QDir(folder).absolutePath();
    now.keepDays = keepDays_->value() > 0 ? std::optional(keepDays_->value()) : std::nullopt;
    now.modelCapMb = modelCap_->value();
    now.priors = PriorSearch(priors_->currentData().toInt());
    now.receiving = receive_->settings();
    now.keys = keys_->own();
    return now;
}

}  // namespace macula::viewer
