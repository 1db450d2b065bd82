#include "viewer/browser/series_mime.h"

#include <QList>
#include <cstddef>

namespace macula::viewer {

namespace {

// Of this run.
QByteArray listOf(const study::FoundVolumes& found) {
    return QByteArray::number(quintptr(&found));
}

template <class T>
const T* at(const std::vector<T>& all, const QByteArray& place) {
    bool isNumber = false;
    const qulonglong index = place.toULongLong(&isNumber);
    return isNumber && index < all.size() ? &all[std::size_t(index)] : nullptr;
}

}  // namespace

QByteArray seriesText(const study::FoundVolumes& found, const dicom::Stack& stack) {
    const study::PlanarSeries of = study::seriesOf(found, &stack);
    if (of.stack == nullptr) return {};
    QByteArray text = listOf(found);
    text += '/' + QByteArray::number(qlonglong(of.study - found.scan().studies.data()));
    text += '/' + QByteArray::number(qlonglong(of.series - of.study->series.data()));
    return text + '/' + QByteArray::number(qlonglong(of.stack - of.series->stacks.data()));
}

study::PlanarSeries seriesOfText(const QByteArray& text, const study::FoundVolumes& found) {
    const QList<QByteArray> places = text.split('/');
    if (places.size() != 4 || places[0] != listOf(found)) return {};
    study::PlanarSeries of;
    of.study = at(found.scan().studies, places[1]);
    of.series = of.study == nullptr ? nullptr : at(of.study->series, places[2]);
    of.stack = of.series == nullptr ? nullptr : at(of.series->stacks, places[3]);
    if (of.stack == nullptr || of.stack->frames.empty()) return {};
    return of;
}

}  // namespace macula::viewer
