#include "viewer/documents/document_dialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSplitter>
#include <QTextBrowser>
#include <QTextDocumentFragment>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "dicom/documents/document_text.h"
#include "dicom/documents/read_document.h"
#include "viewer/documents/document_html.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

const QSize kFirstSize(860, 640);

QLabel* plainLabel(const char* name) {
    auto* label = new QLabel;
    makePlain(*label, name);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QLabel* boldLabel(const char* name) {
    QLabel* label = plainLabel(name);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

}  // namespace

DocumentDialog::DocumentDialog(QWidget* parent)
    : QDialog(parent),
      patient_(boldLabel("document-patient")),
      title_(plainLabel("document-title")),
      status_(boldLabel("document-status")),
      notes_(plainLabel("document-notes")),
      browser_(new QTextBrowser),
      beside_(new QWidget),
      imagesTitle_(new QLabel),
      list_(new QListWidget) {
    setObjectName(QStringLiteral("document"));
    setModal(false);
    makeText();
    makeImages();
    auto* split = new QSplitter(Qt::Horizontal);
    split->addWidget(browser_);
    split->addWidget(beside_);
    split->setStretchFactor(0, 3);
    split->setStretchFactor(1, 1);
    split->setChildrenCollapsible(false);
    auto* column = new QVBoxLayout(this);
    for (QLabel* label : {patient_, title_, status_, notes_}) column->addWidget(label);
    column->addWidget(split, 1);
    column->addWidget(makeButtons());
    resize(kFirstSize);
}

void DocumentDialog::makeText() {
    describe(*browser_, "document-text", tr("Text of the document"),
             tr("What the document says. Links go to the images that it names."));
    browser_->setOpenLinks(false);  // nothing outside is ever opened
    browser_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(browser_, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
        bool isNumber = false;
        const int place = link.fragment().toInt(&isNumber);
        if (isNumber && place >= 0 && place < images_.size()) Q_EMIT imageAsked(place);
    });
}

void DocumentDialog::makeImages() {
    describe(*list_, "document-images", tr("Images of the document"),
             tr("The images that the document names, in its order. A double click or Enter shows one."));
    previous_ = new QPushButton(tr("&Previous Image"));
    previous_->setObjectName(QStringLiteral("document-previous"));
    next_ = new QPushButton(tr("&Next Image"));
    next_->setObjectName(QStringLiteral("document-next"));
    for (QPushButton* each : {previous_, next_}) each->setAutoDefault(false);
    connect(previous_, &QPushButton::clicked, this, [this] { step(-1); });
    connect(next_, &QPushButton::clicked, this, [this] { step(1); });
    connect(list_, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { Q_EMIT imageAsked(list_->row(item)); });
    auto* column = new QVBoxLayout(beside_);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(imagesTitle_);
    column->addWidget(list_, 1);
    column->addWidget(previous_);
    column->addWidget(next_);
}

QWidget* DocumentDialog::makeButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    const auto add = [&](const QString& words, const char* name, const QString& tip) {
        QPushButton* button = buttons->addButton(words, QDialogButtonBox::ActionRole);
        button->setObjectName(QLatin1String(name));
        button->setToolTip(tip);
        button->setAutoDefault(false);
        return button;
    };
    openFile_ = add(tr("&Open in the PDF Viewer…"), "document-open-file",
                    tr("In the program of this computer that shows PDF files"));
    saveFile_ = add(tr("Save &File As…"), "document-save-file", tr("The file that the document holds"));
    measurements_ = add(tr("Take Over &Measurements"), "document-measurements",
                        tr("Adds what the report measured to the slices of the open study"));
    QPushButton* copies = add(tr("Cop&y"), "document-copy", tr("The selected text, otherwise all of it"));
    QPushButton* saves = add(tr("&Save as Text…"), "document-save-text", tr("With the patient's name"));
    connect(openFile_, &QPushButton::clicked, this, &DocumentDialog::fileOpenAsked);
    connect(saveFile_, &QPushButton::clicked, this, &DocumentDialog::fileSaveAsked);
    connect(measurements_, &QPushButton::clicked, this, &DocumentDialog::measurementsAsked);
    connect(copies, &QPushButton::clicked, this, &DocumentDialog::copy);
    connect(saves, &QPushButton::clicked, this, &DocumentDialog::textSaveAsked);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    return buttons;
}

void DocumentDialog::setDocument(const dicom::StudyDocument& document, const QStringList& images) {
    document_ = document;
    images_ = images;
    image_ = -1;
    setWindowTitle(harmless(inWindowsLanguage(titleLineOf(document))));
    patient_->setText(harmless(inWindowsLanguage(patientLineOf(document))));
    title_->setText(QStringLiteral("%1 · %2").arg(windowTitle(), inWindowsLanguage(dateLineOf(document))));
    status_->setText(inWindowsLanguage(document.status).join(QLatin1Char(' ')));
    status_->setVisible(!document.status.empty());
    notes_->setText(inWindowsLanguage(document.notes).join(QLatin1Char(' ')));
    notes_->setVisible(!document.notes.empty());
    const std::vector<dicom::DocumentReference> references = document.references();
    browser_->setHtml(htmlOf(document, [&](const dicom::DocumentReference& reference) {
        const auto at = std::ranges::find(references, reference);
        const auto place = qsizetype(at - references.begin());
        return place < images.size() ? images[place] : QString();
    }));
    if (document.contents) browser_->setPlainText(inWindowsLanguage(contentsLineOf(document)));
    list_->clear();
    for (std::size_t i = 0; i < references.size(); ++i) {
        const QString& name = images.value(qsizetype(i));
        auto* item = new QListWidgetItem(name.isEmpty() ? tr("not in this folder") : name, list_);
        if (name.isEmpty()) item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
    }
    const bool isSelection = document.kind == dicom::StudyDocument::Kind::keyObjects;
    imagesTitle_->setText(isSelection ? tr("Key images") : tr("Images of the document"));
    beside_->setVisible(!references.empty());
    const bool canGo = std::ranges::any_of(images, [](const QString& each) { return !each.isEmpty(); });
    for (QPushButton* each : {previous_, next_}) each->setEnabled(canGo);
    openFile_->setVisible(document.contents && document.contents->mimeType == "application/pdf");
    saveFile_->setVisible(document.contents.has_value());
    measurements_->setVisible(std::ranges::any_of(
        document.entries, [](const dicom::DocumentEntry& each) { return each.points.has_value(); }));
    browser_->setFocus();
}

void DocumentDialog::setImage(int place) {
    image_ = place;
    list_->setCurrentRow(place);
    for (int row = 0; row < list_->count(); ++row) {
        QFont font = list_->font();
        font.setBold(row == place);
        list_->item(row)->setFont(font);
    }
}

// To the next image that is there.
void DocumentDialog::step(int by) {
    for (int place = image_ < 0 && by < 0 ? int(images_.size()) - 1 : image_ + by;
         place >= 0 && place < images_.size(); place += by) {
        if (!images_[place].isEmpty()) return Q_EMIT imageAsked(place);
    }
}

QString DocumentDialog::text() const {
    const std::vector<dicom::DocumentReference> references = document_.references();
    return QString::fromStdString(dicom::plainTextOf(
        document_, [](const Text& text) { return inWindowsLanguage(text).toStdString(); },
        [&](const dicom::DocumentReference& reference) {
            const auto at = std::ranges::find(references, reference);
            return images_.value(qsizetype(at - references.begin())).toStdString();
        }));
}

void DocumentDialog::copy() {
    const QString selected = browser_->textCursor().selection().toPlainText();
    QGuiApplication::clipboard()->setText(selected.isEmpty() ? text() : selected);
}

}  // namespace macula::viewer
