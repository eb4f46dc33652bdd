#pragma once

#include "app/model/series/quantity.h"
#include "lessons/api/step.h"

#include <QObject>

#include <vector>

namespace app {

/// The quantities of one plot: one against time, or one against another.
struct PlotSpec
{
    Quantity up;
    Quantity across = {};

    bool isAgainstTime() const { return across.what == QuantityKind::time; }
    /// Returns whether the plot keeps the bodies that it names when the selection changes.
    bool isPinned() const;
    friend bool operator==(const PlotSpec &, const PlotSpec &) = default;
};

/// The plots that the learner has chosen. They are stored, and restored when the program starts again. Until the
/// learner chooses any, there is one that suits the step.
class PlotList : public QObject
{
    Q_OBJECT

public:
    /// More plots than this would be too small to read.
    static constexpr std::size_t most = 8;

    explicit PlotList(QObject *parent = nullptr);

    const std::vector<PlotSpec> &plots() const { return m_plots; }
    bool isFull() const { return m_plots.size() >= most; }
    /// Called when another step is opened, with its run.
    void open(const sim::Script &script);
    void add(const PlotSpec &plot);
    void remove(std::size_t index);
    void change(std::size_t index, const PlotSpec &plot);
    /// Makes the plots of the body `from` show the body `to`.
    void renameBody(const QString &from, const QString &to);

signals:
    /// A plot was added, removed or changed.
    void changed();

private:
    void keep();

    std::vector<PlotSpec> m_plots;
    bool m_isChosen = false; ///< by the learner
};

/// Returns all quantities that the plots show, each once.
std::vector<Quantity> quantitiesOf(const std::vector<PlotSpec> &plots);
/// Returns `plot` with "the selected body" replaced by the name `selected`.
PlotSpec pinned(PlotSpec plot, const QString &selected);
/// Returns `plot` for the selected body, whichever it is.
PlotSpec unpinned(PlotSpec plot);
/// Returns the default plot of a run: the angle of the first body, if points turn in the scene. Otherwise it is the
/// coordinate in which that body moves, or y if it moves in both or in neither.
PlotSpec firstPlot(const sim::Script &script);

}
