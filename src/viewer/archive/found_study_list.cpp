#include "viewer/archive/found_study_list.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMenu>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "viewer/archive/read_marks.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr int kWidestColumnPx = 160;  // at first; a person can make columns wider
constexpr int kRowsThatCountForWidth = 100;

}  // namespace

FoundStudyList::FoundStudyList(const QString& name, const QString& title, QWidget* parent)
    : QWidget(parent),
      model_(new FoundStudyModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      list_(new QTreeView(this)) {
    sorted_->setSourceModel(model_);
    sorted_->setSortRole(FoundStudyModel::sortRole);
    list_->setObjectName(name);
    list_->setAccessibleName(title);
    list_->setToolTip(tr("Enter or a double click opens the selected study"));
    list_->setModel(sorted_);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAlternatingRowColors(true);
    list_->setSortingEnabled(true);
    list_->sortByColumn(FoundStudyModel::date, Qt::DescendingOrder);
    list_->header()->setSectionsMovable(true);
    list_->header()->setResizeContentsPrecision(kRowsThatCountForWidth);
    connect(list_, &QTreeView::activated, this, [this] {
        if (const auto study = selected()) Q_EMIT openAsked(*study);
    });
    mark_ = new QAction(tr("Mark as Read"), list_);
    describe(*mark_, "mark-study-read",
             tr("A study that is marked stands as read; Space marks it, or takes it back"));
    mark_->setShortcut(Qt::Key_Space);
    mark_->setShortcutContext(Qt::WidgetShortcut);
    connect(mark_, &QAction::triggered, this, &FoundStudyList::toggleMark);
    list_->addAction(mark_);
    list_->header()->moveSection(FoundStudyModel::mark, 0);
    auto* row = new QWidget(this);
    makeButtons(*row, name);
    makeMenuOfColumns();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(list_, 1);
    column->addWidget(row);
    connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        showButtons();
        Q_EMIT selectionChanged();
    });
    showButtons();
}

void FoundStudyList::makeButtons(QWidget& row, const QString& name) {
    auto* buttons = new QHBoxLayout(&row);
    buttons->setContentsMargins(0, 0, 0, 0);
    buttons->addStretch(1);
    const auto add = [&](const QString& suffix, const QString& text, const QString& tip,
                         void (FoundStudyList::*asked)(const study::ListedStudy&)) {
        auto* button = new QPushButton(text, &row);
        button->setObjectName(name + suffix);
        button->setToolTip(tip);
        connect(button, &QPushButton::clicked, this, [this, asked] {
            if (const auto study = selected()) Q_EMIT(this->*asked)(*study);
        });
        buttons->addWidget(button);
        return button;
    };
    fetch_ = add(QStringLiteral("-fetch"), tr("Fetch"),
                 tr("Fetch the selected study in the background, and keep it on this machine"),
                 &FoundStudyList::fetchAsked);
    beside_ = add(QStringLiteral("-beside"), tr("Beside"),
                  tr("Show the selected study beside the open one, as a second volume"),
                  &FoundStudyList::besideAsked);
    open_ = add(QStringLiteral("-open"), tr("Open"),
                tr("Show the selected study; from an archive as soon as images are there"),
                &FoundStudyList::openAsked);
}

// The menu of the header, which Menu or Shift+F10 opens too while the list has the focus.
void FoundStudyList::makeMenuOfColumns() {
    QHeaderView* header = list_->header();
    header->setContextMenuPolicy(Qt::ActionsContextMenu);
    header->setToolTip(tr("A right click chooses the columns; drag to move them, click to sort"));
    list_->setContextMenuPolicy(Qt::ActionsContextMenu);
    auto* columns = new QAction(tr("Columns"), list_);
    auto* menu = new QMenu(this);
    columns->setMenu(menu);
    list_->addAction(columns);
    for (int column = 0; column < FoundStudyModel::columnCountOf; ++column) {
        QAction* shown =
            menu->addAction(model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
        shown->setCheckable(true);
        shown->setChecked(true);
        header->addAction(shown);
        connect(shown, &QAction::triggered, this, [this, header, column](bool isShown) {
            if (!isShown && header->hiddenSectionCount() == header->count() - 1) return;  // the last one
            header->setSectionHidden(column, !isShown);
            hasOwnColumns_ = true;
            Q_EMIT columnsChanged();
        });
        connect(menu, &QMenu::aboutToShow, shown,
                [shown, header, column] { shown->setChecked(!header->isSectionHidden(column)); });
    }
    const auto changed = [this] {
        if (!list_->isVisible()) return;
        hasOwnColumns_ = true;
        Q_EMIT columnsChanged();
    };
    connect(header, &QHeaderView::sectionMoved, this, changed);
}

void FoundStudyList::setStudies(std::vector<study::ListedStudy> studies) {
    const auto before = selected();
    std::vector<std::string> uids;
    for (const study::ListedStudy& each : studies) uids.push_back(each.study.studyInstanceUid);
    model_->setStudies(std::move(studies));
    if (marks_ != nullptr) marks_->ask(uids);
    fitColumns();
    int row = model_->rowCount() > 0 ? sorted_->mapToSource(sorted_->index(0, 0)).row() : -1;
    if (before) row = rowOf(*before);
    if (row >= 0) list_->setCurrentIndex(sorted_->mapFromSource(model_->index(row, 0)));
    showButtons();
    Q_EMIT selectionChanged();
}

// Once the archive has answered, a study of this machine is listed as the archive's. -1: it is gone, and none
// is taken for it.
int FoundStudyList::rowOf(const study::ListedStudy& study) const {
    int row = -1;
    for (int each = 0; each < model_->rowCount(); ++each) {
        const study::ListedStudy& other = model_->study(each);
        if (other.study.studyInstanceUid != study.study.studyInstanceUid) continue;
        if (other.archive == study.archive) return each;
        if (row < 0) row = each;
    }
    return row;
}

void FoundStudyList::fitColumns() {
    if (hasOwnColumns_) return;
    for (int column = 0; column < FoundStudyModel::columnCountOf; ++column) {
        list_->resizeColumnToContents(column);
        list_->setColumnWidth(column, std::min(list_->columnWidth(column), kWidestColumnPx));
    }
}

void FoundStudyList::showButtons() {
    const auto study = selected();
    const bool isHere = study && !study->folder.empty();
    open_->setEnabled(study.has_value());
    beside_->setEnabled(study && canOpenBeside_);
    fetch_->setEnabled(study && !study->archive.empty() && !(isHere && study->isWhole));
    const bool isRead =
        study && marks_ != nullptr && marks_->of(study->study.studyInstanceUid) == ReadMark::read;
    mark_->setEnabled(study && marks_ != nullptr);
    mark_->setText(isRead ? tr("Mark as Not Read") : tr("Mark as Read"));
}

void FoundStudyList::setMarks(ReadMarks* marks) {
    marks_ = marks;
    model_->setMarks(marks);
    connect(marks, &ReadMarks::changed, this, [this] {
        model_->tellMarksChanged();
        showButtons();
    });
    showButtons();
}

void FoundStudyList::toggleMark() {
    const auto study = selected();
    if (!study || marks_ == nullptr) return;
    const std::string& uid = study->study.studyInstanceUid;
    marks_->setRead(uid, marks_->of(uid) != ReadMark::read);
}

void FoundStudyList::showNames(bool shown) {
    model_->showNames(shown);
}

void FoundStudyList::hideColumns(const QList<FoundStudyModel::Column>& columns) {
    for (const FoundStudyModel::Column column : columns) list_->setColumnHidden(column, true);
}

void FoundStudyList::setCanOpenBeside(bool can) {
    canOpenBeside_ = can;
    showButtons();
}

std::optional<study::ListedStudy> FoundStudyList::selected() const {
    const QModelIndexList rows = list_->selectionModel()->selectedRows();
    if (rows.isEmpty()) return std::nullopt;
    return model_->study(sorted_->mapToSource(rows.front()).row());
}

QString FoundStudyList::columns() const {
    return hasOwnColumns_ ? QString::fromLatin1(list_->header()->saveState().toBase64()) : QString();
}

void FoundStudyList::setColumns(const QString& columns) {
    if (columns.isEmpty()) return;
    hasOwnColumns_ = list_->header()->restoreState(QByteArray::fromBase64(columns.toLatin1()));
}

}  // namespace macula::viewer
