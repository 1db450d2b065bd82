#include "viewer/dose/isodose_table.h"

#include <QHeaderView>
#include <QLocale>
#include <QScopedValueRollback>

#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr double kPercent = 100.0;
enum Column { kColour, kLevel, kOther, kColumns };

QString numberText(double value) {
    return QLocale().toString(value, 'g', 5);
}

}  // namespace

IsodoseTable::IsodoseTable(QWidget* parent) : QTableWidget(parent) {
    describe(*this, "isodoses", tr("Isodoses"),
             tr("Levels of the lines. Double click: another level, or another colour"));
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    verticalHeader()->hide();
    setColumnCount(kColumns);
    horizontalHeader()->setStretchLastSection(true);
    connect(this, &QTableWidget::itemChanged, this, &IsodoseTable::onChanged);
    connect(this, &QTableWidget::cellActivated, this, [this](int row, int column) {
        if (column == kColour && row >= 0) Q_EMIT colourAsked(std::size_t(row));
    });
}

void IsodoseTable::show(const scene::Isodoses& isodoses, const std::optional<study::DoseReference>& reference,
                        const QString& unit) {
    if (isodoses == isodoses_ && reference == reference_ && unit == unit_ &&
        rowCount() == int(isodoses.levels.size()))
        return;
    isodoses_ = isodoses;
    reference_ = reference;
    unit_ = unit;
    fill();
}

std::optional<std::size_t> IsodoseTable::current() const {
    if (rowCount() == 0) return std::nullopt;
    return std::size_t(currentRow() >= 0 ? currentRow() : rowCount() - 1);
}

// Items stay: one of them may be telling that it was edited.
QTableWidgetItem& IsodoseTable::cellAt(int row, int column) {
    if (QTableWidgetItem* there = item(row, column)) return *there;
    auto* made = new QTableWidgetItem;
    made->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable |
                   (column == kLevel ? Qt::ItemIsEditable : Qt::NoItemFlags));
    setItem(row, column, made);
    return *made;
}

void IsodoseTable::fill() {
    const QScopedValueRollback fills(isFilling_, true);
    const int was = currentRow();
    const QString percent = QStringLiteral("%");
    const QString dose = unit_.isEmpty() ? tr("Dose") : unit_;
    setHorizontalHeaderLabels(
        {tr("Colour"), isodoses_.areInPercent ? percent : dose, isodoses_.areInPercent ? dose : percent});
    setRowCount(int(isodoses_.levels.size()));
    for (int row = 0; row < rowCount(); ++row) {
        const scene::Isodose& each = isodoses_.levels[std::size_t(row)];
        const QColor ink(each.rgb[0], each.rgb[1], each.rgb[2]);
        QTableWidgetItem& colour = cellAt(row, kColour);
        colour.setBackground(ink);
        colour.setData(Qt::AccessibleTextRole, ink.name());
        cellAt(row, kLevel).setText(numberText(each.level));
        cellAt(row, kOther)
            .setText(!reference_
                         ? QString()
                         : numberText(isodoses_.areInPercent ? each.level / kPercent * reference_->value
                                                             : kPercent * each.level / reference_->value));
    }
    if (was >= 0 && was < rowCount()) setCurrentCell(was, kLevel);
}

// What is no level leaves the old one.
void IsodoseTable::onChanged(QTableWidgetItem* item) {
    if (isFilling_ || item->column() != kLevel) return;
    const auto row = std::size_t(item->row());
    bool isNumber = false;
    double level = QLocale().toDouble(item->text().trimmed(), &isNumber);
    if (!isNumber) level = item->text().trimmed().toDouble(&isNumber);
    if (isNumber && level > 0.0 && level <= scene::kHighestIsodose && row < isodoses_.levels.size()) {
        Q_EMIT levelEntered(row, level);
    }
    fill();
}

}  // namespace macula::viewer
