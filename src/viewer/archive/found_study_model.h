// The Qt item model of the studies that a search found.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "study/archive/study_search.h"

namespace macula::viewer {

class ReadMarks;

// A row for each study; what tells most apart comes first, since a panel is narrow. Sorting is a proxy's:
// sortRole has dates and numbers as such.
class FoundStudyModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    enum Column {
        patient,
        date,
        modalities,
        description,
        patientId,
        birthDate,
        accession,
        images,
        place,
        mark,
        columnCountOf
    };
    enum Role { sortRole = Qt::UserRole };

    using QAbstractTableModel::QAbstractTableModel;

    void setStudies(std::vector<study::ListedStudy> studies);
    void setMarks(const ReadMarks* marks);  // null: the column stays empty; outlives this
    void tellMarksChanged();
    void showNames(bool shown);  // otherwise name, ID, date of birth and accession number are hidden
    const study::ListedStudy& study(int row) const { return studies_[std::size_t(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    QString text(const study::ListedStudy& listed, int column) const;

    std::vector<study::ListedStudy> studies_;
    const ReadMarks* marks_ = nullptr;
    bool namesShown_ = true;
};

}  // namespace macula::viewer
