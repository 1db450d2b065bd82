#include "viewer/presets/preset_list_model.h"

#include <cstddef>
#include <optional>
#include <utility>

#include "scene/choice/preset_kinds.h"
#include "study/list/search_text.h"
#include "viewer/status/status_texts.h"

namespace macula::viewer {

namespace {

constexpr std::size_t kMostLastUsedShown = 6;

}  // namespace

PresetRows::PresetRows(const StudyEditor& session, const PresetLibrary& library)
    : session_(session), library_(library) {}

void PresetRows::setFilter(const QString& text) {
    words_ = study::searchWords(text.toStdString());
}

bool PresetRows::toggle(PresetGroup group) {
    if (!words_.empty()) return false;
    if (folded_.erase(group) == 0) folded_.insert(group);
    return true;
}

std::set<PresetGroup> PresetRows::expanded() const {
    std::set<PresetGroup> expanded(kPresetGroups.begin(), kPresetGroups.end());
    if (words_.empty())
        for (const PresetGroup group : folded_) expanded.erase(group);
    return expanded;
}

std::set<live::PresetRef> PresetRows::favourites() const {
    std::set<live::PresetRef> favourites;
    for (const LibraryPreset& preset : presetsOf(PresetGroup::favourites)) favourites.insert(preset.ref);
    return favourites;
}

bool PresetRows::isFound(const LibraryPreset& preset) const {
    const TransferFunction& function = *preset.function;
    const std::string shown = shownTitle(preset).toStdString();  // in the language of the window
    return study::holdsAll(study::foldedForSearch(function.title + ' ' + shown + ' ' + function.name + ' ' +
                                                  scene::kindOf(function)),
                           words_);
}

std::vector<LibraryPreset> PresetRows::presetsOf(PresetGroup group) const {
    std::vector<LibraryPreset> presets;
    if (group == PresetGroup::own) return library_.own();
    if (group == PresetGroup::lastUsed) {
        const auto& volume = session_.study().volume;
        for (const live::PresetRef& ref : library_.shelf().lastUsed(volume ? volume->modality() : "")) {
            if (presets.size() == kMostLastUsedShown) break;
            if (auto preset = library_.find(ref)) presets.push_back(*std::move(preset));
        }
        return presets;
    }
    if (group == PresetGroup::favourites) {
        for (const auto& all : {library_.own(), library_.builtIn()})
            for (const LibraryPreset& preset : all)
                if (library_.shelf().isFavourite(preset.ref)) presets.push_back(preset);
        return presets;
    }
    for (const LibraryPreset& preset : library_.builtIn()) {
        if (library_.fits(*preset.function) == (group == PresetGroup::fitting)) presets.push_back(preset);
    }
    return presets;
}

std::vector<PresetRow> PresetRows::rows() const {
    const std::set<PresetGroup> shown = expanded();
    std::vector<PresetRow> rows;
    for (const PresetGroup group : kPresetGroups) {
        std::vector<LibraryPreset> presets = presetsOf(group);
        std::erase_if(presets, [this](const LibraryPreset& preset) { return !isFound(preset); });
        if (presets.empty()) continue;
        rows.push_back({.group = group, .preset = std::nullopt, .count = presets.size()});
        if (!shown.contains(group)) continue;
        for (LibraryPreset& preset : presets) rows.push_back({.group = group, .preset = std::move(preset)});
    }
    return rows;
}

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
