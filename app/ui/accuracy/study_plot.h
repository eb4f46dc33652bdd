#pragma once

#include "app/model/analysis/accuracy_study.h"
#include "app/model/analysis/representative_methods.h"
#include "app/ui/accuracy/error_scale.h"
#include "app/ui/accuracy/study_marks.h"
#include "app/ui/plots/spot_plot.h"

namespace app {

/// A plot of an accuracy study: errors on the vertical axis, and a line for each method with its name at the end. Each
/// spot is a row of the study, and using it adopts the row's method and step. Derived classes say what the horizontal
/// axis is and how lines are drawn.
class StudyPlot : public SpotPlot
{
    Q_OBJECT

public:
    StudyPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent = nullptr);

    /// Sets which methods are shown; at first all of them.
    void setShown(const ShownMethods &shown);
    const ShownMethods &shown() const { return m_shown; }

    const std::vector<Spot> &spots() const { return m_spots; }
    /// Returns the place of a spot in the widget, in px.
    QPointF onScreen(const Spot &spot) const { return Plot::onScreen(spot.place); }

    /// Returns the numbers of the plot as comma-separated text; empty if there are none.
    QByteArray numbers() const;

    QSize minimumSizeHint() const override { return {320, 200}; }
    QSize sizeHint() const override { return {520, 380}; }

protected:
    using Plot::onScreen;
    using Line = std::vector<const Spot *>; ///< spots of one method, from left to right

    /// Sets the axes for the study's rows and returns the spots.
    virtual std::vector<Spot> layOut() = 0;
    /// Returns all names but lessUp.
    virtual AxisNames axisNames() const = 0;
    static QString largestError() { return tr("largest error, px"); }
    /// Draws the lines of the methods and what lies below their names.
    virtual void drawLines(QPainter &painter) = 0;
    /// Draws what lies over the names.
    virtual void drawOver(QPainter &) {}
    /// Returns the name at the end of a method's line.
    virtual QString nameOf(const sim::Method &method) const;
    /// Returns what names must not cover.
    virtual LabelPlaces takenPlaces() const;
    /// Finds places for names and returns all that is taken then. It is called once a layout, because it takes longer
    /// than drawing.
    virtual LabelPlaces placeNames();
    virtual double markerSize() const { return 9.0; } ///< px
    virtual QByteArray numbersOf(const sim::Accuracy &accuracy) const;

    /// Returns the lines of all methods that are shown.
    std::vector<Line> lines() const;
    QPolygonF onScreen(const Line &line) const;
    const sim::AccuracyRow &rowOf(const Spot &spot) const { return m_study.accuracy()->rows[spot.row]; }
    MethodColors inkOf(const Spot &spot) const;
    /// Returns the spot of the method and step in use; null if it is not shown.
    const Spot *spotInUse() const;
    /// Sets the scale of the vertical axis, in px.
    void setErrors(const ErrorScale &errors);
    const ErrorScale &errors() const { return m_errors; }
    /// Lays out and draws the plot again: at once if the plot is visible, otherwise as soon as it is.
    void refresh();

    QString tipOf(const Spot &spot) const override;
    void applyTheme() override;
    void paintMarks(QPainter &painter) override;
    std::optional<Spot> spotAt(QPointF place) const override;
    std::optional<Spot> spotBeyond(QPoint step) const override;
    void use(const Spot &spot) override;
    QString overview() const override;
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;

    AccuracyStudy &m_study;

private:
    void drawFloor(QPainter &painter) const;
    std::optional<Spot> chosenInNewLayout() const;

    ShownMethods m_shown;
    std::vector<Spot> m_spots;
    std::vector<PlacedLabel> m_names;
    ErrorScale m_errors;
    QSharedPointer<PowerTicker> m_errorTicks;
    sim::MethodSetup m_chosenSetup; ///< finds the chosen spot again in new rows
    bool m_isStale = true;
    bool m_axesAreOld = true; ///< their colours have changed, so that they must be painted again
    bool m_namesAreOld = true;
};

}
