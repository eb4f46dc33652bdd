#pragma once

#include "app/ui/plots/plot.h"

#include <optional>

namespace app {

/// A place in a plot that the learner can choose.
struct Spot
{
    std::size_t row = 0; ///< of the data that the plot shows
    QPointF place;       ///< on the axes
    int line = 0;        ///< Left and Right go along the spots of one line

    bool operator==(const Spot &) const = default;
};

/// A plot with spots that mouse and keyboard find. The spot under the pointer is chosen, and the arrow keys choose
/// others. A click, Enter or Space uses the chosen spot. Derived classes say where spots are and what using one does.
class SpotPlot : public Plot
{
    Q_OBJECT

public:
    using Plot::Plot;

    const std::optional<Spot> &chosen() const { return m_chosen; }
    QString sentence() const override;
    bool canPress() const override { return true; }
    /// Uses the chosen spot.
    void press() override;

signals:
    void chosenChanged();

protected:
    /// Returns the spot at a place of the widget.
    virtual std::optional<Spot> spotAt(QPointF place) const = 0;
    /// Returns the spot that an arrow key goes to. `step` is the key's direction on the screen, with y down.
    virtual std::optional<Spot> spotBeyond(QPoint step) const = 0;
    /// Uses a spot.
    virtual void use(const Spot &spot) = 0;
    /// Returns all about a spot, one sentence a line.
    virtual QString tipOf(const Spot &spot) const = 0;
    /// Returns the sentence for screen readers while no spot is chosen.
    virtual QString overview() const = 0;
    /// Returns the area that the tip of a spot must not cover, in px.
    virtual QRectF markOf(const Spot &spot) const { return {onScreen(spot.place), QSizeF(0.0, 0.0)}; }

    void choose(const std::optional<Spot> &spot);
    /// Sets the chosen spot after a new layout, without announcing it.
    void keepChosen(const std::optional<Spot> &spot) { m_chosen = spot; }
    /// Shows the tip of the chosen spot beside it.
    void showTip();

    bool wantsKey(const QKeyEvent &event) const override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *) override {}
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    std::optional<Spot> m_chosen;
};

}
