// Qt's Fusion style with lighter edges of controls, marks and focus frames, which are too dark in a dark
// window.
#pragma once

#include <QIcon>
#include <QProxyStyle>

#include "viewer/theme/theme_colours.h"

namespace macula::viewer {

class ThemeStyle : public QProxyStyle {
    Q_OBJECT

  public:
    // `colours` outlives it. Marks and icons grow by `scale`, as the fonts do.
    ThemeStyle(const ThemeColours& colours, double scale);

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget = nullptr) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget = nullptr) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget = nullptr) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption* option = nullptr,
                    const QWidget* widget = nullptr) const override;

    QIcon standardIcon(StandardPixmap which, const QStyleOption* option = nullptr,
                       const QWidget* widget = nullptr) const override;

  private:
    void drawEdge(QPainter& painter, const QRect& rect, bool hasFocus) const;
    void drawFocus(QPainter& painter, const QRect& rect) const;
    void drawCheckBox(QPainter& painter, const QStyleOption& option) const;
    void drawRadioButton(QPainter& painter, const QStyleOption& option) const;
    void drawToolButtonPanel(QPainter& painter, const QStyleOption& option) const;
    void drawScrollBar(QPainter& painter, const QStyleOptionComplex& option, const QWidget* widget) const;
    void drawToolBarSeparator(QPainter& painter, const QStyleOption& option) const;

    const ThemeColours& colours_;
    double scale_;
};

}  // namespace macula::viewer
