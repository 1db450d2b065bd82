#include "viewer/transfer/transfer_edits.h"

#include <algorithm>
#include <cstddef>

namespace macula::viewer {

void TransferEdits::select(std::optional<PointId> point) {
    if (point == selected_) return;
    selected_ = point;
    Q_EMIT selectionChanged();
}

void TransferEdits::deselectIfGone() {
    if (selected_ && selected_->index >= plot_.countOf(selected_->curve)) select(std::nullopt);
}

bool TransferEdits::selectNext(bool forwards) {
    const std::size_t opacities = plot_.countOf(PointId::Curve::opacity);
    std::optional<std::size_t> place;  // opacity points first, then colour points
    if (!selected_) {
        place = forwards ? 0 : plot_.pointCount() - 1;
    } else {
        const std::size_t now =
            selected_->curve == PointId::Curve::opacity ? selected_->index : opacities + selected_->index;
        if (forwards && now + 1 < plot_.pointCount()) place = now + 1;
        if (!forwards && now > 0) place = now - 1;
    }
    if (!place) {
        select(std::nullopt);
        return false;
    }
    const bool isColour = *place >= opacities;
    select(isColour ? PointId{PointId::Curve::colour, *place - opacities}
                    : PointId{PointId::Curve::opacity, *place});
    plot_.reveal(*selected_);
    return true;
}

void TransferEdits::propose(const TransferFunction& function, bool isDrag) {
    if (function == plot_.function()) return;
    if (isDrag) {
        Q_EMIT dragged(function);
    } else {
        Q_EMIT edited(function);
    }
}

void TransferEdits::removeSelected() {
    if (!selected_) return;
    const PointId point = *selected_;
    const bool isColour = point.curve == PointId::Curve::colour;
    const TransferFunction left = isColour ? scene::withoutColourPoint(plot_.function(), point.index)
                                           : scene::withoutOpacityPoint(plot_.function(), point.index);
    if (left == plot_.function()) return;  // the last point of a curve cannot be removed
    propose(left, false);
    if (!(plot_.function() == left)) return;
    // Selects the point that took its place, so that several can be removed in a row.
    const std::size_t count = isColour ? left.colour.size() : left.opacity.size();
    selected_.reset();
    select(PointId{point.curve, std::min(point.index, count - 1)});
}

void TransferEdits::addBesideSelected() {
    const PointId from = selected_.value_or(PointId{});
    const scene::ValueAxis& axis = plot_.axis();
    const double low = selected_ ? plot_.valueOf(from) : axis.shown.low;
    const bool hasNext = selected_ && from.index + 1 < plot_.countOf(from.curve);
    const double high =
        hasNext ? plot_.valueOf({from.curve, from.index + 1}) : std::max(low, axis.shown.high);
    const double value = plot_.map().presetFrom(0.5 * (low + high));
    const TransferFunction& function = plot_.function();
    const auto point = add(from.curve,
                           from.curve == PointId::Curve::colour
                               ? scene::withColourPoint(function, value, colourAt(function, value))
                               : scene::withOpacityPoint(function, value, opacityAt(function, value)),
                           false);
    if (point) plot_.reveal(*point);
}

std::optional<PointId> TransferEdits::add(PointId::Curve curve, const scene::Added& added, bool isDrag) {
    if (!added.index) return std::nullopt;
    propose(added.function, isDrag);
    if (!(plot_.function() == added.function)) return std::nullopt;  // no listener accepted it
    const PointId point{curve, *added.index};
    select(point);
    return point;
}

bool TransferEdits::askForColour() {
    if (!selected_ || selected_->curve != PointId::Curve::colour) return false;
    Q_EMIT colourAsked();
    return true;
}

}  // namespace macula::viewer
