#pragma once

#include "app/ui/plots/plot_export.h"
#include "app/ui/theme/custom_plot.h"
#include "app/ui/theme/theme.h"

namespace app {

/// Gives an axis and its grid the colours and fonts of the theme.
void styleAxis(QCPAxis &axis, const Theme &theme);

/// A plot in the colours of the theme. It takes the keyboard focus, has a focus ring, speaks to screen readers and can
/// be saved. Derived classes say what is plotted. See CursorPlot for plots over time, and SpotPlot for plots with
/// places to choose from.
class Plot : public QCustomPlot
{
    Q_OBJECT

public:
    Plot(const Theme &theme, QWidget *parent);

    /// Returns the name that a screen reader reads, for example "y of foot 1 against time".
    virtual QString title() const { return accessibleName(); }
    /// Returns the numbers that the plot shows, as a sentence.
    virtual QString sentence() const = 0;
    /// Returns the sentence together with what the pointer shows: the value that a screen reader reads.
    virtual QString spokenValue() const { return sentence(); }
    /// Returns whether Enter does something in this plot.
    virtual bool canPress() const { return false; }
    /// Does what Enter does; screen readers call it.
    virtual void press() {}
    /// Returns the plot as PlotExport saves it, without focus ring and pointer.
    virtual PlotPicture picture() { return pictureNamed(title(), title()); }

protected:
    /// Paints over axes and curves, on the screen and in saved pictures.
    virtual void paintMarks(QPainter &painter) = 0;
    /// Paints what follows pointer and keyboard, on the screen only.
    virtual void paintPointer(QPainter &) {}
    /// Returns whether the plot handles a key itself, so that it triggers no shortcut of the window.
    virtual bool wantsKey(const QKeyEvent &event) const = 0;
    /// Applies colours and fonts of the theme to background and axes. Each class calls it at the end of its
    /// constructor.
    virtual void applyTheme();

    PlotPicture pictureNamed(const QString &title, const QString &fileName);
    /// Returns the place of a point of the axes in the widget, in px.
    QPointF onScreen(QPointF place) const;
    /// Tells screen readers that the value has changed.
    void announceValue();

    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

    const Theme &m_theme;

private:
    bool m_hasFocusRing = false;
};

/// Returns whether only modifiers in `allowed` are held, or the keypad is used.
bool isPlainKey(const QKeyEvent &event, Qt::KeyboardModifiers allowed = Qt::NoModifier);

/// Returns a pen for curves, which are drawn line by line: its ends leave no gap between two lines. `ink` must be
/// opaque, otherwise the places where lines meet would show.
QPen curvePen(const QColor &ink, double width);
/// Returns whether both coordinates are finite.
bool isFinite(QPointF place);

}
