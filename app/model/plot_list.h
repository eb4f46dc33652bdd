#pragma once

#include "app/model/quantity.h"
#include "lessons/api/step.h"

#include <QObject>

#include <vector>

namespace app {

/// What one plot shows: a quantity against time, or against another quantity.
struct PlotSpec
{
    Quantity up;
    Quantity across = {};

    bool isAgainstTime() const { return across.what == Measured::time; }
    /// Whether it keeps to the bodies that it names, whatever is selected.
    bool isPinned() const;
    friend bool operator==(const PlotSpec &, const PlotSpec &) = default;
};

/// The plots of a learner. They are kept, and come back when the program starts again. As long as nobody has chosen
/// any, there is one that suits the step.
class PlotList : public QObject
{
    Q_OBJECT

public:
    /// More than these would be too small to be read.
    static constexpr std::size_t most = 8;

    explicit PlotList(QObject *parent = nullptr);

    const std::vector<PlotSpec> &plots() const { return m_plots; }
    bool isFull() const { return m_plots.size() >= most; }
    /// Another step is open, with this run.
    void open(const sim::Script &script);
    void add(const PlotSpec &plot);
    void remove(std::size_t index);
    void change(std::size_t index, const PlotSpec &plot);
    /// All quantities that the plots show, each once.
    std::vector<Quantity> quantities() const;

signals:
    /// A plot was added, removed, or shows something else.
    void changed();

private:
    void keep();

    std::vector<PlotSpec> m_plots;
    bool m_isChosen = false; ///< by the learner
};

/// `plot` with the name of `selected` in place of "the selected body".
PlotSpec pinned(PlotSpec plot, const QString &selected);
/// `plot` of whatever is selected.
PlotSpec unpinned(PlotSpec plot);
/// Returns the plot of a run that nobody has chosen one for: where the first body points, if things turn there; else the
/// coordinate in which it moves, y if in both or in none.
PlotSpec firstPlot(const sim::Script &script);

}
