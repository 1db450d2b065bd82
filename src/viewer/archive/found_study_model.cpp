#include "viewer/archive/found_study_model.h"

#include <QStringList>
#include <utility>

#include "study/open/identity.h"
#include "viewer/archive/read_marks.h"

namespace macula::viewer {

namespace {

bool namesSomebody(int column) {
    return column == FoundStudyModel::patient || column == FoundStudyModel::patientId ||
           column == FoundStudyModel::birthDate || column == FoundStudyModel::accession;
}

QString placeOf(const study::ListedStudy& listed) {
    const QString archive = QString::fromStdString(listed.archive);
    if (listed.folder.empty()) return archive;
    if (archive.isEmpty()) return FoundStudyModel::tr("this machine");
    return listed.isWhole ? FoundStudyModel::tr("%1, fetched").arg(archive)
                          : FoundStudyModel::tr("%1, partly fetched").arg(archive);
}

QString textOf(ReadMark mark) {
    switch (mark) {
        case ReadMark::unseen:
            return FoundStudyModel::tr("new");
        case ReadMark::seen:
            return FoundStudyModel::tr("opened");
        case ReadMark::read:
            return FoundStudyModel::tr("read");
        case ReadMark::unknown:
            break;
    }
    return {};
}

}  // namespace

void FoundStudyModel::setMarks(const ReadMarks* marks) {
    marks_ = marks;
    tellMarksChanged();
}

void FoundStudyModel::tellMarksChanged() {
    if (!studies_.empty()) Q_EMIT dataChanged(index(0, mark), index(rowCount() - 1, mark));
}

void FoundStudyModel::setStudies(std::vector<study::ListedStudy> studies) {
    beginResetModel();
    studies_ = std::move(studies);
    endResetModel();
}

void FoundStudyModel::showNames(bool shown) {
    namesShown_ = shown;
    if (!studies_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCountOf - 1));
}

int FoundStudyModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(studies_.size());
}

int FoundStudyModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(columnCountOf);
}

QString FoundStudyModel::text(const study::ListedStudy& listed, int column) const {
    const net::FoundStudy& study = listed.study;
    if (!namesShown_ && namesSomebody(column)) return tr("hidden");
    switch (column) {
        case patient:
            return QString::fromStdString(study::nameForPeople(study.patientName));
        case patientId:
            return QString::fromStdString(study.patientId);
        case birthDate:
            return QString::fromStdString(study::dateForPeople(study.patientBirthDate));
        case date:
            return QString::fromStdString(study::dateForPeople(study.date));
        case modalities: {
            QStringList list;
            for (const std::string& modality : study.modalities)
                list.append(QString::fromStdString(modality));
            return list.join(QStringLiteral(", "));
        }
        case description:
            return QString::fromStdString(study.description);
        case accession:
            return QString::fromStdString(study.accessionNumber);
        case images:
            return study.instanceCount ? QString::number(*study.instanceCount) : QString();
        case place:
            return placeOf(listed);
        case mark:
            return marks_ != nullptr ? textOf(marks_->of(study.studyInstanceUid)) : QString();
        default:
            return {};
    }
}

QVariant FoundStudyModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const study::ListedStudy& listed = studies_[std::size_t(index.row())];
    const net::FoundStudy& study = listed.study;
    if (role == Qt::DisplayRole) return text(listed, index.column()).simplified();
    // An archive may send anything, and a tip shows markup.
    if (role == Qt::ToolTipRole) return text(listed, index.column()).simplified().toHtmlEscaped();
    if (role != sortRole) return {};
    // Later studies of a day stand behind earlier ones.
    if (index.column() == date) return QString::fromStdString(study.date + study.time);
    if (index.column() == mark) return marks_ != nullptr ? int(marks_->of(study.studyInstanceUid)) : 0;
    if (index.column() == images) return study.instanceCount ? int(*study.instanceCount) : -1;
    return text(listed, index.column());
}

QVariant FoundStudyModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole || orientation != Qt::Horizontal) return {};
    switch (section) {
        case patient:
            return tr("Patient");
        case patientId:
            return tr("Patient ID");
        case birthDate:
            return tr("Born");
        case date:
            return tr("Study date");
        case modalities:
            return tr("Modalities");
        case description:
            return tr("Description");
        case accession:
            return tr("Accession number");
        case images:
            return tr("Images");
        case place:
            return tr("Place");
        case mark:
            return tr("Read");
        default:
            return {};
    }
}

}  // namespace macula::viewer
