// The presets of the gallery, in groups below headings, as one list.
#pragma once

#include <QAbstractListModel>
#include <QImage>
#include <QString>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "viewer/editor/study_editor.h"
#include "viewer/presets/preset_library.h"

namespace macula::viewer {

enum class PresetGroup { favourites, lastUsed, own, fitting, others };
inline constexpr std::array kPresetGroups{PresetGroup::favourites, PresetGroup::lastUsed, PresetGroup::own,
                                          PresetGroup::fitting, PresetGroup::others};

// A heading, or a preset. A preset is in each group that it belongs to.
struct PresetRow {
    PresetGroup group = PresetGroup::others;
    std::optional<LibraryPreset> preset;  // nothing: the heading of the group
    std::size_t count = 0;                // for a heading: how many presets the group has
};

// The rows of the gallery, without folded groups and presets that the filter rejects. Needs no window. Looks
// for the words of the filter in title, name and kind of image.
class PresetRows {
  public:
    PresetRows(const StudyEditor& session, const PresetLibrary& library);  // both outlive this

    void setFilter(const QString& text);
    // Folds or expands a group. Does nothing and returns false during a filter, which expands all groups.
    bool toggle(PresetGroup group);

    std::set<PresetGroup> expanded() const;
    std::vector<PresetRow> rows() const;  // without empty groups
    std::set<live::PresetRef> favourites() const;

  private:
    std::vector<LibraryPreset> presetsOf(PresetGroup group) const;
    bool isFound(const LibraryPreset& preset) const;

    const StudyEditor& session_;
    const PresetLibrary& library_;
    std::vector<std::string> words_;  // the words of the filter
    std::set<PresetGroup> folded_{PresetGroup::others};
};

class PresetListModel : public QAbstractListModel {
    Q_OBJECT

  public:
    static constexpr int isHeadingRole = Qt::UserRole;
    static constexpr int isExpandedRole = Qt::UserRole + 1;
    static constexpr int isFavouriteRole = Qt::UserRole + 2;
    static constexpr int isShownRole = Qt::UserRole + 3;  // the preset in use
    static constexpr int aboutRole = Qt::UserRole + 4;    // a line below the title

    explicit PresetListModel(QObject* parent = nullptr);

    // Replaces all rows. A folded group has only its heading; an empty group has none.
    void setRows(std::vector<PresetRow> rows, std::set<PresetGroup> expanded,
                 std::set<live::PresetRef> favourites);
    void setShown(const live::PresetRef& ref);
    const std::vector<PresetRow>& rows() const { return rows_; }
    bool isExpanded(PresetGroup group) const { return expanded_.contains(group); }

    // Pictures belong to a function, and stay when rows change.
    void forgetPictures();
    bool hasPicture(const TransferFunction& function) const { return pictures_.contains(&function); }
    void setPicture(std::shared_ptr<const TransferFunction> function, QImage picture);  // null: failed

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

  private:
    QString titleOf(const PresetRow& row) const;
    QString aboutOf(const LibraryPreset& preset) const;
    QVariant headingData(const PresetRow& row, int role) const;

    std::vector<PresetRow> rows_;
    std::set<PresetGroup> expanded_;
    std::set<live::PresetRef> favourites_;
    live::PresetRef shown_;
    struct Picture {
        std::shared_ptr<const TransferFunction> function;  // keeps the address unique
        QImage image;
    };
    std::map<const TransferFunction*, Picture> pictures_;
};

}  // namespace macula::viewer
