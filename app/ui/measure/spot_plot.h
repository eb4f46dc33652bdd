#pragma once

#include "app/model/accuracy_study.h"
#include "app/model/telling_methods.h"
#include "app/ui/measure/error_scale.h"
#include "app/ui/measure/spots.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/theme/theme.h"

#include "app/ui/theme/custom_plot.h"

namespace app {

class PowerTicker;

/// A plot of a study's rows: the axes, and spots that mouse and keyboard find. A click or Enter on a spot adopts its
/// method and step. What is drawn and where is the plots' own business.
class SpotPlot : public QCustomPlot
{
    Q_OBJECT

public:
    SpotPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent = nullptr);

    /// Which methods are shown: all, unless told otherwise.
    void setShown(const ShownMethods &shown);
    const ShownMethods &shown() const { return m_shown; }

    const std::vector<Spot> &spots() const { return m_spots; }
    /// Where a spot is drawn, in px of the widget.
    QPointF onScreen(const Spot &spot) const { return onScreen(spot.place); }
    /// The spot under the mouse, or the one that the keys went to; null for none.
    const Spot *chosen() const;
    /// What is chosen, in words, for those who cannot see it.
    QString sentence() const;

    /// The plot as it is saved.
    PlotPicture picture();
    /// Its numbers, as comma-separated text; empty where there are none.
    QByteArray numbers() const;

    QSize minimumSizeHint() const override { return {320, 200}; }
    QSize sizeHint() const override { return {520, 380}; }

signals:
    void chosenChanged();

protected:
    /// Puts the axes where the study's rows want them and returns the spots.
    virtual std::vector<Spot> layOut() = 0;
    /// Finds places for names, before they are drawn for the first time after a layout: that takes longer than
    /// drawing them.
    virtual void placeWords() = 0;
    /// Draws all but the axes.
    virtual void draw(QPainter &painter) = 0;
    /// What it shows of a study, as comma-separated text.
    virtual QByteArray numbersOf(const sim::Accuracy &accuracy) const;
    /// What a tip says about a spot.
    virtual QString tipOf(const Spot &spot) const;
    /// Mouse and keys that are no spot's business. Returns whether they were used.
    virtual bool press(QPointF) { return false; }
    virtual void drag(QPointF) {}
    virtual void drop() {}
    virtual bool key(const QKeyEvent &) { return false; }
    virtual bool wantsKey(const QKeyEvent &) const { return false; }
    virtual Qt::CursorShape cursorAt(QPointF) const { return Qt::ArrowCursor; }

    /// Gives the vertical axis the scale of errors (px).
    void setErrors(const ErrorScale &errors);
    const ErrorScale &errors() const { return m_errors; }
    /// Lays out and draws anew; at once if it is seen, else as soon as it is.
    void refresh();
    QPointF onScreen(QPointF place) const;
    const sim::AccuracyRow &rowOf(const Spot &spot) const { return m_study.accuracy()->rows[spot.row]; }

    AccuracyStudy &m_study;
    const Theme &m_theme;

    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    void dress();
    OnScreen screen() const;
    void drawFloor(QPainter &painter) const;
    /// All but the axes, with places for names.
    void drawAll(QPainter &painter);
    void choose(const Spot *spot);
    void walk(int along, int across);
    void showTip();
    void adopt();

    ShownMethods m_shown;
    std::vector<Spot> m_spots;
    ErrorScale m_errors;
    QSharedPointer<PowerTicker> m_errorTicks;
    std::optional<Spot> m_chosen;
    sim::MethodSetup m_chosenWay; ///< by which it is found again when rows come in
    bool m_stale = true;
    bool m_axesAreOld = true; ///< their colours are others, so that they must be painted anew
    bool m_isUnplaced = true;
    bool m_dragging = false;
    bool m_ringed = false; ///< the keyboard is here
};

}
