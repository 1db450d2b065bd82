#include "viewer/browser/study_tree_model.h"

#include <QMimeData>
#include <utility>

#include "viewer/browser/series_mime.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

constexpr int kLinesOfWhyNot = 3;

QString shownText(const Text& text) {
    return harmless(inWindowsLanguage(text));
}

}  // namespace

StudyTreeModel::StudyTreeModel(QObject* parent) : QAbstractItemModel(parent) {}

void StudyTreeModel::setTree(study::StudyTree tree) {
    open_.reset();
    stored_.clear();
    pictures_.clear();
    setTexts(std::move(tree));
}

void StudyTreeModel::setTexts(study::StudyTree tree) {
    beginResetModel();
    tree_ = std::move(tree);
    shown_.assign(tree_.rows.size(), true);
    layOut();
    endResetModel();
}

void StudyTreeModel::setRowsShown(std::vector<bool> shown) {
    MACULA_CHECK(shown.size() == tree_.rows.size());
    if (shown == shown_) return;
    beginResetModel();
    shown_ = std::move(shown);
    layOut();
    endResetModel();
}

void StudyTreeModel::layOut() {
    top_.clear();
    children_.assign(tree_.rows.size(), {});
    places_.assign(tree_.rows.size(), -1);
    const auto add = [&](std::size_t row, std::vector<std::size_t>& siblings) {
        if (!shown_[row]) return;
        places_[row] = int(siblings.size());
        siblings.push_back(row);
    };
    for (const std::size_t row : tree_.top) add(row, top_);
    for (std::size_t row = 0; row < tree_.rows.size(); ++row) {
        for (const std::size_t child : tree_.rows[row].children) add(child, children_[row]);
    }
}

template <class Which>
void StudyTreeModel::tellChanged(Which which) {
    for (std::size_t row = 0; row < tree_.rows.size(); ++row) {
        if (!which(row)) continue;
        if (const QModelIndex index = indexOf(row); index.isValid()) Q_EMIT dataChanged(index, index);
    }
}

void StudyTreeModel::setOpen(std::optional<std::size_t> volume) {
    if (volume == open_) return;
    const std::optional<std::size_t> before = std::exchange(open_, volume);
    tellChanged([&](std::size_t row) {
        const auto& opens = tree_.rows[row].volume;
        return opens && (opens == before || opens == open_);
    });
}

void StudyTreeModel::setStored(std::set<std::size_t> volumes) {
    stored_ = std::move(volumes);
    tellChanged([&](std::size_t row) { return tree_.rows[row].volume.has_value(); });
}

void StudyTreeModel::setPicture(const dicom::Stack* stack, const QImage& picture) {
    pictures_[stack] = picture;
    tellChanged([&](std::size_t row) { return tree_.rows[row].picture == stack; });
}

QModelIndex StudyTreeModel::indexOf(std::size_t row) const {
    if (row >= places_.size() || places_[row] < 0) return {};
    return createIndex(places_[row], 0, quintptr(row));
}

QModelIndex StudyTreeModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent)) return {};
    const auto& siblings = parent.isValid() ? children_[rowOf(parent)] : top_;
    return createIndex(row, column, quintptr(siblings[std::size_t(row)]));
}

QModelIndex StudyTreeModel::parent(const QModelIndex& child) const {
    if (!child.isValid()) return {};
    return indexOf(tree_.rows[rowOf(child)].parent);
}

int StudyTreeModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid()) return int(top_.size());
    return parent.column() == 0 ? int(children_[rowOf(parent)].size()) : 0;
}

int StudyTreeModel::columnCount(const QModelIndex&) const {
    return 1;
}

Qt::ItemFlags StudyTreeModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags usual = QAbstractItemModel::flags(index);
    const bool can = index.isValid() && tree_.rows[rowOf(index)].picture != nullptr;
    return can ? usual | Qt::ItemIsDragEnabled : usual;
}

QStringList StudyTreeModel::mimeTypes() const {
    return {QLatin1String(kSeriesMime)};
}

QMimeData* StudyTreeModel::mimeData(const QModelIndexList& indexes) const {
    if (indexes.isEmpty() || !found_) return nullptr;
    const dicom::Stack* stack = tree_.rows[rowOf(indexes.front())].picture;
    const QByteArray text = stack == nullptr ? QByteArray() : seriesText(*found_, *stack);
    if (text.isEmpty()) return nullptr;
    auto* data = new QMimeData;
    data->setData(QLatin1String(kSeriesMime), text);
    return data;
}

bool StudyTreeModel::isOpen(std::size_t row) const {
    return open_ && tree_.rows[row].volume == open_;
}

bool StudyTreeModel::isStored(std::size_t row) const {
    const auto& volume = tree_.rows[row].volume;
    return volume && stored_.contains(*volume);
}

QStringList StudyTreeModel::details(std::size_t row) const {
    QStringList lines;
    const study::StudyRow& shown = tree_.rows[row];
    for (const Text& line : shown.details) lines << shownText(line);
    if (isOpen(row)) lines << tr("Open now");
    if (isStored(row)) lines << tr("Seen before; opens as it was left");
    return lines;
}

// Escaped, because Qt renders text that looks like HTML, and files may hold any text.
QString StudyTreeModel::toolTip(std::size_t row) const {
    const study::StudyRow& shown = tree_.rows[row];
    QStringList lines{shownText(shown.title)};
    lines += details(row);
    for (const Text& message : shown.messages) lines << shownText(message);
    if (!shown.whyNot.empty()) {
        lines << tr("This cannot be opened.");
    } else if (shown.presentation) {
        lines << tr("A double click or Enter opens its series, and shows it so.");
    } else if ((shown.volume && !isOpen(row)) || shown.images != nullptr) {
        lines << tr("A double click or Enter opens it.");
    }
    for (QString& line : lines) line = line.toHtmlEscaped();
    return QStringLiteral("<p>%1</p>").arg(lines.join(QStringLiteral("<br>")));
}

QString StudyTreeModel::spoken(std::size_t row) const {
    const study::StudyRow& shown = tree_.rows[row];
    QStringList parts{shownText(shown.title)};
    parts += details(row);
    if (!shown.whyNot.empty()) parts << tr("Cannot be opened: %1").arg(shownText(shown.whyNot));
    return parts.join(QStringLiteral(", "));
}

QVariant StudyTreeModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const std::size_t row = rowOf(index);
    const study::StudyRow& shown = tree_.rows[row];
    switch (role) {
        case Qt::DisplayRole:
            return shownText(shown.title);
        case Qt::ToolTipRole:
            return toolTip(row);
        case Qt::AccessibleTextRole:
            return spoken(row);
        case detailsRole:
            return details(row);
        case whyNotRole:
            return shownText(shown.whyNot);
        case isOpenRole:
            return isOpen(row);
        case hasPictureRole:
            return shown.picture != nullptr;
        case pictureRole: {
            const auto found = pictures_.find(shown.picture);
            return found == pictures_.end() ? QImage() : found->second;
        }
        case lineCountRole:
            return 1 + int(shown.details.size()) + (isOpen(row) ? 1 : 0) + (isStored(row) ? 1 : 0) +
                   (shown.whyNot.empty() ? 0 : kLinesOfWhyNot);
        default:
            return {};
    }
}

}  // namespace macula::viewer
