#include "viewer/dose/dvh_dialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPixmap>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "study/dose/dose_table.h"
#include "viewer/dose/dvh_chart.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/status/status_widgets.h"

namespace macula::viewer {

namespace {

constexpr double kPercent = 100.0;
constexpr int kSwatchPx = 12;
const QSize kFirstSize(900, 640);

QString numberText(const std::optional<double>& value, int decimals, double factor = 1.0) {
    if (!value || !std::isfinite(*value)) return QStringLiteral("–");
    return QLocale().toString(*value * factor, 'f', decimals);
}

}  // namespace

DvhDialog::DvhDialog(QWidget* parent)
    : QDialog(parent),
      title_(new QLabel(this)),
      chart_(new DvhChart),
      table_(new QTableWidget),
      notes_(new QLabel(this)),
      work_(new WorkBar(this)) {
    setObjectName(QStringLiteral("dvh-dialog"));
    setWindowTitle(tr("Dose-Volume Histogram"));
    makePlain(*title_, "dvh-title");
    makePlain(*notes_, "dvh-notes");
    describe(
        *table_, "dvh-table", tr("Dose in each region"),
        tr("A check mark shows the curve of a region. D95 is the dose that 95 % of the region receive at "
           "least; V20 is the share that receives 20 Gy or more"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->verticalHeader()->hide();
    auto* halves = new QSplitter(Qt::Vertical, this);
    halves->setChildrenCollapsible(false);
    halves->addWidget(chart_);
    halves->addWidget(table_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    copy_ = buttons->addButton(tr("&Copy as Table"), QDialogButtonBox::ActionRole);
    describe(*copy_, "dvh-copy", copy_->text(), tr("All figures as CSV, to paste into a spreadsheet"));
    export_ = buttons->addButton(tr("&Save as Table…"), QDialogButtonBox::ActionRole);
    describe(*export_, "dvh-export", export_->text(), tr("All figures in a file (CSV)"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(title_);
    column->addWidget(halves, 1);
    column->addWidget(notes_);
    column->addWidget(work_);
    column->addWidget(buttons);
    resize(kFirstSize);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(copy_, &QPushButton::clicked, this, &DvhDialog::copy);
    connect(export_, &QPushButton::clicked, this, [this] { Q_EMIT exportAsked(csv()); });
    connect(work_, &WorkBar::cancelClicked, this, &DvhDialog::cancelAsked);
    connect(table_, &QTableWidget::itemChanged, this, &DvhDialog::onItemChanged);
    connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) {
        chart_->setMarked(row >= 0 ? std::optional(std::size_t(row)) : std::nullopt);
    });
    setReport(nullptr, {});
}

void DvhDialog::begin(const QString& stage) {
    setReport(nullptr, {});
    work_->begin(stage);
    work_->show();
}

void DvhDialog::setProgress(const QString& stage, double fraction) {
    work_->setProgress(stage, fraction);
}

void DvhDialog::setReport(std::shared_ptr<const study::DoseReport> report, const QString& title) {
    report_ = std::move(report);
    work_->hide();
    title_->setText(title);
    title_->setVisible(!title.isEmpty());
    chart_->setReport(report_);
    copy_->setEnabled(report_ != nullptr);
    export_->setEnabled(report_ != nullptr);
    fill();
    showNotes();
}

void DvhDialog::setTrouble(const QString& sentence) {
    setReport(nullptr, {});
    notes_->setText(sentence);
    notes_->setVisible(!sentence.isEmpty());
}

void DvhDialog::showNames(bool shown) {
    namesShown_ = shown;
    fill();
    chart_->setHidden({});  // all regions are checked again
}

void DvhDialog::showNotes() {
    QStringList notes;
    if (report_) notes = inWindowsLanguage(report_->notes);
    notes_->setText(notes.join(QLatin1Char('\n')));
    notes_->setVisible(!notes.isEmpty());
}

void DvhDialog::fill() {
    const QScopedValueRollback fills(isFilling_, true);
    table_->clear();
    table_->setRowCount(0);
    table_->setColumnCount(0);
    if (!report_) return;
    const QString unit = harmless(QString::fromStdString(report_->unit));
    const auto inUnit = [&](const QString& what) {
        return unit.isEmpty() ? what : tr("%1 (%2)").arg(what, unit);
    };
    const QStringList headers{tr("Region"),       tr("ml"),          tr("Outside (%)"), inUnit(tr("Min")),
                              inUnit(tr("Mean")), inUnit(tr("Max")), inUnit(tr("D98")), inUnit(tr("D95")),
                              inUnit(tr("D50")),  inUnit(tr("D2")),  tr("V20 Gy (%)"),  tr("V95 % (%)"),
                              tr("V100 % (%)"),   tr("V107 % (%)")};
    table_->setColumnCount(int(headers.size()));
    table_->setHorizontalHeaderLabels(headers);
    table_->setRowCount(int(report_->regions.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const study::RegionInDose& region = report_->regions[std::size_t(row)];
        const study::DoseFigures f = figuresOf(region, *report_);
        QPixmap swatch(kSwatchPx, kSwatchPx);
        swatch.fill(QColor(region.rgb[0], region.rgb[1], region.rgb[2]));
        auto* name = new QTableWidgetItem(swatch, harmless(QString::fromStdString(region.label)));
        name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        name->setCheckState(region.dose.histogram.isEmpty() ? Qt::Unchecked : Qt::Checked);
        if (namesShown_) name->setToolTip(harmless(QString::fromStdString(region.set)).toHtmlEscaped());
        table_->setItem(row, 0, name);
        const double outside = region.dose.outsideShare();
        const std::array texts{
            numberText(region.volumeMl, 2),
            region.dose.samples > 0 ? numberText(outside, 1, kPercent) : QStringLiteral("–"),
            numberText(f.minimum, 2),
            numberText(f.mean, 2),
            numberText(f.maximum, 2),
            numberText(f.d98, 2),
            numberText(f.d95, 2),
            numberText(f.d50, 2),
            numberText(f.d2, 2),
            numberText(f.v20Gy, 1, kPercent),
            numberText(f.v95, 1, kPercent),
            numberText(f.v100, 1, kPercent),
            numberText(f.v107, 1, kPercent)};
        for (std::size_t i = 0; i < texts.size(); ++i) {
            auto* item = new QTableWidgetItem(texts[i]);
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table_->setItem(row, int(i) + 1, item);
        }
    }
    table_->resizeColumnsToContents();
}

void DvhDialog::onItemChanged() {
    if (isFilling_) return;
    std::set<std::size_t> hidden;
    for (int row = 0; row < table_->rowCount(); ++row)
        if (table_->item(row, 0)->checkState() != Qt::Checked) hidden.insert(std::size_t(row));
    chart_->setHidden(std::move(hidden));
}

QString DvhDialog::csv() const {
    return report_ ? QString::fromStdString(doseCsv(*report_)) : QString();
}

void DvhDialog::copy() {
    QGuiApplication::clipboard()->setText(csv());
}

}  // namespace macula::viewer
