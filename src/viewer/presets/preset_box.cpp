#include "viewer/presets/preset_box.h"

#include <QListView>
#include <QSignalBlocker>
#include <QStandardItemModel>

#include "scene/transfer/same_transfer.h"
#include "viewer/status/status_texts.h"

namespace macula::viewer {

PresetBox::PresetBox(const PresetLibrary& library, QWidget* parent) : QComboBox(parent), library_(library) {
    setAccessibleName(tr("Preset"));
    setView(new QListView(this));
    connect(this, &QComboBox::activated, this, [this](int row) {
        if (row < 0 || std::size_t(row) >= rows_.size()) return;
        if (const std::optional<LibraryPreset> preset = rows_[std::size_t(row)]) Q_EMIT chosen(*preset);
    });
    fillAnew();
}

void PresetBox::add(const LibraryPreset& preset, bool isOffered) {
    rows_.emplace_back(preset);
    const TransferFunction& function = *preset.function;
    addItem(titleOr(function.title, function.name));
    const int row = count() - 1;
    setItemData(row, QString::fromStdString(function.name), Qt::ToolTipRole);
    if (isOffered) return;
    // Disabled as well as hidden, so that keys skip it, too.
    if (auto* items = qobject_cast<QStandardItemModel*>(model())) items->item(row)->setEnabled(false);
    if (auto* list = qobject_cast<QListView*>(view())) list->setRowHidden(row, true);
}

void PresetBox::addLine() {
    if (rows_.empty() || !rows_.back()) return;
    rows_.emplace_back(std::nullopt);
    insertSeparator(count());
}

void PresetBox::fillAnew() {
    const QSignalBlocker blocker(this);
    clear();
    rows_.clear();
    for (const LibraryPreset& preset : library_.own()) add(preset, true);
    addLine();
    std::vector<LibraryPreset> others;
    for (const LibraryPreset& preset : library_.builtIn()) {
        if (library_.fits(*preset.function)) {
            add(preset, true);
        } else {
            others.push_back(preset);
        }
    }
    for (const LibraryPreset& preset : others) add(preset, false);
    setCurrentIndex(-1);
}

void PresetBox::choose(const TransferFunction* function) {
    int found = -1;
    for (std::size_t row = 0; row < rows_.size() && found < 0; ++row) {
        if (function != nullptr && rows_[row] && scene::isSame(*rows_[row]->function, *function))
            found = int(row);
    }
    setCurrentIndex(found);
    if (function != nullptr) setPlaceholderText(titleOr(function->title, function->name));
}

}  // namespace macula::viewer
