#include "viewer/theme/theme_style.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QPainter>
#include <QPushButton>
#include <QStyleOption>
#include <algorithm>
#include <array>
#include <cmath>

namespace macula::viewer {

namespace {

constexpr double kFocusPx = 2.0;
constexpr double kCornerPx = 2.0;

class Painting {  // leaves the painter as it was
  public:
    explicit Painting(QPainter& painter) : painter_(painter) {
        painter_.save();
        painter_.setRenderHint(QPainter::Antialiasing);
        painter_.setBrush(Qt::NoBrush);
    }
    ~Painting() { painter_.restore(); }
    Painting(const Painting&) = delete;
    Painting& operator=(const Painting&) = delete;

  private:
    QPainter& painter_;
};

bool is(const QStyleOption& option, QStyle::StateFlag flag) {
    return option.state.testFlag(flag);
}

// Buttons show the focus only if it came by the keyboard.
bool hasKeyboardFocus(const QStyleOption& option) {
    return is(option, QStyle::State_HasFocus) && is(option, QStyle::State_KeyboardFocusChange);
}

// The largest square in the middle of `rect`; its lines lie on pixel centres.
QRectF squareIn(const QRect& rect) {
    const int side = std::min(rect.width(), rect.height());
    return QRectF(rect.x() + (rect.width() - side) / 2, rect.y() + (rect.height() - side) / 2, side, side)
        .adjusted(0.5, 0.5, -0.5, -0.5);
}

// Two arrows, to the right or downwards: the sign for hidden entries.
QIcon moreIcon(bool isDown, const QColor& ink, double scale) {
    constexpr double kSidePx = 16.0;
    constexpr double kRatio = 2.0;  // for displays with two device pixels to a logical one
    QPixmap picture(QSize(1, 1) * int(std::lround(kSidePx * scale * kRatio)));
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(picture.width(), picture.height());
    if (isDown) painter.setTransform(QTransform(0.0, 1.0, 1.0, 0.0, 0.0, 0.0), true);
    painter.setPen(QPen(ink, 0.1, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    for (const double left : {0.25, 0.52}) {
        painter.drawPolyline(
            std::array<QPointF, 3>{QPointF(left, 0.28), QPointF(left + 0.22, 0.5), QPointF(left, 0.72)}
                .data(),
            3);
    }
    painter.end();
    picture.setDevicePixelRatio(kRatio);
    return QIcon(picture);
}

}  // namespace

ThemeStyle::ThemeStyle(const ThemeColours& colours, double scale)
    : QProxyStyle(QStringLiteral("Fusion")), colours_(colours), scale_(scale) {}

void ThemeStyle::drawEdge(QPainter& painter, const QRect& rect, bool hasFocus) const {
    if (hasFocus) return drawFocus(painter, rect);
    const Painting painting(painter);
    painter.setPen(QPen(QColor(colours_.line), 1.0));
    painter.drawRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), kCornerPx, kCornerPx);
}

void ThemeStyle::drawFocus(QPainter& painter, const QRect& rect) const {
    const Painting painting(painter);
    painter.setPen(QPen(QColor(colours_.accent), kFocusPx));
    const double half = 0.5 * kFocusPx;
    painter.drawRoundedRect(QRectF(rect).adjusted(half, half, -half, -half), kCornerPx, kCornerPx);
}

void ThemeStyle::drawCheckBox(QPainter& painter, const QStyleOption& option) const {
    const Painting painting(painter);
    const bool isSet = !is(option, State_Off) && (is(option, State_On) || is(option, State_NoChange));
    const bool isEnabled = is(option, State_Enabled);
    const QRectF box = squareIn(option.rect);
    const QRgb edge = isEnabled ? (isSet || hasKeyboardFocus(option) ? colours_.accent : colours_.line)
                                : colours_.disabledText;
    painter.setPen(QPen(QColor(edge), 1.0));
    painter.setBrush(QColor(isSet ? edge : is(option, State_Sunken) ? colours_.button : colours_.field));
    painter.drawRoundedRect(box, kCornerPx, kCornerPx);
    if (!isSet) return;
    const auto at = [&](double x, double y) {
        return box.topLeft() + QPointF(x * box.width(), y * box.height());
    };
    painter.setPen(QPen(QColor(colours_.onAccent), std::max(1.5, 0.14 * box.width()), Qt::SolidLine,
                        Qt::RoundCap, Qt::RoundJoin));
    if (is(option, State_NoChange))
        painter.drawLine(at(0.25, 0.5), at(0.75, 0.5));
    else
        painter.drawPolyline(std::array<QPointF, 3>{at(0.22, 0.52), at(0.42, 0.73), at(0.78, 0.28)}.data(),
                             3);
}

void ThemeStyle::drawRadioButton(QPainter& painter, const QStyleOption& option) const {
    const Painting painting(painter);
    const bool isSet = is(option, State_On);
    // A curve one pixel wide would be too faint.
    const QRectF circle = squareIn(option.rect).adjusted(0.25, 0.25, -0.25, -0.25);
    const QRgb edge = is(option, State_Enabled)
                          ? (isSet || hasKeyboardFocus(option) ? colours_.accent : colours_.line)
                          : colours_.disabledText;
    painter.setPen(QPen(QColor(edge), 1.5));
    painter.setBrush(QColor(is(option, State_Sunken) ? colours_.button : colours_.field));
    painter.drawEllipse(circle);
    if (!isSet) return;
    const double inset = 0.22 * circle.width();
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(edge));
    painter.drawEllipse(circle.adjusted(inset, inset, -inset, -inset));
}

void ThemeStyle::drawToolButtonPanel(QPainter& painter, const QStyleOption& option) const {
    const Painting painting(painter);
    const bool isEnabled = is(option, State_Enabled);
    const bool isOn = is(option, State_On);
    const bool isDown = is(option, State_Sunken);
    const bool isFlat = is(option, State_AutoRaise) && !isOn && !isDown;
    if (isFlat && !(isEnabled && is(option, State_MouseOver))) return;
    const QRgb ground = (isOn || isDown) && isEnabled ? colours_.selection : colours_.button;
    const QRgb edge = !isEnabled ? colours_.disabledText : isOn ? colours_.accent : colours_.line;
    painter.setPen(isFlat ? QPen(Qt::NoPen) : QPen(QColor(edge), 1.0));
    painter.setBrush(QColor(ground));
    painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), kCornerPx, kCornerPx);
}

void ThemeStyle::drawToolBarSeparator(QPainter& painter, const QStyleOption& option) const {
    const Painting painting(painter);
    painter.setPen(QPen(QColor(colours_.line).darker(150), 1.0));
    const QRectF rect = QRectF(option.rect).adjusted(2.0, 2.0, -2.0, -2.0);
    const QPointF middle(std::floor(rect.center().x()) + 0.5, std::floor(rect.center().y()) + 0.5);
    if (is(option, State_Horizontal))
        painter.drawLine(QPointF(middle.x(), rect.top()), QPointF(middle.x(), rect.bottom()));
    else
        painter.drawLine(QPointF(rect.left(), middle.y()), QPointF(rect.right(), middle.y()));
}

void ThemeStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
    switch (element) {
        case PE_IndicatorCheckBox:
            return drawCheckBox(*painter, *option);
        case PE_IndicatorRadioButton:
            return drawRadioButton(*painter, *option);
        case PE_PanelButtonTool:
            return drawToolButtonPanel(*painter, *option);
        case PE_IndicatorToolBarSeparator:
            return drawToolBarSeparator(*painter, *option);
        case PE_FrameFocusRect:
            // Buttons and combo boxes draw the focus as a frame of their own.
            if (qobject_cast<const QPushButton*>(widget) != nullptr ||
                qobject_cast<const QComboBox*>(widget) != nullptr)
                return;
            if (is(*option, State_KeyboardFocusChange)) drawFocus(*painter, option->rect);
            return;
        case PE_FrameLineEdit:
            QProxyStyle::drawPrimitive(element, option, painter, widget);
            return drawEdge(*painter, option->rect, is(*option, State_HasFocus));
        case PE_PanelButtonCommand:
            QProxyStyle::drawPrimitive(element, option, painter, widget);
            return drawEdge(*painter, option->rect, hasKeyboardFocus(*option));
        case PE_PanelMenu:
        case PE_FrameMenu:
            QProxyStyle::drawPrimitive(element, option, painter, widget);
            return drawEdge(*painter, option->rect, false);
        default:
            return QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
}

void ThemeStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                             const QWidget* widget) const {
    if (element != CE_Splitter) return QProxyStyle::drawControl(element, option, painter, widget);
    const bool isHeld = is(*option, State_MouseOver) || is(*option, State_Sunken);
    painter->fillRect(option->rect, QColor(isHeld ? colours_.accent : colours_.window));
}

void ThemeStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                    QPainter* painter, const QWidget* widget) const {
    if (control == CC_ScrollBar) return drawScrollBar(*painter, *option, widget);
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    const bool hasFocus = is(*option, State_HasFocus);
    if (control == CC_ComboBox) {
        const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
        if (box != nullptr && box->frame) drawEdge(*painter, option->rect, hasFocus);
    } else if (control == CC_SpinBox) {
        const auto* box = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
        if (box != nullptr && box->frame) drawEdge(*painter, option->rect, hasFocus);
    } else if (control == CC_Slider && option->subControls.testFlag(SC_SliderHandle)) {
        drawEdge(*painter, proxy()->subControlRect(control, option, SC_SliderHandle, widget),
                 hasKeyboardFocus(*option));
    }
}

// A handle in its groove: what Fusion draws cannot be seen in the dark.
void ThemeStyle::drawScrollBar(QPainter& painter, const QStyleOptionComplex& option,
                               const QWidget* widget) const {
    painter.save();
    painter.fillRect(option.rect, QColor(colours_.window));
    const QRect handle = proxy()->subControlRect(CC_ScrollBar, &option, SC_ScrollBarSlider, widget);
    const bool isHeld = is(option, State_MouseOver) && option.activeSubControls.testFlag(SC_ScrollBarSlider);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(isHeld ? colours_.accent : colours_.line));
    const QRectF inner = QRectF(handle).adjusted(3.0, 3.0, -3.0, -3.0);
    const double radius = 0.5 * std::min(inner.width(), inner.height());
    painter.drawRoundedRect(inner, radius, radius);
    painter.restore();
}

// Fusion draws the arrows of a bar's extension button in black, where nobody sees them on a dark bar.
QIcon ThemeStyle::standardIcon(StandardPixmap which, const QStyleOption* option,
                               const QWidget* widget) const {
    const bool isDown = which == SP_ToolBarVerticalExtensionButton;
    if (isDown || which == SP_ToolBarHorizontalExtensionButton)
        return moreIcon(isDown, QColor(colours_.text), scale_);
    return QProxyStyle::standardIcon(which, option, widget);
}

int ThemeStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
    const int px = QProxyStyle::pixelMetric(metric, option, widget);
    switch (metric) {
        case PM_IndicatorWidth:
        case PM_IndicatorHeight:
        case PM_ExclusiveIndicatorWidth:
        case PM_ExclusiveIndicatorHeight:
        case PM_SmallIconSize:
        case PM_ButtonIconSize:
        case PM_ToolBarIconSize:
        case PM_ScrollBarExtent:
            return int(std::lround(px * scale_));
        default:
            return px;
    }
}

}  // namespace macula::viewer
