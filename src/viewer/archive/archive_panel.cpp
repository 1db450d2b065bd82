#include "viewer/archive/archive_panel.h"

#include <QComboBox>
#include <QDate>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSplitter>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "viewer/archive/found_study_list.h"
#include "viewer/archive/series_strip.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

// What an item of the list of places stands for.
enum Place { everywhere, archive, thisMachine };

constexpr const char* kModalities[] = {"CT", "MR", "PT", "NM", "CR", "DX", "MG", "US", "XA", "RF"};

// "2026-11-30", "30.11.2026", or "20261130" as DICOM has it; nothing for what is no day.
std::optional<std::string> dayOf(const QLineEdit& field) {
    const QString text = field.text().trimmed();
    if (text.isEmpty()) return std::string();
    for (const char* format : {"yyyy-MM-dd", "d.M.yyyy", "yyyyMMdd"}) {
        const QDate day = QDate::fromString(text, QString::fromLatin1(format));
        if (day.isValid()) return day.toString(QStringLiteral("yyyyMMdd")).toStdString();
    }
    return std::nullopt;
}

std::string textOf(const QLineEdit& field) {
    return field.text().trimmed().toStdString();
}

}  // namespace

ArchivePanel::ArchivePanel(QWidget* parent)
    : QWidget(parent), places_(new QComboBox(this)), remark_(new QLabel(this)) {
    describe(*places_, "archive-source", tr("Where to search"),
             tr("All archives (PACS) and this machine, or one of them"));
    makePlain(*remark_, "archive-remark");
    auto* halves = new QSplitter(Qt::Vertical, this);
    halves->setChildrenCollapsible(false);
    halves->addWidget(makeFound());
    halves->addWidget(makePriors());
    auto* column = new QVBoxLayout(this);
    column->addWidget(makeForm());
    column->addWidget(halves, 1);
}

QLineEdit* ArchivePanel::addField(QFormLayout& form, const QString& label, const char* name,
                                  const QString& tip) {
    auto* field = new QLineEdit(this);
    describe(*field, name, label, tip);
    field->setClearButtonEnabled(true);
    form.addRow(label, field);
    connect(field, &QLineEdit::returnPressed, this, &ArchivePanel::search);
    connect(field, &QLineEdit::textEdited, this, [this] { isTypedIn_ = true; });
    return field;
}

QWidget* ArchivePanel::makeForm() {
    auto* box = new QWidget(this);
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    auto* setUp = new QPushButton(tr("Set up…"), this);
    setUp->setObjectName(QStringLiteral("archive-set-up"));
    setUp->setToolTip(tr("Set up an archive, try it, or remove it"));
    connect(setUp, &QPushButton::clicked, this, &ArchivePanel::setUpAsked);
    auto* first = new QHBoxLayout;
    first->addWidget(places_, 1);
    first->addWidget(setUp);
    form->addRow(tr("Where"), first);
    patient_ = addField(*form, tr("Patient"), "archive-patient",
                        tr("Name, family name first; * stands for what is not known"));
    patientId_ = addField(*form, tr("Patient ID"), "archive-patient-id", tr("As the hospital writes it"));
    accession_ = addField(*form, tr("Accession number"), "archive-accession", tr("Of the order"));
    description_ = addField(*form, tr("Description"), "archive-description",
                            tr("Of the study; * stands for what is not known"));
    from_ = addField(*form, tr("From"), "archive-from", tr("Earliest day of the study, as 2026-11-30"));
    to_ = addField(*form, tr("To"), "archive-to", tr("Latest day of the study"));
    modality_ = new QComboBox(this);
    describe(*modality_, "archive-modality", tr("Modality"), tr("Studies that hold images of this kind"));
    modality_->addItem(tr("any"));
    for (const char* modality : kModalities)
        modality_->addItem(QString::fromLatin1(modality), QString::fromLatin1(modality));
    form->addRow(tr("Modality"), modality_);
    search_ = new QPushButton(tr("Search"), this);
    search_->setObjectName(QStringLiteral("archive-search"));
    search_->setToolTip(tr("Ask the archive; Enter in a field does the same"));
    connect(search_, &QPushButton::clicked, this, [this] {
        if (isSearching_)
            Q_EMIT cancelAsked();
        else
            search();
    });
    form->addRow(QString(), search_);
    return box;
}

QWidget* ArchivePanel::makeFound() {
    auto* box = new QWidget(this);
    found_ = new FoundStudyList(QStringLiteral("archive-studies"), tr("Studies that match"), box);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(remark_);
    column->addWidget(found_, 1);
    series_ = new SeriesStrip(box);
    column->addWidget(series_);
    return box;
}

QWidget* ArchivePanel::makePriors() {
    priorsBox_ = new QWidget(this);
    priorsRemark_ = new QLabel(priorsBox_);
    makePlain(*priorsRemark_, "archive-priors-remark");
    auto* all = new QPushButton(tr("Search Everywhere"), priorsBox_);
    describe(*all, "archive-priors-all", tr("Search everywhere for studies of this patient"),
             tr("Ask all archives, and this machine, for other studies of the patient"));
    connect(all, &QPushButton::clicked, this, &ArchivePanel::priorsAsked);
    priors_ =
        new FoundStudyList(QStringLiteral("archive-priors"), tr("Other studies of this patient"), priorsBox_);
    priors_->hideColumns({FoundStudyModel::patient, FoundStudyModel::patientId, FoundStudyModel::birthDate,
                          FoundStudyModel::accession});
    auto* first = new QHBoxLayout;
    first->addWidget(priorsRemark_, 1);
    first->addWidget(all);
    auto* column = new QVBoxLayout(priorsBox_);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(first);
    column->addWidget(priors_, 1);
    priorsBox_->hide();
    return priorsBox_;
}

void ArchivePanel::setSources(const std::vector<net::Source>& sources) {
    // Without archives there was nothing to choose.
    const QString before = places_->count() > 1 ? places_->currentText() : QString();
    places_->clear();
    if (!sources.empty()) places_->addItem(tr("Everywhere"), int(Place::everywhere));
    for (const net::Source& each : sources)
        places_->addItem(QString::fromStdString(each.name), int(Place::archive));
    places_->addItem(tr("This machine"), int(Place::thisMachine));
    if (const int place = places_->findText(before); place >= 0 && !before.isEmpty())
        places_->setCurrentIndex(place);
    if (sources.empty())
        setRemark(tr("No archive has been set up yet. Set one up, or ask your administrator."));
}

SearchedPlaces ArchivePanel::places() const {
    switch (places_->currentData().toInt()) {
        case Place::archive:
            return {{places_->currentText()}, false};
        case Place::thisMachine:
            return {{}, true};
        default:
            return allPlaces();
    }
}

SearchedPlaces ArchivePanel::allPlaces() const {
    SearchedPlaces all{{}, true};
    for (int i = 0; i < places_->count(); ++i) {
        if (places_->itemData(i).toInt() == Place::archive) all.archives.append(places_->itemText(i));
    }
    return all;
}

std::optional<net::StudyQuery> ArchivePanel::query() {
    const auto from = dayOf(*from_);
    const auto to = dayOf(*to_);
    if (!from || !to) {
        setRemark(tr("A day is written as 2026-11-30."));
        (from ? to_ : from_)->setFocus();
        return std::nullopt;
    }
    net::StudyQuery query;
    query.patientName = textOf(*patient_);
    // People type the beginning of a name, and expect to find it.
    if (!query.patientName.empty() && query.patientName.find_first_of("*?") == std::string::npos)
        query.patientName += '*';
    query.patientId = textOf(*patientId_);
    query.accessionNumber = textOf(*accession_);
    query.description = textOf(*description_);
    if (!query.description.empty() && query.description.find_first_of("*?") == std::string::npos)
        query.description = "*" + query.description + "*";
    query.dateFrom = *from;
    query.dateTo = *to;
    query.modality = modality_->currentData().toString().toStdString();
    return query;
}

void ArchivePanel::search() {
    if (isSearching_) return;
    const auto asked = query();
    if (!asked) return;
    isTypedIn_ = false;
    Q_EMIT searchAsked(*asked);
}

void ArchivePanel::setListing(const study::Listing& listing, bool isWhole) {
    found_->setStudies(listing.studies);
    showCount(listing, isWhole);
    // Whoever types on while the search lasts does not lose the keyboard.
    if (isWhole && !isTypedIn_ && !listing.studies.empty()) found_->view().setFocus();
}

void ArchivePanel::renewListing(const study::Listing& listing) {
    found_->setStudies(listing.studies);
    if (remark_->text() == count_) showCount(listing, true);  // and nothing else is said there
}

void ArchivePanel::showCount(const study::Listing& listing, bool isWhole) {
    QStringList lines;
    if (!listing.studies.empty()) {
        QString count = tr("%n studies", nullptr, int(listing.studies.size()));
        if (listing.isCutShort) count += tr("; there are more. Narrow the search.");
        lines.append(count);
    } else if (isWhole && listing.silent.empty()) {
        lines.append(tr("No study matches."));
    }
    for (const study::SilentArchive& silent : listing.silent)
        lines.append(
            QStringLiteral("%1: %2").arg(QString::fromStdString(silent.name), inWindowsLanguage(silent.why)));
    if (!isWhole) lines.append(tr("Searching…"));
    count_ = lines.join(QLatin1Char('\n'));
    setRemark(count_);
}

void ArchivePanel::setPriors(const std::vector<study::ListedStudy>& priors, const QString& remark) {
    priors_->setStudies(priors);
    priors_->setVisible(!priors.empty());
    priorsRemark_->setText(remark);
    priorsBox_->setVisible(!remark.isEmpty());
}

void ArchivePanel::setRemark(const QString& text) {
    remark_->setText(text);
}

void ArchivePanel::setSearching(bool searching) {
    isSearching_ = searching;
    search_->setText(searching ? tr("Stop Searching") : tr("Search"));
}

void ArchivePanel::showNames(bool shown) {
    found_->showNames(shown);
    series_->showNames(shown);
    priors_->showNames(shown);
}

void ArchivePanel::focusSearch() {
    patient_->setFocus();
    patient_->selectAll();
}

}  // namespace macula::viewer
