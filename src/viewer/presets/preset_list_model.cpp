#include "viewer/presets/preset_list_model.h"

#include <utility>

#include "scene/choice/preset_kinds.h"
#include "viewer/status/status_texts.h"

namespace macula::viewer {

PresetListModel::PresetListModel(QObject* parent) : QAbstractListModel(parent) {}

void PresetListModel::setRows(std::vector<PresetRow> rows, std::set<PresetGroup> expanded,
                              std::set<live::PresetRef> favourites) {
    beginResetModel();
    rows_ = std::move(rows);
    expanded_ = std::move(expanded);
    favourites_ = std::move(favourites);
    endResetModel();
}

void PresetListModel::setShown(const live::PresetRef& ref) {
    if (std::exchange(shown_, ref) == ref || rows_.empty()) return;
    Q_EMIT dataChanged(index(0), index(int(rows_.size()) - 1), {isShownRole, Qt::AccessibleTextRole});
}

void PresetListModel::forgetPictures() {
    pictures_.clear();
    if (!rows_.empty()) Q_EMIT dataChanged(index(0), index(int(rows_.size()) - 1), {Qt::DecorationRole});
}

void PresetListModel::setPicture(std::shared_ptr<const TransferFunction> function, QImage picture) {
    const TransferFunction* key = function.get();
    pictures_[key] = {std::move(function), std::move(picture)};
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        if (rows_[row].preset && rows_[row].preset->function.get() == key)
            Q_EMIT dataChanged(index(int(row)), index(int(row)), {Qt::DecorationRole});
    }
}

int PresetListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(rows_.size());
}

Qt::ItemFlags PresetListModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::NoItemFlags;
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
}

QString PresetListModel::titleOf(const PresetRow& row) const {
    if (row.preset) return titleOr(row.preset->function->title, row.preset->function->name);
    switch (row.group) {
        case PresetGroup::favourites:
            return tr("Favourites");
        case PresetGroup::lastUsed:
            return tr("Last used for such images");
        case PresetGroup::own:
            return tr("Your own");
        case PresetGroup::fitting:
            return tr("For such images");
        case PresetGroup::others:
            return tr("For other images");
    }
    return {};
}

QString PresetListModel::aboutOf(const LibraryPreset& preset) const {
    const QString kind = QString::fromStdString(scene::kindOf(*preset.function));
    if (!preset.own || !preset.own->seen) return kind;
    return kind.isEmpty() ? tr("all that was seen") : tr("%1, all that was seen").arg(kind);
}

QVariant PresetListModel::headingData(const PresetRow& row, int role) const {
    switch (role) {
        case Qt::DisplayRole:
            return tr("%1 (%2)").arg(titleOf(row)).arg(row.count);
        case Qt::ToolTipRole:
            return isExpanded(row.group) ? tr("Enter or a click folds this group")
                                         : tr("Enter or a click shows this group");
        case Qt::AccessibleTextRole:
            return isExpanded(row.group) ? tr("%1, %n presets, shown", nullptr, row.count).arg(titleOf(row))
                                         : tr("%1, %n presets, folded", nullptr, row.count).arg(titleOf(row));
        case isHeadingRole:
            return true;
        case isExpandedRole:
            return isExpanded(row.group);
        default:
            return {};
    }
}

QVariant PresetListModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || std::size_t(index.row()) >= rows_.size()) return {};
    const PresetRow& row = rows_[std::size_t(index.row())];
    if (!row.preset) return headingData(row, role);
    const LibraryPreset& preset = *row.preset;
    const bool isFavourite = favourites_.contains(preset.ref);
    const QString about = aboutOf(preset);
    switch (role) {
        case Qt::DisplayRole:
            return titleOf(row);
        case Qt::DecorationRole: {
            const auto picture = pictures_.find(preset.function.get());
            return picture == pictures_.end() ? QVariant() : QVariant(picture->second.image);
        }
        case Qt::ToolTipRole:
        case Qt::AccessibleTextRole: {
            QStringList parts{titleOf(row)};
            if (!about.isEmpty()) parts << about;
            parts << (preset.own ? tr("your own") : tr("built in, is never changed"));
            if (isFavourite) parts << tr("favourite");
            if (preset.ref == shown_) parts << tr("shown now");
            return parts.join(QStringLiteral(", "));
        }
        case isHeadingRole:
            return false;
        case isFavouriteRole:
            return isFavourite;
        case isShownRole:
            return preset.ref == shown_;
        case aboutRole:
            return about;
        default:
            return {};
    }
}

}  // namespace macula::viewer
