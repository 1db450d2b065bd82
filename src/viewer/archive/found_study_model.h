// The Qt item model of the studies that an archive found.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "net/archive/query.h"

namespace macula::viewer {

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
        columnCountOf
    };
    enum Role { sortRole = Qt::UserRole };

    using QAbstractTableModel::QAbstractTableModel;

    void setStudies(std::vector<net::FoundStudy> studies);
    void showNames(bool shown);  // otherwise name, ID, date of birth and accession number are hidden
    const net::FoundStudy& study(int row) const { return studies_[std::size_t(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    QString text(const net::FoundStudy& study, int column) const;

    std::vector<net::FoundStudy> studies_;
    bool namesShown_ = true;
};

}  // namespace macula::viewer
