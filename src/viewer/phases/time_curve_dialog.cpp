#include "viewer/phases/time_curve_dialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QMainWindow>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/atomic_file.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

namespace {

constexpr int kMarginPx = 12;
constexpr std::array<QRgb, 6> kInks{0x78d2ff, 0xffb45a, 0x6ed66e, 0xff8adc, 0xf6dc4a, 0xff6054};

// Means over phases, with bars of one standard deviation.
class TimeCurveChart : public QWidget {
  public:
    TimeCurveChart(scene::TimeCurves curves, QWidget* parent) : QWidget(parent), curves_(std::move(curves)) {
        setMinimumSize(420, 260);
        setAccessibleName(QCoreApplication::translate("TimeCurveDialog", "Mean in each phase"));
        for (const scene::TimeCurve& curve : curves_.curves)
            for (const auto& values : curve.values) {
                if (!values || !std::isfinite(values->mean)) continue;
                const double off = std::isfinite(values->deviation) ? values->deviation : 0.0;
                low_ = std::min(low_, values->mean - off);
                high_ = std::max(high_, values->mean + off);
            }
        if (!(low_ < high_)) high_ = low_ + 1.0;
    }

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.fillRect(rect(), Qt::black);
        if (!std::isfinite(low_)) return;
        const QFontMetrics metrics = painter.fontMetrics();
        const QString top = numberOf(high_);
        const QString bottom = numberOf(low_);
        const int left =
            kMarginPx + std::max(metrics.horizontalAdvance(top), metrics.horizontalAdvance(bottom));
        plot_ = QRectF(rect()).adjusted(left + 6, kMarginPx + metrics.height(), -kMarginPx,
                                        -kMarginPx - metrics.height());
        painter.setPen(QColor(150, 150, 150));
        painter.drawRect(plot_);
        painter.drawText(QPointF(kMarginPx, plot_.top() + metrics.ascent()), top);
        painter.drawText(QPointF(kMarginPx, plot_.bottom()), bottom);
        painter.drawText(QPointF(kMarginPx, metrics.height()),
                         harmless(QString::fromStdString(curves_.unit)));
        const QString axis = hasTimes() ? numberOf(*curves_.phases.back().atMs) + QStringLiteral(" ms")
                                        : QString::number(curves_.phases.size());
        painter.drawText(QPointF(plot_.right() - metrics.horizontalAdvance(axis), height() - kMarginPx / 2.0),
                         axis);
        painter.drawText(QPointF(plot_.left(), height() - kMarginPx / 2.0),
                         hasTimes() ? QStringLiteral("0 ms") : QStringLiteral("1"));
        for (std::size_t i = 0; i < curves_.curves.size(); ++i) paintCurve(painter, i);
    }

  private:
    static QString numberOf(double value) { return withLocalNumbers(QString::number(value, 'g', 4)); }
    bool hasTimes() const { return curves_.phases.back().atMs.has_value(); }
    QPointF placeOf(std::size_t phase, double value) const {
        const double share =
            hasTimes() ? *curves_.phases[phase].atMs / *curves_.phases.back().atMs
                       : double(phase) / double(std::max<std::size_t>(curves_.phases.size() - 1, 1));
        return {plot_.left() + share * plot_.width(),
                plot_.bottom() - (value - low_) / (high_ - low_) * plot_.height()};
    }

    void paintCurve(QPainter& painter, std::size_t index) const {
        const scene::TimeCurve& curve = curves_.curves[index];
        const QColor ink = QColor::fromRgb(kInks.at(index % kInks.size()));
        QPainterPath path;
        painter.setPen(QPen(ink, 1.0));
        for (std::size_t phase = 0; phase < curve.values.size(); ++phase) {
            const auto& values = curve.values[phase];
            if (!values || !std::isfinite(values->mean)) continue;
            const QPointF at = placeOf(phase, values->mean);
            if (path.elementCount() == 0) path.moveTo(at);
            path.lineTo(at);
            painter.drawEllipse(at, 2.5, 2.5);
            if (!std::isfinite(values->deviation)) continue;
            painter.drawLine(placeOf(phase, values->mean - values->deviation),
                             placeOf(phase, values->mean + values->deviation));
        }
        painter.setPen(QPen(ink, 1.5));
        painter.drawPath(path);
        const double line = painter.fontMetrics().height();
        painter.drawText(QPointF(plot_.left() + 6, plot_.top() + line * (double(index) + 1.0)),
                         nameOf(curve));
    }

    static QString nameOf(const scene::TimeCurve& curve) {
        if (!curve.label.empty()) return harmless(QString::fromStdString(curve.label));
        const QString name = curve.kind == "outline"
                                 ? QCoreApplication::translate("TimeCurveDialog", "Outline %1")
                                 : QCoreApplication::translate("TimeCurveDialog", "Ellipse %1");
        return name.arg(curve.number);
    }

    scene::TimeCurves curves_;
    QRectF plot_;
    double low_ = std::numeric_limits<double>::infinity();
    double high_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

TimeCurveDialog::TimeCurveDialog(const scene::TimeCurves& curves, const WindowContext& context)
    : QDialog(&context.window), context_(context) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName(QStringLiteral("time-curve-dialog"));
    setWindowTitle(tr("Curve over Phases"));
    resize(640, 400);
    auto* column = new QVBoxLayout(this);
    column->addWidget(new TimeCurveChart(curves, this), 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* copy = buttons->addButton(tr("&Copy as a Table"), QDialogButtonBox::ActionRole);
    copy->setObjectName(QStringLiteral("time-curve-copy"));
    QPushButton* saved = buttons->addButton(tr("&Save as a Table…"), QDialogButtonBox::ActionRole);
    saved->setObjectName(QStringLiteral("time-curve-save"));
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(copy, &QPushButton::clicked, this,
            [csv = toCsv(curves)] { QGuiApplication::clipboard()->setText(QString::fromStdString(csv)); });
    connect(saved, &QPushButton::clicked, this, [this, csv = toCsv(curves)] { save(csv); });
}

void TimeCurveDialog::save(const std::string& csv) {
    auto* dialog = context_.files.toSave(FolderKind::measurements, tr("Save the curve"), tr("Table (*.csv)"),
                                         QStringLiteral("csv"), QStringLiteral("curve.csv"));
    context_.files.ask(dialog, FolderKind::measurements, [context = context_, csv](const QString& path) {
        if (const Result<void> written = writeTextAtomically(path.toStdString(), csv); !written)
            return context.notifications.fail(written.error());
        context.notifications.showNote(tr("The curve is written to %1.").arg(path));
    });
}

}  // namespace macula::viewer
