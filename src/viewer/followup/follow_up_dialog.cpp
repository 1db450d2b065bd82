#include "viewer/followup/follow_up_dialog.h"

#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "base/atomic_file.h"
#include "study/open/identity.h"
#include "viewer/editor/study_editor.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

namespace {

using scene::LesionSize;

constexpr int kSumRows = 4;

QString mmText(double mm) {
    return withLocalNumbers(QString::number(mm, 'f', 1));
}

QString percentText(std::optional<double> part) {
    constexpr double kPercent = 100.0;
    if (!part) return QStringLiteral("–");
    const QString number = QString::number(kPercent * *part, 'f', 1);
    return withLocalNumbers((*part > 0.0 ? QStringLiteral("+") : QString()) + number) + QStringLiteral(" %");
}

QString dateOf(const std::string& date) {
    return date.empty() ? QCoreApplication::translate("FollowUpDialog", "No date")
                        : harmless(QString::fromStdString(study::dateForPeople(date)));
}

QString titleOf(scene::Response response) {
    switch (response) {
        case scene::Response::baseline:
            return QCoreApplication::translate("FollowUpDialog", "Baseline");
        case scene::Response::before:
            return QCoreApplication::translate("FollowUpDialog", "Before the baseline");
        case scene::Response::complete:
            return QCoreApplication::translate("FollowUpDialog", "CR: complete response");
        case scene::Response::partial:
            return QCoreApplication::translate("FollowUpDialog", "PR: partial response");
        case scene::Response::stable:
            return QCoreApplication::translate("FollowUpDialog", "SD: stable disease");
        case scene::Response::progress:
            return QCoreApplication::translate("FollowUpDialog", "PD: progressive disease");
        case scene::Response::unknown:
            break;
    }
    return QCoreApplication::translate("FollowUpDialog", "NE: not all are measured");
}

bool hasLesion(const scene::FollowedExam& exam) {
    return !scene::followUp(std::span(&exam, 1), 0).lesions.empty();
}

}  // namespace

FollowUpDialog::FollowUpDialog(FollowedStudies studies, const WindowContext& context)
    : QDialog(&context.window),
      studies_(std::move(studies)),
      context_(context),
      baselines_(new QComboBox(this)),
      grid_(new QTableWidget(this)),
      notes_(new QLabel(this)),
      isGone_(new QPushButton(tr("&Gone"), this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName(QStringLiteral("follow-up-dialog"));
    setWindowTitle(tr("Follow-up"));
    resize(760, 520);
    describe(*baselines_, "follow-up-baseline", tr("Baseline"),
             tr("The study that the later ones are compared with: the last before the treatment"));
    describe(*grid_, "follow-up-table", tr("Lesions in each study, in mm"), tr("Sizes in mm"));
    describe(*isGone_, "follow-up-gone", tr("Gone"),
             tr("The lesion of the chosen field is no longer seen in that study: its size is 0"));
    isGone_->setCheckable(true);
    isGone_->setAutoDefault(false);
    grid_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    grid_->setSelectionMode(QAbstractItemView::SingleSelection);
    makePlain(*notes_, "follow-up-notes");
    auto* column = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    form->addRow(tr("&Baseline"), baselines_);
    column->addLayout(form);
    column->addWidget(grid_, 1);
    column->addWidget(notes_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->addButton(isGone_, QDialogButtonBox::ActionRole);
    QPushButton* copy = buttons->addButton(tr("&Copy as a Table"), QDialogButtonBox::ActionRole);
    copy->setObjectName(QStringLiteral("follow-up-copy"));
    QPushButton* saved = buttons->addButton(tr("&Save as a Table…"), QDialogButtonBox::ActionRole);
    saved->setObjectName(QStringLiteral("follow-up-save"));
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(QString::fromStdString(toCsv(table_))); });
    connect(saved, &QPushButton::clicked, this, &FollowUpDialog::save);
    connect(baselines_, &QComboBox::activated, this, [this](int index) {
        baseline_ = std::size_t(index);
        isBaselineChosen_ = true;
        fill();
    });
    connect(grid_, &QTableWidget::currentCellChanged, this, &FollowUpDialog::showWhetherGone);
    connect(isGone_, &QPushButton::clicked, this, &FollowUpDialog::setGone);
    connect(&context_.session, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        if (before.measurements != context_.session.state().measurements) fill();
    });
    connect(&context_.session, &StudyEditor::studyShown, this, &QDialog::close);
    fill();
}

// All studies by date, with what is measured now.
void FollowUpDialog::gather() {
    FollowedStudy open = studies_.open;
    const auto& measured = context_.session.state().measurements;
    open.exam.measurements.insert(open.exam.measurements.end(), measured.begin(), measured.end());
    std::vector<FollowedStudy> all = studies_.others;
    all.push_back(std::move(open));
    std::ranges::stable_sort(all, {}, [](const FollowedStudy& study) { return study.exam.date; });
    exams_.clear();
    keys_.clear();
    gone_.clear();
    for (FollowedStudy& study : all) {
        for (std::string& lesion : study.gone) gone_.emplace(std::move(lesion), exams_.size());
        keys_.push_back(study.study);
        exams_.push_back(std::move(study.exam));
    }
}

void FollowUpDialog::fill() {
    gather();
    if (!isBaselineChosen_) {
        const auto first = std::ranges::find_if(exams_, hasLesion);
        baseline_ = first != exams_.end() ? std::size_t(first - exams_.begin()) : 0;
    }
    table_ = scene::followUp(exams_, baseline_, gone_);
    fillBaselines();
    const QSignalBlocker quiet(grid_);
    const int row = grid_->currentRow();
    const int column = grid_->currentColumn();
    const int lesions = int(table_.lesions.size());
    grid_->clear();
    grid_->setRowCount(lesions + kSumRows);
    grid_->setColumnCount(int(exams_.size()));
    QStringList dates;
    for (const scene::FollowedExam& exam : exams_) dates << dateOf(exam.date);
    grid_->setHorizontalHeaderLabels(dates);
    for (int i = 0; i < lesions; ++i) fillRow(i, table_.lesions[std::size_t(i)]);
    fillSums(lesions);
    grid_->resizeColumnsToContents();
    grid_->setCurrentCell(std::min(row, lesions + kSumRows - 1), column);
    showNotes();
    showWhetherGone();
}

void FollowUpDialog::fillBaselines() {
    const QSignalBlocker quiet(baselines_);
    baselines_->clear();
    for (const scene::FollowedExam& exam : exams_) baselines_->addItem(dateOf(exam.date));
    baselines_->setCurrentIndex(int(baseline_));
}

void FollowUpDialog::setCell(int row, int column, const QString& text, bool isStrong) {
    auto* item = new QTableWidgetItem(text);
    item->setToolTip(text);
    if (isStrong) {
        QFont font = item->font();
        font.setBold(true);
        item->setFont(font);
    }
    grid_->setItem(row, column, item);
}

void FollowUpDialog::fillRow(int row, const scene::FollowedLesion& lesion) {
    QString title = harmless(QString::fromStdString(lesion.label));
    if (lesion.isNode) title = tr("%1 (lymph node, short axis)").arg(title);
    if (lesion.isNew) title = tr("%1 (not at the baseline)").arg(title);
    grid_->setVerticalHeaderItem(row, new QTableWidgetItem(title));
    for (std::size_t exam = 0; exam < lesion.sizes.size(); ++exam) {
        const LesionSize& size = lesion.sizes[exam];
        setCell(row, int(exam),
                size.is == LesionSize::Is::measured ? mmText(size.mm)
                : size.is == LesionSize::Is::gone   ? tr("0 (gone)")
                                                    : tr("not measured"));
    }
}

void FollowUpDialog::fillSums(int row) {
    const std::array<QString, kSumRows> titles{tr("Sum in mm"), tr("From the baseline"),
                                               tr("From the smallest sum before"), tr("RECIST 1.1")};
    for (int i = 0; i < kSumRows; ++i)
        grid_->setVerticalHeaderItem(row + i, new QTableWidgetItem(titles.at(std::size_t(i))));
    for (std::size_t exam = 0; exam < table_.sums.size(); ++exam) {
        const scene::ExamSum& sum = table_.sums[exam];
        const int column = int(exam);
        setCell(row, column, sum.sumMm ? mmText(*sum.sumMm) : QStringLiteral("–"), true);
        setCell(row + 1, column, percentText(sum.fromBaseline));
        setCell(row + 2, column, percentText(sum.fromNadir));
        setCell(row + 3, column, titleOf(sum.response), true);
    }
}

void FollowUpDialog::showNotes() {
    QStringList lines{
        tr("The categories are what RECIST 1.1 gives for these sizes alone. New lesions and lesions that "
           "are not measured (non-target lesions) are not in them. A physician decides.")};
    if (table_.lesions.empty())
        lines << tr(
            "Measure lesions with both axes (Shift+D), and give the same lesion the same label in each "
            "study.");
    else if (exams_.size() < 2)
        lines << tr(
            "Only this study is known. Open a prior in its place, measure there, and come back: what is "
            "measured is kept. Priors of this folder are known, and those of the folder that is open beside "
            "it "
            "(Ctrl+B).");
    if (!context_.session.study().measured()->provenance().isCalibrated)
        lines << tr("The size of the pixels of the open study is not calibrated: its lengths are estimates.");
    lines << inWindowsLanguage(table_.notes) << studies_.notes;
    notes_->setText(lines.join(QLatin1Char('\n')));
}

// The button is for a field of a lesion that was not measured.
void FollowUpDialog::showWhetherGone() {
    const int row = grid_->currentRow();
    const int exam = grid_->currentColumn();
    const bool isLesion = row >= 0 && std::size_t(row) < table_.lesions.size() && exam >= 0;
    const LesionSize size =
        isLesion ? table_.lesions[std::size_t(row)].sizes[std::size_t(exam)] : LesionSize{};
    isGone_->setEnabled(isLesion && size.is != LesionSize::Is::measured);
    isGone_->setChecked(isLesion && size.is == LesionSize::Is::gone);
}

void FollowUpDialog::setGone(bool isGone) {
    const int row = grid_->currentRow();
    const int exam = grid_->currentColumn();
    if (row < 0 || exam < 0 || std::size_t(row) >= table_.lesions.size()) return;
    const std::string key = scene::keyOfLesion(table_.lesions[std::size_t(row)].label);
    const std::string& study = keys_[std::size_t(exam)];
    const auto other = std::ranges::find(studies_.others, study, &FollowedStudy::study);
    FollowedStudy& of = other != studies_.others.end() ? *other : studies_.open;
    std::erase(of.gone, key);
    if (isGone) of.gone.push_back(key);
    Q_EMIT goneChanged(of.study, of.gone);
    fill();
}

void FollowUpDialog::save() {
    auto* dialog =
        context_.files.toSave(FolderKind::measurements, tr("Save the follow-up"), tr("Table (*.csv)"),
                              QStringLiteral("csv"), QStringLiteral("follow-up.csv"));
    context_.files.ask(dialog, FolderKind::measurements,
                       [context = context_, csv = toCsv(table_)](const QString& path) {
                           context.notifications.showOutcome(writeTextAtomically(path.toStdString(), csv),
                                                             tr("The follow-up is written to %1.").arg(path));
                       });
}

}  // namespace macula::viewer
