#include "viewer/browser/study_browser.h"

#include <QAction>
#include <QEvent>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QVBoxLayout>
#include <utility>

#include "study/list/search_text.h"
#include "viewer/browser/study_row_delegate.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr int kIndentPx = 14;  // for each level; small, to leave room for pictures

QImage asImage(const study::Thumbnail& thumbnail) {
    const QImage borrowed(thumbnail.grey.data(), thumbnail.widthPx, thumbnail.heightPx, thumbnail.widthPx,
                          QImage::Format_Grayscale8);
    return borrowed.copy();
}

// Also expands a series that has only presentation states or documents: nothing else can be opened there.
bool startsExpanded(const study::StudyTree& tree, const study::StudyRow& row) {
    if (row.kind == study::StudyRow::Kind::patient || row.kind == study::StudyRow::Kind::study) return true;
    return row.kind == study::StudyRow::Kind::series && row.picture == nullptr && !row.children.empty() &&
           (tree.rows[row.children.front()].kind == study::StudyRow::Kind::presentation ||
            tree.rows[row.children.front()].kind == study::StudyRow::Kind::document);
}

}  // namespace

StudyBrowser::StudyBrowser(QWidget* parent)
    : QWidget(parent),
      search_(new QLineEdit),
      tree_(new QTreeView),
      nothing_(new QLabel),
      reading_(new QLabel(tr("The folder is still being read. What is in it can be opened then."))),
      elsewhere_(new QLabel(tr("Nothing of this folder is open."))),
      model_(new StudyTreeModel(this)),
      pictures_(this, {.ended = [this](const Result<study::Thumbnail>& made) { takePicture(made); }}) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(search_);
    column->addWidget(nothing_);
    column->addWidget(reading_);
    column->addWidget(elsewhere_);
    column->addWidget(tree_, 1);
    column->addStretch();
    makeSearch();
    makeTree();
    reading_->setObjectName(QStringLiteral("reading"));
    reading_->setWordWrap(true);
    elsewhere_->setObjectName(QStringLiteral("elsewhere"));
    elsewhere_->setWordWrap(true);
    makePlain(*nothing_, "nothing");
    nothing_->setAlignment(Qt::AlignCenter);
    picturesAreDue_.setSingleShot(true);
    connect(&picturesAreDue_, &QTimer::timeout, this, &StudyBrowser::makeNextPicture);
    tellWhatIsMissing();
}

void StudyBrowser::makeSearch() {
    search_->setObjectName(QStringLiteral("search"));
    search_->setAccessibleName(tr("Search the studies of the folder"));
    search_->setPlaceholderText(tr("Search"));
    search_->setToolTip(
        tr("Name, ID, date, modality or description; all words have to be there. Down or Enter goes to "
           "the list, Esc ends the search."));
    search_->setClearButtonEnabled(true);
    search_->installEventFilter(this);
    connect(search_, &QLineEdit::textChanged, this, &StudyBrowser::search);
}

void StudyBrowser::makeTree() {
    describe(
        *tree_, "studies", tr("Studies, series and volumes of the folder"),
        tr("What is in the folder; sizes of voxels are in mm. One click selects; a double click or Enter "
           "opens, be it a volume or a view of one that was kept. The files are only read, and stay where "
           "they are."));
    tree_->setModel(model_);
    tree_->setItemDelegate(new StudyRowDelegate(tree_));
    tree_->setHeaderHidden(true);
    tree_->setIndentation(kIndentPx);
    tree_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    tree_->setExpandsOnDoubleClick(false);  // a double click opens; see openRow
    tree_->setDragEnabled(true);
    tree_->setDragDropMode(QAbstractItemView::DragOnly);
    tree_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    tree_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    tree_->installEventFilter(this);
    tree_->viewport()->installEventFilter(this);
    connect(tree_, &QTreeView::doubleClicked, this, &StudyBrowser::openRow);
    connect(tree_, &QTreeView::expanded, this, [this](const QModelIndex& i) { rememberExpanded(i, true); });
    connect(tree_, &QTreeView::collapsed, this, [this](const QModelIndex& i) { rememberExpanded(i, false); });
    setFocusProxy(tree_);
    auto* beside = new QAction(tr("Open &Beside"), tree_);
    beside->setObjectName(QStringLiteral("open-beside-row"));
    beside->setToolTip(tr("Show this volume beside the study that is open"));
    connect(beside, &QAction::triggered, this, [this] {
        if (const auto other = selectedOther()) Q_EMIT secondAsked(*other);
    });
    tree_->addAction(beside);
    tree_->setContextMenuPolicy(Qt::ActionsContextMenu);
}

std::optional<std::size_t> StudyBrowser::selectedOther() const {
    const std::size_t row = currentRow();
    if (row >= model_->tree().rows.size() || !tree_->selectionModel()->isSelected(tree_->currentIndex()))
        return std::nullopt;
    const std::optional<std::size_t> volume = model_->tree().rows[row].volume;
    return volume && volume != model_->open() ? volume : std::nullopt;
}

void StudyBrowser::setFound(std::shared_ptr<const study::FoundVolumes> found,
                            std::optional<std::size_t> open) {
    if (found == found_) return setShown(open);
    pictures_.cancel();
    making_ = nullptr;
    const bool goesOn = found_ && found && !found_->isWhole();
    const int scrolledTo = tree_->verticalScrollBar()->value();
    found_ = std::move(found);
    keys_.reset();
    if (!goesOn) endSearch();
    model_->setFound(found_);
    model_->setTree(makeRows());
    model_->setRowsShown(study::rowsThatMatch(model_->tree(), search_->text().toStdString()));
    expanded_.clear();
    for (const study::StudyRow& row : model_->tree().rows)
        expanded_.push_back(startsExpanded(model_->tree(), row));
    model_->setOpen(open);
    layOut(study::kNoRow);
    revealOpen();
    // The open volume is in another folder: a selected row would be mistaken for it.
    if (!open) tree_->selectionModel()->clearSelection();
    tellWhatIsMissing();
    // The rows on screen stay in place while more are found below.
    if (goesOn && !open) tree_->verticalScrollBar()->setValue(scrolledTo);
    Q_EMIT listed();
}

void StudyBrowser::setShown(std::optional<std::size_t> open) {
    if (open == model_->open()) return;
    model_->setOpen(open);
    revealOpen();
    tellWhatIsMissing();
}

void StudyBrowser::showNames(bool shown) {
    if (shown == namesShown_) return;
    namesShown_ = shown;
    if (!shown) endSearch();  // what was typed may be a name
    showRows();
}

void StudyBrowser::setKeyImages(std::shared_ptr<const study::KeyImages> keys) {
    keys_ = std::move(keys);
    showRows();
}

void StudyBrowser::showRows() {
    const std::size_t current = currentRow();
    const bool isSelected = tree_->selectionModel()->hasSelection();
    const int scrolledTo = tree_->verticalScrollBar()->value();
    model_->setTexts(makeRows());
    model_->setRowsShown(study::rowsThatMatch(model_->tree(), search_->text().toStdString()));
    layOut(current);
    if (!isSelected) tree_->selectionModel()->clearSelection();
    tree_->verticalScrollBar()->setValue(scrolledTo);
    tellWhatIsMissing();
}

void StudyBrowser::setStored(std::set<std::size_t> volumes) {
    model_->setStored(std::move(volumes));
}

void StudyBrowser::focusSearch() {
    search_->setFocus(Qt::ShortcutFocusReason);
    search_->selectAll();
}

// Does not update the rows.
void StudyBrowser::endSearch() {
    const QSignalBlocker blocker(search_);
    search_->clear();
    words_.clear();
}

study::StudyTree StudyBrowser::makeRows() const {
    if (!found_) return {};
    return study::studyTree(*found_, namesShown_ ? study::Names::shown : study::Names::hidden, keys_.get());
}

void StudyBrowser::search() {
    const std::string typed = search_->text().toStdString();
    const std::size_t current = currentRow();
    words_ = study::searchWords(typed);
    model_->setRowsShown(study::rowsThatMatch(model_->tree(), typed));
    layOut(current);
    tellWhatIsMissing();
}

// Restores selection and expanded rows after the model was reset.
void StudyBrowser::layOut(std::size_t current) {
    const QScopedValueRollback laysOut(isLayingOut_, true);
    for (std::size_t row = 0; row < model_->tree().rows.size(); ++row) {
        if (model_->isShown(row)) tree_->setExpanded(model_->indexOf(row), isExpanded(row));
    }
    const QModelIndex index = model_->indexOf(rowToSelect(current));
    tree_->setCurrentIndex(index);
    if (index.isValid()) tree_->scrollTo(index);
}

bool StudyBrowser::isExpanded(std::size_t row) const {
    if (words_.empty()) return expanded_[row];
    const study::StudyRow& shown = model_->tree().rows[row];
    // A row that matches by itself need not show its children to explain the match.
    return startsExpanded(model_->tree(), shown) || !study::holdsAll(shown.searched, words_);
}

void StudyBrowser::rememberExpanded(const QModelIndex& index, bool isExpanded) {
    if (!isLayingOut_ && words_.empty()) expanded_[StudyTreeModel::rowOf(index)] = isExpanded;
}

// Selects the open volume, and expands the rows that contain it.
void StudyBrowser::revealOpen() {
    const std::vector<study::StudyRow>& rows = model_->tree().rows;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        if (!rows[row].volume || rows[row].volume != model_->open() || !model_->isShown(row)) continue;
        for (std::size_t above = rows[row].parent; above != study::kNoRow; above = rows[above].parent)
            tree_->expand(model_->indexOf(above));
        tree_->setCurrentIndex(model_->indexOf(row));
        tree_->scrollTo(model_->indexOf(row));
        return;
    }
}

std::size_t StudyBrowser::currentRow() const {
    const QModelIndex index = tree_->currentIndex();
    return index.isValid() ? StudyTreeModel::rowOf(index) : study::kNoRow;
}

// A visible row: `wanted`, else the open volume, else the first row that can be opened and is not folded
// away, else the first row.
std::size_t StudyBrowser::rowToSelect(std::size_t wanted) const {
    const std::vector<study::StudyRow>& rows = model_->tree().rows;
    if (wanted < rows.size() && model_->isShown(wanted)) return wanted;
    std::size_t openable = study::kNoRow;
    std::size_t first = study::kNoRow;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        if (!model_->isShown(row)) continue;
        if (first == study::kNoRow) first = row;
        if (!rows[row].volume && rows[row].images == nullptr) continue;
        if (rows[row].volume && rows[row].volume == model_->open()) return row;
        if (openable == study::kNoRow && isExpanded(rows[row].parent)) openable = row;
    }
    return openable != study::kNoRow ? openable : first;
}

void StudyBrowser::openRow(const QModelIndex& index) {
    if (!index.isValid()) return;
    const study::StudyRow& row = model_->tree().rows[StudyTreeModel::rowOf(index)];
    // Copied, because a listener may set another folder here.
    if (const auto presentation = row.presentation) {
        if (presentation->images != nullptr) return Q_EMIT imagesPresented(*presentation);
        return Q_EMIT presentationChosen(*presentation);
    }
    if (row.kind == study::StudyRow::Kind::presentation) return Q_EMIT presentationRefused(Text(row.whyNot));
    if (const auto document = row.document) return Q_EMIT documentChosen(*document);
    if (row.images != nullptr) return Q_EMIT imagesChosen(row.images);
    if (!row.volume) return tree_->setExpanded(index, !tree_->isExpanded(index));
    if (row.volume == model_->open()) return Q_EMIT openChosen();
    Q_EMIT chosen(*row.volume);
}

void StudyBrowser::tellWhatIsMissing() {
    const bool isEmpty = model_->rowCount() == 0;
    if (!found_) {
        nothing_->setText(tr("No folder of images is open."));
    } else if (model_->tree().rows.empty()) {
        nothing_->setText(tr("There are no studies in this folder."));
    } else {
        nothing_->setText(tr("Nothing matches “%1”.").arg(search_->text().simplified()));
    }
    nothing_->setVisible(isEmpty);
    reading_->setVisible(found_ && !found_->isWhole());
    elsewhere_->setVisible(found_ && found_->isWhole() && !isEmpty && !model_->open());
    tree_->setVisible(!isEmpty);
    search_->setEnabled(!model_->tree().rows.empty());
}

bool StudyBrowser::onSearchKey(int key) {
    const bool goesOn = key == Qt::Key_Down || key == Qt::Key_Return || key == Qt::Key_Enter;
    if (goesOn && model_->rowCount() > 0) return tree_->setFocus(Qt::TabFocusReason), true;
    if (key != Qt::Key_Escape || search_->text().isEmpty()) return false;
    return search_->clear(), true;
}

bool StudyBrowser::eventFilter(QObject* watched, QEvent* event) {
    if (watched == tree_->viewport()) {
        // Rows that come into view are painted, whatever moved them there.
        if (event->type() == QEvent::Paint) picturesAreDue_.start(0);
    } else if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (watched == search_ && onSearchKey(key)) return true;
        if (watched == tree_ && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
            openRow(tree_->currentIndex());
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void StudyBrowser::makeNextPicture() {
    if (!found_ || making_ != nullptr || !tree_->isVisible()) return;
    const QRect seen = tree_->viewport()->rect();
    for (QModelIndex index = tree_->indexAt(QPoint(seen.center().x(), 0)); index.isValid();
         index = tree_->indexBelow(index)) {
        if (tree_->visualRect(index).top() > seen.bottom()) return;
        const dicom::Stack* stack = model_->tree().rows[StudyTreeModel::rowOf(index)].picture;
        if (stack == nullptr || model_->isAsked(stack)) continue;
        making_ = stack;
        pictures_.start([found = found_, stack](const Progress& progress) {
            return study::thumbnailOf(*stack, progress.token());
        });
        return;
    }
}

void StudyBrowser::takePicture(const Result<study::Thumbnail>& made) {
    const dicom::Stack* stack = std::exchange(making_, nullptr);
    // Not an error to report: a series without a picture can be told apart by its texts.
    model_->setPicture(stack, made.ok() ? asImage(*made) : QImage());
    makeNextPicture();
}

}  // namespace macula::viewer
