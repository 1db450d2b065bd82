#include "viewer/presets/preset_gallery.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/presets/preset_delegate.h"

namespace macula::viewer {

namespace {

bool isSame(const PresetRow& a, const PresetRow& b) {
    return a.group == b.group && a.preset.has_value() == b.preset.has_value() &&
           (!a.preset || a.preset->ref == b.preset->ref);
}

}  // namespace

PresetGallery::PresetGallery(StudyEditor& session, PresetLibrary& library, StateNow stateNow, QWidget* parent)
    : QWidget(parent),
      session_(session),
      library_(library),
      rows_(session, library),
      naming_(*this, session, library, std::move(stateNow)),
      filter_(new QLineEdit),
      list_(new QListView),
      model_(new PresetListModel(this)),
      nothing_(new QLabel),
      note_(new QLabel),
      undo_(new QPushButton(tr("Undo"))) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    makeBar(*column);
    makeList();
    makePlain(*nothing_, "preset-nothing");
    nothing_->setAlignment(Qt::AlignCenter);
    makePlain(*note_, "preset-note");
    describe(*undo_, "preset-undo", tr("Put the deleted preset back"),
             tr("The preset that was deleted last comes back as it was"));
    auto* below = new QHBoxLayout;
    below->setContentsMargins(4, 0, 4, 4);
    below->addWidget(note_, 1);
    below->addWidget(undo_);
    column->addWidget(nothing_);
    column->addWidget(list_, 1);
    column->addLayout(below);
    setFocusProxy(list_);
    picturesAreDue_.setSingleShot(true);
    connect(&picturesAreDue_, &QTimer::timeout, this, &PresetGallery::drawNext);
    listen();
    onStudyShown();
}

void PresetGallery::listen() {
    connect(undo_, &QPushButton::clicked, this, [this] {
        removed_.clear();
        library_.putBackRemoved();
    });
    connect(&library_, &PresetLibrary::changed, this, &PresetGallery::showRows);
    connect(&session_, &StudyEditor::studyShown, this, &PresetGallery::onStudyShown);
    connect(&session_, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        if (session_.state().preset != before.preset) showShown();
    });
    connect(&naming_, &PresetNaming::named, this, [this] { trouble_.clear(); });
    connect(&naming_, &PresetNaming::done, this, &PresetGallery::showNotes);
    connect(&naming_, &PresetNaming::failed, this, &PresetGallery::tell);
    connect(&pictures_, &PresetPictures::drawn, this,
            [this](std::shared_ptr<const TransferFunction> function, const QImage& picture) {
                model_->setPicture(std::move(function), picture);
                drawNext();
            });
    connect(&pictures_, &PresetPictures::failed, this, [this](const Error& error) {
        error.code == ErrorCode::inputNotUsable ? showNotes() : tell(error);
    });
}

void PresetGallery::makeBar(QVBoxLayout& column) {
    filter_->setObjectName(QStringLiteral("preset-filter"));
    filter_->setAccessibleName(tr("Filter the presets"));
    filter_->setPlaceholderText(tr("Filter"));
    filter_->setToolTip(
        tr("Part of a name or a kind of image; Down or Enter goes to the presets, Esc ends it"));
    filter_->setClearButtonEnabled(true);
    filter_->installEventFilter(this);
    connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
        rows_.setFilter(text);
        showRows();
    });
    auto* keep = new QToolButton;
    keep->setObjectName(QStringLiteral("preset-keep"));
    keep->setText(tr("Keep"));
    keep->setAccessibleName(tr("Keep or import a preset of your own"));
    keep->setToolTip(tr("Keep the curve, or all that is seen, as a preset of your own; or import one"));
    keep->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(keep);
    menu->setToolTipsVisible(true);
    QAction* curve = menu->addAction(tr("Keep the &Curve…"), this, &PresetGallery::askToSaveCurve);
    describe(*curve, "keep-curve", tr("The transfer function that is shown"));
    QAction* seen = menu->addAction(tr("Keep All That Is &Seen…"), this, &PresetGallery::askToSaveSeen);
    describe(*seen, "keep-seen", tr("Curve, look, lights, window, clip and camera, for other studies too"));
    menu->addSeparator();
    menu->addAction(tr("&Import…"), this, &PresetGallery::importAsked)
        ->setToolTip(tr("Of Macula, 3D Slicer, ParaView, VolView, MITK, Horos or OsiriX"));
    keep->setMenu(menu);
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(4, 4, 4, 0);
    bar->addWidget(filter_, 1);
    bar->addWidget(keep);
    column.addLayout(bar);
}

void PresetGallery::makeList() {
    describe(*list_, "presets", tr("Presets"),
             tr("Each preset as it shows this volume, from anterior and coarse. A double click or "
                "Enter uses it."));
    list_->setModel(model_);
    list_->setItemDelegate(new PresetDelegate(list_));
    list_->setFlow(QListView::LeftToRight);
    list_->setWrapping(true);
    list_->setResizeMode(QListView::Adjust);
    list_->setMovement(QListView::Static);
    list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_->verticalScrollBar()->setSingleStep(24);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    // Headings are as wide as the list, so a scroll bar that comes and goes would move them.
    list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    list_->setMinimumWidth(2 * pictures::kPresetThumbnailPx + 60);
    list_->installEventFilter(this);
    list_->viewport()->installEventFilter(this);
    connect(list_, &QListView::doubleClicked, this, [this](const QModelIndex& index) {
        if (!index.data(PresetListModel::isHeadingRole).toBool()) activate(index);
    });
    connect(list_, &QListView::clicked, this, [this](const QModelIndex& index) {
        if (index.data(PresetListModel::isHeadingRole).toBool()) activate(index);
    });
    connect(list_, &QWidget::customContextMenuRequested, this, &PresetGallery::showMenu);
}

void PresetGallery::onStudyShown() {
    pictures_.begin(session_.study().volume);
    model_->forgetPictures();
    showRows();
}

// Rows. ----------------------------------------------------------------------------------------------

void PresetGallery::showRows() {
    const std::optional<PresetRow> before = currentRow();
    const int scrolled = list_->verticalScrollBar()->value();
    model_->setRows(rows_.rows(), rows_.expanded(), rows_.favourites());
    selectAgain(before);
    list_->verticalScrollBar()->setValue(scrolled);
    const bool isEmpty = model_->rowCount() == 0;
    nothing_->setText(tr("No preset matches “%1”.").arg(filter_->text().simplified()));
    nothing_->setVisible(isEmpty);
    list_->setVisible(!isEmpty);
    showShown();
    showNotes();
}

void PresetGallery::showShown() {
    const auto& preset = session_.state().preset;
    model_->setShown(preset ? library_.refOf(*preset) : live::PresetRef());
}

std::optional<PresetRow> PresetGallery::currentRow() const {
    const QModelIndex index = list_->currentIndex();
    if (!index.isValid()) return std::nullopt;
    return model_->rows().at(std::size_t(index.row()));
}

// Selects the same row again; if it is gone, its heading.
void PresetGallery::selectAgain(const std::optional<PresetRow>& before) {
    if (!before) return;
    const std::vector<PresetRow>& rows = model_->rows();
    auto found = std::ranges::find_if(rows, [&](const PresetRow& row) { return isSame(row, *before); });
    if (found == rows.end())
        found = std::ranges::find_if(
            rows, [&](const PresetRow& row) { return row.group == before->group && !row.preset; });
    if (found != rows.end()) list_->setCurrentIndex(model_->index(int(found - rows.begin())));
}

void PresetGallery::showNotes() {
    QStringList notes;
    if (!trouble_.isEmpty()) notes << trouble_;
    const bool canPutBack = !removed_.isEmpty() && removed_ == library_.removedTitle();
    if (canPutBack) notes << tr("“%1” is deleted.").arg(removed_);
    if (pictures_.hasNone()) notes << tr("There is nothing in this volume to draw small pictures of.");
    if (const QString note = library_.note(); !note.isEmpty()) notes << note;
    note_->setText(notes.join(QLatin1Char(' ')));
    note_->setVisible(!notes.isEmpty());
    undo_->setVisible(canPutBack);
}

void PresetGallery::tell(const Error& error) {
    if (!isVisible()) return Q_EMIT failed(error);
    trouble_ = inWindowsLanguage(error);
    showNotes();
}

// Choosing. ------------------------------------------------------------------------------------------

void PresetGallery::toggle(PresetGroup group) {
    if (rows_.toggle(group)) showRows();
}

void PresetGallery::activate(const QModelIndex& index) {
    if (!index.isValid()) return;
    const PresetRow row = model_->rows().at(std::size_t(index.row()));
    if (!row.preset) return toggle(row.group);
    trouble_.clear();
    showNotes();
    Q_EMIT useAsked(*row.preset);
}

bool PresetGallery::onListKey(int key) {
    if (key == Qt::Key_Return || key == Qt::Key_Enter) return activate(list_->currentIndex()), true;
    if (key != Qt::Key_Delete) return false;
    if (const auto row = currentRow(); row && row->preset && row->preset->own) remove(*row->preset);
    return true;
}

bool PresetGallery::eventFilter(QObject* watched, QEvent* event) {
    if (watched == list_->viewport()) {
        // Rows that come into view are painted, whatever moved them there.
        if (event->type() == QEvent::Paint) picturesAreDue_.start(0);
    } else if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (watched == list_ && onListKey(key)) return true;
        const bool goesOn = key == Qt::Key_Down || key == Qt::Key_Return || key == Qt::Key_Enter;
        if (watched == filter_ && goesOn && model_->rowCount() > 1) {
            list_->setFocus(Qt::TabFocusReason);
            list_->setCurrentIndex(model_->index(1));  // 0 is a heading
            return true;
        }
        if (watched == filter_ && key == Qt::Key_Escape && !filter_->text().isEmpty())
            return filter_->clear(), true;
    }
    return QWidget::eventFilter(watched, event);
}

// Keeping. -------------------------------------------------------------------------------------------

void PresetGallery::showMenu(const QPoint& at) {
    const QModelIndex index = list_->indexAt(at);
    if (!index.isValid()) return;
    const PresetRow& row = model_->rows().at(std::size_t(index.row()));
    if (!row.preset) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setObjectName(QStringLiteral("preset-menu"));
    menu->setToolTipsVisible(true);
    fillMenu(*menu, *row.preset);
    menu->popup(list_->viewport()->mapToGlobal(at));
}

void PresetGallery::fillMenu(QMenu& menu, const LibraryPreset& preset) {
    const auto add = [&](const QString& text, const char* name, const auto& then) {
        QAction* action = menu.addAction(text, this, then);
        action->setObjectName(QLatin1String(name));
        return action;
    };
    const bool isOwn = preset.own != nullptr;
    add(tr("&Use"), "preset-use", [this, preset] { Q_EMIT useAsked(preset); });
    add(tr("&Compare with What Is Shown…"), "preset-compare", [this, preset] {
        Q_EMIT compareAsked(preset);
    })->setEnabled(session_.hasStudy());
    const bool isFavourite = library_.shelf().isFavourite(preset.ref);
    QAction* favourite = add(tr("&Favourite"), "preset-favourite", [this, preset, isFavourite] {
        library_.setFavourite(preset.ref, !isFavourite);
    });
    favourite->setCheckable(true);
    favourite->setChecked(isFavourite);
    menu.addSeparator();
    add(tr("Save as C&opy…"), "preset-copy", [this, preset] { naming_.askToCopy(preset); });
    QAction* rename = add(tr("&Rename…"), "preset-rename", [this, preset] { naming_.askToRename(preset); });
    QAction* removal = add(tr("&Delete"), "preset-delete", [this, preset] { remove(preset); });
    for (QAction* action : {rename, removal}) {
        action->setEnabled(isOwn);
        if (!isOwn) action->setToolTip(tr("Built-in presets are never changed: save a copy"));
    }
    menu.addSeparator();
    add(tr("&Export…"), "preset-export", [this, preset] {
        Q_EMIT exportAsked(preset);
    })->setToolTip(tr("The curve, as a file for --preset and 3D Slicer"));
    add(tr("&Import…"), "preset-import", [this] { Q_EMIT importAsked(); });
}

void PresetGallery::remove(const LibraryPreset& preset) {
    trouble_.clear();
    removed_ = shownTitle(preset);
    if (!library_.remove(preset.ref)) removed_.clear();
}

// Pictures. ------------------------------------------------------------------------------------------

void PresetGallery::drawNext() {
    if (!pictures_.canDraw() || !list_->isVisible()) return;
    const QRect seen = list_->viewport()->rect();
    for (std::size_t row = 0; row < model_->rows().size(); ++row) {
        const std::optional<LibraryPreset>& preset = model_->rows()[row].preset;
        if (!preset || model_->hasPicture(*preset->function)) continue;
        if (list_->visualRect(model_->index(int(row))).intersects(seen)) return pictures_.draw(*preset);
    }
}

}  // namespace macula::viewer
