#include "viewer/archive/send_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "study/open/same_patient.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr double kPatientsFontScale = 1.15;
constexpr int kLeastSidePx = 600;
constexpr int kMostPatientsNamed = 8;  // of more, a person could read none

QLabel* sentence(QWidget* parent, const char* name) {
    auto* label = new QLabel(parent);
    makePlain(*label, name);
    return label;
}

// Name, ID with date of birth and sex, and the study, each on a line of its own.
QString linesFor(const study::Identity& patient) {
    QStringList lines;
    for (const Text& line : study::linesOf(patient)) {
        const QString words = harmless(inWindowsLanguage(line));
        if (!words.isEmpty()) lines.append(words);
    }
    if (patient.birthDate.empty())
        lines.insert(std::min<qsizetype>(2, lines.size()), SendDialog::tr("No date of birth"));
    return lines.join(QLatin1Char('\n'));
}

bool areOfOnePatient(const study::Identity& a, const study::Identity& b) {
    return study::samePatient(a, b) == study::SamePatient::yes;
}

bool isNamed(const std::vector<study::Identity>& patients, const study::Identity& patient) {
    return std::ranges::any_of(patients, [&](const study::Identity& each) {
        return each.studyInstanceUid == patient.studyInstanceUid && areOfOnePatient(each, patient);
    });
}

}  // namespace

SendDialog::SendDialog(const SendOffer& offer, QWidget* parent)
    : QDialog(parent),
      offer_(offer),
      archives_(new QComboBox(this)),
      picture_(new QCheckBox(tr("&Picture of the 3D view (Secondary Capture)"), this)),
      sizes_(new QComboBox(this)),
      view_(new QCheckBox(tr("&View in 3D (presentation state, no pixels)"), this)),
      measurements_(new QCheckBox(this)),
      segments_(new QCheckBox(this)),
      deidentified_(new QCheckBox(tr("&Without patient and study"), this)),
      filesTold_(sentence(this, "send-files-told")),
      question_(sentence(this, "send-question")),
      patients_(sentence(this, "send-patients")),
      warning_(sentence(this, "send-warning")),
      reading_(this, {.ended = [this](const auto& found) { showFiles(found); }}) {
    setWindowTitle(tr("Send to an Archive"));
    auto* form = new QFormLayout;
    makeObjects(*form);
    makeFiles(*form);
    describe(*archives_, "send-archive", tr("Archive"), tr("The archive (PACS) in which they are stored"));
    archives_->addItems(offer_.archives);
    archives_->setCurrentIndex(std::max(0, archives_->findText(offer_.archive)));
    form->addRow(tr("&Archive"), archives_);
    auto* line = new QFrame(this);
    line->setFrameShape(QFrame::HLine);
    QFont large = patients_->font();
    large.setPointSizeF(large.pointSizeF() * kPatientsFontScale);
    large.setBold(true);
    patients_->setFont(large);
    patients_->setAccessibleName(tr("Patients"));
    auto* column = new QVBoxLayout(this);
    column->addLayout(form);
    column->addWidget(line);
    for (QLabel* each : {question_, patients_, warning_}) column->addWidget(each);
    column->addStretch(1);
    column->addWidget(makeButtons());
    connect(archives_, &QComboBox::currentIndexChanged, this, &SendDialog::showQuestion);
    for (QCheckBox* each : {picture_, view_, measurements_, segments_, deidentified_})
        connect(each, &QCheckBox::toggled, this, &SendDialog::showQuestion);
    setTabOrder(clear_, archives_);
    setTabOrder(archives_, send_);
    showQuestion();
}

void SendDialog::makeObjects(QFormLayout& form) {
    describe(*picture_, "send-picture", tr("Picture of the 3D view"),
             tr("Drawn with cube, scale and letters, at the quality of the settings"));
    describe(*sizes_, "send-size", tr("Size of the picture"), tr("In pixels"));
    describe(*view_, "send-view", tr("View in 3D"),
             tr("Camera, colours, clip and shading; Macula draws the same picture of it"));
    measurements_->setText(offer_.measurements > 0
                               ? tr("&Measurements (%1, structured report)").arg(offer_.measurements)
                               : tr("&Measurements (none)"));
    describe(*measurements_, "send-measurements", tr("Measurements"),
             tr("Lengths, angles, areas and values with their places in the images, unverified"));
    segments_->setText(offer_.segments > 0 ? tr("Segmen&tation (%n segments)", nullptr, offer_.segments)
                                           : tr("Segmen&tation (none is shown)"));
    describe(*segments_, "send-segmentation", tr("Segmentation"),
             tr("The segments that are shown, with labels, colours and codes, in one object"));
    describe(*deidentified_, "send-without-patient", tr("Without patient and study"),
             tr("What Macula makes gets a pseudonym and new UIDs. Files are sent as they are. A face can "
                "still be seen."));
    const auto addSize = [&](const QString& title, QSize pixels) {
        sizes_->addItem(QStringLiteral("%1 (%2 × %3)").arg(title).arg(pixels.width()).arg(pixels.height()),
                        pixels);
    };
    addSize(offer_.is3dShown ? tr("As on screen") : tr("As the panes"), offer_.screenPx);
    addSize(tr("Twice as large"), 2 * offer_.screenPx);
    addSize(tr("Full HD"), {1920, 1080});
    addSize(tr("Square"), {1024, 1024});
    addSize(tr("Large square"), {2048, 2048});
    // A quarter of a window is little for whoever looks at it in the archive.
    const int shorterPx = std::min(offer_.screenPx.width(), offer_.screenPx.height());
    if (shorterPx < kLeastSidePx) sizes_->setCurrentIndex(1);
    const bool canMake = offer_.whyNoObjects.isEmpty();
    picture_->setChecked(canMake);
    deidentified_->setChecked(offer_.isDeidentified && canMake);
    for (QWidget* each :
         std::initializer_list<QWidget*>{picture_, sizes_, view_, measurements_, segments_, deidentified_})
        each->setEnabled(canMake);
    const auto disable = [](QCheckBox& object, const QString& why) {
        if (why.isEmpty()) return;
        object.setEnabled(false);
        object.setToolTip(why);
    };
    disable(*view_, offer_.whyNoView);
    disable(*measurements_, offer_.whyNoMeasurements);
    disable(*segments_, offer_.whyNoSegments);
    connect(picture_, &QCheckBox::toggled, sizes_, &QWidget::setEnabled);
    auto* row = new QHBoxLayout;
    row->addWidget(picture_, 1);
    row->addWidget(sizes_);
    form.addRow(row);
    form.addRow(view_);
    form.addRow(measurements_);
    form.addRow(segments_);
    form.addRow(deidentified_);
    if (canMake) return;
    auto* why = sentence(this, "send-why-not");
    why->setText(offer_.whyNoObjects);
    form.addRow(why);
}

void SendDialog::makeFiles(QFormLayout& form) {
    const auto button = [&](const QString& title, const char* name, const QString& tip) {
        auto* made = new QPushButton(title, this);
        describe(*made, name, QString(title).remove(QLatin1Char('&')), tip);
        made->setAutoDefault(false);
        return made;
    };
    auto* files = button(tr("Add &Files…"), "send-add-files", tr("DICOM files from a disk, as they are"));
    auto* folder =
        button(tr("Add F&older…"), "send-add-folder", tr("All DICOM files in a folder and below it"));
    clear_ = button(tr("&None"), "send-no-files", tr("Send no files from a disk"));
    connect(files, &QPushButton::clicked, this, [this] { Q_EMIT filesAsked(); });
    connect(folder, &QPushButton::clicked, this, [this] { Q_EMIT folderAsked(); });
    connect(clear_, &QPushButton::clicked, this, &SendDialog::clearFiles);
    auto* row = new QHBoxLayout;
    row->addWidget(filesTold_, 1);
    row->addWidget(files);
    row->addWidget(folder);
    row->addWidget(clear_);
    form.addRow(row);
    filesTold_->setText(tr("No files from a disk"));
    clear_->setEnabled(false);
}

QWidget* SendDialog::makeButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    send_ = buttons->addButton(tr("&Send"), QDialogButtonBox::AcceptRole);
    send_->setObjectName(QStringLiteral("send-now"));
    send_->setToolTip(tr("Store these objects in the archive, in the background"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Send nothing"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
}

void SendDialog::addFiles(std::vector<std::filesystem::path> paths) {
    for (std::filesystem::path& each : paths) paths_.push_back(std::move(each));
    filesTold_->setText(tr("Reading files…"));
    reading_.start([all = paths_](Progress& progress) { return study::filesToSend(all, progress); });
    showQuestion();
}

void SendDialog::clearFiles() {
    reading_.cancel();
    paths_.clear();
    files_ = {};
    filesTold_->setText(tr("No files from a disk"));
    showQuestion();
}

// Where one of the paths cannot be used none is, so that nothing goes that the question does not name.
void SendDialog::showFiles(const Result<study::FilesToSend>& found) {
    files_ = found ? *found : study::FilesToSend();
    if (!found) paths_.clear();
    filesTold_->setText(found ? tr("%n files", nullptr, int(files_.files.size()))
                              : inWindowsLanguage(found.error()));
    showQuestion();
}

void SendDialog::showQuestion() {
    std::vector<study::Identity> patients;
    const int made = (sendsPicture() ? 1 : 0) + (sendsView() ? 1 : 0) + (sendsMeasurements() ? 1 : 0) +
                     (sendsSegments() ? 1 : 0);
    const bool makes = made > 0;
    if (makes && !isDeidentified()) patients.push_back(offer_.patient);
    for (const study::Identity& each : files_.patients)
        if (!isNamed(patients, each)) patients.push_back(each);
    const int count = int(files_.files.size()) + made;
    const bool canSend = count > 0 && !reading_.running() && archives_->count() > 0;
    send_->setEnabled(canSend);
    clear_->setEnabled(!paths_.empty());
    question_->setText(count == 0
                           ? tr("Choose what to send.")
                           : tr("Send %n objects to %1, of:", nullptr, count).arg(harmless(archive())));
    QStringList names;
    for (int i = 0; i < int(patients.size()) && i < kMostPatientsNamed; ++i)
        names.append(linesFor(patients[std::size_t(i)]));
    if (makes && isDeidentified()) names.prepend(tr("A pseudonym, in place of patient and study"));
    if (int(patients.size()) > kMostPatientsNamed)
        names.append(tr("and %n more", nullptr, int(patients.size()) - kMostPatientsNamed));
    patients_->setText(names.join(QStringLiteral("\n\n")));
    patients_->setVisible(!names.isEmpty());
    const bool areOfSeveral = std::ranges::any_of(
        patients, [&](const study::Identity& each) { return !areOfOnePatient(patients.front(), each); });
    warning_->setText(areOfSeveral ? tr("These objects are not of one patient.") : QString());
    warning_->setVisible(!warning_->text().isEmpty());
}

QString SendDialog::archive() const {
    return archives_->currentText();
}

bool SendDialog::sendsPicture() const {
    return picture_->isEnabled() && picture_->isChecked();
}

bool SendDialog::sendsView() const {
    return view_->isEnabled() && view_->isChecked();
}

bool SendDialog::sendsMeasurements() const {
    return measurements_->isEnabled() && measurements_->isChecked();
}

bool SendDialog::sendsSegments() const {
    return segments_->isEnabled() && segments_->isChecked();
}

bool SendDialog::isDeidentified() const {
    return deidentified_->isEnabled() && deidentified_->isChecked();
}

QSize SendDialog::sizePx() const {
    return sizes_->currentData().toSize();
}

}  // namespace macula::viewer
