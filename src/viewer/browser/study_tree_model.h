// The Qt item model of the study browser.
#pragma once

#include <QAbstractItemModel>
#include <QImage>
#include <memory>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "study/list/study_tree.h"

namespace macula::viewer {

// One column. A row keeps its index in StudyTree::rows, whichever rows are shown.
class StudyTreeModel : public QAbstractItemModel {
    Q_OBJECT

  public:
    enum Role {
        detailsRole = Qt::UserRole,  // QStringList, below the title
        whyNotRole,                  // QString, empty if the row can be opened
        isOpenRole,                  // bool
        hasPictureRole,              // bool: the row has a thumbnail, made or not yet
        pictureRole,                 // QImage, null until it is made
        lineCountRole,               // int: title, details and whyNot
    };

    explicit StudyTreeModel(QObject* parent = nullptr);

    // Shows all rows, and clears the open volume, the stored ones and the thumbnails.
    void setTree(study::StudyTree tree);
    // Where its series are; null: none can be dragged.
    void setFound(std::shared_ptr<const study::FoundVolumes> found) { found_ = std::move(found); }
    // Replaces the texts of the same folder, and keeps the open volume, the stored ones and the thumbnails.
    void setTexts(study::StudyTree tree);
    const study::StudyTree& tree() const { return tree_; }
    void setRowsShown(std::vector<bool> shown);  // one for each row
    bool isShown(std::size_t row) const { return shown_[row]; }

    // An index into FoundVolumes::volumes().
    void setOpen(std::optional<std::size_t> volume);
    std::optional<std::size_t> open() const { return open_; }
    void setStored(std::set<std::size_t> volumes);
    // Null: the thumbnail cannot be made.
    void setPicture(const dicom::Stack* stack, const QImage& picture);
    bool isAsked(const dicom::Stack* stack) const { return pictures_.contains(stack); }

    QModelIndex indexOf(std::size_t row) const;  // invalid for a row that is not shown
    static std::size_t rowOf(const QModelIndex& index) { return std::size_t(index.internalId()); }

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    // A series with images can be dragged, as kSeriesMime.
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QModelIndexList& indexes) const override;

  private:
    void layOut();
    bool isOpen(std::size_t row) const;
    bool isStored(std::size_t row) const;
    QStringList details(std::size_t row) const;
    QString toolTip(std::size_t row) const;
    QString spoken(std::size_t row) const;
    template <class Which>
    void tellChanged(Which which);

    study::StudyTree tree_;
    std::shared_ptr<const study::FoundVolumes> found_;
    std::vector<bool> shown_;
    std::vector<std::size_t> top_;                    // the shown rows at the top level
    std::vector<std::vector<std::size_t>> children_;  // each row's shown children
    std::vector<int> places_;  // the position of each row among the children of its parent
    std::optional<std::size_t> open_;
    std::set<std::size_t> stored_;
    std::unordered_map<const dicom::Stack*, QImage> pictures_;
};

}  // namespace macula::viewer
