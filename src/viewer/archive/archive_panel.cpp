#include "viewer/archive/archive_panel.h"

#include <QComboBox>
#include <QDate>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "viewer/archive/found_study_model.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr int kWidestColumnPx = 160;  // at first; a person can make columns wider
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
    : QWidget(parent),
      sources_(new QComboBox(this)),
      model_(new FoundStudyModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      remark_(new QLabel(this)) {
    describe(*sources_, "archive-source", tr("Archive"), tr("The archive (PACS) that is searched"));
    sorted_->setSourceModel(model_);
    sorted_->setSortRole(FoundStudyModel::sortRole);
    remark_->setTextFormat(Qt::PlainText);
    remark_->setWordWrap(true);
    remark_->setObjectName(QStringLiteral("archive-remark"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(makeForm());
    column->addWidget(makeList(), 1);
    column->addWidget(remark_);
    column->addWidget(makeButtons());
}

QLineEdit* ArchivePanel::addField(QFormLayout& form, const QString& label, const char* name,
                                  const QString& tip) {
    auto* field = new QLineEdit(this);
    describe(*field, name, label, tip);
    field->setClearButtonEnabled(true);
    form.addRow(label, field);
    connect(field, &QLineEdit::returnPressed, this, &ArchivePanel::search);
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
    first->addWidget(sources_, 1);
    first->addWidget(setUp);
    form->addRow(tr("Archive"), first);
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
    connect(search_, &QPushButton::clicked, this, &ArchivePanel::search);
    form->addRow(QString(), search_);
    return box;
}

QWidget* ArchivePanel::makeList() {
    list_ = new QTreeView(this);
    describe(*list_, "archive-studies", tr("Studies in the archive"),
             tr("Enter or a double click opens the selected study"));
    list_->setModel(sorted_);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAlternatingRowColors(true);
    list_->setSortingEnabled(true);
    list_->sortByColumn(FoundStudyModel::date, Qt::DescendingOrder);
    list_->header()->setSectionsMovable(true);
    connect(list_, &QTreeView::activated, this, [this] {
        if (const auto study = selected()) Q_EMIT openAsked(*study);
    });
    return list_;
}

QWidget* ArchivePanel::makeButtons() {
    auto* row = new QWidget(this);
    auto* buttons = new QHBoxLayout(row);
    buttons->setContentsMargins(0, 0, 0, 0);
    open_ = new QPushButton(tr("Open"), this);
    open_->setObjectName(QStringLiteral("archive-open"));
    open_->setToolTip(tr("Fetch the selected study, and show it as soon as images are there"));
    connect(open_, &QPushButton::clicked, this, [this] {
        if (const auto study = selected()) Q_EMIT openAsked(*study);
    });
    buttons->addStretch(1);
    buttons->addWidget(open_);
    open_->setEnabled(false);
    connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            [this] { open_->setEnabled(selected().has_value()); });
    return row;
}

void ArchivePanel::setSources(const std::vector<net::Source>& sources) {
    const QString before = source();
    sources_->clear();
    for (const net::Source& each : sources) sources_->addItem(QString::fromStdString(each.name));
    if (const int place = sources_->findText(before); place >= 0) sources_->setCurrentIndex(place);
    search_->setEnabled(!sources.empty());
    if (sources.empty())
        setRemark(tr("No archive has been set up yet. Set one up, or ask your administrator."));
}

QString ArchivePanel::source() const {
    return sources_->currentText();
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
    if (!search_->isEnabled()) return;
    if (const auto asked = query()) Q_EMIT searchAsked(*asked);
}

std::optional<net::FoundStudy> ArchivePanel::selected() const {
    const QModelIndexList rows = list_->selectionModel()->selectedRows();
    if (rows.isEmpty()) return std::nullopt;
    return model_->study(sorted_->mapToSource(rows.front()).row());
}

void ArchivePanel::setAnswers(const net::StudyAnswers& answers) {
    model_->setStudies(answers.studies);
    for (int column = 0; column < FoundStudyModel::columnCountOf; ++column) {
        list_->resizeColumnToContents(column);
        list_->setColumnWidth(column, std::min(list_->columnWidth(column), kWidestColumnPx));
    }
    QString remark = tr("%n studies", nullptr, int(answers.studies.size()));
    if (answers.isCutShort) remark += tr("; there are more. Narrow the search.");
    if (answers.studies.empty()) remark = tr("No study matches.");
    setRemark(remark);
    if (!answers.studies.empty()) {
        list_->setCurrentIndex(sorted_->index(0, 0));
        list_->setFocus();
    }
}

void ArchivePanel::setRemark(const QString& text) {
    remark_->setText(text);
}

void ArchivePanel::setSearching(bool searching) {
    search_->setEnabled(!searching && sources_->count() > 0);
}

void ArchivePanel::showNames(bool shown) {
    model_->showNames(shown);
}

void ArchivePanel::focusSearch() {
    patient_->setFocus();
    patient_->selectAll();
}

}  // namespace macula::viewer
